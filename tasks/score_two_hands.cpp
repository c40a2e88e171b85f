// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of a record of two hands (docs/measures.md, Two hands).
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hand/two_hands_columns.hpp"
#include "tasks/measures/coordination/coupling.hpp"
#include "tasks/measures/coordination/two_hands.hpp"
#include "tasks/measures/delay.hpp"
#include "tasks/measures/error.hpp"
#include "tasks/record.hpp"
#include "tasks/score.hpp"

namespace isograsp::tasks {

namespace {

constexpr Words kCoupled = "one platform moves the other: mount them apart"_text;
constexpr Words kNobodysSide = "it is not known which side is affected"_text;

class TwoHandsScorer {
 public:
  TwoHandsScorer(const Record& record, const TwoHandsContext& context,
                 std::initializer_list<Phase> phases)
      : record_(record),
        context_(context),
        phases_(phases),
        affected_(context.affected.value_or(Hand::left)),
        other_(other_than(affected_)),
        both_(select({columns::hand_grip.left, columns::hand_grip.right})) {}

  std::vector<Measure> score() {
    add_shares();
    add_coordination();
    add_synergy();
    add_cancelled();
    add_errors();
    return std::move(measures_);
  }

 private:
  [[nodiscard]] Section select(const std::vector<std::string>& columns) const {
    return record_.select(phases_, columns, Record::TimeAxis::record);
  }
  [[nodiscard]] bool has(std::string_view column) const { return record_.signals().has(column); }
  [[nodiscard]] std::vector<double> force_of(Hand hand) const {
    return both_.values(columns::hand_grip[hand]);
  }
  /// The channel says which hand is the affected one.
  void add(const char* name, const char* unit, const Section& section,
           const statistics::Computed& computed) {
    const std::string channel(context_.affected ? name_of(affected_) : "both");
    measures_.push_back(make_measure(name, channel, unit, section, computed));
  }

  /// Both forces stand beside their share: it also rises when the other hand weakens.
  void add_shares() {
    OfHands<statistics::Computed> above{"no samples"_text, "no samples"_text};
    for (const Hand hand : {affected_, other_}) {
      const std::string channel(name_of(hand));
      const auto mean = mean_over(both_, columns::hand_grip[hand]);
      measures_.push_back(make_measure("mean_force", channel, "N", both_, mean));
      above[hand] = above_rest(mean, hand);
      if (context_.resting_N)
        measures_.push_back(make_measure("force_above_rest", channel, "N", both_, above[hand]));
    }
    const auto& affected = above[affected_];
    const auto& other = above[other_];
    const statistics::Computed missing = affected.value ? other : affected;
    HandShare share{missing, missing};
    statistics::Computed effort = missing;
    if (affected.value && other.value) {
      share = hand_share(*affected.value, *other.value);
      effort = of_effort(*affected.value, *other.value);
    }
    if (!context_.affected) {
      share = {kNobodysSide, kNobodysSide};
      effort = kNobodysSide;
    }
    if (context_.coupled) {
      share = {kCoupled, kCoupled};
      effort = kCoupled;
    }
    add("share_affected", "%", both_, share.affected_percent);
    add("asymmetry", "%", both_, share.asymmetry_percent);
    add("effort_share_affected", "%", both_, effort);
  }
  [[nodiscard]] statistics::Computed above_rest(const statistics::Computed& mean, Hand hand) const {
    if (!mean.value || !context_.resting_N) return mean;
    const auto& resting_N = (*context_.resting_N)[hand];
    if (!resting_N) return "the resting force was not measured"_text;
    return *mean.value - *resting_N;
  }
  [[nodiscard]] statistics::Computed of_effort(double affected_N, double other_N) const {
    const auto& maximum_N = context_.maximum_N;
    if (!maximum_N.left || !maximum_N.right) return "the maximum of each hand is not known"_text;
    return effort_share(affected_N, other_N, *maximum_N[affected_], *maximum_N[other_]);
  }

  void add_coordination() {
    const auto affected = force_of(affected_);
    const auto other = force_of(other_);
    add("hand_correlation", "", both_, correlation(affected, other, both_.weight_s));
    constexpr Words kTooShort = "fewer than two samples"_text;
    LagPeak peak{kTooShort, kTooShort};
    if (both_.rows.size() >= 2)
      peak = lag_peak(statistics::on_uniform_grid(both_.t_s, other),
                      statistics::on_uniform_grid(both_.t_s, affected));
    if (!context_.affected) peak = {kNobodysSide, kNobodysSide};
    add("hand_lag", "s", both_, peak.lag_s);
    add("hand_lag_correlation", "", both_, peak.correlation);
  }

