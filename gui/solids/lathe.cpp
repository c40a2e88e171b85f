// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/solids/lathe.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Inventor/nodes/SoIndexedTriangleStripSet.h>

#include "gui/solids/ring_mesh.hpp"

namespace isograsp::gui::scene_nodes {

namespace {

float angle_of(int sector, int sectors) {
  return 2.0F * std::numbers::pi_v<float> * static_cast<float>(sector) /
         static_cast<float>(sectors);
}

/// Outward, of the outline at point i; an edge has one to each side.
SbVec2f outward(const std::vector<Turned>& outline, std::size_t i) {
  const auto same = [&](std::size_t a, std::size_t b) {
    return outline[a].radius_m == outline[b].radius_m && outline[a].y_m == outline[b].y_m;
  };
  const std::size_t before = i > 0 && !same(i - 1, i) ? i - 1 : i;
  const std::size_t after = i + 1 < outline.size() && !same(i, i + 1) ? i + 1 : i;
  SbVec2f out(outline[after].y_m - outline[before].y_m,
              outline[before].radius_m - outline[after].radius_m);
  if (out.length() > 0.0F) out.normalize();
  return out;
}

}  // namespace

SoNode* make_lathe(const std::vector<Turned>& outline, int sectors) {
  std::vector<SbVec3f> points, normals;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const SbVec2f out = outward(outline, i);
    for (int j = 0; j < sectors; ++j) {
      const float angle = angle_of(j, sectors);
      const float c = std::cos(angle), s = std::sin(angle);
      points.emplace_back(outline[i].radius_m * c, outline[i].y_m, outline[i].radius_m * s);
      normals.emplace_back(out[0] * c, out[1], out[0] * s);
    }
  }
  return make_ring_mesh(points, normals, sectors);
}

SoNode* make_tube(const std::vector<SbVec3f>& line, float radius_m, int sectors) {
  std::vector<SbVec3f> points, normals;
  const std::size_t last = line.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    SbVec3f way = line[std::min(i + 1, last)] - line[i > 0 ? i - 1 : 0];
    way.normalize();
    SbVec3f side = way.cross(std::abs(way[2]) < 0.9F ? SbVec3f(0, 0, 1) : SbVec3f(1, 0, 0));
    side.normalize();
    const SbVec3f up = side.cross(way);
    for (int j = 0; j < sectors; ++j) {
      const float angle = angle_of(j, sectors);
      const SbVec3f out = side * std::cos(angle) + up * std::sin(angle);
      normals.push_back(out);
      points.push_back(line[i] + out * radius_m);
    }
  }
  return make_ring_mesh(points, normals, sectors);
}

}  // namespace isograsp::gui::scene_nodes
