// SPDX-License-Identifier: GPL-3.0-or-later
// A log of a NatNet stream (device/bus/datagram_log.hpp: a datagram a line) as a table of markers.
#pragma once

#include <string>

#include "device/markers/natnet_codec.hpp"

namespace isograsp {

struct NatNetLogCounts {
  NatNetCounts stream;
  std::uint64_t rows = 0;
  std::uint64_t repeated = 0;  ///< frames whose number is not above that of the last one
};

/// Writes the rows of the log to `out`; t_s = stamp - first stamp. Only datagrams of the computer
/// that says first that it is a server are read. Errors name the log; nothing is left under `out`
/// then.
[[nodiscard]] Result<NatNetLogCounts> convert_natnet_log(const std::string& log,
                                                         const std::string& out);

}  // namespace isograsp
