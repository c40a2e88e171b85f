// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/doc_table.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include <gtest/gtest.h>

namespace isograsp::test {

namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// Cells of a line of a table, without what stands before the first bar.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream text(line);
  std::string cell;
  std::getline(text, cell, '|');
  while (std::getline(text, cell, '|')) cells.push_back(trimmed(cell));
  return cells;
}

std::vector<std::string> lines_of(const std::filesystem::path& path) {
  std::vector<std::string> lines;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

std::vector<double> numbers_of(const std::string& cell) {
  std::vector<double> numbers;
  std::istringstream text(cell);
  std::string part;
  while (std::getline(text, part, '/')) {
    char* end = nullptr;
    const double number = std::strtod(part.c_str(), &end);
    if (end == part.c_str()) return {};
    numbers.push_back(number);
  }
  return numbers;
}

bool same_figures(const std::string& a, const std::string& b, double within) {
  const auto left = numbers_of(a);
  const auto right = numbers_of(b);
  if (left.empty() || left.size() != right.size()) return false;
  constexpr double kDecimals = 1e-9;  // of numbers read from text
  for (std::size_t i = 0; i < left.size(); ++i)
    if (std::abs(left[i] - right[i]) > within + kDecimals) return false;
  return true;
}

struct Place {
  std::size_t line;
  std::size_t cell;
};
std::optional<Place> find(const std::vector<std::string>& lines, const std::string& row,
                          const std::string& column) {
  const auto wanted = cells_of("|" + row + "|");
  constexpr std::size_t kNone = std::string::npos;
  std::size_t at = kNone;  // of the column, in the table of this line
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i].starts_with('|')) {
      at = kNone;
      continue;
    }
    const auto cells = cells_of(lines[i]);
    const bool head = i == 0 || !lines[i - 1].starts_with('|');
    if (head) {
      for (std::size_t c = 0; c < cells.size(); ++c)
        if (cells[c] == column) at = c;
      continue;
    }
    if (at < cells.size() && cells.size() >= wanted.size() &&
        std::equal(wanted.begin(), wanted.end(), cells.begin()))
      return Place{i, at};
  }
  return std::nullopt;
}

}  // namespace

std::string figures(const std::vector<double>& numbers, int decimals) {
  std::string text;
  for (const double number : numbers) {
    char one[32];
    std::snprintf(one, sizeof one, "%.*f", decimals, number);
    text += (text.empty() ? "" : " / ") + std::string(one);
  }
  return text;
}

void expect_figures(const std::string& document, const std::string& row, const std::string& column,
                    const std::string& figures, double within) {
  const auto path = std::filesystem::path(ISOGRASP_SOURCE_DIR) / "docs" / document;
  auto lines = lines_of(path);
  const auto place = find(lines, row, column);
  ASSERT_TRUE(place) << document << " has no row \"" << row << "\" with a column \"" << column
                     << '"';
  auto cells = cells_of(lines[place->line]);
  if (std::getenv("ISOGRASP_WRITE_DOCS") == nullptr) {
    EXPECT_TRUE(same_figures(cells[place->cell], figures, within))
        << document << ", row \"" << row << "\", column \"" << column << "\": says "
        << cells[place->cell] << ", computed " << figures;
    return;
  }
  cells[place->cell] = figures;
  std::string line = "|";
  for (const auto& cell : cells) line += " " + cell + " |";
  lines[place->line] = line;
  std::ofstream file(path);
  for (const auto& one : lines) file << one << '\n';
}

std::vector<std::vector<std::string>> rows_of_table(const std::string& document,
                                                    const std::string& head) {
  std::vector<std::vector<std::string>> rows;
  bool inside = false;
  for (const std::string& line :
       lines_of(std::filesystem::path(ISOGRASP_SOURCE_DIR) / "docs" / document)) {
    if (!line.starts_with('|')) inside = false;
    auto cells = cells_of(line);
    if (inside && !cells[0].starts_with("---"))
      rows.push_back(std::move(cells));
    else if (!cells.empty() && cells[0] == head)
      inside = true;
  }
  return rows;
}

}  // namespace isograsp::test
