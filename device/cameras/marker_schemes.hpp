// SPDX-License-Identifier: GPL-3.0-or-later
// Inside device/cameras/ only. How each scheme of a URI is opened; open_marker_device() holds the
// table.
#pragma once

#include <memory>

#include "device/cameras/marker_device.hpp"

namespace isograsp {

/// replay://FILE?rig=…&speed=1: a recording of any format that open_markers() reads. The period is
/// that of its times, numbers are places in that grid: rows that are not there are gaps. Stamps are
/// the times of the file since its first row. speed 0: never wait.
[[nodiscard]] Result<std::unique_ptr<MarkerDevice>> open_marker_replay(const Uri& uri,
                                                                       MarkerSource* source);

/// sim://arm?patient=…&seed=1&rate=100&hand=right&drop=0&rig=…: what `source` shows, number k
/// stamped k / rate after the start; the source is asked for picture k when it is read, so that it
/// can see() what followed from picture k - 1. `drop`: probability that a picture is lost (the
/// source has moved all the same). Same seed, source and parameters: same pictures.
[[nodiscard]] Result<std::unique_ptr<MarkerDevice>> open_simulated_markers(const Uri& uri,
                                                                           MarkerSource* source);

}  // namespace isograsp
