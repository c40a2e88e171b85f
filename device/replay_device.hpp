// SPDX-License-Identifier: GPL-3.0-or-later
// replay://FILE?speed=1: a finger-forces CSV (docs/file_formats.md) as a device.
#pragma once

#include <memory>

#include "device/force_device.hpp"
#include "device/uri.hpp"

namespace isograsp {

/// Reads the whole file at once and reports everything that is wrong with it. A regular time grid
/// of 50 to 1000 Hz becomes the frame grid, so that every frame holds exactly one row; any other
/// file is resampled to 100 Hz by the frame clock. Empty fields, and fingers that the file does not
/// have, are samples marked invalid.
///
/// Stamps, deadlines and now() are recorded time since the start; `speed` (0.01 to 1000) says how
/// many recorded seconds pass in one second of the clock, 0: never wait. Forces made by a
/// simulation say so in a comment line that begins with "simulated"; DeviceInfo::simulated is then
/// set.
[[nodiscard]] Result<std::unique_ptr<ForceDevice>> open_replay_device(const Uri& uri);

}  // namespace isograsp
