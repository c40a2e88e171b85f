// SPDX-License-Identifier: GPL-3.0-or-later
// What a page of a report paints, and where: every text with its box, every stroked line. Points
// from the upper left corner of the page.
#pragma once

#include <QLineF>
#include <QRectF>
#include <QString>
#include <vector>

#include "reports/paper/report_pages.hpp"

namespace isograsp::test {

struct PaintedText {
  QString text;
  QRectF box;            ///< of its letters, from their tops to a little below the line
  bool slanted = false;  ///< neither level nor upright: the watermark
};
struct PaintedPage {
  std::vector<PaintedText> texts;
  std::vector<QLineF> lines;
};

/// `page` counts from 0.
[[nodiscard]] PaintedPage painted(const reports::ReportPages& pages, int page);

/// 0, 1, …: the pages of a report.
[[nodiscard]] std::vector<int> all_pages(const reports::ReportPages& pages);

/// Pairs of level or upright texts that lie on each other, in words; empty: none.
[[nodiscard]] std::vector<QString> overprinted(const PaintedPage& page);

}  // namespace isograsp::test
