// SPDX-License-Identifier: GPL-3.0-or-later
// How far the own arm turns, as a dial: the range so far is filled, a hand points where it is now.
#pragma once

#include <QPainter>

#include "gui/picture/patient_picture.hpp"

namespace isograsp::gui {

/// Positive angles to the left for a right arm, to the right for a left one: as the thumb goes when
/// the forearm turns the palm down. @pre picture.page == Page::range
void paint_range(QPainter& painter, const QRectF& area, const PatientPicture& picture);

}  // namespace isograsp::gui
