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

/// qtm://HOST[:PORT]?rig=…: Qualisys Track Manager, RT protocol over TCP.
[[nodiscard]] Result<std::unique_ptr<MarkerDevice>> open_qtm(const Uri& uri, MarkerSource* source);

/// natnet://HOST[:PORT]?local=…&multicast=…&rig=…: Motive (OptiTrack), NatNet 2.5 to 4.1 over UDP;
/// PORT is that of commands. `local`: address of this computer in the network of the cameras;
/// `multicast`: group of the frames, else the one that Motive names.
[[nodiscard]] Result<std::unique_ptr<MarkerDevice>> open_natnet(const Uri& uri,
                                                                MarkerSource* source);

}  // namespace isograsp
