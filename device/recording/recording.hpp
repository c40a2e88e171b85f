// SPDX-License-Identifier: GPL-3.0-or-later
// A recording as a device plays it: all samples in the order of their time.
#pragma once

#include <string>
#include <vector>

#include "core/result.hpp"
#include "device/config/device_config.hpp"
#include "device/sensors/force_device.hpp"

namespace isograsp {

struct Recording {
  DeviceInfo info;                    ///< all but the URI
  std::vector<SensorSample> samples;  ///< stamps since the start of the recording
};

/// A finger-forces file (docs/file_formats.md). A regular time grid of 50 to 1000 Hz becomes the
/// frame grid, so that every frame holds exactly one row; any other file is resampled to 100 Hz by
/// the frame clock. Empty fields, and fingers that the file does not have, are samples marked
/// invalid. Errors name file and line.
[[nodiscard]] Result<Recording> read_csv_recording(const std::string& path);

/// A raw log of a CAN bus (candump), or of datagrams for net-ft: decoded, corrected by the clinic's
/// calibration and mounted as the device file says; not smoothed. Without `addresses_known` the
/// senders of datagrams are thumb, index and middle in ascending order. Errors name file and line.
[[nodiscard]] Result<Recording> read_log_recording(const std::string& path,
                                                   const DeviceConfig& config,
                                                   bool addresses_known);

}  // namespace isograsp
