// SPDX-License-Identifier: GPL-3.0-or-later
// What the screening of an arm allows of targets: no link angle beyond the passive range that was
// entered, nothing where no movement is allowed, half of the way where only a small range is, and
// 50, 75 and 100 % of the way each only after the one before.
// Angles in the sequence and from the zero of the rig [rad].
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "hand/arm_links.hpp"
#include "kinematics/postures.hpp"
#include "storage/records/profile.hpp"
#include "storage/records/records.hpp"
#include "tasks/references.hpp"
#include "tasks/task.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::session {

/// As answers of the session: topic "screening", items "passive_forearm_a3_least_deg" and
/// "..._most_deg".
[[nodiscard]] std::vector<storage::SessionAnswer> stored(std::span<const PassiveLimit> limits);
/// Those among the answers. Errors: one of the two is missing or no number, or they are no range.
[[nodiscard]] Result<std::vector<PassiveLimit>> passive_limits_in(
    std::span<const storage::SessionAnswer> answers);

/// Where only a small range is allowed targets lie at most this part of the way from the start.
inline constexpr double kSmallWay = 0.5;

/// From a passive range as it is typed, in degrees: "forearm_a3=-40:60".
[[nodiscard]] Result<PassiveLimit> passive_limit_from(std::string_view text);

/// Fixed postures are gone to by stages, each only after the one before.
inline constexpr std::array kStages{0.5, 0.75, 1.0};

/// A task whose targets are fixed postures, and how far it goes to them; nothing: it has none, or
/// they are of the person's own range.
struct WayTo {
  std::string postures;
  double way = 1.0;
};
[[nodiscard]] std::optional<WayTo> way_of(const tasks::TaskSpec& spec);

/// Refuses a task of postures whose targets the screening does not allow; says how much of the way
/// fits, or which stage comes first. `links`: of the chain of the library. Tasks without postures,
/// in which the arm goes as far as it likes, are refused only if no movement is allowed.
[[nodiscard]] Result<void> check_screening(const tasks::TaskSpec& spec, const Postures* library,
                                           const std::array<RigLink, kArmLinkCount>& links,
                                           tasks::Effort allowed,
                                           const tasks::ArmScreening& screening);

}  // namespace isograsp::session
