// SPDX-License-Identifier: GPL-3.0-or-later
// Inside tasks/ only: numbers of task and protocol files within their limits. Problems are reported
// to the reader; the caller asks it in the end.
#pragma once

#include <optional>
#include <string_view>

#include "core/toml_reader.hpp"

namespace isograsp::tasks {

inline constexpr double kLongestPart_s = 3600.0;  ///< nobody exercises for longer: a typing error

/// A number in [least, most]; the fallback makes the key optional.
double read_within(TomlReader& reader, std::string_view key, double least, double most,
                   std::optional<double> fallback = {});
/// A duration above zero [s].
double read_duration(TomlReader& reader, std::string_view key, double fallback);
/// A duration from zero on [s].
double read_wait(TomlReader& reader, std::string_view key, double fallback);
int read_count(TomlReader& reader, std::string_view key, std::optional<int> fallback, int most);

}  // namespace isograsp::tasks
