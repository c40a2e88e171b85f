// SPDX-License-Identifier: GPL-3.0-or-later
// replay://FILE.csv?speed=1, replay://FRAMES.log?protocol=…: a recording as a device.
#pragma once

#include <memory>

#include "device/config/uri.hpp"
#include "device/sensors/force_device.hpp"

namespace isograsp {

/// Reads the whole file at once and reports everything that is wrong with it: finger forces, or,
/// with `protocol` or `config`, a raw log of frames or datagrams (device/recording/recording.hpp).
///
/// Stamps, deadlines and now() are recorded time since the start; `speed` (0.01 to 1000) says how
/// many recorded seconds pass in one second of the clock, 0: never wait. Forces made by a
/// simulation say so in a comment line that begins with "simulated"; DeviceInfo::simulated is then
/// set.
[[nodiscard]] Result<std::unique_ptr<ForceDevice>> open_replay_device(const Uri& uri);

}  // namespace isograsp
