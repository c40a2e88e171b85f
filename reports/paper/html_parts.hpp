// SPDX-License-Identifier: GPL-3.0-or-later
// What all HTML reports are made of: head and foot with their furniture, tables, plots with
// descriptions for screen readers.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "reports/paper/page_furniture.hpp"
#include "reports/paper/panel.hpp"
#include "reports/paper/plots.hpp"

namespace isograsp::reports {

inline constexpr double kHtmlUnit = 4.0 / 3.0;  ///< CSS pixels per point

[[nodiscard]] QString escaped(const std::string& text);
/// From the doctype to the beginning of the main part.
[[nodiscard]] QString html_head(const PageFurniture& furniture);
[[nodiscard]] QString html_end(const PageFurniture& furniture);
/// The first cell of each row is its head; columns from `first_number` on are right-aligned. All
/// texts are HTML already.
[[nodiscard]] QString html_table(const QString& caption, const std::vector<QString>& heads,
                                 const std::vector<std::vector<QString>>& rows,
                                 std::size_t first_number = static_cast<std::size_t>(-1));
[[nodiscard]] QString html_section(const Panel& panel);
/// A plot as an <svg> element with role, title and description. Its unit is kHtmlUnit.
[[nodiscard]] QString svg_of(PlotView view, const std::string& title,
                             const std::string& description);

}  // namespace isograsp::reports
