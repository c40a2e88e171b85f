// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of reference values, row by row, by the names of their columns.
#pragma once

#include <cstdlib>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "core/tables/word_table.hpp"
#include "tests/support/must.hpp"

namespace isograsp::test {

/// One row of a table of reference values.
using Fields = std::map<std::string, std::string>;

inline std::vector<Fields> golden_table(const std::string& path) {
  auto table = must(WordTable::open(path));
  std::vector<Fields> rows;
  while (must(table.next())) {
    Fields row;
    for (std::size_t c = 0; c < table.columns().size(); ++c)
      row[table.columns()[c]] = std::string(table.word(c));
    rows.push_back(std::move(row));
  }
  return rows;
}

/// NaN where the field is empty.
inline double number_in(const Fields& row, const std::string& column) {
  const std::string& text = row.at(column);
  return text.empty() ? std::numeric_limits<double>::quiet_NaN()
                      : std::strtod(text.c_str(), nullptr);
}

}  // namespace isograsp::test
