// SPDX-License-Identifier: GPL-3.0-or-later
// Text and blocks on pages. All sizes in points (1/72 inch); `unit` is device pixels per point.
#pragma once

#include <QColor>
#include <QRectF>
#include <QString>
#include <functional>
#include <vector>

#include "reports/paper/palette.hpp"

class QPainter;
class QCPPainter;

namespace isograsp::reports {

struct TextStyle {
  double size = 8.0;
  bool bold = false;
  QColor color = Palette::ink();
  Qt::Alignment align = Qt::AlignLeft;
  double line_height_percent = 125.0;
};

class TextPainter {
 public:
  explicit TextPainter(double unit) : unit_(unit) {}
  /// Height of the wrapped text [points].
  [[nodiscard]] double height(const QString& text, double width, const TextStyle& style) const;
  /// Width of the longest word [points].
  [[nodiscard]] double word_width(const QString& text, const TextStyle& style) const;
  /// Draws at (x, y); returns the height.
  double draw(QPainter& painter, double x, double y, double width, const QString& text,
              const TextStyle& style) const;

 private:
  double unit_;
};

/// The widths of columns, changed as little as it takes that none is narrower than `least`: what
/// one lacks, the one with most room gives, as far as there is room.
[[nodiscard]] std::vector<double> widened(std::vector<double> widths,
                                          const std::vector<double>& least);

/// Paints something at the height `y` of the page [points]; takes some milliseconds at most.
using Draw = std::function<void(QCPPainter&, double y)>;

/// Something that is not broken across pages.
struct Block {
  double gap_above = 0.0;  ///< left out at the top of a page
  double height = 0.0;
  bool keep_with_next = false;
  std::vector<Draw> parts;  ///< painted one after the other, all with the top of the block
  bool new_page = false;    ///< stands at the top of a page
  /// How many blocks above stands the head of its table, which is repeated at the top of a page; 0:
  /// it has none.
  std::size_t below_head = 0;
};

/// Distributes blocks over pages of `page_height`, the first of which offers `first_height`.
/// Returns the pages as ranges [first, last) of blocks.
struct PageRange {
  std::size_t first = 0;
  std::size_t last = 0;
};
[[nodiscard]] std::vector<PageRange> break_into_pages(const std::vector<Block>& blocks,
                                                      double first_height, double page_height);

}  // namespace isograsp::reports
