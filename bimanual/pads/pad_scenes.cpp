// SPDX-License-Identifier: GPL-3.0-or-later
#include "bimanual/pads/pad_scenes.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp::bimanual {

namespace {

constexpr double kGravity_m_s2 = 9.81;

/// A pulp of 15 x 11 mm that gives 2 N/mm, on a bed that gives 10 um under 20 N.
PadSpec pulp(Side hand, const Vec3& from_hand_m, const Vec3& normal, double friction) {
  PadSpec pad;
  pad.hand = hand;
  pad.from_hand_m = from_hand_m;
  pad.normal = normal;
  pad.tangent = Vec3::UnitZ();
  pad.friction = friction;
  pad.foundation_N_m3 = 4e7;
  pad.stiffness << Vec3::Constant(2000.0), Vec3::Constant(0.3);
  pad.damping << Vec3::Constant(4.0), Vec3::Constant(6e-4);
  return pad;
}

Scene solid(Shape shape, const Vec3& size_m, double mass_kg, const Vec3& inertia_kg_m2) {
  Scene object;
  object.shape = shape;
  object.size_m = size_m;
  object.mass_kg = mass_kg;
  object.inertia_kg_m2 = inertia_kg_m2;
  object.free.fill(true);
  return object;
}

/// One pad of each hand presses along x, `up_m` above the middle of the object and `along_m` from
/// it.
void add_pair(PadGrasp& grasp, const Vec3& from_hand_m, double friction) {
  grasp.pads.push_back(pulp(Side::left, from_hand_m, Vec3::UnitX(), friction));
  grasp.pads.push_back(pulp(Side::right, from_hand_m, -Vec3::UnitX(), friction));
}

/// 0.4 kg, 120 mm: two pads of each hand towards its middle, 30 degrees above and below.
PadGrasp ball() {
  constexpr double kRadius_m = 0.06, kMass_kg = 0.4, kFriction = 0.8, kAbove_rad = 0.5236;
  PadGrasp grasp;
  grasp.object = solid(Shape::sphere, {2.0 * kRadius_m, 0.0, 0.0}, kMass_kg,
                       Vec3::Constant(0.4 * kMass_kg * kRadius_m * kRadius_m));
  for (const Side hand : {Side::left, Side::right})
    for (const double above_rad : {kAbove_rad, -kAbove_rad}) {
      const double out = hand == Side::left ? -1.0 : 1.0;
      const Vec3 outward(out * std::cos(above_rad), std::sin(above_rad), 0.0);
      grasp.pads.push_back(pulp(hand, kRadius_m * outward, -outward, kFriction));
    }
  grasp.squeeze_m = 0.003;
  grasp.pull_m_s2 = {0.0, 2.0, 0.0};
  grasp.turn_rad_s2 = 10.0;
  return grasp;
}

/// 1.5 kg: a bar of 30 mm along z with its mass at the ends, held 5 mm beside its middle by two
/// pads of each hand, 30 mm apart.
PadGrasp dumbbell() {
  constexpr double kRadius_m = 0.015, kMass_kg = 1.5, kEnds_m = 0.06, kBeside_m = 0.005,
                   kApart_m = 0.03, kFriction = 0.8;
  PadGrasp grasp;
  const double across = kMass_kg * kEnds_m * kEnds_m;
  grasp.object = solid(Shape::cylinder, {2.0 * kRadius_m, 0.16, 0.0}, kMass_kg,
                       {across, across, 0.5 * kMass_kg * 0.03 * 0.03});
  grasp.hand_m = {kRadius_m, 0.0, kBeside_m};
  add_pair(grasp, {0.0, 0.0, 0.5 * kApart_m}, kFriction);
  add_pair(grasp, {0.0, 0.0, -0.5 * kApart_m}, kFriction);
  grasp.squeeze_m = 0.006;
  grasp.pull_m_s2 = {0.0, 1.0, 0.0};
  grasp.turn_rad_s2 = 5.0;
  return grasp;
}

/// 10 g, 8 mm thick, along z: two pads that are wider than it, 20 mm beside its middle, pull it
/// along.
PadGrasp pencil() {
  constexpr double kRadius_m = 0.004, kLength_m = 0.175, kMass_kg = 0.01, kBeside_m = 0.02,
                   kFriction = 0.6;
  PadGrasp grasp;
  const double across = kMass_kg * (kRadius_m * kRadius_m / 4.0 + kLength_m * kLength_m / 12.0);
  grasp.object = solid(Shape::cylinder, {2.0 * kRadius_m, kLength_m, 0.0}, kMass_kg,
                       {across, across, 0.5 * kMass_kg * kRadius_m * kRadius_m});
  grasp.hand_m = {kRadius_m, 0.0, kBeside_m};
  add_pair(grasp, Vec3::Zero(), kFriction);
  grasp.squeeze_m = 0.001;
  grasp.pull_m_s2 = {0.0, 0.0, 20.0};
  grasp.turn_rad_s2 = 50.0;
  return grasp;
}

/// 150 g, 60 x 60 x 20 mm: two pads at its upper edge, half of them beside it.
PadGrasp edge() {
  constexpr double kSide_m = 0.06, kThick_m = 0.02, kMass_kg = 0.15, kFriction = 0.6;
  PadGrasp grasp;
  const double long2 = kSide_m * kSide_m, thick2 = kThick_m * kThick_m;
  grasp.object = solid(Shape::box, {kSide_m, kSide_m, kThick_m}, kMass_kg,
                       kMass_kg / 12.0 * Vec3(long2 + thick2, long2 + thick2, 2.0 * long2));
  grasp.hand_m = {0.5 * kSide_m, 0.5 * kSide_m, 0.0};
  add_pair(grasp, Vec3::Zero(), kFriction);
  grasp.squeeze_m = 0.0025;
  grasp.pull_m_s2 = {0.0, 2.0, 0.0};
  grasp.turn_rad_s2 = 20.0;
  return grasp;
}

PadGrasp grasp_of(PadScene scene) {
  switch (scene) {
    case PadScene::ball: return ball();
    case PadScene::dumbbell: return dumbbell();
    case PadScene::pencil: return pencil();
    case PadScene::edge: break;
  }
  return edge();
}

}  // namespace

