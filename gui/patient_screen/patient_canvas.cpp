// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/patient_screen/patient_canvas.hpp"

#include <QLocale>
#include <QObject>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "gui/look/look.hpp"
#include "gui/patient_screen/hand_footer.hpp"
#include "gui/patient_screen/patient_directions.hpp"
#include "gui/patient_screen/patient_ink.hpp"
#include "gui/patient_screen/patient_range.hpp"
#include "gui/patient_screen/patient_signs.hpp"
#include "gui/patient_screen/patient_two_hands.hpp"
#include "gui/training_looks/curve_view.hpp"

namespace isograsp::gui {

using namespace ink;

namespace ink {

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

}  // namespace ink

namespace {

QFont badge_font(const QRectF& area) {
  return font_of(area, 0.026, true);
}

QString badge_words(const PatientPicture& picture) {
  return picture.example     ? QObject::tr("EXAMPLE")
         : picture.simulated ? QObject::tr("SIMULATED")
                             : QString();
}

/// Where the mark of an example or a simulation stands; empty: there is none.
QRectF badge_place(const QRectF& area, const PatientPicture& picture) {
  const QString text = badge_words(picture);
  if (text.isEmpty()) return {};
  const double edge = 0.03 * area.height();
  const double width = QFontMetricsF(badge_font(area)).horizontalAdvance(text) + edge;
  return {area.right() - width - edge, area.top() + edge, width, 0.046 * area.height()};
}

/// The mark on every picture of an example or a simulation, which the patient must not take for
/// their own.
void draw_badge(QPainter& painter, const QRectF& area, const PatientPicture& picture) {
  const QRectF badge = badge_place(area, picture);
  if (badge.isEmpty()) return;
  painter.setPen(QPen(Qt::white, 2));  // also on a dark head
  painter.setBrush(kInk);
  painter.drawRoundedRect(badge, 5, 5);
  painter.setFont(badge_font(area));
  painter.setPen(Qt::white);
  painter.drawText(badge, Qt::AlignCenter, badge_words(picture));
}

/// The headline in `line`. Words that would reach under the mark at the right end before it.
void draw_headline(QPainter& painter, const QRectF& area, const PatientPicture& picture,
                   QRectF line, double share, const QColor& colour) {
  const QString words = QString::fromStdString(picture.headline);
  const QRectF badge = badge_place(area, picture);
  const double gap = 0.02 * area.height();
  const double width = QFontMetricsF(font_of(area, share, true)).horizontalAdvance(words);
  const double right = line.center().x() + std::min(width, line.width()) / 2.0;
  if (!badge.isEmpty() && right > badge.left() - gap) line.setRight(badge.left() - gap);
  draw_line(painter, area, line, words, share, true, colour);
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

/// Headline and detail at the top, white on dark while something is to be done: a change that can
/// be seen without reading and without colours.
void draw_words(QPainter& painter, const QRectF& area, const PatientPicture& picture,
                double left = 0.06) {
  if (picture.urgent) painter.fillRect(part(area, 0.0, 0.0, 1.0, 0.28), kInk);
  const double share = picture.urgent ? 0.115 : 0.085;
  draw_headline(painter, area, picture, part(area, left, 0.03, 1.0 - left, 0.17), share,
                picture.urgent ? QColor(Qt::white) : kInk);
  draw_line(painter, area, part(area, left, 0.17, 1.0 - left, 0.26),
            QString::fromStdString(picture.detail), 0.05, false,
            picture.urgent ? QColor(Qt::white) : kSoftInk);
}

/// A circle that breathes, in it the seconds that are left, round it a ring of which a whole round
/// is a minute.
void draw_rest_circle(QPainter& painter, const QRectF& area, const QPointF& centre, double radius,
                      const PatientPicture& picture) {
  constexpr double kRound_s = 60.0;
  constexpr int kDegree = 16;
  const double inner = (0.66 + 0.20 * picture.breath) * radius;
  QRadialGradient glow(centre, inner);
  glow.setColorAt(0.0, QColor(0xE6, 0xF1, 0xF4));
  glow.setColorAt(1.0, QColor(0xB5, 0xD5, 0xDD));
  painter.setPen(Qt::NoPen);
  painter.setBrush(glow);
  painter.drawEllipse(centre, inner, inner);
  const QRectF ring(centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kFaint, 0.07 * radius));
  painter.drawEllipse(ring);
  painter.setPen(QPen(kDot, 0.07 * radius, Qt::SolidLine, Qt::RoundCap));
  const double share = std::min(1.0, *picture.rest_left_s / kRound_s);
  painter.drawArc(ring, 90 * kDegree, static_cast<int>(360 * kDegree * share));
  draw_line(painter, area, QRectF(centre.x() - inner, centre.y() - inner, 2 * inner, 2 * inner),
            QLocale().toString(static_cast<int>(std::ceil(*picture.rest_left_s))), 0.11, true,
            kInk);
}

void draw_message(QPainter& painter, const QRectF& area, const PatientPicture& picture) {
  if (picture.urgent) {
    const double size = 0.5 * area.height();
    draw_words(painter, area, picture);
    return paint_sign(
        painter,
        QRectF(area.center().x() - size / 2, area.top() + 0.36 * area.height(), size, size),
        picture);
  }
  const double size = 0.34 * area.height();
  const QPointF middle(area.center().x(), area.top() + 0.31 * area.height());
  if (picture.rest_left_s)
    draw_rest_circle(painter, area, middle, 0.56 * size, picture);
  else
    paint_sign(painter, QRectF(middle.x() - size / 2, middle.y() - size / 2, size, size), picture);
  draw_line(painter, area, part(area, 0.06, 0.53, 0.94, 0.67),
            QString::fromStdString(picture.headline), 0.095, true, kInk);
  draw_line(painter, area, part(area, 0.08, 0.68, 0.92, 0.78),
            QString::fromStdString(picture.detail), 0.05, false, kSoftInk);
}

void draw_column(QPainter& painter, const QRectF& column, const PatientPicture& picture) {
  // More force always fills more, whatever the patient's maximum is.
  const double fill = 1.0 - std::exp(-std::max(0.0, picture.force_N) / picture.full_N);
  QPainterPath outline;
  outline.addRoundedRect(column, column.width() / 4, column.width() / 4);
  painter.fillPath(outline, kFaint);
  painter.save();
  painter.setClipPath(outline);
  painter.fillRect(QRectF(column.left(), column.bottom() - fill * column.height(), column.width(),
                          fill * column.height()),
                   kDot);
  painter.restore();
  painter.setPen(QPen(kSoftInk, 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(outline);
}

void draw_effort(QPainter& painter, const QRectF& area, const PatientPicture& picture) {
  draw_words(painter, area, picture);
  const double sign = 0.40 * area.height();
  const double middle = area.center().x();
  const double left = picture.force_shown ? middle - 1.2 * sign : middle - 0.5 * sign;
  paint_sign(painter, QRectF(left, area.top() + 0.42 * area.height(), sign, sign), picture);
  if (!picture.force_shown) return;
  const double width = 0.16 * area.height();
  draw_column(
      painter,
      QRectF(middle + 0.3 * sign, area.top() + 0.36 * area.height(), width, 0.54 * area.height()),
      picture);
}

/// A diagram with time to the right and force up. It moves, and the present stays at one place. In
/// the calm form the diagram stands still while the present moves across it; it shows the next page
/// before less of the future than usual would be visible.
class Field {
 public:
  Field(const QRectF& field, const PatientPicture& picture, double behind_s, double ahead_s)
      : field_(field), axis_(picture.axis) {
    const double now_s = picture.task_time_s;
    double shown_s = behind_s + ahead_s;
    begin_s_ = now_s - behind_s;
    if (picture.calm && picture.preview != nullptr) {
      constexpr double kMargin = 0.06;  // the mark is whole at the beginning of a page
      shown_s *= 2.0;
      const double page_s = (1.0 - kMargin) * shown_s - ahead_s;
      begin_s_ = page_s * std::floor(now_s / page_s) - kMargin * shown_s;
    }
    end_s_ = begin_s_ + shown_s;
    px_per_s_ = field.width() / shown_s;
  }
  [[nodiscard]] double begin_s() const { return begin_s_; }
  [[nodiscard]] double end_s() const { return end_s_; }
  [[nodiscard]] double x(double task_time_s) const {
    return field_.left() + (task_time_s - begin_s_) * px_per_s_;
  }
  [[nodiscard]] double y(double force_N) const {
    return field_.bottom() - axis_.share(force_N) * field_.height();
  }

 private:
  QRectF field_;
  ForceAxis axis_;
  double px_per_s_ = 0.0;
  double begin_s_ = 0.0;
  double end_s_ = 0.0;
};

void draw_band(QPainter& painter, const QPolygonF& line, double half_band) {
  QPolygonF band;
  for (const auto& point : line) band.append(point - QPointF(0, half_band));
  for (auto point = line.rbegin(); point != line.rend(); ++point)
    band.append(*point + QPointF(0, half_band));
  painter.setPen(Qt::NoPen);
  painter.setBrush(kBand);
  painter.drawPolygon(band);
  painter.setPen(QPen(kBandEdge, 3));
  painter.drawPolyline(line);
}

/// The target as time passes, from left to right; where it has no value on the screen the line is
/// broken.
std::vector<QPolygonF> target_lines(const PatientPicture& picture, const Field& place,
                                    const QRectF& field) {
  constexpr int kSteps = 160;
  if (!picture.line_shown) return {};
  if (picture.preview == nullptr) {
    const double y = place.y(picture.target_N);
    return {polygon({{field.left(), y}, {field.right(), y}})};
  }
  std::vector<QPolygonF> lines;
  QPolygonF line;
  for (int k = 0; k <= kSteps; ++k) {
    const double t_s = place.begin_s() + (place.end_s() - place.begin_s()) * k / kSteps;
    const auto target_N = picture.preview->at(t_s, picture.task_time_s);
    if (target_N) line.append({place.x(t_s), place.y(*target_N)});
    if (target_N && k < kSteps) continue;
    lines.push_back(line);
    line.clear();
  }
  return lines;
}

void draw_dot(QPainter& painter, const QPointF& dot, double radius, bool inside) {
  if (inside) return paint_check(painter, dot, radius);
  painter.setPen(QPen(Qt::white, 4));
  painter.setBrush(kDot);
  painter.drawEllipse(dot, radius, radius);
}

void draw_tracking(QPainter& painter, const QRectF& area, const PatientPicture& picture) {
  constexpr double kBehind_s = 1.5;
  const bool sign = picture.sign == PatientPicture::Sign::act && picture.channel != ForceChannel{};
  const double sign_side = 0.22 * area.height();
  const double sign_left = 0.05;
  draw_words(painter, area, picture, sign ? sign_left + 0.03 + sign_side / area.width() : 0.06);
  constexpr double kFieldTop = 0.30;
  const QRectF field = part(area, 0.0, kFieldTop, 1.0, kFieldTop + kFieldShare);
  // With a future the present stands at the left, without one in the middle of the screen.
  const bool future = picture.preview != nullptr;
  const double ahead_s = future ? picture.preview->ahead_s : kBehind_s;
  const Field place(field, picture, kBehind_s, ahead_s);
  const double now_x = place.x(picture.task_time_s);
  const double half_band = kHalfBandShare * field.height();
  const auto targets = target_lines(picture, place, field);
  const double radius = 0.036 * area.height();
  if (picture.look != tasks::Look::plain) {
    CurveView view;
    view.field = field;
    view.light = picture.light;
    view.targets = targets;
    view.half_band_px = half_band;
    view.zero_y = place.y(0.0);
    view.mark_shown = picture.force_shown;
    view.mark = QPointF(now_x, place.y(picture.force_N));
    view.mark_radius_px = radius;
    view.on_target = picture.on_target;
    view.px_per_s = place.x(1.0) - place.x(0.0);
    view.begin_s = place.begin_s();
    paint_curve_look(painter, picture.look, view);
  } else {
    painter.fillRect(field, Qt::white);
    painter.setPen(QPen(kZero, 3));
    painter.drawLine(QPointF(field.left(), place.y(0.0)), QPointF(field.right(), place.y(0.0)));
    for (const QPolygonF& line : targets) draw_band(painter, line, half_band);
    painter.setPen(QPen(kSoftInk, 2, Qt::DashLine));
    painter.drawLine(QPointF(now_x, field.top()), QPointF(now_x, field.bottom()));
    if (picture.force_shown)
      draw_dot(painter, {now_x, place.y(picture.force_N)}, radius, picture.on_target);
  }
  if (picture.sign == PatientPicture::Sign::let_go) {
    const double size = 0.44 * area.height();
    paint_sign(
        painter,
        QRectF(field.left() + 0.14 * area.width(), field.center().y() - 0.5 * size, size, size),
        picture);
  }
  if (sign)
    paint_sign(painter,
               QRectF(area.left() + sign_left * area.width(), area.top() + 0.04 * area.height(),
                      sign_side, sign_side),
               picture);
}

void draw_directions(QPainter& painter, const QRectF& area, const PatientPicture& picture) {
  draw_words(painter, area, picture);
  paint_directions(painter, part(area, 0.03, 0.27, 0.97, 0.93), picture);
}

}  // namespace

void paint_page(QPainter& painter, const QRectF& area, const PatientPicture& picture) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(area, kPaper);
  switch (picture.page) {
    case PatientPicture::Page::effort: draw_effort(painter, area, picture); break;
    case PatientPicture::Page::tracking: draw_tracking(painter, area, picture); break;
    case PatientPicture::Page::directions: draw_directions(painter, area, picture); break;
    case PatientPicture::Page::range:
      draw_words(painter, area, picture);
      paint_range(painter, part(area, 0.06, 0.30, 0.94, 0.92), picture);
      break;
    case PatientPicture::Page::two_hands:
      draw_words(painter, area, picture);
      paint_two_hands(painter, area, picture);
      break;
    default: draw_message(painter, area, picture);
  }
  if (picture.progress_shown) draw_progress(painter, area, picture.progress);
  paint_camera_sign(painter, area, picture);
  paint_notice(painter, area, picture);
  draw_badge(painter, area, picture);
}

void paint_banner(QPainter& painter, const QRectF& area, const PatientPicture& picture) {
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF strip = part(area, 0.0, 0.0, 1.0, kBannerShare);
  painter.fillRect(strip, kPaper);
  painter.fillRect(QRectF(strip.left(), strip.bottom() - 2, strip.width(), 2), kFaint);
  const bool alone = picture.detail.empty() && picture.target_count == 0;
  draw_headline(painter, area, picture,
                alone ? part(area, 0.12, 0.02, 0.88, 0.17) : part(area, 0.12, 0.015, 0.88, 0.115),
                0.075, kInk);
  if (!picture.detail.empty())
    draw_line(painter, area, part(area, 0.12, 0.112, 0.88, 0.172),
              QString::fromStdString(picture.detail), 0.042, false, kSoftInk);
  paint_target_marks(painter,
                     {area.left() + 0.045 * area.height(), area.top() + 0.053 * area.height()},
                     0.017 * area.height(), picture);
  draw_badge(painter, area, picture);
}

void paint_target_marks(QPainter& painter, const QPointF& first, double radius,
                        const PatientPicture& picture) {
  constexpr double kApart = 2.6;  // radii
  for (int i = 0; i < picture.target_count; ++i) {
    const QPointF centre(first.x() + kApart * radius * i, first.y());
    if (i < picture.targets_reached) {
      paint_check(painter, centre, radius);
    } else {
      painter.setPen(QPen(kSoftInk, 2));
      painter.setBrush(Qt::NoBrush);
      painter.drawEllipse(centre, radius - 1, radius - 1);
    }
  }
}

void paint_hold_ring(QPainter& painter, const QPointF& centre, double radius, double fraction,
                     double thick) {
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF box(centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius);
  const double width = thick * radius;
  painter.setBrush(Qt::NoBrush);  // block and outline are seen through it
  painter.setPen(QPen(Qt::white, 1.5 * width));
  painter.drawEllipse(box);
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
  painter.fillRect(area, kPaperSeenThrough);
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

}  // namespace isograsp::gui
