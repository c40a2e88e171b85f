// SPDX-License-Identifier: GPL-3.0-or-later
// Inside tasks/ only: keys that kinds of tasks with an object share. Degrees in the file, radians
// inside.
#pragma once

#include <numbers>
#include <string>

#include "tasks/object_targets.hpp"
#include "tasks/read_keys.hpp"

namespace isograsp::tasks {

inline constexpr double kRadPerDeg = std::numbers::pi / 180.0;
inline constexpr double kMostAngle_deg = 360.0;

/// The name of a scene file, without folder and ending.
std::string read_scene(TomlReader& reader);
PoseTolerance read_tolerance(TomlReader& reader, PoseTolerance fallback);

}  // namespace isograsp::tasks
