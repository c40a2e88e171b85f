// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of carrying with both hands. Of rows of transport and hold in which both hands hold the
// object:
//   least squeeze = 5 % quantile by time of the push of a hand towards the other one
//   path share    = 100 P_A / (P_A + P_U), P the way of the point that a hand is
// Time of a carry is task time, from when it could be taken until it was let go at its target; a
// drop costs what fetching takes.
#include <array>

#include "hand/two_hands_columns.hpp"
#include "statistics/quantile.hpp"
#include "tasks/kinds/tools/object_score.hpp"
#include "tasks/kinds/tools/score_tools.hpp"
#include "tasks/kinds/two_hands/bimanual_pick_place.hpp"
#include "tasks/kinds/two_hands/way_of_hand.hpp"
#include "tasks/measures/coordination/two_hands.hpp"
#include "tasks/score.hpp"

namespace isograsp::tasks {

namespace {

constexpr Words kNeverHeld = "both hands never held the object"_text;
constexpr double kLeastOfTime = 0.05;  // single samples do not count

class CarryScore {
 public:
  CarryScore(const BimanualPickPlaceSpec& spec, const Record& record)
      : spec_(spec), record_(record), context_(hands_context(record)) {}

  std::vector<Measure> score() {
    const Attempts attempts = attempts_of(record_, static_cast<std::size_t>(spec_.carries()));
    std::vector<Measure> all;
    add_completions(all, record_, attempts, spec_.time_limit_s, &Attempt::last_row);
    all.push_back(drops_measure(record_));
    all.push_back(path_efficiency_measure(record_, attempts));
    add_squeeze();
    add_path();
    for (Measure& measure : list_.take()) all.push_back(std::move(measure));
    return all;
  }

 private:
  /// The rows in which both hold it and all of these have a value.
  [[nodiscard]] Section held(std::vector<std::string> columns) const {
    // Too small or too large to compute with is what a measure reads, whoever holds.
    if (Section alone = record_.select(kMoving, columns); !alone.reason.empty()) return alone;
    columns.emplace_back(columns::both_hold);
    Section chosen = record_.select(kMoving, columns);
    keep_rows(chosen, chosen.values(columns::both_hold), [](double held) { return held > 0.5; });
    if (chosen.reason.empty() && chosen.rows.empty()) chosen.reason = kNeverHeld;
    return chosen;
  }

  void add_squeeze() {
    for (const Hand hand : kBothHands) {
      const Column& squeeze = columns::hand_squeeze_N[hand];
      const Section pressed = held({squeeze});
      list_.add("least_squeeze", std::string(name_of(hand)), "N", pressed,
                statistics::quantile(pressed.values(squeeze), pressed.weight_s, kLeastOfTime));
    }
  }

  void add_path() {
    std::vector<std::string> columns;
    for (const Hand hand : kBothHands)
      for (const Column& axis : columns::hand_point[hand]) columns.emplace_back(axis);
    const Section section = held(columns);
    const Hand affected = context_.affected.value_or(Hand::left);
    statistics::Computed share = kNeverHeld;
    if (!context_.affected)
      share = "it is not known which side is affected"_text;
    else if (!section.rows.empty())
      share = hand_share(way_m(section, columns::hand_point[affected]),
                         way_m(section, columns::hand_point[other_than(affected)]))
                  .affected_percent;
    list_.add("path_share_affected", std::string(context_.affected ? name_of(affected) : "both"),
              "%", section, share);
  }

  const BimanualPickPlaceSpec& spec_;
  const Record& record_;
  TwoHandsContext context_;
  MeasureList list_;
};

}  // namespace

std::vector<Measure> score_bimanual_pick_place(const BimanualPickPlaceSpec& spec,
                                               const Record& record) {
  return CarryScore(spec, record).score();
}

}  // namespace isograsp::tasks
