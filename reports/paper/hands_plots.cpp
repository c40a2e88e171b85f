// SPDX-License-Identifier: GPL-3.0-or-later
// Trials of both hands, each on its platform, against time: the force of each over what was asked
// of it, or of both together; where they move an object together, what it did and what each hand
// did for it.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "hand/two_hands_columns.hpp"
#include "reports/paper/plot_tools.hpp"
#include "reports/paper/plots.hpp"

namespace isograsp::reports {

namespace {

constexpr double kMillimetresOfMove = 1000.0;
constexpr double kDegreesOfTilt = 180.0 / std::numbers::pi;

struct HandsLine {
  Column column;
  Column target;
  Words name;
  QColor color;
};

/// One or several pairs of axes, one below the other, over one time.
class HandsPlot {
 public:
  HandsPlot(const TaskSection& section, const DrawnTrial& trial, QSizeF size, double unit,
            const Language& language)
      : view(size, unit, language), section_(section), curves_(trial.curves) {
    const auto t_s = curves_.column(columns::t_s);
    for (const double t : t_s) x_.push_back(t - t_s.front());
  }

  void draw_forces() {
    const std::array<HandsLine, 3> lines{
        {{columns::sum_force_N, columns::target_sum_force_N, "both hands"_text, Palette::ink()},
         line_of(Hand::left, columns::hand_grip, columns::target_hand_grip),
         line_of(Hand::right, columns::hand_grip, columns::target_hand_grip)}};
    QCPAxisRect& rect = axes(0, 1, "grip force [N]"_text);
    Values all{0.0};
    bool asked = false;
    for (const HandsLine& line : lines) {
      const bool has_target = any_number(curves_.column(line.target));
      // Their sum is of interest where it has a target.
      if (&line == &lines[0] && !has_target) continue;
      if (has_target) all += add(rect, column(line.target, 1.0), target_pen());
      all += add(rect, column(line.column, 1.0), QPen(line.color, view.px(1.1)));
      view.explain(PlotView::Mark::line, line.color, line.name);
      asked = asked || has_target;
    }
    if (asked) view.explain(PlotView::Mark::dashed, Palette::target(), "target"_text);
    rect.axis(QCPAxis::atLeft)->setRange(range_of({&all}));
  }

  /// The ends of an object that is lifted, from where it rested; its tilt; what raises it.
  void draw_lift() {
    constexpr int kRects = 3;
    const auto tolerance = section_.spec->tolerance();
    const double rest_mm = first(columns::actual_position[1]) * kMillimetresOfMove;
    QCPAxisRect& height = axes(0, kRects, "height [mm]"_text);
    const double band_mm = tolerance ? kMillimetresOfMove * tolerance->position_m : 0.0;
    Values all = add_band(
        height, less(column(columns::target_position[1], kMillimetresOfMove), rest_mm), band_mm);
    for (const Hand hand : kBothHands)
      all += add(height, less(column(columns::hand_end[hand][1], kMillimetresOfMove), rest_mm),
                 hand_pen(hand));
    height.axis(QCPAxis::atLeft)->setRange(range_of({&all}));
    QCPAxisRect& tilt = axes(1, kRects, "tilt [°]"_text);
    const double most_deg = tolerance ? kDegreesOfTilt * tolerance->angle_rad : 0.0;
    Values turned = add_band(tilt, scaled_zero(columns::target_angle_rad), most_deg);
    turned += add(tilt, column(columns::actual_angle_rad, kDegreesOfTilt),
                  QPen(Palette::ink(), view.px(1.1)));
    tilt.axis(QCPAxis::atLeft)->setRange(range_of({&turned}));
    draw_pushes(axes(2, kRects, "push up [N]"_text),
                {columns::hand_push.left[1], columns::hand_push.right[1]});
    explain_both();
    view.explain(PlotView::Mark::band, Palette::tolerance(), "tolerance"_text);
  }

