// SPDX-License-Identifier: GPL-3.0-or-later
//   mirror_force = 100 (mean of the resting hand - its rest) / (mean of the active hand - its rest)
#include "tasks/kinds/two_hands/mirror.hpp"

#include <cmath>

#include "hand/two_hands_columns.hpp"
#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/kinds/tools/score_tools.hpp"
#include "tasks/kinds/two_hands/hands_timeline.hpp"
#include "tasks/measures/error.hpp"
#include "tasks/pace.hpp"
#include "tasks/read_keys.hpp"

namespace isograsp::tasks {

namespace {

using Active = MirrorSpec::Active;

KindSpec read_mirror(TomlReader& reader) {
  constexpr double kLeastLevel = 0.05;
  constexpr double kMostLevel = 0.5;  // of the maximum: more is not asked of either of two hands
  constexpr int kMostMirrors = 20;
  MirrorSpec spec;
  spec.active =
      static_cast<Active>(reader.choice("active", {"left", "right", "affected", "other"}, 2));
  spec.level = read_within(reader, "level_fraction", kLeastLevel, kMostLevel, spec.level);
  spec.band_fraction = read_within(reader, "band_fraction", 0.01, 1.0, spec.band_fraction);
  spec.repetitions = read_count(reader, "repetitions", spec.repetitions, kMostMirrors);
  spec.hold_s = read_duration(reader, "hold_s", spec.hold_s);
  spec.rest_s = read_wait(reader, "rest_s", spec.rest_s);
  return spec;
}

Duration mirror_duration(const MirrorSpec& spec) {
  const double whole_s = spec.repetitions * (spec.rest_s + spec.hold_s);
  return {whole_s, whole_s};
}

Result<Hand> active_hand(const MirrorSpec& spec, const TaskContext& context) {
  if (spec.active == Active::left) return Hand::left;
  if (spec.active == Active::right) return Hand::right;
  if (const auto& affected = context.two_hands.affected)
    return spec.active == Active::affected ? *affected : other_than(*affected);
  return refused(
             "it is not known which side is affected"_text,
             "enter the affected side of the person, or write active = \"left\" or \"right\""_text)
      .about("active");
}

Result<std::unique_ptr<Task>> make_mirror(const MirrorSpec& spec, const TaskContext& context) {
  const auto hand = active_hand(spec, context);
  if (!hand) return hand.error();
  const double level_N = spec.level * context.two_hands.of[*hand].maximum_N.value_or(0.0);
  HandsSegment hold = hands_relaxed(frames_in(spec.hold_s, context.period_s), Phase::active);
  hold.cue[*hand] = Cue::follow;
  hold.each_shown[*hand] = true;
  hold.each_N[*hand] = {level_N};
  HandsTimeline timeline;
  timeline.band_fraction = spec.band_fraction;
  timeline.level_key = "level_fraction";
  for (int k = 0; k < spec.repetitions; ++k) {
    timeline.segments.push_back(
        hands_relaxed(frames_in(spec.rest_s, context.period_s), Phase::lead_in));
    timeline.segments.push_back(hold);
  }
  return play_hands(std::move(timeline), context);
}

/// Means over the active rows, above rest.
struct Rise {
  Section section;
  statistics::Computed mean_N = "no samples"_text;
};

Rise rise_of(const Record& record, Hand hand) {
  Rise rise;
  const Column& force = columns::hand_grip[hand];
  const Column& rest = columns::hand_resting_force_N[hand];
  rise.section = record.select({Phase::active}, {force});
  rise.mean_N = mean_over(rise.section, force);
  if (!rise.mean_N.value) return rise;
  const auto resting_N = record.constant(rest);
  rise.mean_N = resting_N ? statistics::Computed(*rise.mean_N.value - *resting_N)
                          : statistics::Computed("the resting force was not measured"_text);
  return rise;
}

/// The hand that was to follow; nothing: no row says so.
std::optional<Hand> active_in(const Record& record) {
  for (const Hand hand : kBothHands)
    for (const Part& part : parts_of(record))
      if (known_in(record, part, columns::hand_cue[hand]) == static_cast<double>(Cue::follow))
        return hand;
  return std::nullopt;
}

std::vector<Measure> score_mirror(const MirrorSpec&, const Record& record) {
  MeasureList list;
  const Hand active = active_in(record).value_or(Hand::left);
  const Hand resting = other_than(active);
  const Rise works = rise_of(record, active);
  const Rise rests = rise_of(record, resting);
  constexpr double kLeastActive_N = 0.5;  // below, a share of it is noise
  statistics::Computed overflow = rests.mean_N;
  if (!works.mean_N.value) overflow = works.mean_N;
  if (works.mean_N.value && rests.mean_N.value)
    overflow = *works.mean_N.value > kLeastActive_N
                   ? statistics::Computed(100.0 * *rests.mean_N.value / *works.mean_N.value)
                   : statistics::Computed("the hand that was to work did not"_text);
  list.add("mirror_force", std::string(name_of(resting)), "%", rests.section, overflow);
  list.add("force_above_rest", std::string(name_of(resting)), "N", rests.section, rests.mean_N);
  list.add("force_above_rest", std::string(name_of(active)), "N", works.section, works.mean_N);
  const Column& target = columns::target_hand_grip[active];
  const Section followed = record.select({Phase::active}, {target, columns::hand_grip[active]});
  list.add("rmse", std::string(name_of(active)), "N", followed,
           rmse(followed.values(target), followed.values(columns::hand_grip[active]),
                followed.weight_s));
  return list.take();
}

std::string mirror_curve(const MirrorSpec&) {
  return columns::sum_force_N;
}

int mirror_repetitions(const MirrorSpec& spec) {
  return spec.repetitions;
}

}  // namespace

constinit const KindFacts MirrorSpec::kFacts{.name = "mirror",
                                             .group = TaskGroup::two_hands,
                                             .read = read_mirror,
                                             .apparatus = "two_platforms",
                                             .duration = of_kind<mirror_duration>,
                                             .multiply = multiply<MirrorSpec>,
                                             .curve = of_kind<mirror_curve>,
                                             .repetitions = of_kind<mirror_repetitions>,
                                             .make = of_kind<make_mirror>,
                                             .measures = of_kind<score_mirror>,
                                             .research = true};

}  // namespace isograsp::tasks
