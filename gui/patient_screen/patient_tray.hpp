// SPDX-License-Identifier: GPL-3.0-or-later
// A tray that both hands lift, from the front.
#pragma once

#include <QPainter>
#include <QRectF>

#include "gui/picture/patient_picture.hpp"

namespace isograsp::gui {

/// Into `area`. @pre picture.two_hands->tray
void paint_tray(QPainter& painter, const QRectF& area, const PatientPicture& picture);

}  // namespace isograsp::gui
