// SPDX-License-Identifier: GPL-3.0-or-later
// The contacts of a scene that two hands press with measured forces. Inside bimanual/ only.
#pragma once

#include <array>

#include "bimanual/pressed_by_hands.hpp"
#include "core/toml_reader.hpp"

namespace isograsp::bimanual {

/// Each [[contact]] with its `hand`; without `finger` the whole hand presses. What is wrong is
/// remembered by the reader.
[[nodiscard]] std::array<HandContacts, kSides> read_hand_contacts(TomlReader& root,
                                                                  const Scene& object);

}  // namespace isograsp::bimanual
