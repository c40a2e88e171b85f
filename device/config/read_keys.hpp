// SPDX-License-Identifier: GPL-3.0-or-later
// Keys of device files that several readers know. Inside device/ only.
#pragma once

#include <cstdint>
#include <string_view>

#include "core/toml_reader.hpp"

namespace isograsp {

/// A whole number from `least` to `most`, which fit into a byte.
[[nodiscard]] std::uint8_t read_id(TomlReader& sensor, std::string_view key, std::int64_t fallback,
                                   std::int64_t least, std::int64_t most);
[[nodiscard]] double read_positive(TomlReader& sensor, std::string_view key, double fallback);

}  // namespace isograsp
