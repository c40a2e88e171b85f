// SPDX-License-Identifier: GPL-3.0-or-later
// The soft shadow that a hand and an object cast straight down: sharp and dark where they nearly
// touch, wide and pale from higher up. It tells how high they are. Pure; metres.
#pragma once

#include <cstdint>
#include <vector>

#include "gui/picture/hand_picture.hpp"

namespace isograsp::gui {

/// A level rectangle in the world that is shaded, and in how many points.
struct ShadeArea {
  double left_m = 0.0;   ///< x of its left edge
  double front_m = 0.0;  ///< z of its front edge
  double width_m = 0.0;
  double depth_m = 0.0;  ///< away from the viewer
  double height_m = 0.0;
  int columns = 0;
  int rows = 0;
};

/// Brightness of each point, row by row from the front: 255 where there is no shadow.
[[nodiscard]] std::vector<std::uint8_t> table_shade(const HandPicture& picture,
                                                    const ShadeArea& area);

}  // namespace isograsp::gui
