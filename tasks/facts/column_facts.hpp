// SPDX-License-Identifier: GPL-3.0-or-later
// What a column of stored signals is, also one of an imported recording that no constant is about.
#pragma once

#include <string>
#include <string_view>

#include "core/text.hpp"

namespace isograsp::tasks {

struct ColumnFacts {
  std::string unit;       ///< "N", "N m", "m", "counts" …; empty: a number without one
  Text description;       ///< a sentence without a full stop
  std::string axes;       ///< one of kColumnAxes; empty: no direction in space
  std::string component;  ///< x, y, z, quat_w, quat_x, quat_y, quat_z; empty: none
  std::string body;       ///< what moves or is pressed: "thumb", "object", "target", "platform"
  bool known = false;     ///< false: a column of an imported recording, described by its name
};
[[nodiscard]] ColumnFacts describe_column(std::string_view name);

}  // namespace isograsp::tasks
