// SPDX-License-Identifier: GPL-3.0-or-later
// What stands below a tracked hand on the patient's screen: how much it is helped, how far it
// opens, that a camera looks. Painted with QPainter, beside the 3D picture: it covers nothing of
// it.
#pragma once

#include <QPainter>
#include <QRectF>

#include "gui/picture/patient_picture.hpp"

namespace isograsp::gui {

/// Height of that strip as a share of the screen.
inline constexpr double kFooterShare = 0.085;
/// Where the hand is drawn: between banner and footer.
[[nodiscard]] QRectF hand_area(const QRectF& area);

/// The strip. @pre picture.tracked_hand
void paint_footer(QPainter& painter, const QRectF& area, const PatientPicture& picture);
/// The words of paint_footer(): what looks the same has the same ones.
[[nodiscard]] QString footer_key(const PatientPicture& picture);
/// "Camera on", at the lower right of every page. Nothing while there is none.
void paint_camera_sign(QPainter& painter, const QRectF& area, const PatientPicture& picture);

}  // namespace isograsp::gui
