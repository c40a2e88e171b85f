// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/patient_canvas.hpp"

#include <QObject>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "gui/look.hpp"

namespace isograsp {

namespace {

// On kPaper: kInk 15.5:1, kSoftInk 8.7:1, kDot 8.6:1.
const QColor kPaper(0xF4, 0xF6, 0xF8);
const QColor kInk(0x12, 0x1C, 0x28);
const QColor kSoftInk(0x3A, 0x49, 0x58);
const QColor kBand(0xF5, 0xC9, 0x6B);
const QColor kBandEdge(0x73, 0x45, 0x00);
const QColor kDot(0x0B, 0x3F, 0x78);
const QColor kGood(0x00, 0x66, 0x45);
const QColor kFaint(0xD3, 0xDA, 0xE1);
const QColor kWarn(0x8E, 0x14, 0x0E);

QFont font_of(const QRectF& area, double share, bool bold) {
  QFont font("DejaVu Sans");
  font.setPixelSize(std::max(12, static_cast<int>(area.height() * share)));
  font.setBold(bold);
  return font;
}

/// Draws one line in the largest size up to `share` of the screen's height that fits the width.
void draw_line(QPainter& painter, const QRectF& area, const QRectF& line, const QString& text,
               double share, bool bold, const QColor& colour) {
  QFont font = font_of(area, share, bold);
  const double width = QFontMetricsF(font).horizontalAdvance(text);
  if (width > line.width())
    font.setPixelSize(std::max(12, static_cast<int>(font.pixelSize() * line.width() / width)));
  painter.setFont(font);
  painter.setPen(colour);
  painter.drawText(line, Qt::AlignCenter, text);
}

QRectF part(const QRectF& area, double left, double top, double right, double bottom) {
  return {area.left() + left * area.width(), area.top() + top * area.height(),
          (right - left) * area.width(), (bottom - top) * area.height()};
}

void draw_simulated(QPainter& painter, const QRectF& area) {
  const QFont font = font_of(area, 0.026, true);
  const QString text = QObject::tr("SIMULATED");
  const double width = QFontMetricsF(font).horizontalAdvance(text) + 0.03 * area.height();
  const QRectF badge(area.right() - width - 0.03 * area.height(), area.top() + 0.03 * area.height(),
                     width, 0.046 * area.height());
  painter.setPen(Qt::NoPen);
  painter.setBrush(kInk);
  painter.drawRoundedRect(badge, 5, 5);
  painter.setFont(font);
  painter.setPen(Qt::white);
  painter.drawText(badge, Qt::AlignCenter, text);
}

void draw_progress(QPainter& painter, const QRectF& area, double fraction) {
  const QRectF trough = part(area, 0.2, 0.955, 0.8, 0.97);
  const double radius = trough.height() / 2;
  painter.setPen(Qt::NoPen);
  painter.setBrush(kFaint);
  painter.drawRoundedRect(trough, radius, radius);
  QRectF done = trough;
  done.setWidth(std::max(trough.height(), trough.width() * fraction));
  painter.setBrush(kSoftInk);
  painter.drawRoundedRect(done, radius, radius);
}

void draw_arrow(QPainter& painter, QPointF from, QPointF to, double width) {
  painter.setPen(QPen(kDot, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawLine(from, to);
  const QPointF along = (to - from) / std::hypot(to.x() - from.x(), to.y() - from.y());
  const QPointF across(-along.y(), along.x());
  const double head = 2.2 * width;
  painter.drawPolyline(polygon({to - head * (along - across), to, to - head * (along + across)}));
}

/// A hand seen from above, fingers up; `stretch` 1: open, 0: a fist. On a grid of 100 x 100.
void draw_hand(QPainter& painter, double stretch) {
  painter.setPen(QPen(kDot, 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::white);
  QPainterPath hand;
  hand.addRoundedRect(QRectF(28, 46, 46, 44), 16, 16);
  constexpr std::array<double, 4> kLength{32, 40, 37, 26};
  for (std::size_t i = 0; i < kLength.size(); ++i) {
    const double length = 14 + (kLength[i] + 4 - 14) * stretch;
    QPainterPath finger;
    finger.addRoundedRect(QRectF(28 + 11.6 * static_cast<double>(i), 58 - length, 11.2, length + 6),
                          5.6, 5.6);
    hand = hand.united(finger);
  }
  QPainterPath thumb;
  thumb.addRoundedRect(QRectF(-6, -26 * (0.55 + 0.45 * stretch), 12, 36), 6, 6);
  QTransform turn;
  turn.translate(33, 74);
  turn.rotate(-46);
  hand = hand.united(turn.map(thumb));
  painter.drawPath(hand);
}

void draw_sign(QPainter& painter, const QRectF& box, PatientPicture::Sign sign) {
  painter.save();
  painter.translate(box.topLeft());
  painter.scale(box.width() / 100.0, box.height() / 100.0);
  switch (sign) {
    case PatientPicture::Sign::wait:
      painter.setPen(Qt::NoPen);
      painter.setBrush(kDot);
      for (const double x : {26.0, 50.0, 74.0}) painter.drawEllipse(QPointF(x, 54), 7.5, 7.5);
      break;
    case PatientPicture::Sign::hand_out:
      painter.save();
      painter.translate(-14, 6);
      draw_hand(painter, 1.0);
      painter.restore();
      draw_arrow(painter, {72, 66}, {104, 66}, 6.0);
      break;
    case PatientPicture::Sign::rest: draw_hand(painter, 0.75); break;
    case PatientPicture::Sign::squeeze:
      draw_hand(painter, 0.0);
      draw_arrow(painter, {-8, 66}, {14, 66}, 6.0);
      draw_arrow(painter, {108, 66}, {86, 66}, 6.0);
      break;
    case PatientPicture::Sign::good:
      painter.setPen(Qt::NoPen);
      painter.setBrush(kGood);
      painter.drawEllipse(QPointF(50, 54), 38, 38);
      painter.setPen(QPen(Qt::white, 9, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      painter.setBrush(Qt::NoBrush);
      painter.drawPolyline(polygon({{33, 55}, {46, 68}, {69, 41}}));
      break;
  }
  painter.restore();
}

void draw_message(QPainter& painter, const QRectF& area, const PatientPicture& picture) {
  const double size = 0.34 * area.height();
  draw_sign(painter,
            QRectF(area.center().x() - size / 2, area.top() + 0.14 * area.height(), size, size),
            picture.sign);
  draw_line(painter, area, part(area, 0.06, 0.53, 0.94, 0.67),
            QString::fromStdString(picture.headline), 0.095, true, kInk);
  draw_line(painter, area, part(area, 0.08, 0.68, 0.92, 0.78),
            QString::fromStdString(picture.detail), 0.05, false, kSoftInk);
}

void draw_effort(QPainter& painter, const QRectF& area, const PatientPicture& picture) {
  draw_line(painter, area, part(area, 0.06, 0.06, 0.94, 0.21),
            QString::fromStdString(picture.headline), 0.115, true, kInk);
  draw_line(painter, area, part(area, 0.06, 0.21, 0.94, 0.30),
            QString::fromStdString(picture.detail), 0.05, false, kSoftInk);
  // More force always fills more, whatever the patient's maximum is.
  constexpr double kScale_N = 30.0;
  const double fill = 1.0 - std::exp(-std::max(0.0, picture.force_N) / kScale_N);
  const double width = 0.16 * area.height();
  const QRectF column(area.center().x() - width / 2, area.top() + 0.36 * area.height(), width,
                      0.53 * area.height());
  QPainterPath outline;
  outline.addRoundedRect(column, width / 4, width / 4);
  painter.fillPath(outline, kFaint);
  painter.save();
  painter.setClipPath(outline);
  painter.fillRect(QRectF(column.left(), column.bottom() - fill * column.height(), width,
                          fill * column.height()),
                   kDot);
  painter.restore();
  painter.setPen(QPen(kSoftInk, 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(outline);
  const double hand = 0.26 * area.height();
  draw_sign(painter,
            QRectF(area.center().x() - 2.3 * hand, area.top() + 0.48 * area.height(), hand, hand),
            PatientPicture::Sign::squeeze);
}

void draw_tracking(QPainter& painter, const QRectF& area, const PatientPicture& picture) {
  constexpr double kBehind_s = 1.5;
  constexpr double kAhead_s = 4.0;
  constexpr int kSteps = 160;
  const TargetPreview& preview = *picture.preview;
  draw_line(painter, area, part(area, 0.06, 0.05, 0.94, 0.17),
            QString::fromStdString(picture.headline), 0.085, true, kInk);
  draw_line(painter, area, part(area, 0.06, 0.17, 0.94, 0.25),
            QString::fromStdString(picture.detail), 0.045, false, kSoftInk);

  const QRectF field = part(area, 0.0, 0.30, 1.0, 0.90);
  const double px_per_s = field.width() / (kBehind_s + kAhead_s);
  const double now_x = field.left() + kBehind_s * px_per_s;
  const auto y_of = [&](double force_N) {
    const double share = std::clamp(force_N / picture.top_N, -0.05, 1.05);
    return field.bottom() - share * field.height();
  };
  painter.setPen(Qt::NoPen);
  painter.fillRect(field, Qt::white);
  painter.setPen(QPen(kFaint, 2));
  painter.drawLine(QPointF(field.left(), y_of(0.0)), QPointF(field.right(), y_of(0.0)));

  const double half_band = 0.055 * field.height();
  QPolygonF line, band;
  for (int k = 0; k <= kSteps; ++k) {
    const double t_s = picture.task_time_s - kBehind_s + (kBehind_s + kAhead_s) * k / kSteps;
    if (t_s > preview.end_s()) break;
    line.append({field.left() + field.width() * k / kSteps, y_of(preview.at(t_s))});
  }
  for (const auto& point : line) band.append(point - QPointF(0, half_band));
  for (auto point = line.rbegin(); point != line.rend(); ++point)
    band.append(*point + QPointF(0, half_band));
  painter.setPen(Qt::NoPen);
  painter.setBrush(kBand);
  painter.drawPolygon(band);
  painter.setPen(QPen(kBandEdge, 3));
  painter.drawPolyline(line);

  painter.setPen(QPen(kSoftInk, 2, Qt::DashLine));
  painter.drawLine(QPointF(now_x, field.top()), QPointF(now_x, field.bottom()));
  const QPointF dot(now_x, y_of(picture.force_N));
  const bool inside = std::abs(dot.y() - y_of(picture.target_N)) <= half_band;
  const double radius = 0.036 * area.height();
  painter.setPen(QPen(Qt::white, 4));
  painter.setBrush(kDot);
  if (inside)
    paint_check(painter, dot, radius);
  else
    painter.drawEllipse(dot, radius, radius);
}

}  // namespace

void paint_page(QPainter& painter, const QRectF& area, const PatientPicture& picture) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(area, kPaper);
  switch (picture.page) {
    case PatientPicture::Page::effort: draw_effort(painter, area, picture); break;
    case PatientPicture::Page::tracking: draw_tracking(painter, area, picture); break;
    default: draw_message(painter, area, picture);
  }
  if (picture.progress_shown) draw_progress(painter, area, picture.progress);
  paint_notice(painter, area, picture);
  if (picture.simulated) draw_simulated(painter, area);
}

void paint_banner(QPainter& painter, const QRectF& area, const PatientPicture& picture) {
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF strip = part(area, 0.0, 0.0, 1.0, kBannerShare);
  painter.fillRect(strip, kPaper);
  painter.fillRect(QRectF(strip.left(), strip.bottom() - 2, strip.width(), 2), kFaint);
  const bool alone = picture.detail.empty() && picture.target_count == 0;
  draw_line(painter, area,
            alone ? part(area, 0.12, 0.02, 0.88, 0.17) : part(area, 0.12, 0.015, 0.88, 0.115),
            QString::fromStdString(picture.headline), 0.075, true, kInk);
  if (!picture.detail.empty())
    draw_line(painter, area, part(area, 0.12, 0.112, 0.88, 0.172),
              QString::fromStdString(picture.detail), 0.042, false, kSoftInk);
  // One mark per target, at the left: reached ones carry a check.
  const double radius = 0.017 * area.height();
  for (int i = 0; i < picture.target_count; ++i) {
    const QPointF centre(area.left() + 0.045 * area.height() + 2.6 * radius * i,
                         area.top() + 0.053 * area.height());
    if (i < picture.targets_reached) {
      paint_check(painter, centre, radius);
    } else {
      painter.setPen(QPen(kSoftInk, 2));
      painter.setBrush(Qt::NoBrush);
      painter.drawEllipse(centre, radius - 1, radius - 1);
    }
  }
  if (picture.simulated) draw_simulated(painter, area);
}

void paint_hold_ring(QPainter& painter, const QPointF& centre, double radius, double fraction) {
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF box(centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius);
  const double width = 0.36 * radius;
  painter.setBrush(Qt::white);
  painter.setPen(QPen(Qt::white, 1.5 * width));
  painter.drawEllipse(box);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kFaint, width));
  painter.drawEllipse(box);
  painter.setPen(QPen(kGood, width, Qt::SolidLine, Qt::FlatCap));
  constexpr int kDegree = 16;
  painter.drawArc(box, 90 * kDegree, -static_cast<int>(360 * kDegree * std::min(1.0, fraction)));
}

void paint_check(QPainter& painter, const QPointF& centre, double radius) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(Qt::white, std::max(2.0, 0.14 * radius)));
  painter.setBrush(kGood);
  painter.drawEllipse(centre, radius, radius);
  painter.setPen(QPen(Qt::white, 0.24 * radius, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawPolyline(
      polygon({centre + radius * QPointF(-0.45, 0.03), centre + radius * QPointF(-0.12, 0.36),
               centre + radius * QPointF(0.48, -0.34)}));
}

void paint_notice(QPainter& painter, const QRectF& area, const PatientPicture& picture) {
  if (picture.notice == PatientPicture::Notice::none) return;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(area, QColor(0xF4, 0xF6, 0xF8, 205));
  const bool fault = picture.notice == PatientPicture::Notice::fault;
  const QRectF panel = part(area, 0.10, 0.26, 0.90, 0.78);
  painter.setPen(QPen(fault ? kWarn : kDot, 4));
  painter.setBrush(Qt::white);
  painter.drawRoundedRect(panel, 18, 18);
  const QPointF centre(panel.center().x(), panel.top() + 0.13 * area.height());
  const double size = 0.075 * area.height();
  if (fault) {
    painter.setPen(QPen(kWarn, 5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(polygon({centre + QPointF(0, -size), centre + QPointF(1.15 * size, size),
                                 centre + QPointF(-1.15 * size, size)}));
    painter.setPen(QPen(kWarn, 7, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(centre + QPointF(0, -0.35 * size), centre + QPointF(0, 0.3 * size));
    painter.drawPoint(centre + QPointF(0, 0.68 * size));
  } else {
    painter.setPen(Qt::NoPen);
    painter.setBrush(kDot);
    for (const double side : {-1.0, 1.0})
      painter.drawRoundedRect(QRectF(centre.x() + side * 0.45 * size - 0.2 * size,
                                     centre.y() - 0.8 * size, 0.4 * size, 1.6 * size),
                              5, 5);
  }
  // One sentence a line, the first one large.
  const auto sentences =
      QString::fromStdString(picture.notice_words).split(QStringLiteral(". "), Qt::SkipEmptyParts);
  double top = 0.50;
  for (int i = 0; i < sentences.size(); ++i) {
    const double height = i == 0 ? 0.095 : 0.07;
    QString words = sentences[i];
    if (!words.endsWith(QLatin1Char('.'))) words += QLatin1Char('.');
    draw_line(painter, area, part(area, 0.13, top, 0.87, top + height), words,
              i == 0 ? 0.075 : 0.05, i == 0, i == 0 ? kInk : kSoftInk);
    top += height;
  }
}

}  // namespace isograsp
