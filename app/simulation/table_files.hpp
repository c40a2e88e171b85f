// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of numbers that commands read and write: CSV, or HDF5 where the name says so
// (docs/file_formats.md, "Tables as HDF5").
#pragma once

#include <memory>
#include <span>
#include <string>

#include "core/spatial.hpp"
#include "core/tables/number_table.hpp"

namespace isograsp::app {

/// "forces.csv"; "forces.h5"; "isograsp.h5:/patients/P-1/session-01/trial-01/signals", a place in
/// the file.
[[nodiscard]] Result<std::unique_ptr<TableReader>> open_table(const std::string& name);

/// A table of that name, one number after the other.
class NumberRows {
 public:
  [[nodiscard]] static Result<NumberRows> create(const std::string& path,
                                                 std::span<const std::string> columns);
  void put(double number) { row_.push_back(number); }  ///< NaN: no value
  void put(const Vec3& v) { row_.insert(row_.end(), v.begin(), v.end()); }
  /// w x y z.
  void put(const Quat& q) { row_.insert(row_.end(), {q.w(), q.x(), q.y(), q.z()}); }
  void end() {
    table_->add(row_);
    row_.clear();
  }
  [[nodiscard]] Result<void> commit() { return table_->commit(); }

 private:
  explicit NumberRows(std::unique_ptr<TableWriter> table) : table_(std::move(table)) {}

  std::unique_ptr<TableWriter> table_;
  std::vector<double> row_;
};

/// Appends "<before>x<after>", the same with y and z.
void add_three(std::vector<std::string>& columns, const std::string& before,
               const std::string& after);

}  // namespace isograsp::app
