// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_patient/hand/grip_shapes.hpp"

#include <algorithm>
#include <cmath>

#include "virtual_hand/tip_reach.hpp"

namespace isograsp::virtual_patient {

namespace {

using namespace virtual_hand;

/// From straight ahead (-z) the line from thumb to fingers is turned by this towards the little
/// finger: so thumb and index of a middle-sized hand reach around 115 mm.
constexpr double kGripTurn_rad = 1.1;
/// Where the middle of a grip is at first, of the length of the hand; then each width finds its
/// own.
constexpr std::array<double, 3> kFirstMiddle{-0.24, -0.32, -0.53};
/// Beside the line to the index and middle finger of a tripod: the index a little, as the middle
/// finger is the longer one.
constexpr double kIndexBeside_m = -0.006;
constexpr double kMiddleBeside_m = 0.014;
/// Fingers that do not grip stay this much straighter at the knuckle than the index.
constexpr double kOutOfTheWay_rad = 0.5;
/// Tips that miss their places by more cannot do this width.
constexpr double kMiss_m = 0.002;

/// A digit whose tip is looked for, in the frame of the palm.
struct Reaching {
  Digit digit;
  double side;      ///< -1 the thumb, 1 a finger
  double beside_m;  ///< along z of the grip
};

}  // namespace

Quat GripShapes::q_PG() noexcept {
  const Vec3 x(std::sin(kGripTurn_rad), 0.0, -std::cos(kGripTurn_rad));
  Mat3 R_PG;
  R_PG << x, Vec3::UnitY(), x.cross(Vec3::UnitY());
  return Quat(R_PG);
}

GripShapes::GripShapes(const HandModel& model, Grip grip) {
  HandModel hand = model;
  hand.side = Hand::right;
  const std::array<Reaching, 3> reaching{
      {{Digit::thumb, -1.0, 0.0},
       {Digit::index, 1.0, grip == Grip::pinch ? 0.0 : kIndexBeside_m},
       {Digit::middle, 1.0, kMiddleBeside_m}}};
  const std::size_t used = grip == Grip::pinch ? 2 : 3;
  const Mat3 R_PG = q_PG().toRotationMatrix();
  HandPose pose;
  pose.angles = angles_at_ease();
  Vec3 middle_P = hand.length_m * Vec3(kFirstMiddle[0], kFirstMiddle[1], kFirstMiddle[2]);
  for (std::size_t k = 0; k < kCount; ++k) {
    const double gap_m = kLeast_m + kStep_m * static_cast<double>(k);
    double miss_m = 0.0;
    // Digits reach, then the middle goes where they can: half for the thumb, half for the fingers.
    constexpr int kRounds = 30;
    constexpr int kSteps = 6;
    for (int round = 0; round < kRounds; ++round) {
      miss_m = 0.0;
      Vec3 thumb_miss = Vec3::Zero();
      Vec3 finger_miss = Vec3::Zero();
      for (std::size_t r = 0; r < used; ++r) {
        const Reaching& one = reaching[r];
        const double radius_m = hand.digit(one.digit).radii_m[kLinkCount - 1];
        const Vec3 goal_P = middle_P + one.side * (0.5 * gap_m + radius_m) * R_PG.col(0) +
                            one.beside_m * R_PG.col(2);
        miss_m = std::max(miss_m, reach_with_tip(hand, pose, one.digit, goal_P, kSteps));
        const Vec3 miss = hand_in_space(hand, pose).digit(one.digit).joints[kLinkCount] - goal_P;
        (one.side < 0.0 ? thumb_miss : finger_miss) += miss;
      }
      middle_P += 0.5 * (thumb_miss + finger_miss / static_cast<double>(used - 1));
    }
    for (std::size_t d = index_of(Digit::index) + used - 1; d < kDigitCount; ++d) {
      pose.angles[d] = pose.angles[index_of(Digit::index)];
      pose.angles[d][0] = 0.0;
      pose.angles[d][1] =
          std::max(hand.digits[d].limits[1].least, pose.angles[d][1] - kOutOfTheWay_rad);
    }
    if (miss_m > kMiss_m && k > 0) {  // no wider
      for (std::size_t left = k; left < kCount; ++left) shapes_[left] = shapes_[k - 1];
      break;
    }
    shapes_[k] = {pose.angles, middle_P};
    widest_m_ = gap_m;
  }
}

GripShape between(const GripShape& from, const GripShape& to, double share) noexcept {
  GripShape shape;
  shape.p_PG = from.p_PG + share * (to.p_PG - from.p_PG);
  for (std::size_t d = 0; d < kDigitCount; ++d)
    for (std::size_t a = 0; a < kAngleCount; ++a)
      shape.angles[d][a] = from.angles[d][a] + share * (to.angles[d][a] - from.angles[d][a]);
  return shape;
}

GripShape GripShapes::at(double gap_m) const noexcept {
  const double at = std::clamp((gap_m - kLeast_m) / kStep_m, 0.0, static_cast<double>(kCount - 1));
  const auto k = std::min(static_cast<std::size_t>(at), kCount - 2);
  return between(shapes_[k], shapes_[k + 1], at - static_cast<double>(k));
}

}  // namespace isograsp::virtual_patient
