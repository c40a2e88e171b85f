// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_hand/reachable_grasps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "core/random.hpp"
#include "grasp_model/rotation.hpp"
#include "virtual_hand/capsule.hpp"
#include "virtual_hand/tip_reach.hpp"

namespace isograsp::virtual_hand {

namespace {

constexpr double kReached_m = 0.0005;  ///< a tip so near to its place is there
constexpr double kDeep_m = 0.001;      ///< no link may be deeper in the object
constexpr std::uint64_t kGraspStream = 310;
constexpr double kPi = std::numbers::pi;

/// A place on the object, its axes.
struct SurfacePoint {
  Vec3 p = Vec3::Zero();
  Vec3 inward = Vec3::UnitZ();
};

double between(Random& random, double least, double most) noexcept {
  return least + (most - least) * random.uniform();
}

/// Anywhere: each of six faces, or side (twice as often) and ends of a cylinder, alike.
SurfacePoint anywhere(const ObjectShape& shape, Random& random) noexcept {
  const Vec3& half = shape.half_m;
  if (shape.kind == ObjectShape::Kind::cylinder) {
    const double angle = between(random, -kPi, kPi);
    const Vec3 out(std::cos(angle), std::sin(angle), 0.0);
    if (random.uniform() < 0.5)
      return {half.x() * out + between(random, -half.z(), half.z()) * Vec3::UnitZ(), -out};
    const double side = random.uniform() < 0.5 ? -1.0 : 1.0;
    const double radius = half.x() * std::sqrt(random.uniform());
    return {radius * out + side * half.z() * Vec3::UnitZ(), -side * Vec3::UnitZ()};
  }
  const auto axis = static_cast<Eigen::Index>(3.0 * random.uniform());
  const double side = random.uniform() < 0.5 ? -1.0 : 1.0;
  Vec3 p(between(random, -half.x(), half.x()), between(random, -half.y(), half.y()),
         between(random, -half.z(), half.z()));
  p[axis] = side * half[axis];
  return {p, -side * Vec3::Unit(axis)};
}

/// On the other side of the object, a little beside the point straight through it.
SurfacePoint opposite(const ObjectShape& shape, const SurfacePoint& of, Random& random) noexcept {
  constexpr double kBeside = 0.3;  // of the object's half edges
  const Vec3& half = shape.half_m;
  Vec3 through = of.p - 2.0 * of.p.dot(of.inward) * of.inward;
  for (Eigen::Index k = 0; k < 3; ++k)
    through[k] = std::clamp(through[k] + kBeside * half[k] * random.gaussian(), -half[k], half[k]);
  const bool round = shape.kind == ObjectShape::Kind::cylinder && of.inward.z() == 0.0;
  if (round) {
    const Vec3 out = Vec3(through.x(), through.y(), 0.0).normalized();
    return {half.x() * out + through.z() * Vec3::UnitZ(), -out};
  }
  if (shape.kind == ObjectShape::Kind::cylinder) {
    const double radius = std::hypot(through.x(), through.y());
    if (radius > half.x()) through.head<2>() *= half.x() / radius;
  }
  Eigen::Index axis = 0;
  of.inward.cwiseAbs().maxCoeff(&axis);
  through[axis] = of.inward[axis] > 0.0 ? half[axis] : -half[axis];
  return {through, -of.inward};
}

Mat3 axes_about(const Vec3& normal) noexcept {
  Mat3 R;
  const Vec3 tangent = normal.unitOrthogonal();
  R << tangent, normal.cross(tangent), normal;
  return R;
}

/// A palm beside the object (at the origin of the world): the grip's middle in it, the line from
/// thumb to fingers roughly along the digits' places, otherwise turned anyhow.
Pose palm_beside(const HandModel& hand, const Vec3& thumb, const Vec3& finger,
                 Random& random) noexcept {
  constexpr double kTilt_rad = 0.3;
  const Vec3 line_P = Vec3(0.89, 0.0, -0.45).normalized();  // of a hand that grips
  const Vec3 middle_P = hand.length_m * Vec3(-0.2, -0.33, -0.52);
  const Vec3 way = finger - thumb;
  const Vec3 line_W = way.norm() > 0.0 ? Vec3(way.normalized()) : Vec3(Vec3::UnitX());
  const Quat roll(Eigen::AngleAxisd(between(random, -kPi, kPi), line_W));
  const Vec3 tilt(random.gaussian(), random.gaussian(), random.gaussian());
  Quat q_WP = roll * so3::shortest(line_P, line_W);
  q_WP = Quat(Eigen::AngleAxisd(kTilt_rad * tilt.norm(), tilt.normalized())) * q_WP;
  return {0.5 * (thumb + finger) - q_WP * middle_P, q_WP.normalized()};
}

bool free_of_object(const HandInSpace& space, const HandModel& hand, Digit digit,
                    const ObjectShape& shape) noexcept {
  const DigitPose& of = space.digit(digit);
  for (std::size_t k = 0; k < kLinkCount; ++k)
    if (capsule_contact({of.joints[k], of.joints[k + 1], hand.digit(digit).radii_m[k]}, shape)
            .distance_m < -kDeep_m)
      return false;
  return true;
}

/// One attempt; the object is at the origin of the world.
std::optional<GraspCriteria> attempt(const HandModel& hand, const ObjectShape& shape,
                                     std::size_t size, Random& random) {
  const bool facing = random.uniform() < 0.5;
  std::array<SurfacePoint, 3> places;
  places[0] = anywhere(shape, random);
  for (std::size_t k = 1; k < size; ++k)
    places[k] = facing ? opposite(shape, places[0], random) : anywhere(shape, random);
  // Thumb and a finger, or two that are neighbours.
  const auto first = index_of(Digit::index) + static_cast<std::size_t>(2.0 * random.uniform());
  HandPose pose;
  pose.angles = angles_at_ease();
  pose.X_WP = palm_beside(hand, places[0].p, places[1].p, random);
  std::vector<DigitContact> contacts;
  constexpr int kSteps = 20;
  for (std::size_t k = 0; k < size; ++k) {
    const Digit digit = k == 0 ? Digit::thumb : static_cast<Digit>(first + k - 1);
    const double radius_m = hand.digit(digit).radii_m.back();
    const Vec3 goal_W = places[k].p - radius_m * places[k].inward;
    if (reach_with_tip(hand, pose, digit, goal_W, kSteps) > kReached_m) return std::nullopt;
    contacts.push_back({digit, kLinkCount - 1, places[k].p, axes_about(places[k].inward)});
  }
  const HandInSpace space = hand_in_space(hand, pose);
  for (const DigitContact& contact : contacts)
    if (!free_of_object(space, hand, contact.digit, shape)) return std::nullopt;
  return grasp_criteria(contacts, space, Pose(), hand_scale_m(hand), {});
}

double area(std::span<const GraspCriteria> grasps, double (*value)(const GraspCriteria&)) {
  double above = 0.0;
  double pairs = 0.0;
  for (const GraspCriteria& closed : grasps)
    for (const GraspCriteria& open : grasps) {
      if (!closed.force_closure || open.force_closure) continue;
      pairs += 1.0;
      if (value(closed) > value(open)) above += 1.0;
      if (value(closed) == value(open)) above += 0.5;
    }
  return pairs > 0.0 ? above / pairs : std::numeric_limits<double>::quiet_NaN();
}

double G_min_of(const GraspCriteria& grasp) {
  return grasp.G.least;
}
double H_min_of(const GraspCriteria& grasp) {
  return grasp.H.least;
}
double H_det_of(const GraspCriteria& grasp) {
  return grasp.H.product;
}
double raw_G_min_of(const GraspCriteria& grasp) {
  return grasp.G_raw.least;
}

/// What all but a twentieth of the grasps that close exceed.
double guard(std::span<const GraspCriteria> grasps, double (*value)(const GraspCriteria&)) {
  constexpr double kShare = 0.05;
  std::vector<double> closed;
  for (const GraspCriteria& grasp : grasps)
    if (grasp.force_closure) closed.push_back(value(grasp));
  if (closed.empty()) return std::numeric_limits<double>::infinity();
  std::sort(closed.begin(), closed.end());
  return closed[static_cast<std::size_t>(kShare * static_cast<double>(closed.size()))];
}

/// The value at which closed and open ones part best.
double parting(std::span<const GraspCriteria> grasps) {
  double best = -1.0;
  double at = std::numeric_limits<double>::infinity();
  for (const GraspCriteria& candidate : grasps) {
    if (!candidate.force_closure) continue;
    double closed = 0.0, closed_above = 0.0, open = 0.0, open_above = 0.0;
    for (const GraspCriteria& grasp : grasps) {
      const bool above = grasp.G.least >= candidate.G.least;
      (grasp.force_closure ? closed : open) += 1.0;
      if (above) (grasp.force_closure ? closed_above : open_above) += 1.0;
    }
    const double gain = closed_above / closed - (open > 0.0 ? open_above / open : 0.0);
    if (gain > best || (gain == best && candidate.G.least < at)) {
      best = gain;
      at = candidate.G.least;
    }
  }
  return at;
}

}  // namespace

std::vector<GraspCriteria> reachable_grasps(const HandModel& hand, const ObjectShape& shape,
                                            std::size_t size, std::size_t count,
                                            std::uint64_t seed) {
  constexpr std::size_t kAttempts = 100;  // for each grasp
  Random random(seed, kGraspStream);
  std::vector<GraspCriteria> grasps;
  for (std::size_t k = 0; k < kAttempts * count && grasps.size() < count; ++k)
    if (auto grasp = attempt(hand, shape, size, random)) grasps.push_back(std::move(*grasp));
  return grasps;
}

Separation separation_of(std::span<const GraspCriteria> grasps) {
  Separation separation;
  for (const GraspCriteria& grasp : grasps)
    ++(grasp.force_closure ? separation.closed : separation.open);
  separation.G_min = area(grasps, G_min_of);
  separation.H_min = area(grasps, H_min_of);
  separation.H_det = area(grasps, H_det_of);
  separation.G_min_raw = area(grasps, raw_G_min_of);
  return separation;
}

FoundLimits limits_from(std::span<const GraspCriteria> grasps) {
  return {parting(grasps), guard(grasps, H_min_of), guard(grasps, H_det_of)};
}

}  // namespace isograsp::virtual_hand
