// SPDX-License-Identifier: GPL-3.0-or-later
// Asks a device for one of its web pages.
#pragma once

#include <string>

#include "core/result.hpp"
#include "core/time.hpp"
#include "device/bus/endpoint.hpp"

namespace isograsp {

/// The body of http://SERVER/TARGET, at most 256 KiB. `target` begins with "/". Waits no longer
/// than `limit` in all. Errors name the page. Not real-time safe.
[[nodiscard]] Result<std::string> http_get(const Endpoint& server, const std::string& target,
                                           Timestamp limit);

}  // namespace isograsp
