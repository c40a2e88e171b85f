// SPDX-License-Identifier: GPL-3.0-or-later
// sim://PATIENT?seed=7&hand=right&rate=100&drop=0: three simulated sensors, pressed by a
// FingerSource.
#pragma once

#include <memory>

#include "device/config/uri.hpp"
#include "device/sensors/force_device.hpp"

namespace isograsp {

/// Opens the simulated device. `options.source` presses; PATIENT names who that is and is only
/// checked not to be empty. Samples lie on the frame grid: number k is stamped k / rate after the
/// start, and the source is pressed at 1 kHz up to that instant, never beyond, so that it can see()
/// frame k before the forces of frame k + 1 exist. `drop`: probability that a finger's sample is
/// marked invalid. Same seed, source and parameters: same samples.
[[nodiscard]] Result<std::unique_ptr<ForceDevice>> open_sim_device(const Uri& uri,
                                                                   const DeviceOptions& options);

}  // namespace isograsp