std::array<Pose, kSides> PadGrasp::proxies(double t_s) const noexcept {
  const double closed = std::clamp(t_s / kClosing_s, 0.0, 1.0);
  const double moving_s = std::max(0.0, t_s - kMoving_s);
  const double half_s2 = 0.5 * moving_s * moving_s;
  const Quat turned(Eigen::AngleAxisd(half_s2 * turn_rad_s2, Vec3::UnitX()));
  std::array<Pose, kSides> hands;
  for (std::size_t side = 0; side < kSides; ++side) {
    const double out = side == index_of(Side::left) ? -1.0 : 1.0;
    hands[side].p =
        Vec3(out * (hand_m.x() - closed * squeeze_m), hand_m.y(), hand_m.z()) + half_s2 * pull_m_s2;
    hands[side].q = turned;
  }
  return hands;
}

Vec3 PadGrasp::gravity_m_s2(double t_s) const noexcept {
  return {0.0, -kGravity_m_s2 * std::clamp(t_s / kClosing_s, 0.0, 1.0), 0.0};
}

Result<PadGrasp> pad_grasp(PadScene scene, int points) {
  constexpr int kLeast = 3;        // of a pad: fewer are a line, which has no torsion
  constexpr int kMost = 400;       // of all: twice what is asked of real time
  constexpr double kAround = 1.5;  // rays for each ring, at least
  PadGrasp grasp = grasp_of(scene);
  const int pads = static_cast<int>(grasp.pads.size());
  if (points % pads != 0 || points < kLeast * pads || points > kMost)
    return refused("%1 points cannot be shared by the %2 pads of this scene"_text(points, pads),
                   "take a multiple of %1 from %2 to %3"_text(pads, kLeast * pads, kMost))
        .about("--points");
  const int each = points / pads;
  int rings = std::max(1, static_cast<int>(std::sqrt(each / kAround)));
  while (each % rings != 0) --rings;
  for (PadSpec& pad : grasp.pads) {
    pad.face.rings = rings;
    pad.face.rays = each / rings;
  }
  return grasp;
}

PadStep step_under_way(const PadGrasp& grasp) {
  constexpr double kThen_s = 0.2;
  HeldByPads held(grasp.object, grasp.pads, grasp.step_s, PadSolver::aggregate, grasp.proxies(0.0));
  const int steps = static_cast<int>(std::lround(kThen_s / grasp.step_s));
  for (int k = 1; k < steps; ++k)
    held.step(grasp.proxies(k * grasp.step_s), grasp.gravity_m_s2(k * grasp.step_s));
  return held.next(grasp.proxies(kThen_s), grasp.gravity_m_s2(kThen_s));
}

}  // namespace isograsp::bimanual
