// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that one trial needs, made ready before it begins: task, object, what is stored of
// them.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "core/result.hpp"
#include "session/platform/platform_trial.hpp"
#include "tasks/task.hpp"

namespace isograsp::session {

/// The scene of `spec` as this hand meets it: turned for it, with its contact thresholds [N]
/// (nothing: as the scene says). Nothing for a force task.
struct TrialScene {
  std::optional<Scene> scene;
  std::string text;  ///< of its file
};
[[nodiscard]] Result<TrialScene> read_trial_scene(
    const tasks::TaskSpec& spec, Hand hand,
    const std::array<std::optional<double>, kFingerCount>& threshold_N, const std::string& library);

/// Task, plan and what their record says of them; the session adds its own. Refused like
/// make_task(), or where the scene cannot be read or compiled.
[[nodiscard]] Result<std::unique_ptr<PlatformTrial>> prepare_trial(
    const tasks::TaskSpec& spec, const tasks::TaskContext& context, const TrialScene& scene);

}  // namespace isograsp::session
