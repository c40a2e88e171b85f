// SPDX-License-Identifier: GPL-3.0-or-later
// What the screening of an arm allows of targets: no link angle beyond the passive range that was
// entered, nothing where no movement is allowed, half of the way where only a small range is.
// Angles in the sequence and from the zero of the rig [rad].
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "hand/arm_links.hpp"
#include "kinematics/postures.hpp"
#include "storage/records/profile.hpp"
#include "storage/records/records.hpp"
#include "tasks/references.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::session {

/// How far somebody else turns one angle of this arm.
struct PassiveLimit {
  LinkAngle angle;
  double least_rad = 0.0;
  double most_rad = 0.0;
  bool operator==(const PassiveLimit&) const = default;
};

/// As answers of the session: topic "screening", items "passive_forearm_a3_least_deg" and
/// "..._most_deg".
[[nodiscard]] std::vector<storage::SessionAnswer> stored(std::span<const PassiveLimit> limits);
/// Those among the answers. Errors: one of the two is missing or no number, or they are no range.
[[nodiscard]] Result<std::vector<PassiveLimit>> passive_limits_in(
    std::span<const storage::SessionAnswer> answers);

/// Where only a small range is allowed targets lie at most this part of the way from the start.
inline constexpr double kSmallWay = 0.5;

/// Refuses a task of postures whose targets the screening does not allow; says how much of the way
/// fits. `links`: of the chain of the library. Tasks without postures, in which the arm goes as far
/// as it likes, are refused only if no movement is allowed.
[[nodiscard]] Result<void> check_screening(const tasks::TaskSpec& spec, const Postures* library,
                                           const std::array<RigLink, kArmLinkCount>& links,
                                           tasks::Effort allowed,
                                           std::span<const PassiveLimit> limits);

}  // namespace isograsp::session
