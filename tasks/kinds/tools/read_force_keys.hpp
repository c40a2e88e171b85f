// SPDX-License-Identifier: GPL-3.0-or-later
// Inside tasks/ only: keys that kinds of force tasks share. Problems are reported to the reader.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tasks/aim.hpp"
#include "tasks/read_keys.hpp"

namespace isograsp::tasks {

inline constexpr int kMostRepetitions = 100;

ForceChannel read_channel(TomlReader& reader);
Aim read_aim(TomlReader& reader, bool with_channel = true);
/// "least" is read as least_N or least_fraction, as the scale demands. Opening levels are positive
/// in an opening channel; a signed channel takes negative ones.
double read_level(TomlReader& reader, const Aim& aim, const std::string& name, double fallback);
std::vector<double> read_levels(TomlReader& reader, const Aim& aim, const std::string& name,
                                std::vector<double> fallback);
std::vector<Finger> read_digits(TomlReader& reader, std::string_view key);
void read_waits(TomlReader& reader, double& least_s, double& most_s);

}  // namespace isograsp::tasks
