// SPDX-License-Identifier: GPL-3.0-or-later
// Inside tasks/ only: keys of kinds of tasks that bring an object to postures, and where these
// stand in the library that they name.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hand/arm_links.hpp"
#include "tasks/read_keys.hpp"
#include "tasks/task.hpp"

namespace isograsp::tasks {

/// Names of postures; one at least.
std::vector<std::string> read_sequence(TomlReader& reader);
/// Which angle of which link: own_range, own_angle. In its place a file of postures is none.
LinkAngle read_own_range(TomlReader& reader);
/// How far from the initial posture to the named one, 0.1 to 1.
double read_way(TomlReader& reader);
SizeScale read_scale(TomlReader& reader);

/// Places of the named postures in the library of the arm. Errors: it has no such posture, or the
/// arm is not known.
[[nodiscard]] Result<std::vector<std::size_t>> places_of(const std::vector<std::string>& names,
                                                         const std::string& file,
                                                         const std::optional<ArmPostures>& arm);

}  // namespace isograsp::tasks
