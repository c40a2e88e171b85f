// SPDX-License-Identifier: GPL-3.0-or-later
// A target is level * unit * direction_C, |direction_C| = 1. Of one digit in one push:
//   rmse = sqrt(sum w (|force| - |target|)^2 / sum w), w: how long a row lasts
// Rows with |force| <= 3 noise_sd have no direction.
#include "tasks/kinds/force/force_direction.hpp"

#include <algorithm>
#include <cmath>

#include "hand/columns.hpp"
#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/kinds/tools/read_force_keys.hpp"
#include "tasks/kinds/tools/score_tools.hpp"
#include "tasks/kinds/tools/segments.hpp"
#include "tasks/measures/coordination/digits.hpp"
#include "tasks/measures/coordination/direction.hpp"
#include "tasks/measures/error.hpp"

namespace isograsp::tasks {

namespace {

KindSpec read_force_direction(TomlReader& reader) {
  ForceDirectionSpec spec;
  spec.aim = read_aim(reader, false);
  spec.rise_s = read_wait(reader, "rise_s", spec.rise_s);
  spec.hold_s = read_duration(reader, "hold_s", spec.hold_s);
  spec.rest_s = read_wait(reader, "rest_s", spec.rest_s);
  spec.repetitions = read_count(reader, "repetitions", spec.repetitions, kMostRepetitions);
  for (TomlReader& table : reader.tables("target")) {
    ForceDirectionTarget target;
    target.level = read_level(table, spec.aim, "level", target.level);
    for (const Finger digit : kFingers) {
      const std::string key = std::string(name_of(digit)) + "_direction";
      if (!table.has(key)) continue;
      const Vec3 direction = table.vec3(key);
      if (!(direction.norm() > 0.0))
        table.fail(key, "has no length"_text, "write e.g. [0, 0, 1]"_text);
      target.asked[index_of(digit)] = true;
      target.direction_C[index_of(digit)] = direction.stableNormalized();
    }
    if (!target.asked[0] && !target.asked[1] && !target.asked[2])
      table.fail("", "asks no digit"_text, "add e.g. thumb_direction = [0, 0, 1]"_text);
    spec.targets.push_back(target);
  }
  if (spec.targets.empty())
    reader.fail("target", "is missing"_text, "add at least one [[target]]"_text);
  return spec;
}

Segments force_direction_segments(const ForceDirectionSpec& spec, const Unit& unit, Pace& pace) {
  Segments segments;
  for (int repetition = 0; repetition < spec.repetitions; ++repetition)
    for (const ForceDirectionTarget& target : spec.targets) {
      Segment push;
      push.cue = Cue::follow;
      push.force_shown = spec.aim.force_shown;
      push.digits.shown = target.asked;
      for (const Finger digit : kFingers) {
        const std::size_t f = index_of(digit);
        if (!target.asked[f]) continue;
        push.channel = channel_of(digit);  // of the last one asked: its level stands for the trial
        push.digits.force_C[f] = target.level * unit(channel_of(digit)) * target.direction_C[f];
      }
      push.phase = Phase::lead_in;
      push.frames = pace.frames(spec.rise_s);
      segments.push_back(push);
      push.phase = Phase::active;
      push.frames = pace.frames(spec.hold_s);
      segments.push_back(push);
      segments.push_back(relaxed(push.channel, spec.rest_s, pace));
    }
  return segments;
}

std::vector<Measure> score_force_direction(const ForceDirectionSpec&, const Record& record) {
  MeasureList list;
  std::vector<statistics::Computed> deviations;
  std::vector<Section> paths;
  for (const Finger finger : kFingers) {
    const std::string name(name_of(finger));
    const std::size_t f = index_of(finger);
    std::vector<statistics::Computed> angle, projection, error;
    std::vector<Section> sections;
    for (const Part& part : parts_of(record)) {
      if (part.phase != Phase::active) continue;
      const Vectors target = vectors_of(record, part.first, part.last, columns::target_force[f]);
      if (target.force_N.empty()) {  // this digit was not asked, or nothing can be computed
        if (record.signals().has(columns::target_force[f][2]) && !target.section.reason.empty())
          sections.push_back(target.section);
        continue;
      }
      const Vectors actual = vectors_of(record, part.first, part.last, columns::finger_force[f]);
      const Vec3 wanted_N = target.force_N.front();
      const double noise_N = known_in(record, part, columns::noise_sd_N);
      constexpr double kLeast_sd = 3.0;
      angle.push_back(direction_error(actual.force_N, wanted_N, actual.section.weight_s,
                                      std::isnan(noise_N) ? 0.0 : kLeast_sd * noise_N));
      projection.push_back(
          projection_ratio(actual.force_N, wanted_N.normalized(), actual.section.weight_s));
      std::vector<double> size_N, wanted_size_N;
      for (const Vec3& force_N : actual.force_N) size_N.push_back(force_N.norm());
      wanted_size_N.assign(size_N.size(), wanted_N.norm());
      error.push_back(rmse(wanted_size_N, size_N, actual.section.weight_s));
      sections.push_back(actual.section);
    }
    if (sections.empty()) continue;
    const Section all = join(sections);
    list.add_mean("direction_error", name, "rad", all, angle);
    list.add_mean("projection_ratio", name, "", all, projection);
    list.add_mean("rmse", name, "N", all, error);
  }
  // The way from rest to the target, all digits together.
  const auto parts = parts_of(record);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (parts[i].phase != Phase::active) continue;
    const NormalForces forces = normal_forces(record, parts[i - 1].first, parts[i].last);
    if (forces.section.rows.empty()) continue;
    deviations.push_back(path_deviation(forces.force_N, forces.section.weight_s));
    paths.push_back(forces.section);
  }
  list.add_mean("path_deviation", "digits", "N", join(paths), deviations);
  return list.take();
}

std::vector<ForceChannel> force_direction_channels(const ForceDirectionSpec& spec) {
  std::vector<ForceChannel> channels;
  for (const Finger digit : kFingers)
    if (std::any_of(spec.targets.begin(), spec.targets.end(),
                    [&](const auto& target) { return target.asked[index_of(digit)]; }))
      channels.push_back(channel_of(digit));
  return channels;
}

int force_direction_pushes(const ForceDirectionSpec& spec) {
  return spec.repetitions * static_cast<int>(spec.targets.size());
}

constexpr PlacedMeasure kForceDirectionPlaces[] = {{"direction_error", "", Prominence::key},
                                                   {"projection_ratio", "", Prominence::trend},
                                                   {"path_deviation", "", Prominence::trend}};

constexpr ComponentMeasure kForceDirectionComponents[] = {
    {Component::direction, "direction_error", ""}};

}  // namespace

constinit const KindFacts ForceDirectionSpec::kFacts{.name = "force_direction",
                                                     .group = TaskGroup::fingers_and_directions,
                                                     .read = read_force_direction,
                                                     .aim = own_aim<ForceDirectionSpec>,
                                                     .channels = of_kind<force_direction_channels>,
                                                     .repetitions = of_kind<force_direction_pushes>,
                                                     .segments = of_kind<force_direction_segments>,
                                                     .measures = of_kind<score_force_direction>,
                                                     .places = kForceDirectionPlaces,
                                                     .components = kForceDirectionComponents};

}  // namespace isograsp::tasks
