// SPDX-License-Identifier: GPL-3.0-or-later
// A table of numbers, a row at a time in constant memory, whatever holds it: text (core/csv.hpp) or
// columns of bytes (exports/hdf5_table.hpp).
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "core/signals.hpp"
#include "core/text.hpp"

namespace isograsp {

class TableReader {
 public:
  virtual ~TableReader() = default;

  [[nodiscard]] virtual const std::vector<std::string>& columns() const noexcept = 0;
  /// Lines of the file that are comments and stand before its numbers.
  [[nodiscard]] virtual const std::vector<std::string>& comments() const noexcept = 0;
  /// Reads the next row; NaN: no value. False at the end.
  /// @pre row.size() == columns().size()
  [[nodiscard]] virtual Result<bool> next(std::span<double> row) = 0;
  /// The same for one column, whatever the others hold. @pre column < columns().size()
  [[nodiscard]] virtual Result<bool> next(std::size_t column, double& value) = 0;
  /// An error at the row read last.
  [[nodiscard]] virtual Error error_here(std::string field, Text what, Text remedy) const = 0;

  /// Index of a column; nothing: there is none of this name.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const noexcept {
    return index_of(columns(), name);
  }

 protected:
  TableReader() = default;
  TableReader(const TableReader&) = default;
  TableReader(TableReader&&) = default;
  TableReader& operator=(const TableReader&) = default;
  TableReader& operator=(TableReader&&) = default;
};

/// Opens one and the same table from its beginning.
using OpenTable = std::function<Result<std::unique_ptr<TableReader>>()>;

/// A table that appears under its name when it is complete, or not at all.
class TableWriter {
 public:
  virtual ~TableWriter() = default;
  TableWriter(const TableWriter&) = delete;
  TableWriter& operator=(const TableWriter&) = delete;

  /// One value a column; NaN: no value. What fails is said by commit().
  virtual void add(std::span<const double> row) = 0;
  [[nodiscard]] virtual Result<void> commit() = 0;

 protected:
  TableWriter() = default;
};

}  // namespace isograsp
