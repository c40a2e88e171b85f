// SPDX-License-Identifier: GPL-3.0-or-later
// What two hands carry and lift in training, drawn flat: in the outline that the object has.
#pragma once

#include <QPainter>
#include <QRectF>

#include "tasks/looks/look.hpp"

namespace isograsp::gui {

/// Wall and table behind it.
void paint_flat_room(QPainter& painter, const QRectF& area, tasks::Daylight light);
/// A crate of apples; `held`, by both hands: its frame is thick. On the target it is green.
void paint_crate(QPainter& painter, const QRectF& box, bool held, bool on_target);
/// A wooden tray with pot and cups, seen from the front.
void paint_tea_tray(QPainter& painter, const QRectF& board, bool on_target);

}  // namespace isograsp::gui
