// SPDX-License-Identifier: GPL-3.0-or-later
// The arm of whom the postures of a library were taken, for tasks that bring an object to them: the
// elbow at the origin, held in the initial posture.
#pragma once

#include <stdexcept>
#include <string>

#include "core/files.hpp"
#include "tasks/kinds/arm/pose_matching.hpp"
#include "tasks/task.hpp"

namespace isograsp::test {

/// @pre the task names postures, which stand in the library, or asks for an own range: of 1 rad
inline tasks::ArmPostures reference_subject(const tasks::TaskSpec& spec) {
  const auto* const matching = spec.kind.get_if<tasks::PoseMatchingSpec>();
  const bool own = matching != nullptr && matching->own_range;
  const std::string path = std::string(ISOGRASP_SOURCE_DIR) + "/library/postures/" +
                           (own ? "screw" : spec.kind->postures(spec.kind)) + ".toml";
  const auto text = read_text(path);
  if (!text) throw std::runtime_error(text.error().message());
  auto library = parse_postures(*text, path);
  if (!library) throw std::runtime_error(library.error().message());
  StartPosture start{1, Pose{Vec3::Zero(), Quat::Identity()}, library->postures.front().X_L};
  if (own)
    *library = own_range_postures(start, library->chain, index_of(matching->own_range->link), {},
                                  {"", matching->own_range->angle - 1, -0.5, 0.5});
  return {*std::move(library), std::move(start), {}};
}

/// Where the object is in the initial posture.
inline Pose initial_pose(const tasks::ArmPostures& arm) {
  return adapted(arm.library, 0, arm.start, SizeScale::none);
}

}  // namespace isograsp::test
