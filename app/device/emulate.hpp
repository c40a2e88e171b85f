// SPDX-License-Identifier: GPL-3.0-or-later
// Inside app/device/ only. What `isograsp emulate` is told, and who plays it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/result.hpp"

namespace isograsp::app {

struct EmulateOptions {
  std::string protocol;
  std::string config;
  std::string on;
  std::string play = "healthy";
  std::uint64_t seed = 1;
  std::vector<std::string> faults;
  double duration_s = 0.0;
  bool json = false;
  // Of cameras.
  bool loop = false;
  std::string natnet_version = "4.1";
  std::string multicast;
};

/// Three sensors of a family on a bus.
[[nodiscard]] Result<void> emulate_sensors(const EmulateOptions& options);

[[nodiscard]] bool is_marker_protocol(const std::string& protocol) noexcept;
/// Cameras that show a recording.
[[nodiscard]] Result<void> emulate_markers(const EmulateOptions& options);

}  // namespace isograsp::app
