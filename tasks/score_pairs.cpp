// SPDX-License-Identifier: GPL-3.0-or-later
// Default measures without a task: every target_X with its actual_X, whole record
// (docs/measures.md).
#include <algorithm>
#include <cmath>
#include <string_view>

#include "hand/columns.hpp"
#include "tasks/measures/delay.hpp"
#include "tasks/measures/error.hpp"
#include "tasks/measures/regularity.hpp"
#include "tasks/measures/smoothness.hpp"
#include "tasks/record.hpp"
#include "tasks/score.hpp"

namespace isograsp::tasks {

namespace {

constexpr Words kPairTooShort = "fewer than two samples"_text;

/// "force_N" is the channel "force" in "N".
struct Quantity {
  std::string channel;
  std::string unit;
};
Quantity quantity_of(std::string_view column) {
  const auto underscore = column.rfind('_');
  if (underscore == std::string_view::npos) return {std::string(column), ""};
  std::string unit(column.substr(underscore + 1));
  if (unit == "mps") unit = "m/s";
  if (unit == "radps") unit = "rad/s";
  return {std::string(column.substr(0, underscore)), unit};
}

void score_pair(const Record& record, const std::string& quantity_column,
                std::vector<Measure>& measures) {
  const std::string target_column = std::string(columns::kTarget) + quantity_column;
  const std::string actual_column = std::string(columns::kActual) + quantity_column;
  const Quantity quantity = quantity_of(quantity_column);
  const Section both = record.select({}, {target_column, actual_column}, Record::TimeAxis::record);
  const auto target = both.values(target_column);
  const auto actual = both.values(actual_column);
  const auto& weight_s = both.weight_s;
  const auto add = [&](const char* name, const std::string& unit,
                       const statistics::Computed& computed) {
    measures.push_back(make_measure(name, quantity.channel, unit, both, computed));
  };
  // Two measures do not use the target: they count every row that has an actual value.
  const auto target_values = record.signals().column(target_column);
  const bool target_has_gaps = std::any_of(target_values.begin(), target_values.end(),
                                           [](double value) { return std::isnan(value); });
  const Section alone =
      target_has_gaps ? record.select({}, {actual_column}, Record::TimeAxis::record) : both;
  const auto all_actual = alone.values(actual_column);
  const auto add_alone = [&](const char* name, const std::string& unit,
                             const statistics::Computed& computed) {
    measures.push_back(make_measure(name, quantity.channel, unit, alone, computed));
  };
  add("rmse", quantity.unit, rmse(target, actual, weight_s));
  add("mae", quantity.unit, mae(target, actual, weight_s));
  add("constant_error", quantity.unit, constant_error(target, actual, weight_s));
  add("time_in_range", "%", time_in_range(target, actual, weight_s));
  add_alone("cv", "%", cv(alone.t_s, all_actual));
  if (alone.rows.size() < 2)
    add_alone("sample_entropy", "", kPairTooShort);
  else
    add_alone("sample_entropy", "",
              sample_entropy(statistics::on_uniform_grid(alone.t_s, all_actual).values));
  if (both.rows.size() < 2)
    add("lag", "s", kPairTooShort);
  else
    add("lag", "s",
        lag(statistics::on_uniform_grid(both.t_s, target),
            statistics::on_uniform_grid(both.t_s, actual)));
}

void score_motion(const Record& record, std::vector<Measure>& measures) {
  const Signals& signals = record.signals();
  if (!signals.has(columns::actual_position[0]) || !signals.has(columns::actual_position[1]))
    return;
  const Section motion = record.select_position(0, record.rows(), {}, Record::TimeAxis::record);
  statistics::Computed smooth = kPairTooShort;
  statistics::Computed jerk = kPairTooShort;
  if (motion.rows.size() >= 2) {
    const statistics::UniformSamples speed = speed_of(position_of(motion));
    smooth = sparc(speed);
    jerk = ldlj(speed);
  }
  measures.push_back(make_measure("sparc", "position", "", motion, smooth));
  measures.push_back(make_measure("ldlj", "position", "", motion, jerk));
}

}  // namespace

std::vector<Measure> score_pairs(const Signals& signals) {
  const Record record(signals);
  std::vector<Measure> measures;
  for (const std::string& name : signals.names()) {
    if (!name.starts_with(columns::kTarget)) continue;
    const std::string quantity_column = name.substr(columns::kTarget.size());
    if (!quantity_column.empty() && signals.has(std::string(columns::kActual) + quantity_column))
      score_pair(record, quantity_column, measures);
  }
  score_motion(record, measures);
  return measures;
}

}  // namespace isograsp::tasks
