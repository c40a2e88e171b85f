// SPDX-License-Identifier: GPL-3.0-or-later
// A UDP port of this computer that hears anybody, a multicast group too, and never waits.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "core/result.hpp"
#include "core/time.hpp"
#include "device/bus/endpoint.hpp"

namespace isograsp {

class UdpPort {
 public:
  UdpPort();
  ~UdpPort();
  UdpPort(const UdpPort&) = delete;
  UdpPort& operator=(const UdpPort&) = delete;

  /// Opens it at this address (0: any) and port (0: one that is free). `shared`: other programs of
  /// this computer may hear the same port. Errors name the address.
  [[nodiscard]] Result<void> open(const Endpoint& local, bool shared);
  /// Joins a multicast group at the network of this address (0: the system's choice).
  [[nodiscard]] Result<void> join(std::uint32_t group, std::uint32_t local);
  /// Groups are sent to through the network of this address.
  void send_groups_through(std::uint32_t local) noexcept;
  [[nodiscard]] bool is_open() const noexcept;
  [[nodiscard]] Endpoint local() const noexcept;

  /// False: the system did not take it. Real-time safe.
  bool send(const Endpoint& to, std::span<const std::uint8_t> bytes) noexcept;
  /// The next datagram that has come; nothing: there is none. One that does not fit counts with its
  /// full length. Real-time safe.
  [[nodiscard]] std::optional<std::size_t> receive(std::span<std::uint8_t> room,
                                                   Endpoint& from) noexcept;
  void close() noexcept;

  /// Until one of two ports has something, or `span` has passed. Real-time safe.
  static void wait(const UdpPort& one, const UdpPort& other, Timestamp span) noexcept;

 private:
  [[nodiscard]] int descriptor() const noexcept;
  struct Socket;
  std::unique_ptr<Socket> socket_;
};

}  // namespace isograsp
