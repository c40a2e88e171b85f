// SPDX-License-Identifier: GPL-3.0-or-later
// Trials that one platform does not measure, against time. Of an arm: how far the object is from
// its reference, and how far each link has turned, or the one angle that the task is about.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "hand/arm_columns.hpp"
#include "kinematics/attitude.hpp"
#include "reports/paper/plot_tools.hpp"
#include "reports/paper/plots.hpp"

namespace isograsp::reports {

namespace {

constexpr double kDegreesOfTurn = 180.0 / std::numbers::pi;
constexpr double kMillimetresOfWay = 1000.0;

/// Poses of one segment or of the reference, row by row; missing where a field is empty.
std::vector<Pose> poses_in(const Signals& curves, const columns::OfAxes& position,
                           const columns::OfComponents& attitude) {
  std::vector<Pose> poses(curves.rows(), missing_pose());
  std::array<std::span<const double>, 7> values;
  for (std::size_t a = 0; a < 3; ++a) values[a] = curves.column(position[a]);
  for (std::size_t i = 0; i < 4; ++i) values[3 + i] = curves.column(attitude[i]);
  for (const auto& column : values)
    if (column.empty()) return poses;
  for (std::size_t row = 0; row < poses.size(); ++row) {
    bool whole = true;
    for (const auto& column : values) whole = whole && !std::isnan(column[row]);
    if (whole)
      poses[row] = {{values[0][row], values[1][row], values[2][row]},
                    Quat(values[3][row], values[4][row], values[5][row], values[6][row])};
  }
  return poses;
}

std::vector<Pose> poses_of(const Signals& curves, ArmSegment segment) {
  const columns::OfSegment& columns = columns::segment_pose[index_of(segment)];
  return poses_in(curves, columns.position, columns.attitude);
}

/// How far `child` has turned in `parent` since both were first seen [deg].
Values turn(const std::vector<Pose>& parent, const std::vector<Pose>& child) {
  Values angle_deg;
  std::optional<Quat> first;
  for (std::size_t row = 0; row < child.size(); ++row) {
    if (is_missing(parent[row]) || is_missing(child[row])) {
      angle_deg.push_back(std::nan(""));
      continue;
    }
    const Quat q = parent[row].q.conjugate() * child[row].q;
    if (!first) first = q;
    angle_deg.push_back(kDegreesOfTurn * angle_between(*first, q));
  }
  return angle_deg;
}

Values times(const Signals& curves) {
  const auto t_s = curves.column(columns::t_s);
  Values elapsed_s;
  for (const double t : t_s) elapsed_s.push_back(t - t_s.front());
  return elapsed_s;
}

class ArmPlot {
 public:
  ArmPlot(const TaskSection& section, const DrawnTrial& trial, QSizeF size, double unit,
          const Language& language)
      : view(size, unit, language),
        section_(section),
        curves_(trial.curves),
        x_(times(trial.curves)) {}

  void draw_angle(const std::string& column) {
    QCPAxisRect& rect = axes(0, 1, "angle [°]"_text);
    const Values angle_deg = scaled(curves_.column(column), kDegreesOfTurn);
    rect.axis(QCPAxis::atLeft)->setRange(range_of({&angle_deg}));
    add(rect, angle_deg, QPen(Palette::of(section_.hand), view.px(1.1)));
  }

  void draw_matching() {
    constexpr int kRects = 3;
    const auto object = poses_of(curves_, ArmSegment::object);
    const auto reference =
        poses_in(curves_, columns::reference_position, columns::reference_attitude);
    Values distance_mm, angle_deg;
    for (std::size_t row = 0; row < object.size(); ++row) {
      const bool both = !is_missing(object[row]) && !is_missing(reference[row]);
      distance_mm.push_back(both ? kMillimetresOfWay * (object[row].p - reference[row].p).norm()
                                 : std::nan(""));
      angle_deg.push_back(both ? kDegreesOfTurn * angle_between(object[row].q, reference[row].q)
                               : std::nan(""));
    }
    const auto tolerance = section_.spec->tolerance();
    const QPen pen(Palette::of(section_.hand), view.px(1.1));
    draw_error(axes(0, kRects, "away [mm]"_text), distance_mm,
               tolerance ? kMillimetresOfWay * tolerance->position_m : 0.0, pen);
    draw_error(axes(1, kRects, "away [°]"_text), angle_deg,
               tolerance ? kDegreesOfTurn * tolerance->angle_rad : 0.0, pen);
    if (tolerance) view.explain(PlotView::Mark::band, Palette::tolerance(), "tolerance"_text);
    draw_links(axes(2, kRects, "turn [°]"_text));
  }

  PlotView view;

 private:
  QCPAxisRect& axes(int place, int of, Words title) {
    return stacked_axes(view, place, of, x_.back(), title);
  }

  void add(QCPAxisRect& rect, const Values& values, const QPen& pen) {
    const int bins = static_cast<int>(rect.minimumSize().width() / view.px(kFinest));
    const auto rows = visible_rows(values, bins);
    add_line(rect, picked(x_, rows), picked(values, rows), pen);
  }

  void draw_error(QCPAxisRect& rect, const Values& values, double tolerance, const QPen& pen) {
    const Values ends{0.0, tolerance};
    rect.axis(QCPAxis::atLeft)->setRange(range_of({&values, &ends}));
    if (tolerance > 0.0) {
      const Values whole{x_.front(), x_.back()};
      QCPGraph& lower = add_line(rect, whole, {0.0, 0.0}, QPen(Qt::NoPen));
      QCPGraph& upper = add_line(rect, whole, {tolerance, tolerance}, QPen(Qt::NoPen));
      upper.setBrush(Palette::tolerance());
      upper.setChannelFillGraph(&lower);
    }
    add(rect, values, pen);
  }

  void draw_links(QCPAxisRect& rect) {
    const auto elbow = poses_of(curves_, ArmSegment::elbow);
    const auto forearm = poses_of(curves_, ArmSegment::forearm);
    const auto dorsum = poses_of(curves_, ArmSegment::dorsum);
    const auto object = poses_of(curves_, ArmSegment::object);
    const std::array<Values, kArmLinkCount> turns{turn(elbow, forearm), turn(forearm, dorsum),
                                                  turn(dorsum, object)};
    rect.axis(QCPAxis::atLeft)->setRange(range_of({&turns[0], &turns[1], &turns[2]}));
    for (std::size_t link = 0; link < kArmLinkCount; ++link) {
      add(rect, turns[link], link_pen(view, static_cast<ArmLink>(link)));
      explain_link(view, static_cast<ArmLink>(link));
    }
  }

  const TaskSection& section_;
  const Signals& curves_;
  Values x_;
};

}  // namespace

bool is_of_arm(const TaskSection& section) {
  return section.spec && section.spec->apparatus() == kArm;
}

PlotView arm_plot(const TaskSection& section, const DrawnTrial& trial, QSizeF size, double unit,
                  const Language& language) {
  ArmPlot plot(section, trial, size, unit, language);
  const auto curve = section.spec->kind->curve;
  if (curve != nullptr)
    plot.draw_angle(curve(section.spec->kind));
  else
    plot.draw_matching();
  return std::move(plot.view);
}

}  // namespace isograsp::reports
