// SPDX-License-Identifier: GPL-3.0-or-later
// Inside session/two_platforms/ only. The scene of two hands that a task names.
#pragma once

#include <string>

#include "bimanual/read_hands.hpp"
#include "core/result.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::session {

struct NamedScene {
  std::string path;
  std::string text;
  bimanual::HandsScene scene;
};

/// Errors name the task, or the file and line of the scene.
[[nodiscard]] Result<NamedScene> named_scene(const tasks::TaskSpec& spec,
                                             const std::string& library);

}  // namespace isograsp::session
