// SPDX-License-Identifier: GPL-3.0-or-later
// A force that follows its target, as a training look is given it: places on the screen, which the
// page has decided. A look draws round them and moves none of them.
#pragma once

#include <QPainter>
#include <QPolygonF>
#include <QRectF>
#include <vector>

#include "tasks/looks/look.hpp"

namespace isograsp::gui {

struct CurveView {
  QRectF field;
  tasks::Daylight light = tasks::Daylight::day;
  std::vector<QPolygonF> targets;  ///< from left to right; broken where no target may be seen
  double half_band_px = 0.0;
  double zero_y = 0.0;  ///< of no force
  bool mark_shown = false;
  QPointF mark;  ///< the own force, now
  double mark_radius_px = 0.0;
  bool on_target = false;
  double px_per_s = 1.0;
  double begin_s = 0.0;  ///< task time at the left edge: what stands in the landscape goes with it
};

/// @pre look is one for a curve
void paint_curve_look(QPainter& painter, tasks::Look look, const CurveView& view);

}  // namespace isograsp::gui
