// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/patient_screen/hand_footer.hpp"

#include <QFontMetricsF>
#include <QLocale>
#include <QObject>
#include <algorithm>

#include "gui/patient_screen/patient_canvas.hpp"
#include "gui/patient_screen/patient_ink.hpp"

namespace isograsp::gui {

using namespace ink;

namespace {

constexpr double kCentimetres = 100.0;

QString opening_words(const HandPicture::Opening& opening) {
  return QObject::tr("%1 cm").arg(QLocale().toString(kCentimetres * opening.gap_m, 'f', 1));
}

void draw_bar(QPainter& painter, const QRectF& bar, double share, const QColor& colour) {
  const double radius = bar.height() / 2;
  painter.setPen(Qt::NoPen);
  painter.setBrush(kFaint);
  painter.drawRoundedRect(bar, radius, radius);
  QRectF full = bar;
  full.setWidth(std::max(bar.height(), bar.width() * share));
  painter.setBrush(colour);
  painter.drawRoundedRect(full, radius, radius);
}

/// Thumb and index apart: a bar, and a number beside it.
void draw_opening(QPainter& painter, const QRectF& area, const QRectF& strip,
                  const HandPicture::Opening& opening) {
  draw_bar(painter, part(strip, 0.27, 0.32, 0.62, 0.68), opening.share, kDot);
  const QRectF number = part(strip, 0.63, 0.0, 0.75, 1.0);
  painter.setFont(font_of(area, 0.045, true));
  painter.setPen(kInk);
  painter.drawText(number, Qt::AlignVCenter | Qt::AlignLeft, opening_words(opening));
}

}  // namespace

QRectF hand_area(const QRectF& area) {
  return part(area, 0.0, kBannerShare, 1.0, 1.0 - kFooterShare);
}

QString footer_key(const PatientPicture& picture) {
  const HandPicture& hand = *picture.tracked_hand;
  constexpr int kSteps = 500;  // of a bar: finer than its points
  const double bar = hand.opening ? hand.opening->share : picture.progress;
  return QStringLiteral("%1|%2|%3|%4")
      .arg(hand.assistance ? static_cast<int>(*hand.assistance) : -1)
      .arg(hand.opening ? opening_words(*hand.opening) : QString())
      .arg(static_cast<int>(kSteps * bar))
      .arg(2 * picture.progress_shown + picture.camera_on);
}

void paint_footer(QPainter& painter, const QRectF& area, const PatientPicture& picture) {
  painter.setRenderHint(QPainter::Antialiasing);
  const HandPicture& hand = *picture.tracked_hand;
  const QRectF strip = part(area, 0.0, 1.0 - kFooterShare, 1.0, 1.0);
  painter.fillRect(strip, kPaper);
  painter.fillRect(QRectF(strip.left(), strip.top(), strip.width(), 2), kFaint);
  if (hand.assistance) {
    painter.setFont(font_of(area, 0.034, true));
    painter.setPen(kSoftInk);
    painter.drawText(part(strip, 0.02, 0.0, 0.5, 1.0), Qt::AlignVCenter | Qt::AlignLeft,
                     QString::fromStdString(help_words(*hand.assistance)));
  }
  if (hand.opening)
    draw_opening(painter, area, strip, *hand.opening);
  else if (picture.progress_shown)
    draw_bar(painter, part(strip, 0.27, 0.40, 0.73, 0.60), picture.progress, kSoftInk);
  paint_camera_sign(painter, area, picture);
}

void paint_camera_sign(QPainter& painter, const QRectF& area, const PatientPicture& picture) {
  if (!picture.camera_on) return;
  painter.setRenderHint(QPainter::Antialiasing);
  const QString words = QObject::tr("Camera on");
  painter.setFont(font_of(area, 0.028, true));
  const double width = QFontMetricsF(painter.font()).horizontalAdvance(words);
  const double height = 0.045 * area.height();
  const double edge = 0.02 * area.height();
  const QRectF line(area.right() - width - edge, area.bottom() - edge - height, width, height);
  painter.setPen(kSoftInk);
  painter.drawText(line, Qt::AlignVCenter | Qt::AlignRight, words);
  // A camera: a body, a lens.
  const double size = 0.5 * height;
  const QRectF body(line.left() - 2.4 * size, line.center().y() - 0.5 * size, 1.5 * size, size);
  painter.setPen(Qt::NoPen);
  painter.setBrush(kSoftInk);
  painter.drawRoundedRect(body, 0.2 * size, 0.2 * size);
  painter.drawPolygon(QPolygonF({body.center() + QPointF(0.7 * size, 0.0),
                                 body.center() + QPointF(1.25 * size, -0.42 * size),
                                 body.center() + QPointF(1.25 * size, 0.42 * size)}));
}

}  // namespace isograsp::gui
