// SPDX-License-Identifier: GPL-3.0-or-later
// Inside gui/training_looks only: the looks of a curve, each in its file.
#pragma once

#include "gui/training_looks/curve_view.hpp"

namespace isograsp::gui {

void paint_river(QPainter& painter, const CurveView& view);
void paint_balloon(QPainter& painter, const CurveView& view);

}  // namespace isograsp::gui
