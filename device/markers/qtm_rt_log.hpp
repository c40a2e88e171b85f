// SPDX-License-Identifier: GPL-3.0-or-later
// A log of a stream of Qualisys Track Manager (device/bus/datagram_log.hpp: a piece of the TCP
// connection a line) as a table of markers.
#pragma once

#include <string>

#include "device/markers/qtm_rt_codec.hpp"

namespace isograsp {

/// Writes the rows of the log to `out`; t_s = (stamp - first stamp) / 1e6. Pieces of other
/// addresses than the first are passed over. Errors name the log; nothing is left under `out`
/// then.
[[nodiscard]] Result<QtmRtCounts> convert_qtm_rt_log(const std::string& log,
                                                     const std::string& out);

}  // namespace isograsp
