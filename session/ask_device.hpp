// SPDX-License-Identifier: GPL-3.0-or-later
// Whether what an address names answers: opened, looked at for a second, let go. Nothing is
// stored.
#pragma once

#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "session/open_apparatus.hpp"

namespace isograsp::session {

struct DeviceAnswer {
  Text description;  ///< one line for people: "Robotous RFT on can0"
  std::string kind;  ///< ApparatusInfo::kind
  std::vector<storage::SensorRecord> sensors;
  int frames = 0;    ///< that were looked at; 0: a camera sees the person, and was only asked
  int with_gap = 0;  ///< of them: a part was missing
  double rate_Hz = 0.0;

  /// Every frame that was looked at was whole.
  [[nodiscard]] bool good() const noexcept { return with_gap == 0; }
};

/// Asks for a second at most; devices may need some to start. Errors: as opening or starting it.
/// Cancelled: failed. Any thread.
[[nodiscard]] Result<DeviceAnswer> ask_device(
    const std::string& uri, const std::string& library, const std::stop_token& stop = {},
    std::span<const ApparatusRow> rows = all_apparatuses());

}  // namespace isograsp::session
