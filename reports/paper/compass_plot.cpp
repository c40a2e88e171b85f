// SPDX-License-Identifier: GPL-3.0-or-later
// The compass of one digit: three axes through a centre, closing upward, opening downward.
#include <cmath>
#include <numbers>

#include "reports/findings/compass.hpp"
#include "reports/paper/plot_tools.hpp"
#include "reports/paper/plots.hpp"
#include "reports/paper/plotting.hpp"
#include "tasks/facts/measure_words.hpp"

namespace isograsp::reports {

namespace {

constexpr double kRadians = std::numbers::pi / 180.0;
/// Opposite ways lie opposite each other.
constexpr std::array<double, kCompassPoints> kAngle_deg{90.0, 270.0, 30.0, 210.0, 150.0, 330.0};
constexpr double kCompassFont = 6.4;

/// Draws in newtons from the centre.
class Drawing {
 public:
  Drawing(PlotView& view, QCPAxisRect& rect) : view_(view), rect_(rect) {}

  void curve(const Values& x, const Values& y, const QPen& pen, const QBrush& brush = Qt::NoBrush) {
    auto* curve = new QCPCurve(rect_.axis(QCPAxis::atBottom), rect_.axis(QCPAxis::atLeft));
    curve->setData(x, y);  // the plot owns it
    curve->setPen(pen);
    curve->setBrush(brush);
  }
  void arc(double radius, double from_rad, double to_rad, const QPen& pen) {
    Values x, y;
    constexpr int kPieces = 48;
    for (int i = 0; i <= kPieces; ++i) {
      const double a = std::lerp(from_rad, to_rad, static_cast<double>(i) / kPieces);
      x.push_back(radius * std::cos(a));
      y.push_back(radius * std::sin(a));
    }
    curve(x, y, pen);
  }
  void mark(double x, double y, const QCPScatterStyle& style) {
    QCPGraph& one = add_line(rect_, {x}, {y}, QPen(Qt::NoPen));
    one.setLineStyle(QCPGraph::lsNone);
    one.setScatterStyle(style);
  }
  void word(double x, double y, const QString& text, Qt::Alignment align, const QColor& color) {
    auto* label = new QCPItemText(rect_.parentPlot());  // the plot owns it
    label->position->setAxes(rect_.axis(QCPAxis::atBottom), rect_.axis(QCPAxis::atLeft));
    label->setClipToAxisRect(false);
    label->position->setCoords(x, y);
    label->setPositionAlignment(align);
    label->setText(text);
    label->setFont(report_font(view_.px(kCompassFont), false));
    label->setColor(color);
  }

 private:
  PlotView& view_;
  QCPAxisRect& rect_;
};

/// The outer ring has the radius 1.
void draw_frame(Drawing& drawing, PlotView& view) {
  const QPen thin(Palette::line(), view.px(0.6));
  for (const double radius : {0.5, 1.0}) drawing.arc(radius, 0.0, 2.0 * std::numbers::pi, thin);
  for (std::size_t point = 0; point < kCompassPoints; ++point) {
    const double a = kRadians * kAngle_deg[point];
    drawing.curve({0.0, std::cos(a)}, {0.0, std::sin(a)}, thin);
    constexpr double kOutside = 1.06;
    const double x = kOutside * std::cos(a);
    const double y = kOutside * std::sin(a);
    const auto across = std::abs(std::cos(a)) < 0.1 ? Qt::AlignHCenter
                        : std::cos(a) > 0.0         ? Qt::AlignLeft
                                                    : Qt::AlignRight;
    const auto along = std::sin(a) > 0.1 ? Qt::AlignBottom : Qt::AlignTop;
    drawing.word(x, y, view.said(words_of(static_cast<CompassPoint>(point))), across | along,
                 Palette::ink());
  }
}

void draw_hand(Drawing& drawing, PlotView& view, const Compass& compass, Finger finger,
               double ring_N) {
  const CompassDigit& digit = compass.digits[index_of(finger)];
  const QColor color = Palette::of(compass.hand);
  // Round the compass, not in the order of the axes.
  constexpr std::array kRound{CompassPoint::radial, CompassPoint::closing, CompassPoint::distal,
                              CompassPoint::ulnar,  CompassPoint::opening, CompassPoint::proximal,
                              CompassPoint::radial};
  Values x, y;
  const auto shape =
      compass.hand == Hand::right ? QCPScatterStyle::ssCircle : QCPScatterStyle::ssSquare;
  for (const CompassPoint point : kRound) {
    const auto p = static_cast<std::size_t>(point);
    if (!digit.force_N[p]) continue;
    const double radius = std::max(0.0, *digit.force_N[p] / ring_N);
    const double a = kRadians * kAngle_deg[p];
    x.push_back(radius * std::cos(a));
    y.push_back(radius * std::sin(a));
    drawing.mark(x.back(), y.back(), {shape, QPen(color, view.px(0.9)), color, view.px(3.6)});
    if (digit.error_rad[p]) {
      QPen wide(Palette::pale(compass.hand), view.px(1.6));
      wide.setCapStyle(Qt::FlatCap);
      drawing.arc(radius, a - *digit.error_rad[p], a + *digit.error_rad[p], wide);
    }
  }
  if (x.isEmpty()) return;
  QColor faint = color;
  faint.setAlphaF(0.10);
  QPen outline(color, view.px(1.0));
  if (compass.hand == Hand::left) outline.setDashPattern({4.0, 2.0});
  drawing.curve(x, y, outline, faint);
  if (digit.resting_N)
    drawing.mark(0.0, *digit.resting_N / ring_N,
                 {QCPScatterStyle::ssDiamond, QPen(color, view.px(1.1)), Qt::white, view.px(5.0)});
}

}  // namespace

PlotView compass_plot(const std::vector<Compass>& compasses, Finger finger, double most_N,
                      QSizeF size, double unit, const Language& language) {
  PlotView view(size, unit, language);
  const double side = std::min(size.width() - 8.0, size.height() - 4.0);
  QCPAxisRect& rect = view.add_axes({(size.width() - side) / 2.0, 2.0, side, side});
  constexpr double kRoomForWords = 1.36;
  for (const auto at : {QCPAxis::atBottom, QCPAxis::atLeft}) {
    rect.axis(at)->setRange(-kRoomForWords, kRoomForWords);
    rect.axis(at)->setVisible(false);
    rect.axis(at)->grid()->setVisible(false);
  }
  Drawing drawing(view, rect);
  draw_frame(drawing, view);
  // A hand too weak to be seen beside the other one has a scale of its own.
  constexpr double kVisible = 1.0 / 3.0;
  double ring_y = 1.0;
  std::vector<Text> coflexion;
  for (const auto& compass : compasses) {
    const double own_N = compass_range({compass});
    const double ring_N = own_N < kVisible * most_N ? own_N : most_N;
    draw_hand(drawing, view, compass, finger, ring_N);
    const Text hand = side_words(compass.hand);
    drawing.word(1.30, ring_y + 0.28, view.said("ring %1 N %2"_text(shortest(ring_N), hand)),
                 Qt::AlignRight | Qt::AlignTop, Palette::of(compass.hand));
    ring_y -= 0.14;
    if (const auto& share = compass.digits[index_of(finger)].coflexion_percent)
      coflexion.push_back("%1 %2 %"_text(hand, value_number(*share, "%")));
  }
  const Text below = coflexion.empty() ? Text() : "co-flexion: %1"_text(listed(coflexion));
  drawing.word(0.0, -1.23, view.said(below), Qt::AlignHCenter | Qt::AlignTop, Palette::quiet());
  return view;
}

}  // namespace isograsp::reports
