// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of a record of two hands (docs/measures.md, Two hands).
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tasks/measures/coordination/coupling.hpp"
#include "tasks/measures/coordination/two_hands.hpp"
#include "tasks/measures/delay.hpp"
#include "tasks/measures/error.hpp"
#include "tasks/record.hpp"
#include "tasks/score.hpp"

namespace isograsp::tasks {

namespace {

constexpr std::string_view kForceEnding = "_force_N";
constexpr const char* kTargetOfSum = "target_sum_force_N";

std::string force_of(Hand hand) {
  return std::string(name_of(hand)) + std::string(kForceEnding);
}

class TwoHandsScorer {
 public:
  TwoHandsScorer(const Record& record, const TwoHandsContext& context)
      : record_(record),
        context_(context),
        other_(context.affected == Hand::left ? Hand::right : Hand::left),
        both_(select({force_of(Hand::left), force_of(Hand::right)})) {}

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
    return record_.select({}, columns, Record::TimeAxis::record);
  }
  [[nodiscard]] bool has(const std::string& column) const { return record_.signals().has(column); }
  /// The channel says which hand is the affected one.
  void add(const char* name, const char* unit, const Section& section,
           const statistics::Computed& computed) {
    measures_.push_back(
        make_measure(name, std::string(name_of(context_.affected)), unit, section, computed));
  }

  /// Both forces stand beside their share: it also rises when the other hand weakens.
  void add_shares() {
    const auto affected = mean_over(both_, force_of(context_.affected));
    const auto other = mean_over(both_, force_of(other_));
    for (const auto& [hand, mean] : {std::pair(context_.affected, affected), {other_, other}})
      measures_.push_back(make_measure("mean_force", std::string(name_of(hand)), "N", both_, mean));
    HandShare share{affected, affected};
    statistics::Computed effort = affected;
    if (affected.value && other.value) {
      share = hand_share(*affected.value, *other.value);
      effort = of_effort(*affected.value, *other.value);
    }
    add("share_affected", "%", both_, share.affected_percent);
    add("asymmetry", "%", both_, share.asymmetry_percent);
    add("effort_share_affected", "%", both_, effort);
  }
  [[nodiscard]] statistics::Computed of_effort(double affected_N, double other_N) const {
    const auto& left_N = context_.maximum_left_N;
    const auto& right_N = context_.maximum_right_N;
    if (!left_N || !right_N) return "the maximum of each hand is not known"_text;
    const bool of_left = context_.affected == Hand::left;
    return effort_share(affected_N, other_N, of_left ? *left_N : *right_N,
                        of_left ? *right_N : *left_N);
  }

  void add_coordination() {
    const auto affected = both_.values(force_of(context_.affected));
    const auto other = both_.values(force_of(other_));
    add("hand_correlation", "", both_, correlation(affected, other, both_.weight_s));
    constexpr Words kTooShort = "fewer than two samples"_text;
    LagPeak peak{kTooShort, kTooShort};
    if (both_.rows.size() >= 2)
      peak = lag_peak(statistics::on_uniform_grid(both_.t_s, other),
                      statistics::on_uniform_grid(both_.t_s, affected));
    add("hand_lag", "s", both_, peak.lag_s);
    add("hand_lag_correlation", "", both_, peak.correlation);
  }

  void add_synergy() {
    std::vector<std::string> columns{force_of(Hand::left), force_of(Hand::right)};
    const bool follow = has(kTargetOfSum);
    if (follow) columns.emplace_back(kTargetOfSum);
    const Section section = select(columns);
    statistics::Computed synergy = "too few samples"_text;
    if (section.rows.size() >= 2) {
      const auto grid = [&](const std::string& column) {
        return statistics::on_uniform_grid(section.t_s, section.values(column));
      };
      const auto target = follow ? std::optional(grid(kTargetOfSum)) : std::nullopt;
      synergy = hand_synergy(grid(columns[0]), grid(columns[1]), target ? &*target : nullptr);
    }
    add("hand_synergy", "", section, synergy);
  }

  void add_cancelled() {
    constexpr std::array kAxes{"x", "y", "z"};
    std::vector<std::string> columns;
    for (const Hand hand : {Hand::left, Hand::right})
      for (const char* axis : kAxes)
        columns.push_back(std::string(name_of(hand)) + "_push_" + axis + "_N");
    for (const std::string& column : columns)
      if (!has(column)) return;
    const Section section = select(columns);
    const auto pushes = [&](std::size_t first) {
      const std::array axes{section.values(columns[first]), section.values(columns[first + 1]),
                            section.values(columns[first + 2])};
      std::vector<Vec3> push;
      for (std::size_t k = 0; k < section.rows.size(); ++k)
        push.emplace_back(axes[0][k], axes[1][k], axes[2][k]);
      return push;
    };
    add("cancelled_share", "%", section, cancelled_share(pushes(0), pushes(3), section.weight_s));
  }

  void add_errors() {
    const std::string left = force_of(Hand::left);
    const std::string right = force_of(Hand::right);
    if (has(kTargetOfSum)) {
      const Section section = select({kTargetOfSum, left, right});
      auto sum = section.values(left);
      const auto also = section.values(right);
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += also[k];
      add_error("sum", section, section.values(kTargetOfSum), sum);
    }
    for (const Hand hand : {Hand::left, Hand::right}) {
      const std::string target = "target_" + force_of(hand);
      if (!has(target)) continue;
      const Section section = select({target, force_of(hand)});
      add_error(std::string(name_of(hand)), section, section.values(target),
                section.values(force_of(hand)));
    }
  }
  void add_error(const std::string& channel, const Section& section,
                 const std::vector<double>& target, const std::vector<double>& actual) {
    measures_.push_back(
        make_measure("rmse", channel, "N", section, rmse(target, actual, section.weight_s)));
  }

  const Record& record_;
  const TwoHandsContext& context_;
  const Hand other_;
  const Section both_;
  std::vector<Measure> measures_;
};

}  // namespace

std::vector<Measure> score_two_hands(const Signals& signals, const TwoHandsContext& context) {
  if (!signals.has(force_of(Hand::left)) || !signals.has(force_of(Hand::right))) return {};
  const Record record(signals);
  return TwoHandsScorer(record, context).score();
}

}  // namespace isograsp::tasks
