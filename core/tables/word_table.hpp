// SPDX-License-Identifier: GPL-3.0-or-later
// Tables whose columns hold numbers or words: one header line, comma, '#' comment lines, no quotes.
// Row by row, in memory that does not depend on the file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/lines.hpp"
#include "core/result.hpp"

namespace isograsp {

class WordTable {
 public:
  /// Reads comments and header. Errors name file and line.
  [[nodiscard]] static Result<WordTable> open(const std::string& path);

  [[nodiscard]] const std::vector<std::string>& columns() const noexcept { return columns_; }
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const noexcept;
  /// The same, as an error if there is none.
  [[nodiscard]] Result<std::size_t> require(std::string_view name) const;

  /// Reads the next row; false at the end of the file.
  [[nodiscard]] Result<bool> next();
  /// A field of the row read last, without blanks around it.
  [[nodiscard]] std::string_view word(std::size_t column) const noexcept { return fields_[column]; }
  /// A field as a finite number; nothing if it is empty.
  [[nodiscard]] Result<std::optional<double>> number(std::size_t column) const;
  /// The same where it must not be empty.
  [[nodiscard]] Result<double> required_number(std::size_t column) const;

  [[nodiscard]] const std::string& path() const noexcept { return lines_.path(); }
  /// An error at the row read last.
  [[nodiscard]] Error error_here(std::string field, Text what, Text remedy) const;

 private:
  explicit WordTable(LineReader lines) : lines_(std::move(lines)) {}
  /// The next line that is no comment, in fields; false at the end.
  Result<bool> read_fields();

  LineReader lines_;
  std::vector<std::string> columns_;
  std::vector<std::string_view> fields_;
};

}  // namespace isograsp
