// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/kinds/two_hands/bilateral_tracking.hpp"

#include <algorithm>

#include "hand/two_hands_columns.hpp"
#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/kinds/tools/read_force_keys.hpp"
#include "tasks/kinds/tools/read_waveform.hpp"
#include "tasks/kinds/two_hands/hands_timeline.hpp"
#include "tasks/pace.hpp"
#include "tasks/record.hpp"
#include "tasks/score.hpp"

namespace isograsp::tasks {

namespace {

using Goal = BilateralTrackingSpec::Goal;

constexpr double kLeastRatio = 0.1;  // of either hand: less is no task of two hands

const char* most_key(Scale scale) {
  return scale == Scale::newton ? "most_N" : "most_fraction";
}

KindSpec read_bilateral_tracking(TomlReader& reader) {
  BilateralTrackingSpec spec;
  spec.goal = static_cast<Goal>(reader.choice("goal", {"sum", "each", "antiphase"}, 0));
  if (spec.goal == Goal::each)
    spec.ratio_left =
        read_within(reader, "ratio_left", kLeastRatio, 1.0 - kLeastRatio, spec.ratio_left);
  if (spec.goal == Goal::sum) spec.each_shown = reader.choice("feedback", {"sum", "both"}, 1) == 1;
  Aim aim;
  aim.scale =
      reader.choice("scale", {"newton", "of_maximum"}, 1) == 0 ? Scale::newton : Scale::of_maximum;
  spec.scale = aim.scale;
  spec.band_fraction = read_within(reader, "band_fraction", 0.01, 1.0, spec.band_fraction);
  spec.least = read_level(reader, aim, "least", spec.least);
  spec.most = read_level(reader, aim, "most", spec.most);
  if (spec.most <= spec.least)
    reader.fail(most_key(spec.scale), "is not above the least level"_text,
                "write a larger number"_text);
  spec.lead_in_s = read_wait(reader, "lead_in_s", spec.lead_in_s);
  spec.duration_s = read_duration(reader, "duration_s", spec.duration_s);
  spec.waveform = read_waveform(reader, spec.duration_s);
  return spec;
}

Duration bilateral_tracking_duration(const BilateralTrackingSpec& spec) {
  return {spec.lead_in_s + spec.duration_s, spec.lead_in_s + spec.duration_s};
}

/// The levels of one target: `least` and `most` times `unit_N`, along `shape`, 0 … 1.
std::vector<double> levels_of(const BilateralTrackingSpec& spec, double unit_N,
                              const std::vector<double>& shape, bool upside_down = false) {
  std::vector<double> levels_N;
  for (const double value : shape)
    levels_N.push_back(
        unit_N * (spec.least + (spec.most - spec.least) * (upside_down ? 1.0 - value : value)));
  return levels_N;
}

HandsSegment target_segment(const BilateralTrackingSpec& spec, const TaskContext& context,
                            const std::vector<double>& shape) {
  const OfHands<HandReferences>& of = context.two_hands.of;
  const auto maximum_N = [&](Hand hand) { return of[hand].maximum_N.value_or(0.0); };
  const auto unit_N = [&](double of_maximum_N) {
    return spec.scale == Scale::newton ? 1.0 : of_maximum_N;
  };
  const double both_N = unit_N(maximum_N(Hand::left) + maximum_N(Hand::right));
  HandsSegment segment;
  segment.cue = {Cue::follow, Cue::follow};
  segment.each_shown = {spec.each_shown, spec.each_shown};
  switch (spec.goal) {
    case Goal::sum:
      segment.sum_shown = true;
      segment.sum_N = levels_of(spec, both_N, shape);
      break;
    case Goal::each:
      segment.each_N.left = levels_of(spec, spec.ratio_left * both_N, shape);
      segment.each_N.right = levels_of(spec, (1.0 - spec.ratio_left) * both_N, shape);
      break;
    case Goal::antiphase:
      segment.each_N.left = levels_of(spec, unit_N(maximum_N(Hand::left)), shape);
      segment.each_N.right = levels_of(spec, unit_N(maximum_N(Hand::right)), shape, true);
      break;
  }
  return segment;
}

Result<std::unique_ptr<Task>> make_bilateral_tracking(const BilateralTrackingSpec& spec,
                                                      const TaskContext& context) {
  const auto shape = samples_of(spec.waveform, spec.duration_s, context.period_s, context.seed);
  HandsSegment follow = target_segment(spec, context, shape);
  follow.frames = static_cast<std::int64_t>(shape.size());
  HandsSegment lead_in = follow;  // stands at its first value
  lead_in.phase = Phase::lead_in;
  lead_in.frames = frames_in(spec.lead_in_s, context.period_s);
  for (auto* levels : {&lead_in.sum_N, &lead_in.each_N.left, &lead_in.each_N.right})
    if (!levels->empty()) levels->resize(1);
  HandsTimeline timeline;
  timeline.band_fraction = spec.band_fraction;
  timeline.level_key = most_key(spec.scale);
  timeline.segments = {std::move(lead_in), std::move(follow)};
  return play_hands(std::move(timeline), context);
}

std::vector<Measure> score_bilateral_tracking(const BilateralTrackingSpec&, const Record& record) {
  return score_hands(record, hands_context(record), {Phase::active});
}

const Waveform* bilateral_tracking_waveform(const KindSpec& kind) {
  return &kind.as<BilateralTrackingSpec>().waveform;
}

int bilateral_tracking_cycles(const BilateralTrackingSpec& spec) {
  using Shape = Waveform::Shape;
  const Shape shape = spec.waveform.shape;
  const bool periodic =
      shape == Shape::sine || shape == Shape::triangle || shape == Shape::rectangle;
  return periodic ? std::max(1, static_cast<int>(spec.waveform.frequency_Hz * spec.duration_s)) : 1;
}

std::string bilateral_tracking_curve(const BilateralTrackingSpec&) {
  return columns::sum_force_N;
}

constexpr PlacedMeasure kBilateralTrackingPlaces[] = {
    {"share_affected", "", Prominence::key},
    {"effort_share_affected", "", Prominence::key},
    {"rmse", "", Prominence::trend}};

}  // namespace

constinit const KindFacts BilateralTrackingSpec::kFacts{
    .name = "bilateral_tracking",
    .group = TaskGroup::two_hands,
    .read = read_bilateral_tracking,
    .apparatus = "two_platforms",
    .duration = of_kind<bilateral_tracking_duration>,
    .waveform = bilateral_tracking_waveform,
    .multiply = multiply<BilateralTrackingSpec>,
    .curve = of_kind<bilateral_tracking_curve>,
    .repetitions = of_kind<bilateral_tracking_cycles>,
    .make = of_kind<make_bilateral_tracking>,
    .measures = of_kind<score_bilateral_tracking>,
    .places = kBilateralTrackingPlaces};

}  // namespace isograsp::tasks
