// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes with two hands: that of the object (grasp_model/scene.hpp) with [hands],
// [grasp_detection], [magnet] and [[pad]] (docs/file_formats.md).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bimanual/hands_spec.hpp"
#include "bimanual/pads/held_by_pads.hpp"
#include "bimanual/pressed_by_hands.hpp"
#include "core/result.hpp"
#include "grasp_model/scene.hpp"

namespace isograsp::bimanual {

/// What the hands are to the object.
enum class Coupling : std::uint8_t {
  none,   ///< nothing: two numbers
  force,  ///< contacts with measured force (bimanual/pressed_by_hands.hpp)
  proxy   ///< points moved by force
};

struct HandsScene {
  Scene object;  ///< `none`: nothing but the name
  Coupling coupling = Coupling::none;
  std::array<HandContacts, kSides> contacts;  ///< `force`
  HandsSpec hands;                            ///< `proxy`, and what follows
  std::optional<GraspDetection> grasp;        ///< nothing: they never hold it
  Magnet magnet;
  std::vector<PadSpec> pads;
  double pad_step_s = 1e-3;  ///< of pads
};

/// The text is of a scene with two hands.
[[nodiscard]] bool has_hands(std::string_view text) noexcept;
[[nodiscard]] Result<HandsScene> parse_hands_scene(std::string_view text, const std::string& file);

}  // namespace isograsp::bimanual
