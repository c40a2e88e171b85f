// SPDX-License-Identifier: GPL-3.0-or-later
// Postures of an arm of average size, by calculation: what a rig measures at given angles of the
// joints. They are no recording of a person.
#pragma once

#include <vector>

#include "core/result.hpp"
#include "kinematics/postures.hpp"
#include "kinematics/rig.hpp"
#include "virtual_patient/arm/arm_body.hpp"

namespace isograsp::virtual_patient {

/// The arm of average size: healthy, every marker in its place, start posture exact.
[[nodiscard]] ArmBody average_arm() noexcept;

/// Poses of all frames of a rig on this arm in this posture, without noise; missing_pose() where it
/// has not the markers. Errors: it has none of them.
[[nodiscard]] Result<std::vector<Pose>> measured_frames(const Rig& rig, const ArmBody& body,
                                                        const Joints& q);

/// What library/postures/forearm_and_wrist.toml and screw.toml hold: the start posture of the
/// average arm, and turns from there. @pre the rig has a chain
[[nodiscard]] Result<Postures> forearm_and_wrist_postures(const Rig& rig);
[[nodiscard]] Result<Postures> screw_postures(const Rig& rig);

}  // namespace isograsp::virtual_patient