  void add_synergy() {
    std::vector<std::string> columns{columns::hand_grip.left, columns::hand_grip.right};
    const bool follow = has_target(columns::target_sum_force_N);
    if (follow) columns.emplace_back(columns::target_sum_force_N);
    const Section section = select(columns);
    statistics::Computed synergy = "too few samples"_text;
    if (section.rows.size() >= 2) {
      const auto grid = [&](std::string_view column) {
        return statistics::on_uniform_grid(section.t_s, section.values(column));
      };
      const auto target = follow ? std::optional(grid(columns::target_sum_force_N)) : std::nullopt;
      synergy = hand_synergy(grid(columns::hand_grip.left), grid(columns::hand_grip.right),
                             target ? &*target : nullptr);
    }
    add("hand_synergy", "", section, synergy);
  }

  void add_cancelled() {
    std::vector<std::string> columns;
    for (const Hand hand : kBothHands)
      for (const Column& column : columns::hand_push[hand]) columns.emplace_back(column);
    for (const std::string& column : columns)
      if (!has(column)) return;
    const Section section = select(columns);
    const auto pushes = [&](const columns::OfAxes& of) {
      const std::array axes{section.values(of[0]), section.values(of[1]), section.values(of[2])};
      std::vector<Vec3> push;
      for (std::size_t k = 0; k < section.rows.size(); ++k)
        push.emplace_back(axes[0][k], axes[1][k], axes[2][k]);
      return push;
    };
    add("cancelled_share", "%", section,
        cancelled_share(pushes(columns::hand_push.left), pushes(columns::hand_push.right),
                        section.weight_s));
  }

  void add_errors() {
    const Column& left = columns::hand_grip.left;
    const Column& right = columns::hand_grip.right;
    const Column& target_sum = columns::target_sum_force_N;
    if (has_target(target_sum)) {
      const Section section = select({target_sum, left, right});
      auto sum = section.values(left);
      const auto also = section.values(right);
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += also[k];
      add_error("sum", section, section.values(target_sum), sum);
    }
    for (const Hand hand : kBothHands) {
      const Column& target = columns::target_hand_grip[hand];
      if (!has_target(target)) continue;
      const Section section = select({target, columns::hand_grip[hand]});
      add_error(std::string(name_of(hand)), section, section.values(target),
                section.values(columns::hand_grip[hand]));
    }
  }
  /// The column is there; a trial of a session has it empty where nothing of the sort is asked.
  [[nodiscard]] bool has_target(std::string_view column) const {
    if (!has(column)) return false;
    const auto values = record_.signals().column(column);
    return phases_.size() == 0 || std::any_of(values.begin(), values.end(),
                                              [](double value) { return !std::isnan(value); });
  }
  void add_error(const std::string& channel, const Section& section,
                 const std::vector<double>& target, const std::vector<double>& actual) {
    measures_.push_back(
        make_measure("rmse", channel, "N", section, rmse(target, actual, section.weight_s)));
  }

  const Record& record_;
  const TwoHandsContext& context_;
  std::initializer_list<Phase> phases_;
  const Hand affected_;  ///< the left one where that is not known
  const Hand other_;
  const Section both_;
  std::vector<Measure> measures_;
};

}  // namespace

std::vector<Measure> score_hands(const Record& record, const TwoHandsContext& context,
                                 std::initializer_list<Phase> phases) {
  return TwoHandsScorer(record, context, phases).score();
}

TwoHandsContext hands_context(const Record& record) {
  TwoHandsContext context;
  context.affected.reset();
  if (const auto side = record.constant(columns::affected_hand))
    context.affected = *side == 0.0 ? Hand::left : Hand::right;
  context.coupled = record.constant(columns::platforms_coupled).value_or(0.0) != 0.0;
  context.resting_N.emplace();
  for (const Hand hand : kBothHands) {
    context.maximum_N[hand] = record.constant(columns::hand_maximum_force_N[hand]);
    (*context.resting_N)[hand] = record.constant(columns::hand_resting_force_N[hand]);
  }
  return context;
}

std::vector<Measure> score_two_hands(const Signals& signals, const TwoHandsContext& context) {
  if (!signals.has(columns::hand_grip.left) || !signals.has(columns::hand_grip.right)) return {};
  return score_hands(Record(signals), context, {});
}

}  // namespace isograsp::tasks
