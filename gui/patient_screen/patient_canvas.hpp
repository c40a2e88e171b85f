// SPDX-License-Identifier: GPL-3.0-or-later
// The flat parts of the patient's screen, painted with QPainter: whole pages without an object, and
// what lies over the 3D picture. Needs no OpenGL, so tests can look at every page.
#pragma once

#include <QImage>
#include <QPainter>
#include <QRectF>

#include "gui/picture/patient_picture.hpp"

namespace isograsp::gui {

/// Everything of a flat page. @pre picture.page is neither Page::object nor Page::hand
void paint_page(QPainter& painter, const QRectF& area, const PatientPicture& picture);

/// The strip over the 3D picture: instruction, targets reached, "simulated".
void paint_banner(QPainter& painter, const QRectF& area, const PatientPicture& picture);
/// Height of that strip as a share of the screen.
inline constexpr double kBannerShare = 0.19;

/// One mark for each target, to the right from `first`; those that were reached carry a check.
void paint_target_marks(QPainter& painter, const QPointF& first, double radius,
                        const PatientPicture& picture);
/// A ring around `centre` that closes while the block is held; what is behind it stays visible.
/// `thick`: of its radius.
void paint_hold_ring(QPainter& painter, const QPointF& centre, double radius, double fraction,
                     double thick = 0.36);
/// The mark of a finger that touches: a check in a disc.
void paint_check(QPainter& painter, const QPointF& centre, double radius);
/// Pause or fault, over a page that stands still. Nothing if there is none.
void paint_notice(QPainter& painter, const QRectF& area, const PatientPicture& picture);

}  // namespace isograsp::gui
