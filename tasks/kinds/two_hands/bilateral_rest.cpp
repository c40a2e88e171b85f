// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/kinds/two_hands/bilateral_rest.hpp"

#include "hand/two_hands_columns.hpp"
#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/kinds/tools/score_tools.hpp"
#include "tasks/kinds/two_hands/hands_timeline.hpp"
#include "tasks/pace.hpp"
#include "tasks/read_keys.hpp"

namespace isograsp::tasks {

namespace {

KindSpec read_bilateral_rest(TomlReader& reader) {
  BilateralRestSpec spec;
  spec.duration_s = read_duration(reader, "duration_s", spec.duration_s);
  return spec;
}

Duration bilateral_rest_duration(const BilateralRestSpec& spec) {
  return {spec.duration_s, spec.duration_s};
}

Result<std::unique_ptr<Task>> make_bilateral_rest(const BilateralRestSpec& spec,
                                                  const TaskContext& context) {
  HandsTimeline timeline;
  timeline.rests = true;
  timeline.segments = {hands_relaxed(frames_in(spec.duration_s, context.period_s), Phase::active)};
  return play_hands(std::move(timeline), context);
}

std::vector<Measure> score_bilateral_rest(const BilateralRestSpec&, const Record& record) {
  MeasureList list;
  for (const Hand hand : kBothHands) {
    const Column& force = columns::hand_grip[hand];
    const Section rest = record.select({Phase::active}, {force});
    list.add("resting_force", std::string(name_of(hand)), "N", rest, mean_over(rest, force));
  }
  return list.take();
}

std::string bilateral_rest_curve(const BilateralRestSpec&) {
  return columns::sum_force_N;
}

constexpr PlacedMeasure kBilateralRestPlaces[] = {{"resting_force", "left", Prominence::trend},
                                                  {"resting_force", "right", Prominence::trend}};

}  // namespace

constinit const KindFacts BilateralRestSpec::kFacts{
    .name = "bilateral_rest",
    .group = TaskGroup::two_hands,
    .read = read_bilateral_rest,
    .apparatus = "two_platforms",
    .duration = of_kind<bilateral_rest_duration>,
    .curve = of_kind<bilateral_rest_curve>,
    .repetitions = [](const KindSpec&) { return 0; },
    .make = of_kind<make_bilateral_rest>,
    .measures = of_kind<score_bilateral_rest>,
    .places = kBilateralRestPlaces,
    .rests = true};

}  // namespace isograsp::tasks
