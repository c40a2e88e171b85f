// SPDX-License-Identifier: GPL-3.0-or-later
//   force of an effort = largest mean over window_s without interruption, above rest
//   bilateral deficit  = 100 (B_left + B_right) / (U_left + U_right) - 100, B of both at once, U
//   alone
#include "tasks/kinds/two_hands/bilateral_maximum.hpp"

#include <algorithm>
#include <cmath>

#include "hand/two_hands_columns.hpp"
#include "tasks/kinds/tools/effort_score.hpp"
#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/kinds/two_hands/hands_timeline.hpp"
#include "tasks/pace.hpp"
#include "tasks/read_keys.hpp"

namespace isograsp::tasks {

namespace {

KindSpec read_bilateral_maximum(TomlReader& reader) {
  BilateralMaximumSpec spec;
  spec.lead_in_s = read_wait(reader, "lead_in_s", spec.lead_in_s);
  spec.squeeze_s = read_duration(reader, "squeeze_s", spec.squeeze_s);
  spec.rest_s = read_wait(reader, "rest_s", spec.rest_s);
  spec.window_s = read_duration(reader, "window_s", spec.window_s);
  if (spec.window_s > spec.squeeze_s)
    reader.fail("window_s", "is longer than squeeze_s"_text, "make it shorter"_text);
  return spec;
}

Duration bilateral_maximum_duration(const BilateralMaximumSpec& spec) {
  const double whole_s = spec.lead_in_s + 3.0 * spec.squeeze_s + 2.0 * spec.rest_s;
  return {whole_s, whole_s};
}

/// Which hand begins alternates with the seed, which grows by one from trial to trial.
Result<std::unique_ptr<Task>> make_bilateral_maximum(const BilateralMaximumSpec& spec,
                                                     const TaskContext& context) {
  const auto frames = [&](double duration_s) { return frames_in(duration_s, context.period_s); };
  const auto effort = [&](OfHands<bool> squeezes) {
    HandsSegment segment = hands_relaxed(frames(spec.squeeze_s), Phase::active);
    for (const Hand hand : kBothHands)
      if (squeezes[hand]) segment.cue[hand] = Cue::squeeze;
    segment.each_shown = squeezes;
    return segment;
  };
  const bool left_first = context.seed % 2 == 0;
  HandsTimeline timeline;
  timeline.segments = {
      hands_relaxed(frames(spec.lead_in_s), Phase::lead_in), effort({left_first, !left_first}),
      hands_relaxed(frames(spec.rest_s), Phase::lead_in),    effort({!left_first, left_first}),
      hands_relaxed(frames(spec.rest_s), Phase::lead_in),    effort({true, true})};
  return play_hands(std::move(timeline), context);
}

/// Of one hand in the efforts that asked for it.
struct HandEfforts {
  EffortForces alone;
  EffortForces beside;  ///< while the other squeezed, too
  std::optional<Part> alone_part;
  std::optional<Part> beside_part;
};

bool squeezes(const Record& record, const Part& part, Hand hand) {
  return known_in(record, part, columns::hand_cue[hand]) == static_cast<double>(Cue::squeeze);
}

HandEfforts efforts_of_hand(const Record& record, Hand hand, double window_s) {
  HandEfforts efforts;
  for (const Part& part : efforts_of(record)) {
    if (!squeezes(record, part, hand)) continue;
    const bool both = squeezes(record, part, other_than(hand));
    auto& known = both ? efforts.beside_part : efforts.alone_part;
    if (known) continue;
    known = part;
    (both ? efforts.beside : efforts.alone) = effort_of(
        record, part, window_s, columns::hand_grip[hand], columns::hand_resting_force_N[hand]);
  }
  return efforts;
}

Section rows_of(const Record& record, const std::optional<Part>& part, Hand hand) {
  if (!part) return record.select(0, 0, {Phase::active}, {columns::hand_grip[hand]});
  return record.select(part->first, part->last, {Phase::active}, {columns::hand_grip[hand]});
}

std::vector<Measure> score_bilateral_maximum(const BilateralMaximumSpec& spec,
                                             const Record& record) {
  MeasureList list;
  OfHands<HandEfforts> of;
  for (const Hand hand : kBothHands) {
    const std::string channel(name_of(hand));
    of[hand] = efforts_of_hand(record, hand, spec.window_s);
    const Section alone = rows_of(record, of[hand].alone_part, hand);
    list.add("maximum_force", channel, "N", alone, of[hand].alone.above_rest);
    list.add("maximum_force_total", channel, "N", alone, of[hand].alone.total);
    list.add("bilateral_force", channel, "N", rows_of(record, of[hand].beside_part, hand),
             of[hand].beside.above_rest);
  }
  const Section both =
      record.select({Phase::active}, {columns::hand_grip.left, columns::hand_grip.right});
  statistics::Computed deficit = "an effort or a resting force was not measured"_text;
  const auto sum = [](const statistics::Computed& a, const statistics::Computed& b) {
    return a.value && b.value ? std::optional(*a.value + *b.value) : std::nullopt;
  };
  const auto together_N = sum(of.left.beside.above_rest, of.right.beside.above_rest);
  const auto alone_N = sum(of.left.alone.above_rest, of.right.alone.above_rest);
  if (together_N && alone_N)
    deficit = *alone_N > 0.0 ? statistics::Computed(100.0 * *together_N / *alone_N - 100.0)
                             : statistics::Computed("the hands alone gave no force"_text);
  list.add("bilateral_deficit", "both", "%", both, deficit);
  return list.take();
}

std::string bilateral_maximum_curve(const BilateralMaximumSpec&) {
  return columns::sum_force_N;
}

constexpr PlacedMeasure kBilateralMaximumPlaces[] = {{"maximum_force", "left", Prominence::key},
                                                     {"maximum_force", "right", Prominence::key},
                                                     {"bilateral_deficit", "", Prominence::trend}};

}  // namespace

constinit const KindFacts BilateralMaximumSpec::kFacts{
    .name = "bilateral_maximum",
    .group = TaskGroup::two_hands,
    .read = read_bilateral_maximum,
    .apparatus = "two_platforms",
    .duration = of_kind<bilateral_maximum_duration>,
    .curve = of_kind<bilateral_maximum_curve>,
    .repetitions = [](const KindSpec&) { return 3; },
    .make = of_kind<make_bilateral_maximum>,
    .measures = of_kind<score_bilateral_maximum>,
    .places = kBilateralMaximumPlaces};

}  // namespace isograsp::tasks
