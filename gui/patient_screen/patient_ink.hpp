// SPDX-License-Identifier: GPL-3.0-or-later
// Inside gui/ only: colours, type and measures that all flat pictures of the patient's screen
// share.
#pragma once

#include <QColor>
#include <QPainter>
#include <QRectF>

namespace isograsp::gui::ink {

// On kPaper: kInk 15.5:1, kSoftInk 8.7:1, kDot 8.6:1, kRightHand 8.0:1.
inline const QColor kPaper(0xF4, 0xF6, 0xF8);
inline const QColor kPaperSeenThrough(0xF4, 0xF6, 0xF8, 205);
inline const QColor kInk(0x12, 0x1C, 0x28);
inline const QColor kSoftInk(0x3A, 0x49, 0x58);
inline const QColor kBand(0xF5, 0xC9, 0x6B);
inline const QColor kBandEdge(0x73, 0x45, 0x00);
inline const QColor kDot(0x0B, 0x3F, 0x78);
inline const QColor kLeftHand = kDot;
inline const QColor kRightHand(0x7A, 0x2E, 0x6B);
inline const QColor kGood(0x00, 0x66, 0x45);
inline const QColor kZero(0xA4, 0xAF, 0xBA);
inline const QColor kFaint(0xD3, 0xDA, 0xE1);
inline const QColor kWarn(0x8E, 0x14, 0x0E);

[[nodiscard]] QFont font_of(const QRectF& area, double share, bool bold);

/// Draws one line in the largest size up to `share` of the screen's height that fits the width.
void draw_line(QPainter& painter, const QRectF& area, const QRectF& line, const QString& text,
               double share, bool bold, const QColor& colour);

/// The part of `area` between these shares of its width and height.
[[nodiscard]] inline QRectF part(const QRectF& area, double left, double top, double right,
                                 double bottom) {
  return {area.left() + left * area.width(), area.top() + top * area.height(),
          (right - left) * area.width(), (bottom - top) * area.height()};
}

}  // namespace isograsp::gui::ink
