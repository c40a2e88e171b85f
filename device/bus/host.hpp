// SPDX-License-Identifier: GPL-3.0-or-later
// The address of a computer that is called by its name.
#pragma once

#include <string>
#include <string_view>

#include "core/result.hpp"
#include "device/bus/endpoint.hpp"

namespace isograsp {

/// A computer and a port as people write them: "192.168.0.7", "qtm-pc:22223".
struct HostAndPort {
  std::string host;
  std::uint16_t port = 0;
};
/// Nothing: no host, or no port from 1 to 65535 behind the colon.
[[nodiscard]] std::optional<HostAndPort> parse_host(std::string_view text,
                                                    std::uint16_t usual_port);

/// Its IPv4 address: in numbers at once, else by the system's name service, which may take seconds.
/// Errors name the host.
[[nodiscard]] Result<Endpoint> find_host(const HostAndPort& host);

}  // namespace isograsp
