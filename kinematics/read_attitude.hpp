// SPDX-License-Identifier: GPL-3.0-or-later
// Attitudes and poses in TOML files.
#pragma once

#include <string>

#include "core/toml_reader.hpp"
#include "kinematics/attitude.hpp"

namespace isograsp {

/// Four numbers (w, x, y, z), made a unit quaternion; all zero is an error of the key.
[[nodiscard]] Quat read_attitude(TomlReader& table, std::string_view key);
/// `position_m` and `quaternion_wxyz`.
[[nodiscard]] Pose read_pose(TomlReader& table);

/// A text in quotes, with what TOML escapes.
[[nodiscard]] std::string toml_text(std::string_view text);
/// "[1, 2, 3]"
[[nodiscard]] std::string toml_numbers(const Vec3& values);
[[nodiscard]] std::string toml_numbers(const Quat& q);

}  // namespace isograsp
