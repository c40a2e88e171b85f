// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth bodies of a hand: the convex hull of some balls. Of one ball it is a ball, of two a
// capsule that tapers, of those of the metacarpals a palm.
#pragma once

#include <vector>

#include "core/spatial.hpp"

class SoNode;

namespace isograsp::gui::scene_nodes {

struct Ball {
  Vec3 p = Vec3::Zero();  ///< [m]
  double radius_m = 0.0;
};

/// A surface with smooth normals. `fine`: of how many points along half its round.
/// @pre balls is not empty
[[nodiscard]] SoNode* make_rounded(const std::vector<Ball>& balls, int fine = 14);

}  // namespace isograsp::gui::scene_nodes
