// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand/finger_forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/csv.hpp"
#include "hand/columns.hpp"

namespace isograsp {

namespace {
/// Fx Fy Fz Tx Ty Tz of a finger.
const Column& standard_column(Finger finger, std::size_t axis) {
  const std::size_t f = index_of(finger);
  return axis < 3 ? columns::finger_force[f][axis] : columns::finger_torque[f][axis - 3];
}
}  // namespace

std::string FingerForcesReader::column_of(Finger finger, std::size_t axis) const {
  return prefix_ + std::string(standard_column(finger, axis));
}

Result<FingerForcesReader> FingerForcesReader::open(const std::string& path,
                                                    std::array<bool, kFingerCount> required) {
  auto table = open_csv(path);
  if (!table) return table.error();
  return open(*std::move(table), required);
}

Result<FingerForcesReader> FingerForcesReader::open(std::unique_ptr<TableReader> table,
                                                    std::array<bool, kFingerCount> required,
                                                    std::string prefix) {
  FingerForcesReader reader(std::move(table), std::move(prefix));
  const auto time = reader.table_->find(columns::t_s);
  if (!time)
    return reader.table_->error_here(columns::t_s, "the column is missing"_text,
                                     "add the time of each row in seconds"_text);
  reader.time_ = *time;
  reader.fields_.resize(reader.table_->columns().size());
  for (const Finger finger : kFingers) {
    const std::size_t f = index_of(finger);
    auto& axes = reader.axes_[f];
    int forces = 0;
    for (std::size_t axis = 0; axis < 6; ++axis) {
      axes[axis] = reader.table_->find(reader.column_of(finger, axis));
      if (axis < 3 && axes[axis]) ++forces;
    }
    for (std::size_t axis = 0; axis < 6; ++axis) {
      const bool needed = axis < 3 && (forces > 0 || required[f] || axes[3] || axes[4] || axes[5]);
      if (needed && !axes[axis])
        return reader.table_->error_here(reader.column_of(finger, axis),
                                         "the column is missing"_text, "add the column"_text);
    }
  }
  // Other columns are allowed; one that looks like a finger's but is none of a trial is taken for a
  // mistake.
  const std::size_t before = reader.prefix_.size();
  for (const auto& name : reader.table_->columns())
    for (const auto finger : kFingerNames)
      if (name.starts_with(reader.prefix_ + std::string(finger) + "_") &&
          columns::find(std::string_view(name).substr(before)) == nullptr)
        return reader.table_->error_here(
            name, "unknown column of a finger"_text,
            "name it like thumb_fx_N or thumb_tx_Nm, or remove it"_text);
  return reader;
}

Result<bool> FingerForcesReader::next(FingerForcesRow& row) {
  const auto more = table_->next(fields_);
  if (!more || !*more) return more;
  row.t_s = fields_[time_];
  if (std::isnan(row.t_s))
    return table_->error_here(columns::t_s, "the time is empty"_text, "give every row a time"_text);
  if (previous_t_s_ && row.t_s <= *previous_t_s_)
    return table_->error_here(columns::t_s, "time does not increase"_text,
                              "sort the rows and remove repeats"_text);
  previous_t_s_ = row.t_s;
  for (const Finger finger : kFingers) {
    const std::size_t f = index_of(finger);
    row.present[f] = false;
    row.wrench_C[f] = {};
    if (!has(finger)) continue;
    int columns = 0;
    int empty = 0;
    std::size_t an_empty_axis = 0;
    for (std::size_t axis = 0; axis < 6; ++axis) {
      const auto& column = axes_[f][axis];
      if (!column) continue;
      const double value = fields_[*column];
      ++columns;
      if (std::isnan(value)) {
        ++empty;
        an_empty_axis = axis;
        continue;
      }
      auto& part = axis < 3 ? row.wrench_C[f].force : row.wrench_C[f].torque;
      part[static_cast<Eigen::Index>(axis % 3)] = value;
    }
    if (empty > 0 && empty < columns)
      return table_->error_here(column_of(finger, an_empty_axis),
                                "the field is empty while others of this finger are not"_text,
                                "give the value, or leave all fields of the finger empty"_text);
    row.present[f] = empty == 0;
    if (empty > 0) row.wrench_C[f] = {};
  }
  return true;
}

namespace {
/// The grid of all times that `next_time(table, column, t_s)` reads.
template <class NextTime>
Result<TimeGrid> scan_times(const OpenTable& open, const NextTime& next_time) {
  const auto opened = open();
  if (!opened) return opened.error();
  TableReader& table = **opened;
  const auto time = table.find(columns::t_s);
  if (!time)
    return table.error_here(columns::t_s, "the column is missing"_text,
                            "add the time of each row in seconds"_text);
  double previous = 0.0;
  double largest = 0.0;
  double least_step = std::numeric_limits<double>::infinity();
  double largest_step = 0.0;
  TimeGrid grid;
  for (std::size_t row = 0;; ++row) {
    double t = 0.0;
    const auto more = next_time(table, *time, t);
    if (!more) return more.error();
    if (!*more) {
      if (row < 2)
        return table.error_here("", "fewer than two rows"_text, "give at least two rows"_text);
      break;
    }
    if (std::isnan(t))
      return table.error_here(columns::t_s, "the time is empty"_text, "give every row a time"_text);
    largest = std::max(largest, std::abs(t));
    if (row > 0) {
      const double step = t - previous;
      if (!(step > 0))
        return table.error_here(columns::t_s, "time does not increase"_text,
                                "sort the rows and remove repeats"_text);
      if (row == 1) grid.hold_s = step;
      least_step = std::min(least_step, step);
      largest_step = std::max(largest_step, step);
    }
    previous = t;
  }
  const double ulp = std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
  const double tolerance = 4.0 * ulp;
  grid.regular = grid.hold_s - least_step <= tolerance && largest_step - grid.hold_s <= tolerance;
  return grid;
}
}  // namespace

Result<TimeGrid> read_time_grid(const OpenTable& open) {
  auto grid = scan_times(open, [](TableReader& table, std::size_t time, double& t_s) {
    return table.next(time, t_s);
  });
  if (grid) return grid;
  // The error has to name what is wrong first in the file, which may be in another column.
  std::vector<double> fields;
  return scan_times(open, [&fields](TableReader& table, std::size_t time, double& t_s) {
    fields.resize(table.columns().size());
    auto more = table.next(fields);
    t_s = fields[time];
    return more;
  });
}

Result<TimeGrid> read_time_grid(const std::string& path) {
  return read_time_grid([&] { return open_csv(path); });
}

std::vector<std::string> finger_forces_columns() {
  std::vector<std::string> names{columns::t_s};
  for (const Finger finger : kFingers)
    for (std::size_t axis = 0; axis < 6; ++axis) names.emplace_back(standard_column(finger, axis));
  return names;
}

void append_finger_forces(std::string& text, const FingerForcesRow& row) {
  append_number(text, row.t_s);
  for (std::size_t f = 0; f < kFingerCount; ++f)
    for (const Vec3& part : {row.wrench_C[f].force, row.wrench_C[f].torque})
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        text += ',';
        if (row.present[f]) append_number(text, part[axis]);
      }
  text += '\n';
}

}  // namespace isograsp
