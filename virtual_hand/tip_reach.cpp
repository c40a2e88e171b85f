// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_hand/tip_reach.hpp"

#include <algorithm>

#include <Eigen/Cholesky>

namespace isograsp::virtual_hand {

std::array<DigitAngles, kDigitCount> angles_at_ease() noexcept {
  std::array<DigitAngles, kDigitCount> angles;
  angles.fill(kFingerAtEase);
  angles[index_of(Digit::thumb)] = kThumbAtEase;
  return angles;
}

double reach_with_tip(const HandModel& hand, HandPose& pose, Digit digit, const Vec3& goal_W,
                      int steps) noexcept {
  constexpr double kEase_m = 0.001;
  constexpr double kLargest_rad = 0.4;  // of one step
  const std::size_t d = index_of(digit);
  DigitAngles& angles = pose.angles[d];
  const DigitAngles& ease = digit == Digit::thumb ? kThumbAtEase : kFingerAtEase;
  for (int step = 0;; ++step) {
    const HandInSpace space = hand_in_space(hand, pose);
    const Vec3 tip_W = space.digits[d].joints[kLinkCount];
    const Vec3 missing = goal_W - tip_W;
    if (step == steps) return missing.norm();
    const PointJacobian all = point_jacobian(space, digit, kLinkCount - 1, tip_W);
    const Eigen::Matrix<double, 3, 4> J =
        all.block<3, 4>(0, static_cast<Eigen::Index>(6 + d * kAngleCount));
    Eigen::Matrix4d A = J.transpose() * J;
    A.diagonal().array() += kEase_m * kEase_m;
    Eigen::Vector4d b = J.transpose() * missing;
    for (std::size_t a = 0; a < kAngleCount; ++a)
      b[static_cast<Eigen::Index>(a)] += kEase_m * kEase_m * (ease[a] - angles[a]);
    const Eigen::Vector4d way = A.llt().solve(b).cwiseMax(-kLargest_rad).cwiseMin(kLargest_rad);
    for (std::size_t a = 0; a < kAngleCount; ++a) {
      const AngleRange& limit = hand.digits[d].limits[a];
      angles[a] =
          std::clamp(angles[a] + way[static_cast<Eigen::Index>(a)], limit.least, limit.most);
    }
  }
}

}  // namespace isograsp::virtual_hand
