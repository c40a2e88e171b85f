// SPDX-License-Identifier: GPL-3.0-or-later
// What a column of signals is: unit, axes, words. One place for all exports.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace isograsp::tasks {

struct ColumnFacts {
  std::string unit;         ///< "N", "N m", "m", "counts" …; empty: a number without one
  std::string description;  ///< a sentence without a full stop
  std::string axes;         ///< one of kColumnAxes; empty: no direction in space
  std::string component;    ///< x, y, z, quat_w, quat_x, quat_y, quat_z; empty: none
  std::string body;         ///< what moves or is pressed: "thumb", "object", "target", "platform"
  bool known = false;       ///< false: a column of an imported recording, described by its name
};
[[nodiscard]] ColumnFacts describe_column(std::string_view name);

/// Axes by their short name, in words.
inline constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kColumnAxes{
    {{"contact",
      "of each finger's contact: z into the object (pressing is +z), x its tangent, y = "
      "z cross x; right-handed"},
     {"world", "the patient's screen: x right, y up, z out of the screen; right-handed"},
     {"platform", "of the device; the wrench is about its origin; right-handed"},
     {"hand", "of the hand, left hands mirrored: flexion (closing), radial, distal"},
     {"sensor", "of each finger's sensor as its maker defines them"}}};

}  // namespace isograsp::tasks
