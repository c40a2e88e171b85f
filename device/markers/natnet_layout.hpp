// SPDX-License-Identifier: GPL-3.0-or-later
// Versions of the NatNet stream, and what its messages hold in each of them.
#pragma once

#include <cstdint>
#include <string>

namespace isograsp {

struct NatNetVersion {
  int major = 0;
  int minor = 0;

  [[nodiscard]] bool operator==(const NatNetVersion&) const = default;
  [[nodiscard]] constexpr bool at_least(int other_major, int other_minor) const noexcept {
    return major > other_major || (major == other_major && minor >= other_minor);
  }
  /// 2.5 to 4.1: the layouts that are known.
  [[nodiscard]] constexpr bool known() const noexcept { return at_least(2, 5) && !at_least(4, 2); }
  [[nodiscard]] std::string text() const {
    return std::to_string(major) + "." + std::to_string(minor);
  }
};

/// Kinds of messages: the first number of each.
struct NatNetMessage {
  static constexpr std::uint16_t kConnect = 0;
  static constexpr std::uint16_t kServer = 1;
  static constexpr std::uint16_t kRequest = 2;
  static constexpr std::uint16_t kResponse = 3;
  static constexpr std::uint16_t kAskModels = 4;
  static constexpr std::uint16_t kModels = 5;
  static constexpr std::uint16_t kFrame = 7;
  static constexpr std::uint16_t kKeepAlive = 10;
};

/// What stands in the messages of a version.
struct NatNetLayout {
  explicit constexpr NatNetLayout(NatNetVersion version) noexcept
      : byte_counts(version.at_least(4, 1)),
        assets(version.at_least(4, 1)),
        precise_stamps(version.at_least(4, 1)),
        marker_names(version.at_least(4, 0)),
        camera_ticks(version.at_least(3, 0)),
        markers_in_bodies(!version.at_least(3, 0)),
        devices(version.at_least(2, 11)),
        force_plates(version.at_least(2, 9)),
        double_stamps(version.at_least(2, 7)),
        flags(version.at_least(2, 6)) {}

  bool byte_counts;        ///< the size of each list stands behind its count
  bool assets;             ///< a list of trained marker sets
  bool precise_stamps;     ///< two more numbers of time
  bool marker_names;       ///< a body is described with the names of its markers
  bool camera_ticks;       ///< three more numbers of time; residuals; markers in descriptions
  bool markers_in_bodies;  ///< each body of a frame has its markers with it
  bool devices;
  bool force_plates;
  bool double_stamps;  ///< the time of a frame is a double, else a float
  bool flags;          ///< of bodies and labelled markers
};

}  // namespace isograsp
