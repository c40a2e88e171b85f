// SPDX-License-Identifier: GPL-3.0-or-later
// The network side of three emulated Net F/T boxes: each listens for requests on a UDP port and
// serves its page netftapi2.xml. Seen from the emulator it is a bus: requests come in, records go
// out to whoever asked last. Not real-time safe.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "core/result.hpp"
#include "device/bus/bus.hpp"
#include "device/bus/endpoint.hpp"
#include "device/codec/net_ft_box_config.hpp"
#include "device/config/device_config.hpp"

namespace isograsp {

struct NetFtServerOptions {
  struct Box {
    Endpoint records;  ///< UDP; port 0: any that is free
    Endpoint pages;    ///< HTTP; port 0: any that is free
    NetFtBoxConfig config;
  };
  std::array<Box, kFingerCount> boxes;
  /// Asked when a client wants another rate [Hz]; none: the boxes keep theirs and say no.
  std::function<bool(std::size_t finger, double rate_Hz)> set_rate;
};

class NetFtServer : public Bus {
 public:
  /// Errors name the address that cannot be used.
  [[nodiscard]] static Result<std::unique_ptr<NetFtServer>> open(NetFtServerOptions options);
  /// With the ports that are in use.
  [[nodiscard]] virtual Endpoint records(std::size_t finger) const = 0;
  [[nodiscard]] virtual Endpoint pages(std::size_t finger) const = 0;
};

/// Three boxes at `on` ("127.0.0.1:49152:8080": records, web pages) and the two addresses after it,
/// with rate and serial numbers of the configuration. `uri` becomes the device that finds them.
[[nodiscard]] Result<std::unique_ptr<Bus>> open_net_ft_boxes(const std::string& on,
                                                             const DeviceConfig& config,
                                                             std::string& uri);

}  // namespace isograsp
