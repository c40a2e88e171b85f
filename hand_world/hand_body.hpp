// SPDX-License-Identifier: GPL-3.0-or-later
// The virtual hand as something that moves: 26 coordinates, virtual masses, every link dragged to
// the tracked one (docs/virtual_hand.md, "The step"). SI units. Real-time safe.
#pragma once

#include <array>

#include "hand_world/arrow.hpp"
#include "virtual_hand/hand_pose.hpp"
#include "virtual_hand/tracked_link.hpp"

namespace isograsp::hand_world {

using virtual_hand::kAngleCount;
using virtual_hand::kLinkCount;

/// Where the tracked hand is and how it moves: palm and links at their middles.
struct HandTarget {
  virtual_hand::LinkMotion palm;
  std::array<std::array<virtual_hand::LinkMotion, kLinkCount>, kDigitCount> links;
};
/// A hand that stands still.
[[nodiscard]] HandTarget still_target(const virtual_hand::HandInSpace& hand) noexcept;
/// Middle of the palm: between base and knuckle of the middle finger's metacarpal.
[[nodiscard]] Pose palm_middle(const virtual_hand::HandInSpace& hand) noexcept;

/// What drags, and what is dragged: masses are uniform spheres of the diameter of their link.
struct HandDynamics {
  std::array<double, kLinkCount> link_kg{0.012, 0.008, 0.005};
  double palm_kg = 0.3;
  virtual_hand::LinkCoupling link;
  virtual_hand::LinkCoupling palm{1500.0, 30.0, 30.0, 3.0, 0.03, 1.5};
};

struct HandVelocity {
  Vec3 palm_v_W = Vec3::Zero();               ///< of the palm's origin [m/s]
  Vec3 palm_w_W = Vec3::Zero();               ///< [rad/s]
  std::array<LeafVector, kDigitCount> rates;  ///< of the angles [rad/s]
  HandVelocity() { rates.fill(LeafVector::Zero()); }
};

class HandBody {
 public:
  HandBody(const virtual_hand::HandModel& model, const HandDynamics& dynamics) noexcept;

  /// Stands still there.
  void place(const virtual_hand::HandPose& pose) noexcept;
  [[nodiscard]] const virtual_hand::HandModel& model() const noexcept { return model_; }
  [[nodiscard]] const virtual_hand::HandPose& pose() const noexcept { return pose_; }
  [[nodiscard]] const HandVelocity& velocity() const noexcept { return velocity_; }
  [[nodiscard]] virtual_hand::HandInSpace in_space() const noexcept {
    return virtual_hand::hand_in_space(model_, pose_);
  }
  /// The largest force that drags a link [N].
  void set_link_most(double most_N) noexcept { dynamics_.link.most_N = most_N; }

  /// Begins a step: where the hand would be in its middle if nothing pulled.
  void predict(double step_s) noexcept;
  /// That hand.
  [[nodiscard]] const virtual_hand::HandInSpace& middle() const noexcept { return middle_; }
  /// Adds masses and couplings to the matrix and what drags to the pull; `target`: in the middle of
  /// the step.
  void add_to(Arrow& matrix, ArrowVector& pull, const HandTarget& target,
              double step_s) const noexcept;
  /// Writes the velocities at the begin of the step.
  void write_velocity(ArrowVector& to) const noexcept;
  /// The end of a step at which it has these velocities: implicit midpoint.
  void advance(const ArrowVector& velocity, double step_s) noexcept;

  /// Velocity of a point of a link, or of the palm (`digit` kPalm), from those of the coordinates.
  static constexpr int kPalm = -1;
  struct PointRows {
    Eigen::Matrix<double, 3, 6> palm;
    Eigen::Matrix<double, 3, kLeafSize> rates = Eigen::Matrix<double, 3, kLeafSize>::Zero();
    /// Axes of the rates that turn the link; unused ones are zero.
    Eigen::Matrix<double, 3, kLeafSize> axes = Eigen::Matrix<double, 3, kLeafSize>::Zero();
  };
  [[nodiscard]] PointRows rows_of(int digit, std::size_t link, const Vec3& p_W) const noexcept;

 private:
  virtual_hand::HandModel model_;
  HandDynamics dynamics_;
  virtual_hand::HandPose pose_;
  HandVelocity velocity_;
  virtual_hand::HandInSpace middle_;
};

}  // namespace isograsp::hand_world
