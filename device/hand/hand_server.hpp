// SPDX-License-Identifier: GPL-3.0-or-later
// An emulated tracker of hands on a real port of this computer. Not real-time safe; one thread uses
// it.
#pragma once

#include <cstdint>
#include <memory>

#include "core/result.hpp"
#include "core/time.hpp"
#include "device/bus/endpoint.hpp"
#include "device/hand/hand_play.hpp"

namespace isograsp {

struct HandServerCounters {
  std::uint64_t clients = 0;  ///< that came, again and again
  std::uint64_t sent = 0;     ///< messages, to each client
  std::uint64_t closed = 0;   ///< connections that a fault closed
};

class HandServer {
 public:
  HandServer() = default;
  virtual ~HandServer() = default;
  HandServer(const HandServer&) = delete;
  HandServer& operator=(const HandServer&) = delete;

  /// With the port that is in use.
  [[nodiscard]] virtual Endpoint address() const = 0;
  /// Answers and sends what is due; returns at `until`, or a little before.
  virtual void serve(Clock& clock, Timestamp until) = 0;
  /// All frames have been shown, and everybody has got them.
  [[nodiscard]] virtual bool over() const = 0;
  [[nodiscard]] virtual const HandScene& scene() const = 0;
  [[nodiscard]] virtual const HandServerCounters& counters() const = 0;
};

/// The Leap service at this address; port 0: any that is free. The play begins when the first
/// client asks for frames; at its end connections are closed in good order. Errors name the
/// address.
[[nodiscard]] Result<std::unique_ptr<HandServer>> open_leap_server(const Endpoint& on,
                                                                   HandScene scene);

/// A script that sends its hands to this address from the first call of serve() on. Errors: the
/// system gives no port, or a fault is one that only a connection can have.
[[nodiscard]] Result<std::unique_ptr<HandServer>> open_hand_sender(const Endpoint& to,
                                                                   HandScene scene);

}  // namespace isograsp
