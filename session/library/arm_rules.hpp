// SPDX-License-Identifier: GPL-3.0-or-later
// What a task of an arm must ask before its results may be an assessment, and how much a protocol
// may ask of an arm that holds an object.
#pragma once

#include <vector>

#include "core/result.hpp"
#include "tasks/protocol.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::session {

/// Shorter, an object that flies through the reference would count as brought there.
inline constexpr double kLeastHold_s = 0.3;
inline constexpr int kMostMovements = 4;        ///< before the hand is put down
inline constexpr double kHandDown_s = 10.0;     ///< after them, at least
inline constexpr double kBetweenBlocks_s = 60;  ///< from one step with movements to the next
/// Of a protocol at worst, its practice (familiarisation) left out.
inline constexpr double kLongestArmProtocol_s = 15.0 * 60.0;

/// Refused (field "hold_s"): targets are reached after less than kLeastHold_s. Training, whose
/// level follows success, is no assessment; every other task passes.
[[nodiscard]] Result<void> check_assessment(const tasks::TaskSpec& spec);

/// Refuses steps that are assessments and must not be one, too many movements on end, too short
/// rests and a protocol that is too long. `tasks`: of each step. Protocols without postures pass.
[[nodiscard]] Result<void> check_arm_rules(const tasks::ProtocolSpec& protocol,
                                           const std::vector<std::vector<tasks::TaskSpec>>& tasks);

}  // namespace isograsp::session
