// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/training_looks/curve_view.hpp"

#include "gui/training_looks/curve_looks.hpp"

namespace isograsp::gui {

void paint_curve_look(QPainter& painter, tasks::Look look, const CurveView& view) {
  if (look == tasks::Look::balloon)
    paint_balloon(painter, view);
  else
    paint_river(painter, view);
}

}  // namespace isograsp::gui
