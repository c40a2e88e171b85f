// SPDX-License-Identifier: GPL-3.0-or-later
// Each direction of a globe has one point of the hull: that of the ball which reaches farthest
// there, or between balls that reach about as far. Its normal is the direction, so what is flat
// between two balls comes out flat by itself, and what is nearly flat has no edges.
#include "gui/solids/rounded_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Inventor/nodes/SoIndexedTriangleStripSet.h>

#include "gui/solids/ring_mesh.hpp"
#include "gui/solids/scene_nodes.hpp"

namespace isograsp::gui::scene_nodes {

namespace {

/// Within the hull, and by no more than this from it [m], times the logarithm of their number.
constexpr double kSoft_m = 0.0008;

Vec3 point_of(const std::vector<Ball>& balls, const Vec3& way) {
  const auto reach_m = [&way](const Ball& ball) { return ball.p.dot(way) + ball.radius_m; };
  double most_m = reach_m(balls.front());
  for (const Ball& ball : balls) most_m = std::max(most_m, reach_m(ball));
  Vec3 sum = Vec3::Zero();
  double weights = 0.0;
  for (const Ball& ball : balls) {
    const double weight = std::exp((reach_m(ball) - most_m) / kSoft_m);
    sum += weight * (ball.p + ball.radius_m * way);
    weights += weight;
  }
  return sum / weights;
}

}  // namespace

SoNode* make_rounded(const std::vector<Ball>& balls, int fine) {
  const int rings = fine;
  const int sectors = 2 * fine;
  std::vector<SbVec3f> points, normals;
  for (int i = 0; i <= rings; ++i)
    for (int j = 0; j < sectors; ++j) {
      const double theta = std::numbers::pi * i / rings;
      const double phi = 2.0 * std::numbers::pi * j / sectors;
      const Vec3 way(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                     std::cos(theta));
      points.push_back(to_sb(point_of(balls, way)));
      normals.push_back(to_sb(way));
    }
  return make_ring_mesh(points, normals, sectors);
}

}  // namespace isograsp::gui::scene_nodes
