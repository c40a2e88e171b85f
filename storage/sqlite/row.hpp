// SPDX-License-Identifier: GPL-3.0-or-later
// Inside storage/sqlite/ only: each column that is read stands beside the variable it is read into,
// each value that is written beside its column: no two lists have to agree by position.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/measure.hpp"

namespace soci {
class session;
}

namespace isograsp::storage {

/// A list of names as one text, one a line.
[[nodiscard]] std::string as_lines(const std::vector<std::string>& names);
[[nodiscard]] std::vector<std::string> lines_of(const std::string& text);

/// What goes into a column; numbers in a list are float64, little-endian.
using SqlValue = std::variant<std::int64_t, double, std::string, std::vector<double>>;

/// A SELECT: columns, then `from`, then one fetch() a row. Throws as SOCI does.
class Row {
 public:
  explicit Row(soci::session& sql);
  Row(const Row&) = delete;
  Row& operator=(const Row&) = delete;
  ~Row();

  // Never NULL.
  Row& get(const std::string& expression, double& to);
  Row& get(const std::string& expression, int& to);
  Row& get(const std::string& expression, std::int64_t& to);
  Row& get(const std::string& expression, std::string& to);
  Row& get(const std::string& expression, bool& to);
  /// Float64, little-endian.
  Row& get(const std::string& expression, std::vector<double>& to);
  // NULL is nothing.
  Row& get(const std::string& expression, std::optional<double>& to);
  Row& get(const std::string& expression, std::optional<int>& to);
  Row& get(const std::string& expression, std::optional<std::int64_t>& to);
  /// A text that means something: to = parse(text).
  template <class T, class Parse>
  Row& get(const std::string& expression, T& to, Parse parse) {
    return text(expression, [&to, parse](const std::string& text) { to = parse(text); });
  }

  /// `from` begins with FROM; `used` are its parameters in their order.
  void select(const std::string& from, std::vector<SqlValue> used = {});
  [[nodiscard]] bool fetch();

 private:
  struct Parts;
  Row& text(const std::string& expression, std::function<void(const std::string&)> take);
  std::unique_ptr<Parts> parts_;
};

/// All of a stored measure; `of`: its table with a point, or empty.
void get_measure(Row& row, Measure& measure, const std::string& of = "");

/// An INSERT: what each column gets, then one insert().
class NewRow {
 public:
  NewRow(soci::session& sql, std::string table) : sql_(sql), table_(std::move(table)) {}

  NewRow& set(const std::string& column, SqlValue value) {
    columns_.emplace_back(column, std::move(value));
    return *this;
  }
  NewRow& set(const std::string& column, std::string_view text) {
    return set(column, SqlValue(std::string(text)));
  }
  NewRow& set(const std::string& column, const std::string& text) {
    return set(column, SqlValue(text));
  }
  NewRow& set(const std::string& column, bool value) {
    return set(column, SqlValue(std::int64_t{value ? 1 : 0}));
  }
  NewRow& set(const std::string& column, int value) {
    return set(column, SqlValue(std::int64_t{value}));
  }
  NewRow& set(const std::string& column, std::int64_t value) {
    return set(column, SqlValue(value));
  }
  NewRow& set(const std::string& column, double value) { return set(column, SqlValue(value)); }
  NewRow& set(const std::string& column, const char* text) = delete;  // would be a bool
  /// Nothing is NULL.
  template <class T>
  NewRow& set(const std::string& column, const std::optional<T>& value) {
    return value ? set(column, *value) : *this;
  }

  /// `otherwise`: an ON CONFLICT clause. Throws as SOCI does.
  void insert(const std::string& otherwise = "");

 private:
  soci::session& sql_;
  std::string table_;
  std::vector<std::pair<std::string, SqlValue>> columns_;
};

}  // namespace isograsp::storage
