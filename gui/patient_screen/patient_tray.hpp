// SPDX-License-Identifier: GPL-3.0-or-later
// What both hands move: a tray that they lift, from the front, and a box that they carry.
#pragma once

#include <QPainter>
#include <QRectF>

#include "gui/picture/patient_picture.hpp"

namespace isograsp::gui {

/// Into `area`. @pre picture.two_hands->tray
void paint_tray(QPainter& painter, const QRectF& area, const PatientPicture& picture);
/// Likewise. @pre picture.two_hands->carry
void paint_carry(QPainter& painter, const QRectF& area, const PatientPicture& picture);
/// Round and striped is the left hand, square and plain the right one.
void paint_hand_mark(QPainter& painter, const QRectF& box, Hand hand);

}  // namespace isograsp::gui
