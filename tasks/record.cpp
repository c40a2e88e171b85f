// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/record.hpp"

#include <algorithm>
#include <cmath>

#include "tasks/measures/motion.hpp"
#include "tasks/measures/weighted.hpp"

namespace isograsp {

std::vector<double> Section::values(std::span<const double> column) const {
  std::vector<double> chosen(rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) chosen[k] = column[rows[k]];
  return chosen;
}

namespace {

/// A phase number that nobody knows counts as paused: it is never scored.
Phase phase_from(double number) {
  if (std::isnan(number) || number < 0.0 || number > static_cast<double>(Phase::done) ||
      number != std::floor(number))
    return Phase::paused;
  return static_cast<Phase>(static_cast<int>(number));
}

}  // namespace

Record::Record(const Signals& signals) : signals_(signals) {
  const auto t_s = signals.column("t_s");
  const auto phase = signals.column("phase");
  const auto flags = signals.column("sample_flags");
  hold_s_ = hold_lengths(t_s);
  const std::size_t n = hold_s_.size();
  phase_.assign(n, Phase::active);
  flagged_.assign(n, false);
  missing_.assign(n, false);
  task_time_s_.assign(n, 0.0);
  const bool regular = is_regular(t_s);
  double elapsed_s = 0.0;
  std::size_t unpaused = 0;
  for (std::size_t row = 0; row < n; ++row) {
    if (!phase.empty()) phase_[row] = phase_from(phase[row]);
    if (!flags.empty()) {
      flagged_[row] = !(flags[row] == 0.0);  // an empty field is no clean bill of health either
      missing_[row] = std::isnan(flags[row]) ||
                      (static_cast<unsigned>(flags[row]) & unsigned{bit(SampleFlag::missing)}) != 0;
    }
    // On a regular grid a product has one rounding, a running sum as many as rows.
    task_time_s_[row] = regular ? static_cast<double>(unpaused) * hold_s_[row] : elapsed_s;
    if (paused(row)) continue;
    elapsed_s += hold_s_[row];
    ++unpaused;
  }
}

Section Record::select(std::initializer_list<Phase> phases,
                       std::initializer_list<std::string_view> columns, TimeAxis axis) const {
  return select(0, rows(), phases, columns, axis);
}

Section Record::select(std::size_t first, std::size_t last, std::initializer_list<Phase> phases,
                       std::initializer_list<std::string_view> columns, TimeAxis axis) const {
  Section section;
  std::vector<char> usable(last - first);
  for (std::size_t row = first; row < last; ++row) usable[row - first] = counts(row);
  for (const auto name : columns) {
    if (!signals_.has(name)) {
      section.reason = "the column " + std::string(name) + " is missing";
      return section;
    }
    const auto column = signals_.column(name);
    for (std::size_t row = first; row < last; ++row)
      usable[row - first] &= static_cast<char>(!std::isnan(column[row]));
  }
  section.rows.reserve(last - first);
  for (std::size_t row = first; row < last; ++row) {
    const bool in_scope = phases.size() == 0 || paused(row) ||
                          std::find(phases.begin(), phases.end(), phase_[row]) != phases.end();
    if (!in_scope) continue;
    if (usable[row - first])
      section.rows.push_back(row);
    else
      ++section.excluded;
  }
  section.t_s = section.values(axis == TimeAxis::task ? task_time_s_ : signals_.column("t_s"));
  section.weight_s = section.values(hold_s_);
  return section;
}

Section Record::select_position(std::size_t first, std::size_t last,
                                std::initializer_list<Phase> phases, TimeAxis axis) const {
  if (signals_.has("actual_z_m"))
    return select(first, last, phases, {"actual_x_m", "actual_y_m", "actual_z_m"}, axis);
  return select(first, last, phases, {"actual_x_m", "actual_y_m"}, axis);
}

std::optional<double> Record::constant(std::string_view column) const {
  for (const double value : signals_.column(column))
    if (!std::isnan(value)) return value;
  return std::nullopt;
}

std::optional<double> Record::known_delay_s() const {
  const auto device_s = constant("device_delay_s");
  if (!device_s) return std::nullopt;
  return *device_s + constant("display_delay_s").value_or(0.0);
}

Measure make_measure(std::string name, std::string channel, std::string unit,
                     const Section& section, Computed computed) {
  Measure measure;
  measure.name = std::move(name);
  measure.channel = std::move(channel);
  measure.unit = std::move(unit);
  measure.samples = static_cast<std::int64_t>(section.rows.size());
  measure.excluded = section.excluded;
  if (!section.reason.empty()) {
    measure.reason = section.reason;
  } else if (section.rows.empty()) {
    measure.reason = "no samples";
  } else if (computed.value && !std::isfinite(*computed.value)) {
    measure.reason = "the result is not finite";
  } else {
    measure.value = computed.value;
    measure.reason = std::move(computed.reason);
  }
  return measure;
}

Computed mean_over(const Section& section, std::span<const double> column) {
  return weighted_mean_of(section.weight_s, [&](std::size_t k) { return column[section.rows[k]]; });
}

namespace {

std::vector<std::span<const double>> position_columns(const Signals& signals) {
  std::vector<std::span<const double>> axes{signals.column("actual_x_m"),
                                            signals.column("actual_y_m")};
  if (signals.has("actual_z_m")) axes.push_back(signals.column("actual_z_m"));
  return axes;
}

}  // namespace

std::vector<Vec3> path_of(const Section& section, const Signals& signals) {
  const auto axes = position_columns(signals);
  std::vector<Vec3> path_m(section.rows.size(), Vec3::Zero());
  for (std::size_t k = 0; k < path_m.size(); ++k)
    for (std::size_t axis = 0; axis < axes.size(); ++axis)
      path_m[k][static_cast<Eigen::Index>(axis)] = axes[axis][section.rows[k]];
  return path_m;
}

Measure path_length(const Section& motion, const Signals& signals) {
  return make_measure("path_length", "position", "m", motion,
                      motion.rows.empty() ? 0.0 : path_length(path_of(motion, signals)));
}

std::vector<UniformSamples> position_of(const Section& section, const Signals& signals) {
  std::vector<UniformSamples> position;
  for (const auto& axis : position_columns(signals))
    position.push_back(on_uniform_grid(section.t_s, section.values(axis)));
  return position;
}

}  // namespace isograsp
