// SPDX-License-Identifier: GPL-3.0-or-later
// Emulated cameras on a real port of this computer: the play begins when the first client asks for
// pictures. Not real-time safe; one thread uses it.
#pragma once

#include <cstdint>
#include <memory>

#include "core/result.hpp"
#include "core/time.hpp"
#include "device/bus/endpoint.hpp"
#include "device/emulator/emulated_natnet.hpp"
#include "device/emulator/marker_play.hpp"

namespace isograsp {

struct MarkerServerCounters {
  std::uint64_t clients = 0;  ///< that came, again and again
  std::uint64_t sent = 0;     ///< pictures, to each client
  std::uint64_t closed = 0;   ///< connections that a fault closed
};

class MarkerServer {
 public:
  MarkerServer() = default;
  virtual ~MarkerServer() = default;
  MarkerServer(const MarkerServer&) = delete;
  MarkerServer& operator=(const MarkerServer&) = delete;

  /// With the port that is in use.
  [[nodiscard]] virtual Endpoint address() const = 0;
  /// Answers and sends what is due; returns at `until`, or a little before.
  virtual void serve(Clock& clock, Timestamp until) = 0;
  /// All pictures have been shown.
  [[nodiscard]] virtual bool over() const = 0;
  [[nodiscard]] virtual const MarkerScene& scene() const = 0;
  [[nodiscard]] virtual const MarkerServerCounters& counters() const = 0;
};

/// Qualisys Track Manager at this address; port 0: any that is free. Errors name the address.
[[nodiscard]] Result<std::unique_ptr<MarkerServer>> open_qtm_server(const Endpoint& on,
                                                                    MarkerScene scene);

/// Motive at this address, which is that of its commands. Frames go to a multicast group
/// (`options.group`, `options.data_port`) or to those who asked. Errors name the address, or a
/// fault that only a connection can have.
[[nodiscard]] Result<std::unique_ptr<MarkerServer>> open_natnet_server(
    const Endpoint& on, MarkerScene scene, const EmulatedNatNetOptions& options);

}  // namespace isograsp
