// SPDX-License-Identifier: GPL-3.0-or-later
// Pictograms of the patient's screen: each instruction as a picture without words.
#pragma once

#include <QPainter>

#include "gui/picture/patient_picture.hpp"

namespace isograsp::gui {

/// The sign of the picture; `act` shows what its channel asks of which digits of its hand.
void paint_sign(QPainter& painter, const QRectF& box, const PatientPicture& picture);

}  // namespace isograsp::gui
