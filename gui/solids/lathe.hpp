// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that a potter makes: an outline turned about y, and a tube along a line.
#pragma once

#include <vector>

#include <Inventor/SbLinear.h>

class SoNode;

namespace isograsp::gui::scene_nodes {

/// Radius and height of a point of the outline [m]. A point that stands twice is an edge.
struct Turned {
  float radius_m;
  float y_m;
};
/// Smooth normals, from the lowest point up; open where the outline does not reach the axis.
[[nodiscard]] SoNode* make_lathe(const std::vector<Turned>& outline, int sectors = 32);
/// @pre at least two points, none of them twice
[[nodiscard]] SoNode* make_tube(const std::vector<SbVec3f>& line, float radius_m, int sectors = 10);

}  // namespace isograsp::gui::scene_nodes
