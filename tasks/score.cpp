// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of the force tasks and of free handling. Definitions: docs/measures.md.
#include "tasks/score.hpp"

#include <algorithm>
#include <limits>

#include "tasks/measures/delay.hpp"
#include "tasks/measures/error.hpp"
#include "tasks/measures/sine.hpp"
#include "tasks/record.hpp"

namespace isograsp {

std::vector<Measure> score(const TaskSpec& spec, const Signals& signals) {
  const Record record(signals);
  if (const auto* maximum = std::get_if<MaximumSpec>(&spec.kind))
    return score_maximum(*maximum, record);
  if (const auto* tracking = std::get_if<ForceTrackingSpec>(&spec.kind))
    return score_force_tracking(*tracking, record);
  if (const auto* poses = std::get_if<PoseTargetsSpec>(&spec.kind))
    return score_pose_targets(*poses, record);
  if (std::holds_alternative<ObserveSpec>(spec.kind)) return score_observe(record);
  if (std::holds_alternative<RestSpec>(spec.kind)) return score_rest(record);
  return {};
}

std::vector<Measure> score_rest(const Record& record) {
  struct Axis {
    const char* name;
    const char* unit;
  };
  constexpr Axis kAxes[] = {{"fx", "N"},  {"fy", "N"},  {"fz", "N"},
                            {"tx", "Nm"}, {"ty", "Nm"}, {"tz", "Nm"}};
  std::vector<Measure> measures;
  const auto add = [&](const std::string& channel, const std::string& column, const char* unit) {
    const Section rest = record.select({Phase::active}, {column});
    measures.push_back(make_measure("resting_force", channel, unit, rest,
                                    mean_over(rest, record.signals().column(column))));
  };
  add("grip", "actual_force_N", "N");
  for (const Finger finger : kFingers)
    for (const Axis& axis : kAxes) {
      const std::string channel = std::string(name_of(finger)) + "_" + axis.name;
      add(channel, channel + "_" + axis.unit, axis.unit);
    }
  return measures;
}

std::vector<Measure> score_maximum(const MaximumSpec& spec, const Record& record) {
  const auto grip = record.signals().column("actual_force_N");
  const Section squeeze = record.select({Phase::active}, {"actual_force_N"});
  // A window must be uninterrupted, so this list keeps the rows that do not count.
  std::vector<double> force;
  std::vector<double> weight_s;
  std::vector<bool> valid;
  double peak = -std::numeric_limits<double>::infinity();
  if (!grip.empty())
    for (std::size_t row = 0; row < record.rows(); ++row) {
      if (record.phase(row) != Phase::active && !record.paused(row)) continue;
      force.push_back(grip[row]);
      weight_s.push_back(record.hold_s(row));
      valid.push_back(record.counts(row) && !std::isnan(grip[row]));
      if (valid.back()) peak = std::max(peak, grip[row]);
    }
  const Computed total = best_moving_mean(force, weight_s, valid, spec.window_s);
  Computed above_rest = total;
  const auto resting = record.constant("resting_force_N");
  if (total.value && resting)
    above_rest = *total.value - *resting;
  else if (total.value)
    above_rest = "the resting force was not measured";
  return {make_measure("maximum_force", "grip", "N", squeeze, above_rest),
          make_measure("maximum_force_total", "grip", "N", squeeze, total),
          make_measure("peak_force", "grip", "N", squeeze, peak)};
}

std::vector<Measure> score_force_tracking(const ForceTrackingSpec& spec, const Record& record) {
  const Section active = record.select({Phase::active}, {"target_force_N", "actual_force_N"});
  const auto target = active.reason.empty()
                          ? active.values(record.signals().column("target_force_N"))
                          : std::vector<double>{};
  const auto actual = active.reason.empty()
                          ? active.values(record.signals().column("actual_force_N"))
                          : std::vector<double>{};
  const auto& weight_s = active.weight_s;
  const double noise_N = record.constant("noise_sd_N").value_or(0.0);
  const Computed lag_s = target.size() < 2 ? Computed("fewer than two samples")
                                           : lag(on_uniform_grid(active.t_s, target),
                                                 on_uniform_grid(active.t_s, actual));
  const auto measure = [&](const char* name, const char* unit, const Computed& computed) {
    return make_measure(name, "force", unit, active, computed);
  };
  return {measure("rmse", "N", rmse(target, actual, weight_s)),
          measure("relative_rmse", "%", relative_rmse(target, actual, weight_s)),
          measure("mae", "N", mae(target, actual, weight_s)),
          measure("constant_error", "N", constant_error(target, actual, weight_s)),
          measure("time_in_range", "%", time_in_range(target, actual, weight_s, noise_N)),
          measure("lag", "s", lag_s),
          measure("gain", "", gain(active.t_s, target, actual, spec.waveform.frequency_Hz))};
}

namespace {

/// Time in which any finger touches [s]; a finger that the scene lacks has an empty column.
Computed contact_time(const Section& section, const Signals& signals) {
  double touching_s = 0.0;
  for (std::size_t i = 0; i < section.rows.size(); ++i) {
    const bool touches = std::any_of(kFingers.begin(), kFingers.end(), [&](Finger finger) {
      const auto column = signals.column("contact_" + std::string(name_of(finger)));
      return !column.empty() && column[section.rows[i]] > 0.5;
    });
    if (touches) touching_s += section.weight_s[i];
  }
  return touching_s;
}

}  // namespace

std::vector<Measure> score_observe(const Record& record) {
  const Signals& signals = record.signals();
  const auto grip = signals.column("actual_force_N");
  const Section force = record.select({Phase::active}, {"actual_force_N"});
  const Section motion = record.select_position(0, record.rows(), {Phase::active});
  Section contact = record.select({Phase::active}, {});
  const bool known = std::any_of(kFingers.begin(), kFingers.end(), [&](Finger finger) {
    return signals.has("contact_" + std::string(name_of(finger)));
  });
  if (!known) contact.reason = "the columns contact_* are missing";
  Computed most = "no samples";
  for (const std::size_t row : force.rows)
    if (!most.value || grip[row] > *most.value) most = grip[row];
  return {make_measure("mean_grip", "grip", "N", force, mean_over(force, grip)),
          make_measure("peak_force", "grip", "N", force, most),
          make_measure("path_length", "position", "m", motion,
                       motion.rows.empty() ? 0.0 : path_length_of(motion, signals)),
          make_measure("contact_time", "contact", "s", contact, contact_time(contact, signals))};
}

}  // namespace isograsp
