// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/kinds/force/rest.hpp"

#include "hand/columns.hpp"
#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/kinds/tools/score_tools.hpp"
#include "tasks/kinds/tools/segments.hpp"
#include "tasks/read_keys.hpp"

namespace isograsp::tasks {

namespace {

KindSpec read_rest(TomlReader& reader) {
  RestSpec spec;
  spec.duration_s = read_duration(reader, "duration_s", spec.duration_s);
  return spec;
}

Segments rest_segments(const RestSpec& spec, const Unit&, Pace& pace) {
  return {relaxed({}, spec.duration_s, pace, Phase::active)};
}

Duration rest_duration(const RestSpec& spec) {
  return {spec.duration_s, spec.duration_s};
}

std::vector<Measure> score_rest(const RestSpec&, const Record& record) {
  MeasureList list;
  const auto add = [&](const std::string& channel, const Column& column, const char* unit) {
    const Section rest = record.select({Phase::active}, {column});
    list.add("resting_force", channel, unit, rest, mean_over(rest, column));
  };
  add("grip", columns::actual_force_N, "N");
  for (const Finger finger : kFingers)
    for (std::size_t axis = 0; axis < 6; ++axis) {
      const bool force = axis < 3;
      const auto& wrench = force ? columns::finger_force : columns::finger_torque;
      add(std::string(name_of(finger)) + (force ? "_f" : "_t") +
              std::string(columns::kXyz[axis % 3]),
          wrench[index_of(finger)][axis % 3], force ? "N" : "Nm");
    }
  return list.take();
}

constexpr PlacedMeasure kRestPlaces[] = {{"resting_force", "grip", Prominence::trend}};

}  // namespace

constinit const KindFacts RestSpec::kFacts{.name = "rest",
                                           .group = TaskGroup::rest_and_maximum,
                                           .read = read_rest,
                                           .duration = of_kind<rest_duration>,
                                           .repetitions = [](const KindSpec&) { return 0; },
                                           .segments = of_kind<rest_segments>,
                                           .measures = of_kind<score_rest>,
                                           .places = kRestPlaces,
                                           .rests = true};

}  // namespace isograsp::tasks
