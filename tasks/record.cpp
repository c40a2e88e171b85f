// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/record.hpp"

#include <algorithm>
#include <cmath>

#include "hand/columns.hpp"
#include "statistics/weighted.hpp"
#include "tasks/measure_version.hpp"
#include "tasks/measures/motion.hpp"
#include "tasks/reasons/reasons.hpp"

namespace isograsp::tasks {

namespace {

std::vector<double> values_in(const std::vector<std::size_t>& rows,
                              std::span<const double> column) {
  std::vector<double> chosen(rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) chosen[k] = column[rows[k]];
  return chosen;
}

/// A phase number that nobody knows counts as paused: it is never scored.
Phase phase_from(double number) {
  if (std::isnan(number) || number < 0.0 || number > static_cast<double>(Phase::done) ||
      number != std::floor(number))
    return Phase::paused;
  return static_cast<Phase>(static_cast<int>(number));
}

/// Measures multiply up to four values with each other: of sizes beyond these, products are 0 or
/// infinite where the measure itself is neither.
constexpr double kLeastSize = 1e-60;
constexpr double kMostSize = 1e60;

Text out_of_range(double size) {
  if (size > kMostSize) return "the values are too large to compute with"_text;
  if (size > 0.0 && size < kLeastSize) return "the values are too small to compute with"_text;
  return {};
}

/// Rows of a uniform grid: at most a hundred for each row of the record, or the number below, which
/// is an hour at 1 kHz and more.
constexpr double kMostGridRows = 5e6;
constexpr double kMostGridRowsPerRow = 100.0;

/// Why the times cannot be brought onto a grid of their usual step; empty: they can.
Text no_grid(std::span<const double> t_s) {
  if (t_s.size() < 2) return {};
  const double rows = (t_s.back() - t_s.front()) / statistics::median_step(t_s);
  const double most =
      std::max(kMostGridRows, kMostGridRowsPerRow * static_cast<double>(t_s.size()));
  if (rows <= most) return {};
  return "the gaps between the times are too long for their usual step"_text;
}

/// Why times, or what is known of hand and device beside the signals, cannot be used; empty: they
/// can.
Text unusable_context(const Signals& signals, std::span<const double> hold_s) {
  for (const double length_s : hold_s)
    if (Text why = out_of_range(length_s); !why.empty()) return why;
  if (Text why = no_grid(signals.column(columns::t_s)); !why.empty()) return why;
  for (const std::string_view name :
       {columns::t_s, columns::resting_force_N, columns::maximum_force_N, columns::noise_sd_N,
        columns::resolution_N, columns::device_delay_s, columns::display_delay_s})
    for (const double value : signals.column(name))  // these may be close to zero
      if (std::abs(value) > kMostSize) return out_of_range(std::abs(value));
  return {};
}

}  // namespace

Record::Record(const Signals& signals) : signals_(signals) {
  const auto t_s = signals.column(columns::t_s);
  const auto phase = signals.column(columns::phase);
  const auto flags = signals.column(columns::sample_flags);
  hold_s_ = statistics::hold_lengths(t_s);
  const std::size_t n = hold_s_.size();
  phase_.assign(n, Phase::active);
  flagged_.assign(n, false);
  missing_.assign(n, false);
  task_time_s_.assign(n, 0.0);
  const bool regular = statistics::is_regular(t_s);
  double elapsed_s = 0.0;
  std::size_t unpaused = 0;
  for (std::size_t row = 0; row < n; ++row) {
    if (!phase.empty()) phase_[row] = phase_from(phase[row]);
    if (!flags.empty()) {
      flagged_[row] = !(flags[row] == 0.0);  // an empty field does not say that all was well
      missing_[row] = std::isnan(flags[row]) ||
                      (static_cast<unsigned>(flags[row]) & unsigned{bit(SampleFlag::missing)}) != 0;
    }
    // On a regular grid a product is rounded once, but a running sum once in each row.
    task_time_s_[row] = regular ? static_cast<double>(unpaused) * hold_s_[row] : elapsed_s;
    if (paused(row)) continue;
    elapsed_s += hold_s_[row];
    ++unpaused;
  }
  unusable_ = unusable_context(signals, hold_s_);
}

bool Section::has(std::string_view column) const {
  return std::find(columns.begin(), columns.end(), column) != columns.end();
}

std::vector<double> Section::values(std::string_view column) const {
  if (!has(column)) return std::vector<double>(rows.size(), std::nan(""));
  return values_in(rows, signals->column(column));
}

Text Record::unusable(const Section& section, const std::vector<std::string>& columns) const {
  if (!unusable_.empty()) return unusable_;
  double largest = 0.0;
  for (const std::string& name : columns) {
    const auto column = signals_.column(name);
    if (column.empty()) continue;
    for (const std::size_t row : section.rows) largest = std::max(largest, std::abs(column[row]));
  }
  return out_of_range(largest);
}

Section Record::select(std::initializer_list<Phase> phases, const std::vector<std::string>& columns,
                       TimeAxis axis) const {
  return select(0, rows(), phases, columns, axis);
}

Section Record::select(std::size_t first, std::size_t last, std::initializer_list<Phase> phases,
                       const std::vector<std::string>& columns, TimeAxis axis) const {
  Section section;
  std::vector<char> usable(last - first);
  for (std::size_t row = first; row < last; ++row) usable[row - first] = counts(row);
  for (const std::string& name : columns) {
    if (!signals_.has(name)) {
      section.reason = kColumnMissing(name);
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
  if (Text why = unusable(section, columns); !why.empty()) {
    section = {};
    section.reason = std::move(why);
    return section;
  }
  section.t_s = values_in(section.rows,
                          axis == TimeAxis::task ? task_time_s_ : signals_.column(columns::t_s));
  section.weight_s = values_in(section.rows, hold_s_);
  section.signals = &signals_;
  section.columns = columns;
  return section;
}

Section Record::select_position(std::size_t first, std::size_t last,
                                std::initializer_list<Phase> phases, TimeAxis axis) const {
  const auto& [x, y, z] = columns::actual_position;
  if (signals_.has(z)) return select(first, last, phases, {x, y, z}, axis);
  return select(first, last, phases, {x, y}, axis);
}

std::optional<double> Record::constant(std::string_view column) const {
  for (const double value : signals_.column(column))
    if (!std::isnan(value)) return value;
  return std::nullopt;
}

std::optional<double> Record::known_delay_s() const {
  const auto device_s = constant(columns::device_delay_s);
  if (!device_s) return std::nullopt;
  return *device_s + constant(columns::display_delay_s).value_or(0.0);
}

Measure make_measure(std::string name, std::string channel, std::string unit,
                     const Section& section, statistics::Computed computed) {
  Measure measure;
  Text why;
  measure.version = measure_version(name);
  measure.name = std::move(name);
  measure.channel = std::move(channel);
  measure.unit = std::move(unit);
  measure.samples = static_cast<std::int64_t>(section.rows.size());
  measure.excluded = section.excluded;
  if (!section.reason.empty()) {
    why = section.reason;
  } else if (section.rows.empty()) {
    why = "no samples"_text;
  } else if (computed.value && !std::isfinite(*computed.value)) {
    why = "the result is not finite"_text;
  } else {
    measure.value = computed.value;
    if (measure.value) *measure.value += 0.0;  // 0 has no sign
    why = std::move(computed.reason);
  }
  measure.reason = english(why);
  return measure;
}

statistics::Computed mean_over(const Section& section, std::string_view column) {
  const auto values = section.values(column);
  return statistics::weighted_mean_of(section.weight_s, [&](std::size_t k) { return values[k]; });
}

namespace {

/// x, y, and z if selected, in the rows of the section.
std::vector<std::vector<double>> position_axes(const Section& section) {
  const auto& [x, y, z] = columns::actual_position;
  std::vector<std::vector<double>> axes{section.values(x), section.values(y)};
  if (section.has(z)) axes.push_back(section.values(z));
  return axes;
}

}  // namespace

std::vector<Vec3> path_of(const Section& section) {
  const auto axes = position_axes(section);
  std::vector<Vec3> path_m(section.rows.size(), Vec3::Zero());
  for (std::size_t k = 0; k < path_m.size(); ++k)
    for (std::size_t axis = 0; axis < axes.size(); ++axis)
      path_m[k][static_cast<Eigen::Index>(axis)] = axes[axis][k];
  return path_m;
}

Measure path_length(const Section& motion) {
  return make_measure("path_length", "position", "m", motion,
                      motion.rows.empty() ? 0.0 : path_length(path_of(motion)));
}

std::vector<statistics::UniformSamples> position_of(const Section& section) {
  std::vector<statistics::UniformSamples> position;
  for (const auto& axis : position_axes(section))
    position.push_back(statistics::on_uniform_grid(section.t_s, axis));
  return position;
}

}  // namespace isograsp::tasks
