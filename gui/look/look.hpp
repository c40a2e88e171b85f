// SPDX-License-Identifier: GPL-3.0-or-later
// The look of both windows: colours with known contrast, the style sheet, small tools.
#pragma once

#include <QBoxLayout>
#include <QColor>
#include <QPolygonF>
#include <QString>
#include <array>

#include "hand/finger.hpp"

class QApplication;
class QWidget;

namespace isograsp::gui {

namespace look {
// On white: kText 14.6:1, kQuietText 6.6:1, kAccent 6.5:1, kReady 5.5:1, kFault 6.5:1.
inline const QColor kBackground{0xF3, 0xF5, 0xF8};
inline const QColor kCard{0xFF, 0xFF, 0xFF};
inline const QColor kLine{0xD5, 0xDB, 0xE3};
inline const QColor kEdge{0xA9, 0xB4, 0xC0};   ///< of what can be pressed or typed into; zero line
inline const QColor kGrid{0xEB, 0xEF, 0xF3};   ///< of plots and tables
inline const QColor kTrack{0xE6, 0xEA, 0xEF};  ///< of a bar, behind what is filled
inline const QColor kDesk{0xE3, 0xE8, 0xEE};   ///< behind pages of paper
inline const QColor kHover{0xF4, 0xF9, 0xFE};
inline const QColor kChosen{0xE1, 0xEE, 0xFA};
inline const QColor kText{0x1B, 0x27, 0x33};
inline const QColor kQuietText{0x52, 0x60, 0x6D};
inline const QColor kAccent{0x0B, 0x5C, 0xAD};
inline const QColor kPaleAccent{0x8F, 0xB4, 0xD9};
inline const QColor kReady{0x1B, 0x7F, 0x4B};
inline const QColor kAttention{0xE0, 0x8A, 0x00};
inline const QColor kFault{0xB3, 0x26, 0x1E};
/// Of thumb, index and middle: told apart with every kind of colour vision (Okabe and Ito).
inline const std::array<QColor, kFingerCount> kFingers{
    QColor{0x00, 0x72, 0xB2}, QColor{0xC7, 0x52, 0x00}, QColor{0x00, 0x8A, 0x63}};
/// Of curves that are not a finger's, beside those.
inline const std::array<QColor, 2> kOtherCurves{QColor{0xB0, 0x55, 0x8A}, QColor{0x8A, 0x6D, 0x00}};
inline const QColor kPathGround{0xFA, 0xFB, 0xFC};  ///< behind the path of an object
inline const QColor kObject{0x33, 0x6B, 0xA8, 40};  ///< its body, seen through
}  // namespace look

/// "Thumb", "Index", "Middle".
[[nodiscard]] QString finger_title(Finger finger);

/// Font, palette and style sheet of the whole application; letters in percent of the usual size.
void dress(QApplication& application, int font_percent = 100);
/// A length that goes with letters, e.g. the height of a row, at the size that is set.
[[nodiscard]] int scaled(int usual_px) noexcept;
/// Side by side with letters of the usual size, below each other with large ones, so that nobody
/// has to scroll sideways.
[[nodiscard]] QBoxLayout::Direction side_by_side() noexcept;

/// Fills a page with choices, in a column of their own width, and what they are about beside them.
void lay_out_choices(QWidget& page, QWidget& choices, QWidget& body);

/// The corners in order.
[[nodiscard]] inline QPolygonF polygon(std::initializer_list<QPointF> corners) {
  return QPolygonF(QVector<QPointF>(corners));
}

/// Shows a part of a page or not, also before it has been put there.
void show_part(QWidget& part, bool shown);

/// Marks a button as the sensible next thing to press, or something as one answer of the choice
/// that is next. Both are framed in the accent colour; the bar above the pages says what is marked.
void mark_next(QWidget& button, bool next);
void mark_choice(QWidget& answer, bool next);
[[nodiscard]] bool is_choice(const QWidget& marked);
/// What is marked on a page and can be used, the first one; null: nothing is. A part that is only
/// folded away (may_fold) counts, one that is hidden does not.
[[nodiscard]] QWidget* marked_next(QWidget& page);
void may_fold(QWidget& part);
/// The one button that a page or a dialog without that bar is there for: filled.
void mark_main(QWidget& button, bool main);

/// Lets a list, table or plot take the height that is left, down to scaled(`least_px`). Its own
/// wish would count as its least height wherever a text that wraps stands in the same column.
void take_rest(QWidget& widget, int least_px);

/// Name for assistive technology and tooltip in one go. A letter that the tooltip gives ("Alt+D")
/// is that of the button's text in the language of the screen: describe the button after its text
/// is set.
void describe(QWidget& widget, const QString& name, const QString& tooltip);

}  // namespace isograsp::gui
