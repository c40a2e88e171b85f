// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of numbers as text: UTF-8, comma, one header line, '.' decimal, '#' comment lines.
#pragma once

#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/files.hpp"
#include "core/result.hpp"
#include "core/signals.hpp"

namespace isograsp {

/// Characters of the longest number, -2.2250738585072014e-308.
inline constexpr std::size_t kLongestNumber = 24;
/// Writes the shortest decimal that reads back to the same double; nothing for NaN (an empty
/// field). Returns its end. @pre room for kLongestNumber characters
char* print_number(char* at, double value) noexcept;
void append_number(std::string& text, double value);
[[nodiscard]] std::string format_number(double value);
/// A field of words: in quotes if it has to be.
[[nodiscard]] std::string csv_field(const std::string& text);

/// Reads a whole field as a finite number: no blanks, no trailing characters, no "nan" or "inf".
[[nodiscard]] bool parse_number(std::string_view field, double& value) noexcept;

/// Reads a table of numbers row by row, in constant memory. Errors name file, line and column.
class CsvReader {
 public:
  /// Opens the file and reads the comments and the header. Duplicate or empty names are errors.
  [[nodiscard]] static Result<CsvReader> open(const std::string& path);

  [[nodiscard]] const std::vector<std::string>& columns() const noexcept { return columns_; }
  /// Index of a column, or -1.
  [[nodiscard]] int find(std::string_view name) const noexcept;
  /// Comment lines before the header, without the '#' and surrounding blanks.
  [[nodiscard]] const std::vector<std::string>& comments() const noexcept { return comments_; }
  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  /// Line of the row read last, 1-based.
  [[nodiscard]] int line() const noexcept { return line_; }

  /// Reads the next row; an empty field becomes NaN. False at the end of the file.
  /// @pre row.size() == columns().size()
  [[nodiscard]] Result<bool> next(std::span<double> row);
  /// The same for one column; does not look at the fields behind it, nor for numbers in those
  /// before it. @pre 0 <= column < columns().size()
  [[nodiscard]] Result<bool> next(int column, double& value);

  /// An error at the row read last.
  [[nodiscard]] Error error_here(std::string field, std::string what, std::string remedy) const;

 private:
  Result<bool> read_line();
  Result<bool> read_row_line();
  void fill();
  [[nodiscard]] Error too_short(std::size_t column) const;
  [[nodiscard]] Error not_a_number(std::size_t column, std::string_view field) const;

  std::string path_;
  std::ifstream in_;
  std::vector<std::string> columns_;
  std::vector<std::string> comments_;
  std::vector<char> block_;  ///< a part of the file
  std::size_t begin_ = 0;    ///< in block_: first character that no line has taken yet
  std::size_t end_ = 0;      ///< in block_: behind the last character read
  std::string_view text_;    ///< the current line, in block_
  int line_ = 0;
};

/// A whole table in memory: a signals file. Requires `t_s`, strictly increasing, and two rows.
[[nodiscard]] Result<Signals> read_signals(const std::string& path);
/// Writes all columns; NaN becomes an empty field.
[[nodiscard]] Result<void> write_signals(const Signals& signals, const std::string& path,
                                         std::span<const std::string> comments = {});

}  // namespace isograsp
