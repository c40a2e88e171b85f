// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of numbers as text: UTF-8, comma, one header line, '.' decimal, '#' comment lines.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/files.hpp"
#include "core/lines.hpp"
#include "core/result.hpp"
#include "core/signals.hpp"
#include "core/tables/number_table.hpp"

namespace isograsp {

/// Characters of the longest number, -2.2250738585072014e-308.
inline constexpr std::size_t kLongestNumber = 24;
/// Writes the shortest decimal that reads back to the same double; nothing for NaN (an empty
/// field). Returns its end. @pre room for kLongestNumber characters
char* print_number(char* at, double value) noexcept;
void append_number(std::string& text, double value);
[[nodiscard]] std::string format_number(double value);
/// Words that spreadsheet programs would take for a formula, those that begin with = + - @ tab or
/// carriage return, get an apostrophe in front; so do those that already have one there. Numbers
/// stay as they are.
[[nodiscard]] std::string without_formula(std::string text);
/// The reverse.
[[nodiscard]] std::string_view with_formula(std::string_view text) noexcept;
/// A field of words: without_formula(), in quotes if it has to be.
[[nodiscard]] std::string csv_field(std::string text);

/// Reads a whole field as a finite number: no blanks, no trailing characters, no "nan" or "inf".
[[nodiscard]] bool parse_number(std::string_view field, double& value) noexcept;

/// Reads a table of numbers row by row, in constant memory. Errors name file, line and column.
class CsvReader final : public TableReader {
 public:
  /// Most columns of a table.
  static constexpr std::size_t kMostColumns = 10000;

  /// Opens the file and reads the comments and the header; names are read with_formula(). Duplicate
  /// or empty names and more than kMostColumns are errors.
  [[nodiscard]] static Result<CsvReader> open(const std::string& path);

  [[nodiscard]] const std::vector<std::string>& columns() const noexcept override {
    return columns_;
  }
  /// Comment lines before the header, without the '#' and surrounding blanks.
  [[nodiscard]] const std::vector<std::string>& comments() const noexcept override {
    return comments_;
  }
  [[nodiscard]] const std::string& path() const noexcept { return lines_.path(); }
  /// Line of the row read last, 1-based.
  [[nodiscard]] int line() const noexcept { return lines_.line(); }

  /// An empty field becomes NaN.
  [[nodiscard]] Result<bool> next(std::span<double> row) override;
  /// Does not look at the fields behind this one, nor for numbers in those before it.
  [[nodiscard]] Result<bool> next(std::size_t column, double& value) override;
  [[nodiscard]] Error error_here(std::string field, Text what, Text remedy) const override;

 private:
  explicit CsvReader(LineReader lines) : lines_(std::move(lines)) {}
  Result<bool> read_line();
  Result<bool> read_row_line();
  Result<void> read_columns();
  [[nodiscard]] Error too_short(std::size_t column) const;
  [[nodiscard]] Error not_a_number(std::size_t column, std::string_view field) const;

  LineReader lines_;
  std::vector<std::string> columns_;
  std::vector<std::string> comments_;
  std::string_view text_;  ///< the current line without its end
};

/// A CsvReader, for whoever does not mind what holds its numbers.
[[nodiscard]] Result<std::unique_ptr<TableReader>> open_csv(const std::string& path);

/// Prints rows straight into one block, which goes to the file when it is full.
class CsvWriter final : public TableWriter {
 public:
  [[nodiscard]] static Result<std::unique_ptr<TableWriter>> create(
      const std::string& path, std::span<const std::string> columns);
  /// NaN becomes an empty field.
  void add(std::span<const double> row) override;
  [[nodiscard]] Result<void> commit() override;

 private:
  CsvWriter(FileWriter file, std::size_t columns);
  void flush();

  FileWriter file_;
  std::vector<char> block_;
  std::size_t longest_row_;
  std::size_t used_ = 0;
};

/// A whole table in memory: a signals file. Requires `t_s`, strictly increasing, and two rows.
[[nodiscard]] Result<Signals> read_signals(const std::string& path);
/// Writes all columns; NaN becomes an empty field.
[[nodiscard]] Result<void> write_signals(const Signals& signals, const std::string& path,
                                         std::span<const std::string> comments = {});

}  // namespace isograsp
