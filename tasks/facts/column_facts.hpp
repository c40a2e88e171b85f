// SPDX-License-Identifier: GPL-3.0-or-later
// What a column of stored signals is, also one of an imported recording that no constant is about.
#pragma once

#include <string>
#include <string_view>

#include "core/text.hpp"

namespace isograsp::tasks {

/// Groups of signals whose columns are named by what cameras see (docs/file_formats.md): a segment
/// ("forearm_x_m" … "forearm_quat_z"), a marker ("F1_x_m"), and, computed for exports alone, a link
/// ("forearm_dorsum_x_rad").
inline constexpr std::string_view kSegmentGroup = "arm";
inline constexpr std::string_view kMarkerGroup = "markers";
inline constexpr std::string_view kLinkGroup = "angles";

struct ColumnFacts {
  std::string unit;       ///< "N", "N m", "m", "counts" …; empty: a number without one
  Text description;       ///< a sentence without a full stop
  std::string axes;       ///< one of kColumnAxes; empty: no direction in space
  std::string component;  ///< x, y, z, quat_w, quat_x, quat_y, quat_z; empty: none
  std::string body;       ///< what moves or is pressed: "thumb", "object", "target", "platform"
  bool known = false;     ///< false: a column of an imported recording, described by its name
};
/// `group`: of the signals that the column is in; empty: not known.
[[nodiscard]] ColumnFacts describe_column(std::string_view name, std::string_view group = {});

}  // namespace isograsp::tasks
