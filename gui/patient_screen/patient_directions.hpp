// SPDX-License-Identifier: GPL-3.0-or-later
// Forces of given direction and size: one pad per asked digit, a ring that is to be filled and a
// disc that the digit moves. The pads stand as the hand does, opened like a book whose spine is
// next to the person: x of the contact frame is up, y to the right; a sideways
// force moves the disc, a pressing force changes its size. A pulling force is a diamond.
#pragma once

#include <QPainter>

#include "gui/picture/patient_picture.hpp"

namespace isograsp::gui {

void paint_directions(QPainter& painter, const QRectF& field, const PatientPicture& picture);

/// Where a force stands on a pad of half width 1: x and y, y up, and the radius of its mark.
struct PadMark {
  double x = 0.0;
  double y = 0.0;
  double radius = 0.0;
  bool pulls = false;
};
[[nodiscard]] PadMark mark_on_pad(const Vec3& force_C, double full_N) noexcept;

}  // namespace isograsp::gui
