// SPDX-License-Identifier: GPL-3.0-or-later
// The content of a PDF report as blocks: each knows its height and paints itself at a place.
#pragma once

#include <vector>

#include "reports/paper/panel.hpp"
#include "reports/paper/pdf_page.hpp"

namespace isograsp::reports::pdf {

inline constexpr double kSectionGap = 20.0;

[[nodiscard]] Block text_block(const QString& text, const TextStyle& style, double gap_above);
[[nodiscard]] Block heading_block(const QString& text, double gap_above);

/// The table of key measures.
void add_glance(std::vector<Block>& blocks, const ReportContent& content, const Speaker& say);
/// The box that says whether the last measurement was valid.
void add_quality(std::vector<Block>& blocks, const ReportContent& content, const Speaker& say);
/// Parts that are the same on the web.
void add_panels(std::vector<Block>& blocks, const std::vector<Panel>& panels);
/// The tasks with their plots. `content` must outlive the blocks.
void add_sections(std::vector<Block>& blocks, const ReportContent& content, const Speaker& say);

}  // namespace isograsp::reports::pdf