  /// Where an object that is carried is, and what holds it.
  void draw_carry() {
    constexpr int kRects = 3;
    const auto tolerance = section_.spec->tolerance();
    const double band_mm = tolerance ? kMillimetresOfMove * tolerance->position_m : 0.0;
    constexpr std::array<Words, 2> kTitles{"x [mm]"_text, "y [mm]"_text};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      QCPAxisRect& rect = axes(static_cast<int>(axis), kRects, kTitles[axis]);
      Values all =
          add_band(rect, column(columns::target_position[axis], kMillimetresOfMove), band_mm);
      all += add(rect, column(columns::actual_position[axis], kMillimetresOfMove),
                 QPen(Palette::ink(), view.px(1.1)));
      rect.axis(QCPAxis::atLeft)->setRange(range_of({&all}));
    }
    draw_pushes(axes(2, kRects, "squeeze [N]"_text),
                {columns::hand_squeeze_N.left, columns::hand_squeeze_N.right});
    view.explain(PlotView::Mark::line, Palette::ink(), "object"_text);
    explain_both();
    view.explain(PlotView::Mark::band, Palette::tolerance(), "tolerance"_text);
  }

  PlotView view;

 private:
  static HandsLine line_of(Hand hand, const OfHands<Column>& column,
                           const OfHands<Column>& target) {
    return {column[hand], target[hand], hand == Hand::left ? "left hand"_text : "right hand"_text,
            Palette::of(hand)};
  }

  QCPAxisRect& axes(int place, int of, Words title) {
    return stacked_axes(view, place, of, x_.back(), title);
  }

  [[nodiscard]] Values column(std::string_view name, double factor) const {
    return scaled(curves_.column(name), factor);
  }
  [[nodiscard]] double first(std::string_view name) const {
    const auto values = curves_.column(name);
    return values.empty() ? 0.0 : values.front();
  }
  [[nodiscard]] static Values less(Values values, double offset) {
    for (double& value : values) value -= offset;
    return values;
  }
  /// Zero where the column has a value.
  [[nodiscard]] Values scaled_zero(std::string_view name) const { return column(name, 0.0); }

  /// The rows that are seen; returns their values.
  Values add(QCPAxisRect& rect, const Values& values, const QPen& pen) {
    if (values.isEmpty()) return {};
    const int bins = static_cast<int>(rect.minimumSize().width() / view.px(kFinest));
    const auto rows = visible_rows(values, bins);
    const Values seen = picked(values, rows);
    add_line(rect, picked(x_, rows), seen, pen);
    return seen;
  }
  /// A target with its tolerance to either side.
  Values add_band(QCPAxisRect& rect, const Values& target, double half) {
    Values low = target, high = target;
    for (double& value : low) value -= half;
    for (double& value : high) value += half;
    if (half > 0.0 && !target.isEmpty()) {
      QCPGraph& lower = add_line(rect, x_, low, QPen(Qt::NoPen));
      QCPGraph& upper = add_line(rect, x_, high, QPen(Qt::NoPen));
      upper.setBrush(Palette::tolerance());
      upper.setChannelFillGraph(&lower);
    }
    add(rect, target, target_pen());
    return low + high;
  }

  void draw_pushes(QCPAxisRect& rect, const OfHands<Column>& push) {
    Values all{0.0};
    for (const Hand hand : kBothHands) all += add(rect, column(push[hand], 1.0), hand_pen(hand));
    rect.axis(QCPAxis::atLeft)->setRange(range_of({&all}));
  }

  [[nodiscard]] QPen target_pen() const {
    return dashed(Palette::target(), view.px(0.9), {4.0, 2.5});
  }
  /// Told apart without their colours, too.
  [[nodiscard]] QPen hand_pen(Hand hand) const {
    return hand == Hand::left ? dashed(Palette::of(hand), view.px(1.1), {5.0, 2.0})
                              : QPen(Palette::of(hand), view.px(1.1));
  }
  void explain_both() {
    view.explain(PlotView::Mark::dashed, Palette::of(Hand::left), "left hand"_text);
    view.explain(PlotView::Mark::line, Palette::of(Hand::right), "right hand"_text);
  }

