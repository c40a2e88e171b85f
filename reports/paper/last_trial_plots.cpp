// SPDX-License-Identifier: GPL-3.0-or-later
// A trial over its target, and what each finger pressed.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "hand/columns.hpp"
#include "reports/paper/plot_tools.hpp"
#include "reports/paper/plots.hpp"
#include "tasks/task.hpp"

namespace isograsp::reports {

namespace {

void add_band(QCPAxisRect& rect, const Values& x, const Values& low, const Values& high) {
  QCPGraph& lower = add_line(rect, x, low, QPen(Qt::NoPen));
  QCPGraph& upper = add_line(rect, x, high, QPen(Qt::NoPen));
  upper.setBrush(Palette::tolerance());
  upper.setChannelFillGraph(&lower);
}

/// Marks the stretches of `phase` as not scored.
void shade_phase(PlotView& view, QCPAxisRect& rect, const Signals& curves, tasks::Phase phase,
                 Words word) {
  const auto phases = curves.column(columns::phase);
  const auto t_s = curves.column(columns::t_s);
  bool told = false;
  for (std::size_t row = 0; row < phases.size();) {
    std::size_t end = row;
    while (end < phases.size() && phases[end] == static_cast<double>(phase)) ++end;
    if (end == row) {
      ++row;
      continue;
    }
    auto* box = new QCPItemRect(rect.parentPlot());  // the plot owns it
    for (auto* position : {box->topLeft, box->bottomRight})
      position->setAxes(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
    box->setClipAxisRect(&rect);
    const QCPRange range = rect.axis(QCPAxis::atLeft)->range();
    box->topLeft->setCoords(t_s[row] - t_s.front(), range.upper);
    box->bottomRight->setCoords(t_s[std::min(end, t_s.size() - 1)] - t_s.front(), range.lower);
    box->setPen(Qt::NoPen);
    box->setBrush(Palette::band());
    box->setLayer("background");
    told = true;
    row = end;
  }
  if (told) view.explain(PlotView::Mark::band, Palette::band(), word);
}

struct Channel {
  Column target;
  Column actual;
  Words title;  ///< of the axis, with unit
  double factor;
};
constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr Channel kForce{columns::target_force_N, columns::actual_force_N, "grip force [N]"_text,
                         1.0};
constexpr Channel kPose[] = {
    {columns::target_position[0], columns::actual_position[0], "x [mm]"_text, 1000.0},
    {columns::target_position[1], columns::actual_position[1], "y [mm]"_text, 1000.0},
    {columns::target_angle_rad, columns::actual_angle_rad, "angle [°]"_text, kDegrees}};

/// Half width of the tolerance band at this target value; 0: none.
double tolerance(const TaskSection& section, const Channel& channel, double target) {
  if (!section.spec) return 0.0;
  constexpr double kBand = 0.05;  // of the target: measure time_in_range
  if (section.spec->kind->follows_curve) return kBand * target;
  const auto pose = section.spec->tolerance();
  if (!pose || !section.spec->kind->path_drawn) return 0.0;
  return channel.factor *
         (channel.actual == columns::actual_angle_rad ? pose->angle_rad : pose->position_m);
}

Values elapsed(const Signals& curves) {
  const auto t_s = curves.column(columns::t_s);
  Values elapsed_s;
  elapsed_s.reserve(static_cast<int>(t_s.size()));
  for (const double t : t_s) elapsed_s.push_back(t - t_s.front());
  return elapsed_s;
}

/// Target with its tolerance, and what the patient did, in one pair of axes.
void draw_channel(PlotView& view, QCPAxisRect& rect, const TaskSection& section,
                  const Signals& curves, const Channel& channel, bool first) {
  const Values x = elapsed(curves);
  // The axes have their size from the beginning; width() holds only once they are painted.
  const int bins = static_cast<int>(rect.minimumSize().width() / view.px(kFinest));
  const Values all_targets = scaled(curves.column(channel.target), channel.factor);
  const auto target_rows = visible_rows(all_targets, bins);
  const Values target_x = picked(x, target_rows);
  const Values target = picked(all_targets, target_rows);
  const Values all_actual = scaled(curves.column(channel.actual), channel.factor);
  const auto actual_rows = visible_rows(all_actual, bins);
  const Values actual = picked(all_actual, actual_rows);
  const bool has_target = any_number(curves.column(channel.target));
  rect.axis(QCPAxis::atBottom)->setRange(0.0, x.back());
  rect.axis(QCPAxis::atLeft)->setLabel(view.said(channel.title));

  Values low;
  Values high;
  double widest = 0.0;
  for (const double value : target) {
    const double half = tolerance(section, channel, value);
    if (std::isfinite(half)) widest = std::max(widest, half);
    low.push_back(value - half);
    high.push_back(value + half);
  }
  rect.axis(QCPAxis::atLeft)->setRange(range_of({&low, &high, &actual}));
  const QColor color = Palette::of(section.hand);
  if (has_target && widest > 0.0) add_band(rect, target_x, low, high);
  if (has_target)
    add_line(rect, target_x, target, dashed(Palette::target(), view.px(0.9), {4.0, 2.5}));
  add_line(rect, picked(x, actual_rows), actual, QPen(color, view.px(1.1)));
  if (!first) return;
  if (!has_target) return;
  view.explain(PlotView::Mark::dashed, Palette::target(), "target"_text);
  if (widest > 0.0) view.explain(PlotView::Mark::band, Palette::tolerance(), "tolerance"_text);
  view.explain(PlotView::Mark::line, color, "patient"_text);
}

const Measure* find_measure(const DrawnTrial& last, std::string_view name) {
  const auto found = std::find_if(last.measures.begin(), last.measures.end(),
                                  [&](const Measure& m) { return m.name == name && m.value; });
  return found == last.measures.end() ? nullptr : &*found;
}

}  // namespace

PlotView overlay_plot(const TaskSection& section, const DrawnTrial& trial, QSizeF size, double unit,
                      const Language& language) {
  if (is_of_arm(section)) return arm_plot(section, trial, size, unit, language);
  if (is_of_two_hands(section)) return hands_plot(section, trial, size, unit, language);
  PlotView view(size, unit, language);
  const Signals& curves = trial.curves;
  const double width = size.width() - kLeft - kRight;
  const double height = size.height() - kAboveWithKey - kBelow;
  if (!has_path(section)) {
    QCPAxisRect& rect = view.add_axes({kLeft, kAboveWithKey, width, height});
    draw_channel(view, rect, section, curves, kForce, true);
    rect.axis(QCPAxis::atBottom)->setLabel(view.said("time [s]"_text));
    if (const Measure* best = find_measure(trial, "maximum_force_total")) {
      const double end_s = rect.axis(QCPAxis::atBottom)->range().upper;
      add_line(rect, {0.0, end_s}, {*best->value, *best->value},
               dashed(Palette::quiet(), view.px(0.8), {1.5, 2.0}));
      view.explain(PlotView::Mark::dotted, Palette::quiet(), "best mean"_text);
    }
    shade_phase(view, rect, curves, tasks::Phase::lead_in, "not scored"_text);
    shade_phase(view, rect, curves, tasks::Phase::paused, "paused"_text);
    return view;
  }
  constexpr double kGap = 7.0;
  const double each = (height - 2.0 * kGap) / 3.0;
  double top = kAboveWithKey;
  for (const Channel& channel : kPose) {
    QCPAxisRect& rect = view.add_axes({kLeft, top, width, each});
    const bool first = &channel == kPose;
    const bool last = &channel == kPose + 2;
    draw_channel(view, rect, section, curves, channel, first);
    rect.axis(QCPAxis::atLeft)->ticker()->setTickCount(3);
    rect.axis(QCPAxis::atBottom)->setTickLabels(last);
    if (last) rect.axis(QCPAxis::atBottom)->setLabel(view.said("time [s]"_text));
    if (first) shade_phase(view, rect, curves, tasks::Phase::paused, "paused"_text);
    top += each + kGap;
  }
  return view;
}

bool has_fingers(const TaskSection& section) {
  return section.last &&
         any_number(section.last->curves.column(columns::finger_force[index_of(Finger::thumb)][2]));
}

PlotView fingers_plot(const TaskSection& section, QSizeF size, double unit,
                      const Language& language) {
  PlotView view(size, unit, language);
  const Signals& curves = section.last->curves;
  struct Part {
    std::size_t axis;
    Words title;
  };
  constexpr Part kParts[] = {{2, "normal [N]"_text}, {0, "x [N]"_text}, {1, "y [N]"_text}};
  const std::array<QPen, kFingerCount> pens{
      QPen(Palette::ink(), view.px(1.0)), QPen(Palette::of(Hand::right), view.px(1.0)),
      dashed(Palette::of(Hand::left), view.px(1.0), {4.0, 2.0})};
  const Values x = elapsed(curves);
  const double width = size.width() - kLeft - kRight;
  constexpr double kGap = 7.0;
  const double each = (size.height() - kAboveWithKey - kBelow - 2.0 * kGap) / 3.0;
  const auto force_of = [&](Finger finger, const Part& part) {
    return scaled(curves.column(columns::finger_force[index_of(finger)][part.axis]), 1.0);
  };
  // Both tangential forces on one scale: that the one along the support is small must be seen.
  Values tangential{-0.5, 0.5};
  for (const Part& part : std::span(kParts).subspan(1))
    for (const Finger finger : kFingers) tangential += force_of(finger, part);
  double top = kAboveWithKey;
  for (const Part& part : kParts) {
    const bool first = &part == kParts;
    const bool last = &part == kParts + 2;
    QCPAxisRect& rect = view.add_axes({kLeft, top, width, each});
    std::array<Values, kFingerCount> forces;
    for (const Finger finger : kFingers) forces[index_of(finger)] = force_of(finger, part);
    rect.axis(QCPAxis::atBottom)->setRange(0.0, x.back());
    rect.axis(QCPAxis::atLeft)
        ->setRange(first ? range_of({&forces[0], &forces[1], &forces[2]})
                         : range_of({&tangential}));
    rect.axis(QCPAxis::atLeft)->setLabel(view.said(part.title));
    rect.axis(QCPAxis::atLeft)->ticker()->setTickCount(3);
    rect.axis(QCPAxis::atBottom)->setTickLabels(last);
    if (last) rect.axis(QCPAxis::atBottom)->setLabel(view.said("time [s]"_text));
    const int bins = static_cast<int>(rect.minimumSize().width() / view.px(kFinest));
    for (const Finger finger : kFingers) {
      const Values& force = forces[index_of(finger)];
      const auto rows = visible_rows(force, bins);
      add_line(rect, picked(x, rows), picked(force, rows), pens[index_of(finger)]);
      if (!first) continue;
      view.explain(finger == Finger::middle ? PlotView::Mark::dashed : PlotView::Mark::line,
                   pens[index_of(finger)].color(), digit_words(finger));
    }
    if (first) shade_phase(view, rect, curves, tasks::Phase::paused, "paused"_text);
    top += each + kGap;
  }
  return view;
}

Text describe_overlay(const TaskSection& section) {
  if (is_of_arm(section))
    return section.spec->kind->curve != nullptr
               ? "Angle of the link over time in the last trial."_text
               : "How far the object was from its reference over time in the last trial, and how "
                 "far forearm, wrist and fingers had turned."_text;
  if (is_of_two_hands(section) && section.last && lifts_object(section.last->curves))
    return "Height of both ends of the object over time in the last trial, its tilt, and the push up of each hand."_text;
  if (is_of_two_hands(section) && section.last && carries_object(section.last->curves))
    return "Place of the object over time in the last trial, with its targets, and the squeeze of each hand."_text;
  if (is_of_two_hands(section))
    return "Grip force of each hand over time in the last trial, with what was asked of them."_text;
  if (!has_path(section))
    return "Grip force of the patient over time in the last trial, with the target force where "
           "there is one."_text;
  return "Position and angle of the object over time in the last trial, with the target where "
         "there is one."_text;
}

}  // namespace isograsp::reports
