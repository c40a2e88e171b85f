// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of lifting with both hands, over the rows of transport and hold in which the object is
// off its rest (more than kOffRest_m above where it was in the first row):
//   object tilt             = sqrt(mean of angle^2), mean weighted with time
//   least squeeze           = 5 % quantile by time of the push into the object
//   friction utilisation    = 100 (95 % quantile by time of the share of the limit of friction)
//   path share              = 100 P_A / (P_A + P_U), P the way of the end that the hand holds
//   raise, squeeze of hands = mean push up, into the object, less that over the first lead-in
// Time of a lift is task time, up to the hold that counted; a drop costs what fetching takes.
#include <algorithm>
#include <cmath>

#include "hand/two_hands_columns.hpp"
#include "statistics/quantile.hpp"
#include "statistics/weighted.hpp"
#include "tasks/kinds/tools/object_score.hpp"
#include "tasks/kinds/tools/score_tools.hpp"
#include "tasks/kinds/two_hands/bimanual_lift.hpp"
#include "tasks/kinds/two_hands/lifted.hpp"
#include "tasks/kinds/two_hands/way_of_hand.hpp"
#include "tasks/measures/coordination/two_hands.hpp"
#include "tasks/score.hpp"

namespace isograsp::tasks {

namespace {

constexpr Words kNeverLifted = "the object was never off its rest"_text;
constexpr double kLeastShare = 0.05;  // of the time: single samples do not count …
constexpr double kMostShare = 0.95;   // … at either end

/// One force of both hands.
struct ForceOfHands {
  const char* above_rest;
  const char* share;
  const OfHands<Column>& columns;
};
constexpr OfHands<Column> kRaise{columns::hand_push.left[1], columns::hand_push.right[1]};

class LiftScore {
 public:
  LiftScore(const BimanualLiftSpec& spec, const Record& record)
      : spec_(spec), record_(record), context_(hands_context(record)) {}

  std::vector<Measure> score() {
    std::vector<Measure> lifts;
    add_completions(lifts, record_, attempts_of(record_, static_cast<std::size_t>(spec_.lifts)),
                    spec_.time_limit_s, &Attempt::hold_row);
    lifts.push_back(drops_measure(record_));
    add_tilt();
    add_holding();
    add_path();
    add_force({"raise_above_rest", "raise_share_affected", kRaise});
    add_force({"squeeze_above_rest", "squeeze_share_affected", columns::hand_squeeze_N});
    std::vector<Measure> rest = list_.take();
    lifts.insert(lifts.end(), std::make_move_iterator(rest.begin()),
                 std::make_move_iterator(rest.end()));
    return lifts;
  }

 private:
  /// The rows off its rest in which all of these have a value.
  [[nodiscard]] Section lifted(std::vector<std::string> columns) const {
    // Too small or too large to compute with is what a measure reads, whatever the height is.
    if (Section alone = record_.select(kMoving, columns); !alone.reason.empty()) return alone;
    const Column& height = columns::actual_position[1];
    columns.emplace_back(height);
    Section chosen = record_.select(kMoving, columns);
    const double rest_m = record_.constant(height).value_or(0.0);
    keep_rows(chosen, chosen.values(height),
              [rest_m](double height_m) { return height_m - rest_m > kOffRest_m; });
    if (chosen.reason.empty() && chosen.rows.empty()) chosen.reason = kNeverLifted;
    return chosen;
  }

  void add_tilt() {
    const Column& angle = columns::actual_angle_rad;
    const Section section = lifted({angle});
    const auto angle_rad = section.values(angle);
    auto rms = statistics::weighted_mean_of(
        section.weight_s, [&](std::size_t k) { return angle_rad[k] * angle_rad[k]; });
    if (rms.value) rms.value = std::sqrt(*rms.value);
    list_.add("object_tilt", "angle", "rad", section, rms);
    list_.add("object_tilt_mean", "angle", "rad", section, mean_over(section, angle));
  }

  void add_holding() {
    for (const Hand hand : kBothHands) {
      const std::string channel(name_of(hand));
      const Column& squeeze = columns::hand_squeeze_N[hand];
      const Section pressed = lifted({squeeze});
      list_.add("least_squeeze", channel, "N", pressed,
                statistics::quantile(pressed.values(squeeze), pressed.weight_s, kLeastShare));
      const Column& utilisation = columns::hand_utilisation[hand];
      const Section rubbed = lifted({utilisation});
      auto used = statistics::quantile(rubbed.values(utilisation), rubbed.weight_s, kMostShare);
      if (used.value) used.value = 100.0 * *used.value;
      list_.add("friction_utilisation", channel, "%", rubbed, used);
    }
  }

  void add_path() {
    std::vector<std::string> columns;
    for (const Hand hand : kBothHands)
      for (const Column& axis : columns::hand_end[hand]) columns.emplace_back(axis);
    const Section section = lifted(columns);
    statistics::Computed share = kNeverLifted;
    if (!section.rows.empty())
      share = of_affected(way_m(section, columns::hand_end[affected()]),
                          way_m(section, columns::hand_end[other_than(affected())]), false);
    list_.add("path_share_affected", side(), "%", section, share);
  }

  void add_force(const ForceOfHands& force) {
    const Section both = lifted({force.columns.left, force.columns.right});
    const Section still = record_.select(0, first_lift(), {Phase::lead_in},
                                         {force.columns.left, force.columns.right});
    OfHands<statistics::Computed> above{kNeverLifted, kNeverLifted};
    for (const Hand hand : kBothHands) {
      above[hand] = mean_over(both, force.columns[hand]);
      const auto resting = mean_over(still, force.columns[hand]);
      if (above[hand].value && resting.value)
        *above[hand].value -= *resting.value;
      else if (above[hand].value)
        above[hand] = "the hands were not seen at rest"_text;
      list_.add(force.above_rest, std::string(name_of(hand)), "N", both, above[hand]);
    }
    const auto& own = above[affected()];
    const auto& other = above[other_than(affected())];
    statistics::Computed share = own.value ? other : own;
    if (own.value && other.value) share = of_affected(*own.value, *other.value, true);
    list_.add(force.share, side(), "%", both, share);
  }
  /// The row in which the first lift begins.
  [[nodiscard]] std::size_t first_lift() const {
    for (std::size_t row = 0; row < record_.rows(); ++row)
      if (record_.phase(row) != Phase::lead_in && !record_.paused(row)) return row;
    return record_.rows();
  }

  [[nodiscard]] statistics::Computed of_affected(double affected, double other,
                                                 bool of_forces) const {
    if (!context_.affected) return "it is not known which side is affected"_text;
    if (of_forces && context_.coupled) return "one platform moves the other: mount them apart"_text;
    return hand_share(affected, other).affected_percent;
  }
  [[nodiscard]] Hand affected() const { return context_.affected.value_or(Hand::left); }
  [[nodiscard]] std::string side() const {
    return std::string(context_.affected ? name_of(affected()) : "both");
  }

  const BimanualLiftSpec& spec_;
  const Record& record_;
  TwoHandsContext context_;
  MeasureList list_;
};

}  // namespace

std::vector<Measure> score_bimanual_lift(const BimanualLiftSpec& spec, const Record& record) {
  return LiftScore(spec, record).score();
}

}  // namespace isograsp::tasks
