// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/kinds/force/force_tracking.hpp"

#include <algorithm>
#include <cmath>

#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/kinds/tools/read_force_keys.hpp"
#include "tasks/kinds/tools/read_waveform.hpp"
#include "tasks/kinds/tools/segments.hpp"

namespace isograsp::tasks {

namespace {

constexpr int kMostForms = 100;

KindSpec read_force_tracking(TomlReader& reader) {
  ForceTrackingSpec spec;
  spec.aim = read_aim(reader);
  spec.least = read_level(reader, spec.aim, "least", spec.least);
  spec.most = read_level(reader, spec.aim, "most", spec.most);
  if (spec.most <= spec.least)
    reader.fail(spec.aim.scale == Scale::newton ? "most_N" : "most_fraction",
                "is not above the least level"_text, "write a larger number"_text);
  spec.lead_in_s = read_wait(reader, "lead_in_s", spec.lead_in_s);
  spec.duration_s = read_duration(reader, "duration_s", spec.duration_s);
  spec.waveform = read_waveform(reader, spec.duration_s);
  // Only here: in a pose, shifted axes would meet in another path, which is no parallel form.
  using Wave = Waveform::Shape;
  if (spec.waveform.shape == Wave::sine || spec.waveform.shape == Wave::triangle)
    spec.waveform.forms = read_count(reader, "forms", spec.waveform.forms, kMostForms);
  return spec;
}

Segments force_tracking_segments(const ForceTrackingSpec& spec, const Unit& unit, Pace& pace) {
  const double unit_N = unit(spec.aim.channel);
  const double least_N = spec.least * unit_N;
  const double range_N = (spec.most - spec.least) * unit_N;
  auto target_N = samples_of(spec.waveform, spec.duration_s, pace.period_s(), pace.seed());
  for (double& value : target_N) value = least_N + range_N * value;
  Segments segments{on_level(spec.aim, target_N.empty() ? least_N : target_N.front(),
                             spec.lead_in_s, Phase::lead_in, pace),
                    on_level(spec.aim, 0.0, spec.duration_s, Phase::active, pace)};
  segments.back().target_N = std::move(target_N);
  return segments;
}

Duration force_tracking_duration(const ForceTrackingSpec& spec) {
  return {spec.lead_in_s + spec.duration_s, spec.lead_in_s + spec.duration_s};
}

double force_tracking_level(const ForceTrackingSpec& spec) {
  return std::max(std::abs(spec.most), std::abs(spec.least));
}

/// Cycles, where the target has them.
int force_tracking_cycles(const ForceTrackingSpec& spec) {
  using Shape = Waveform::Shape;
  const Shape shape = spec.waveform.shape;
  const bool periodic =
      shape == Shape::sine || shape == Shape::triangle || shape == Shape::rectangle;
  return periodic ? std::max(1, static_cast<int>(spec.waveform.frequency_Hz * spec.duration_s)) : 1;
}

// Rising and falling parts stand in the table of a trial, not in the report.
constexpr PlacedMeasure kForceTrackingPlaces[] = {{"relative_rmse", "", Prominence::key},
                                                  {"time_in_range", "force", Prominence::trend},
                                                  {"lag", "", Prominence::trend}};

constexpr ComponentMeasure kForceTrackingComponents[] = {
    {Component::control, "relative_rmse", "force"}};

}  // namespace

constinit const KindFacts ForceTrackingSpec::kFacts{
    .name = "force_tracking",
    .group = TaskGroup::follow,
    .read = read_force_tracking,
    .duration = of_kind<force_tracking_duration>,
    .aim = own_aim<ForceTrackingSpec>,
    .largest_level = of_kind<force_tracking_level>,
    .waveform = [](const KindSpec& kind) { return &kind.as<ForceTrackingSpec>().waveform; },
    .multiply = multiply<ForceTrackingSpec>,
    .wardrobe = Wardrobe::curve,
    .repetitions = of_kind<force_tracking_cycles>,
    .segments = of_kind<force_tracking_segments>,
    .measures = of_kind<score_force_tracking>,
    .places = kForceTrackingPlaces,
    .components = kForceTrackingComponents,
    .follows_curve = true};

}  // namespace isograsp::tasks
