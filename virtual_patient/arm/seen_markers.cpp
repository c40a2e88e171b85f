// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_patient/arm/seen_markers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/attitude.hpp"

namespace isograsp::virtual_patient {

namespace {

/// Directions to the cameras, far away: around and above the table, two of them low on the side of
/// the back of the hand.
const std::array<Vec3, 6> kCameras{
    Vec3(0.67, 0.55, 0.5).normalized(),  Vec3(-0.7, 0.6, 0.35).normalized(),
    Vec3(0.1, 0.5, -0.86).normalized(),  Vec3(0.9, 0.1, -0.4).normalized(),
    Vec3(0.9, -0.05, 0.42).normalized(), Vec3(-0.75, 0.35, -0.55).normalized()};
/// Nearer to the edge of the view a marker is lost ten times as often.
constexpr double kGrazing = 0.1;

/// How well the second best camera sees a marker: cosine of the angle; one camera is not enough.
double second_best(const Vec3& outward_W) noexcept {
  double best = -1.0;
  double second = -1.0;
  for (const Vec3& camera : kCameras) {
    const double cosine = camera.dot(outward_W);
    second = std::max(second, std::min(best, cosine));
    best = std::max(best, cosine);
  }
  return second;
}

/// Probability that what happens at a rate happens within dt_s.
double happens(double rate_per_s, double dt_s) noexcept {
  return 1.0 - std::exp(-rate_per_s * dt_s);
}

Vec3 gaussian(Random& random) noexcept {
  const double x = random.gaussian();
  const double y = random.gaussian();
  return {x, y, random.gaussian()};
}

}  // namespace

SeenMarkers::SeenMarkers(const ArmTraits& traits, std::uint64_t seed) noexcept
    : traits_(traits), skin_random_(seed, 205), camera_random_(seed, 206), loss_random_(seed, 207) {
  for (Vec3& on_bone : skin_) on_bone = traits_.skin_m * gaussian(skin_random_);
}

void SeenMarkers::look(const ArmBody& body, const ArmPoses& X_W, double dt_s,
                       std::span<Vec3> p_W) noexcept {
  // Ornstein-Uhlenbeck, exact for any step.
  const double keep = std::exp(-dt_s / traits_.skin_s);
  const double fresh = traits_.skin_m * std::sqrt(1.0 - keep * keep);
  const double edge = std::cos(traits_.view_rad);
  blocked_s_ = std::max(0.0, blocked_s_ - dt_s);
  const bool steps_in = loss_random_.uniform() < happens(traits_.block_per_s, dt_s);
  if (blocked_s_ == 0.0 && steps_in) blocked_s_ = traits_.block_s;
  for (std::size_t m = 0; m < kArmMarkers; ++m) {
    const ArmMarker& marker = body.markers[m];
    const Pose& X_WS = X_W[index_of(marker.segment)];
    // Every draw is made whether it is needed or not: what is lost never changes the rest.
    skin_[m] = keep * skin_[m] + fresh * gaussian(skin_random_);
    const Vec3 noise = traits_.camera_m * gaussian(camera_random_);
    const double chance = loss_random_.uniform();
    const double length_s = traits_.loss_s * (0.5 + loss_random_.uniform());

    const double seen = second_best(X_WS.q * marker.outward_S);
    lost_s_[m] = std::max(0.0, lost_s_[m] - dt_s);
    const double rate_per_s = traits_.loss_per_s / std::clamp(seen, kGrazing, 1.0);
    if (lost_s_[m] == 0.0 && chance < happens(rate_per_s, dt_s)) lost_s_[m] = length_s;
    const Vec3 p_S = marker.on_skin ? Vec3(marker.p_S + skin_[m]) : marker.p_S;
    p_W[m] = X_WS.p + X_WS.q * p_S + noise;
    const bool from_everywhere = traits_.view_rad >= std::numbers::pi;
    const bool blocked = blocked_s_ > 0.0 && marker.segment != Segment::brace;
    if (blocked || lost_s_[m] > 0.0 || (!from_everywhere && seen < edge))
      p_W[m].setConstant(kMissing);
  }
}

}  // namespace isograsp::virtual_patient
