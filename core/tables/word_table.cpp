// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/word_table.hpp"

#include <algorithm>

#include "core/csv.hpp"

namespace isograsp {

namespace {

constexpr std::size_t kLongestRow = std::size_t{1} << 20;

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const auto first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

}  // namespace

Result<WordTable> WordTable::open(const std::string& path) {
  auto lines = LineReader::open(path, kLongestRow, "check that it is a table with line ends"_text);
  if (!lines) return lines.error();
  WordTable table(std::move(*lines));
  const auto header = table.read_fields();
  if (!header) return header.error();
  if (!*header)
    return refused("holds no header line"_text,
                   "give a CSV file whose first line names the columns"_text)
        .at(path);
  table.columns_.assign(table.fields_.begin(), table.fields_.end());
  if (table.columns_.size() > CsvReader::kMostColumns)
    return table.error_here("", "the header names %1 columns"_text(table.columns_.size()),
                            "give at most %1"_text(CsvReader::kMostColumns));
  auto sorted = table.columns_;
  std::sort(sorted.begin(), sorted.end());
  if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
    return table.error_here(*twice, "the column appears twice"_text, "keep one of them"_text);
  return table;
}

std::optional<std::size_t> WordTable::find(std::string_view name) const noexcept {
  const auto at = std::find(columns_.begin(), columns_.end(), name);
  if (at == columns_.end()) return std::nullopt;
  return static_cast<std::size_t>(at - columns_.begin());
}

Result<std::size_t> WordTable::require(std::string_view name) const {
  if (const auto at = find(name)) return *at;
  return error_here(std::string(name), "the column is missing"_text, "add it"_text);
}

Result<bool> WordTable::read_fields() {
  std::string_view text;
  do {
    const auto more = lines_.next();
    if (!more || !*more) return more;
    text = lines_.text();
    if (lines_.line() == 1 && text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  } while (without_blanks(text).empty() || text.front() == '#');
  fields_.clear();
  for (;;) {
    const auto comma = text.find(',');
    fields_.push_back(without_blanks(text.substr(0, comma)));
    if (comma == std::string_view::npos) return true;
    text.remove_prefix(comma + 1);
  }
}

Result<bool> WordTable::next() {
  const auto more = read_fields();
  if (!more || !*more) return more;
  if (fields_.size() != columns_.size())
    return error_here("",
                      "the line has %1 fields, the header %2"_text(fields_.size(), columns_.size()),
                      "give every line %1 fields"_text(columns_.size()));
  return true;
}

Result<std::optional<double>> WordTable::number(std::size_t column) const {
  if (fields_[column].empty()) return std::optional<double>();
  double value = 0.0;
  if (parse_number(fields_[column], value)) return std::optional(value);
  return error_here(columns_[column], "'%1' is not a finite number"_text(fields_[column]),
                    "write a number with '.' as the decimal sign, or leave the field empty if the "
                    "value is missing"_text);
}

Result<double> WordTable::required_number(std::size_t column) const {
  const auto value = number(column);
  if (!value) return value.error();
  if (*value) return **value;
  return error_here(columns_[column], "is empty"_text, "write a number"_text);
}

Error WordTable::error_here(std::string field, Text what, Text remedy) const {
  return refused(std::move(what), std::move(remedy))
      .at(lines_.path(), lines_.line(), std::move(field));
}

}  // namespace isograsp
