// SPDX-License-Identifier: GPL-3.0-or-later
// What a NatNet server tells of its models (message 5): sets of markers with their names, and the
// number under which labelled markers name each of them. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "device/markers/natnet_layout.hpp"

namespace isograsp {

/// Markers of one model, side by side in a row.
struct NatNetSet {
  std::string name;
  std::size_t first = 0;  ///< place of its first marker in a row
  std::size_t count = 0;
  std::optional<std::uint32_t> model;  ///< labelled markers of it: model * 65536 + 1, 2, …
  bool operator==(const NatNetSet&) const = default;
};

struct NatNetModels {
  std::vector<NatNetSet> sets;
  /// Names of the markers, each once: one that two sets have gets the name of its set in front,
  /// "OBJECT_Marker1". The set "all", which repeats the others, counts only where it is alone.
  std::vector<std::string> labels;
  bool operator==(const NatNetModels&) const = default;
};

/// Reads the body of message 5. Nothing: it is cut off, or of another layout. At most
/// MarkerReader::kMostMarkers markers.
[[nodiscard]] std::optional<NatNetModels> parse_natnet_models(std::span<const std::uint8_t> body,
                                                              NatNetVersion version);

}  // namespace isograsp