  const TaskSection& section_;
  const Signals& curves_;
  Values x_;
};

struct Course {
  Values x, y;
};
Course course_of(const ReportContent& content, std::optional<double> HandsShared::*value) {
  Course course;
  for (const HandsShared& row : content.both_hands.shared)
    if (const auto& known = row.*value) {
      course.x.push_back(content.sessions[row.session].number);
      course.y.push_back(*known);
    }
  return course;
}

void add_course_marks(QCPAxisRect& rect, const Course& course, const QPen& pen,
                      const QCPScatterStyle& style) {
  add_line(rect, course.x, course.y, pen).setScatterStyle(style);
}

}  // namespace

bool is_of_two_hands(const TaskSection& section) {
  return section.spec && section.spec->apparatus() == kTwoPlatforms;
}

bool lifts_object(const Signals& curves) {
  return any_number(curves.column(columns::hand_end.left[1]));
}

bool carries_object(const Signals& curves) {
  return any_number(curves.column(columns::both_hold));
}

bool moves_object(const TaskSection& section) {
  return is_of_two_hands(section) && section.last &&
         (lifts_object(section.last->curves) || carries_object(section.last->curves));
}

PlotView hands_plot(const TaskSection& section, const DrawnTrial& trial, QSizeF size, double unit,
                    const Language& language) {
  HandsPlot plot(section, trial, size, unit, language);
  if (lifts_object(trial.curves))
    plot.draw_lift();
  else if (carries_object(trial.curves))
    plot.draw_carry();
  else
    plot.draw_forces();
  return std::move(plot.view);
}

PlotView hands_course_plot(const ReportContent& content, HandsCourse shown, QSizeF size,
                           double unit, const Language& language) {
  PlotView view(size, unit, language);
  const bool dated = ticks_have_dates(content);
  QCPAxisRect& rect =
      view.add_axes({kLeft, kAboveWithKey, size.width() - kLeft - kRight,
                     size.height() - kAboveWithKey - kBelow - (dated ? kDateLine : 0.0)});
  QCPAxis& across = *rect.axis(QCPAxis::atBottom);
  QCPAxis& up = *rect.axis(QCPAxis::atLeft);
  const SessionSpan span = session_span(content);
  across.setRange(span.low, span.high);
  across.setLabel(view.said("session"_text));
  add_session_ticks(view, across, content);
  const auto level = [&](double y) {
    add_line(rect, {span.low, span.high}, {y, y},
             dashed(Palette::quiet(), view.px(0.6), {1.5, 2.5}));
  };
  const std::optional<Hand> hand = content.both_hands.shared.back().affected;
  const QColor color = Palette::of(hand);
  const QPen pen(color, view.px(1.1));
  const QCPScatterStyle filled(
      hand == Hand::left ? QCPScatterStyle::ssSquare : QCPScatterStyle::ssCircle, pen, color,
      view.px(5.0));
  if (shown == HandsCourse::share) {
    constexpr double kHalf = 50.0, kAll = 100.0;
    up.setRange(0.0, kAll);
    up.setLabel(QStringLiteral("%"));
    level(kHalf);
    add_course_marks(rect, course_of(content, &HandsShared::share_percent), pen, filled);
    // Open and larger: where both are one, either is seen.
    add_course_marks(rect, course_of(content, &HandsShared::capacity_percent),
                     dashed(Palette::ink(), view.px(0.9), {4.0, 2.5}),
                     {QCPScatterStyle::ssDiamond, QPen(Palette::ink(), view.px(0.9)), Qt::NoBrush,
                      view.px(9.0)});
    view.explain(PlotView::Mark::line, color, "of the force"_text);
    view.explain(PlotView::Mark::dashed, Palette::ink(), "of what both can do"_text);
    view.explain(PlotView::Mark::dotted, Palette::quiet(), "half"_text);
    return view;
  }
  const Course lag = course_of(content, &HandsShared::lag_s);
  constexpr double kLeast_s = 0.1, kAirAround = 1.25;
  double most_s = kLeast_s;
  for (const double lag_s : lag.y) most_s = std::max(most_s, kAirAround * std::abs(lag_s));
  up.setRange(-most_s, most_s);
  up.setLabel(view.said("lag [s]"_text));
  level(0.0);
  add_course_marks(rect, lag, pen, filled);
  view.explain(PlotView::Mark::line, color, "above 0 it follows, below it goes before"_text);
  return view;
}

}  // namespace isograsp::reports
