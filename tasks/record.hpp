// SPDX-License-Identifier: GPL-3.0-or-later
// Inside tasks/ only: a trial's signals as the measures see them - which rows count, for how long,
// and at what task time (it stands still while paused).
#pragma once

#include <initializer_list>
#include <string_view>

#include "core/measure.hpp"
#include "core/signals.hpp"
#include "core/spatial.hpp"
#include "statistics/samples.hpp"
#include "tasks/task.hpp"

namespace isograsp::tasks {

/// Rows chosen for a measure, without the excluded ones, and the columns that it may read there.
struct Section {
  std::vector<std::size_t> rows;
  std::vector<double> t_s;       ///< one per row
  std::vector<double> weight_s;  ///< hold length of each row
  std::int64_t excluded = 0;
  Text reason;  ///< why there is nothing: a column is absent
  const Signals* signals = nullptr;
  std::vector<std::string> columns;  ///< those that have a value in each of the rows

  /// The column's values in these rows. One that was not selected reads as empty: whether its
  /// fields have a value was not looked at.
  [[nodiscard]] std::vector<double> values(std::string_view column) const;
  [[nodiscard]] bool has(std::string_view column) const;
};

class Record {
 public:
  /// Refers to `signals`, which must outlive it.
  explicit Record(const Signals& signals);

  [[nodiscard]] const Signals& signals() const noexcept { return signals_; }
  [[nodiscard]] std::size_t rows() const noexcept { return hold_s_.size(); }
  [[nodiscard]] double hold_s(std::size_t row) const { return hold_s_[row]; }
  /// Sum of the holds of all unpaused rows before this one [s].
  [[nodiscard]] double task_time_s(std::size_t row) const { return task_time_s_[row]; }
  [[nodiscard]] std::span<const double> task_times_s() const noexcept { return task_time_s_; }
  /// `active` if there is no column `phase`.
  [[nodiscard]] Phase phase(std::size_t row) const { return phase_[row]; }
  [[nodiscard]] bool paused(std::size_t row) const { return phase_[row] == Phase::paused; }
  /// Not paused, and every finger's sample in it was received and good.
  [[nodiscard]] bool counts(std::size_t row) const { return !flagged_[row] && !paused(row); }
  /// A finger had no value in this row, not even a held one.
  [[nodiscard]] bool missing(std::size_t row) const { return missing_[row]; }

  enum class TimeAxis { task, record };
  /// Rows in one of `phases` in which all `columns` have a value; paused, flagged and empty ones
  /// are excluded and counted. No phases: every row. Without rows and with a reason if a column is
  /// missing or unusable().
  [[nodiscard]] Section select(std::initializer_list<Phase> phases,
                               const std::vector<std::string>& columns,
                               TimeAxis axis = TimeAxis::task) const;
  /// The same for the rows in [first, last).
  [[nodiscard]] Section select(std::size_t first, std::size_t last,
                               std::initializer_list<Phase> phases,
                               const std::vector<std::string>& columns,
                               TimeAxis axis = TimeAxis::task) const;
  /// Rows in [first, last) in which the object's position is known: x and y, and z if recorded.
  [[nodiscard]] Section select_position(std::size_t first, std::size_t last,
                                        std::initializer_list<Phase> phases,
                                        TimeAxis axis = TimeAxis::task) const;
  /// Why nothing can be computed with these columns in the rows of the section: their squares and
  /// products would leave the range of numbers. Empty: it can.
  [[nodiscard]] Text unusable(const Section& section,
                              const std::vector<std::string>& columns) const;
  /// First value of a column that is constant over the trial.
  [[nodiscard]] std::optional<double> constant(std::string_view column) const;
  /// From what happens to what is recorded, and from the target to the eye where that was measured:
  /// `device_delay_s` + `display_delay_s` [s]. Nothing: that of the device is not known.
  [[nodiscard]] std::optional<double> known_delay_s() const;

 private:
  const Signals& signals_;
  std::vector<double> hold_s_;
  std::vector<double> task_time_s_;
  std::vector<Phase> phase_;
  std::vector<bool> flagged_;
  std::vector<bool> missing_;
  Text unusable_;  ///< why no measure at all can be computed; empty: they can
};

/// Puts a computed value on record. A section that could not be made gives its reason.
[[nodiscard]] Measure make_measure(std::string name, std::string channel, std::string unit,
                                   const Section& section, statistics::Computed computed);

/// sum of the column's value times hold / sum of holds, over the section.
[[nodiscard]] statistics::Computed mean_over(const Section& section, std::string_view column);
/// Positions of the object in the rows of the section [m]; z = 0 where it was not selected.
[[nodiscard]] std::vector<Vec3> path_of(const Section& section);
/// The measure path_length over a section of select_position().
[[nodiscard]] Measure path_length(const Section& motion);
/// The position on a grid: x and y, and z if selected.
[[nodiscard]] std::vector<statistics::UniformSamples> position_of(const Section& section);

}  // namespace isograsp::tasks
