// SPDX-License-Identifier: GPL-3.0-or-later
// Two hands at once: the left one at the left with a round, hatched bar, the right one at the right
// with a square, plain bar, each with its sign, its name and what it does; between them their sum,
// in which each keeps its filling. What is asked is a band across.
#pragma once

#include <QPainter>

#include "gui/picture/patient_picture.hpp"

namespace isograsp::gui {

/// @pre picture.page == Page::two_hands
void paint_two_hands(QPainter& painter, const QRectF& area, const PatientPicture& picture);

}  // namespace isograsp::gui
