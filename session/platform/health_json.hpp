// SPDX-License-Identifier: GPL-3.0-or-later
// The health of a platform as it is stored with a trial.
#pragma once

#include <string>

#include "device/sensors/force_device.hpp"

namespace isograsp::session {

/// {"state", "fault", "fault_finger", "thumb": {"good", …}, …, "foreign_frames", …}: names as in
/// docs/file_formats.md; counters since the device was started.
[[nodiscard]] std::string as_json(const DeviceHealth& health);

}  // namespace isograsp::session
