// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of the documentation whose figures a test computes: the test fails where a figure is
// another one; with ISOGRASP_WRITE_DOCS in the environment it writes the figures instead.
#pragma once

#include <string>
#include <vector>

namespace isograsp::test {

/// Numbers of a cell, with so many decimals each, as they stand in the table: "5.1 / 97.3".
[[nodiscard]] std::string figures(const std::vector<double>& numbers, int decimals = 1);

/// Expects the cell of `document` (below docs/) in the row that begins with the cells `row` ("none
/// | 10") and in the column with the head `column`, of the first table that has both, to hold
/// `figures`. `within`: by how much each number may be another one, for processors whose
/// mathematics round otherwise.
void expect_figures(const std::string& document, const std::string& row, const std::string& column,
                    const std::string& figures, double within);

/// Rows of the table of `document` whose head begins with the cell `head`, without head and rule.
[[nodiscard]] std::vector<std::vector<std::string>> rows_of_table(const std::string& document,
                                                                  const std::string& head);

}  // namespace isograsp::test
