// SPDX-License-Identifier: GPL-3.0-or-later
// The segments of a right arm and the markers on them. W is the frame of the cameras: X right, Y
// up, Z towards the person; the forearm points away from them. Axes of forearm and hand at the
// start of every range: x out of the back of the hand (right), y to the thumb (up), z to the elbow.
// The object's axes are those of the dorsum frame of rigs: x palmar, y to the elbow, z to the
// thumb. Positions in m, angles in rad.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/random.hpp"
#include "core/spatial.hpp"
#include "hand/finger.hpp"
#include "virtual_patient/arm/arm_traits.hpp"

namespace isograsp::virtual_patient {

/// What can be moved, one number each.
namespace joint {
enum Index : std::uint8_t {
  pronation,  ///< about the long axis of the forearm [rad]
  swing_up,   ///< of the forearm about the elbow [rad]
  swing_in,   ///< towards the other arm [rad]
  flexion,    ///< of the wrist; extension is negative [rad]
  ulnar,      ///< deviation; radial is negative [rad]
  turn_x,     ///< of the object in the fingers, a rotation vector, axes of the hand [rad]
  turn_y,
  turn_z,
  shift_x,  ///< of the object in the fingers, axes of the hand [m]
  shift_y,
  shift_z,
  lift,    ///< of the shoulder: raises the elbow outwards and turns the forearm inwards [rad]
  lean_x,  ///< of the trunk, which takes the elbow along, axes of the brace [m]
  lean_y,
  lean_z,
  count
};
}  // namespace joint
inline constexpr int kJoints = joint::count;
using Joints = Eigen::Matrix<double, kJoints, 1>;
/// How the object moves with each of them: rows v, w in axes of the brace.
using ArmJacobian = Eigen::Matrix<double, 6, kJoints>;

enum class Segment : std::uint8_t { brace, trunk, elbow, forearm, hand, object };
inline constexpr std::size_t kSegments = 6;
/// Poses of all segments.
using ArmPoses = std::array<Pose, kSegments>;

/// One marker, in the frame of its segment S.
struct ArmMarker {
  std::string_view label;
  Segment segment = Segment::brace;
  Vec3 p_S = Vec3::Zero();
  Vec3 outward_S = Vec3::UnitY();  ///< unit vector: from where it is seen best
  bool on_skin = false;
};
/// B1-3, EL, F1-2, W, D1-2, O1-6 of the rig of Kurillo et al., and T1 on the breastbone.
inline constexpr std::size_t kArmMarkers = 16;

struct ArmBody {
  /// The body of these traits (already drawn()), with markers placed by `random`. For a left hand
  /// the world is reflected, and the object with it: cameras see the same object for both.
  ArmBody(const ArmTraits& traits, Random& random, Hand hand) noexcept;

  Pose X_WB;  ///< of the brace; fixed to the table
  Vec3 elbow_B = Vec3::Zero();
  Vec3 breastbone_B = Vec3::Zero();
  double forearm_m = 0.0;
  double upper_arm_m = 0.0;
  Pose X_HO;  ///< of the object in the hand, fingers at rest
  std::array<ArmMarker, kArmMarkers> markers;
  Joints rest = Joints::Zero();  ///< start posture
  Joints least = Joints::Zero(), most = Joints::Zero();

  /// Segments in the frame of the brace. Real-time safe.
  [[nodiscard]] ArmPoses poses_B(const Joints& q) const noexcept;
  /// Segments in W. Real-time safe.
  [[nodiscard]] ArmPoses poses_W(const Joints& q) const noexcept;
  /// d(object) / d(joints) in the frame of the brace. Real-time safe.
  [[nodiscard]] ArmJacobian jacobian_B(const Joints& q) const noexcept;
};

[[nodiscard]] constexpr std::size_t index_of(Segment segment) noexcept {
  return static_cast<std::size_t>(segment);
}

}  // namespace isograsp::virtual_patient
