// SPDX-License-Identifier: GPL-3.0-or-later
// A TCP connection as a client that never waits: for streams that are read until a deadline and
// whose connection is made anew meanwhile.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "core/time.hpp"
#include "device/bus/endpoint.hpp"

namespace isograsp {

class TcpLink {
 public:
  enum class State : std::uint8_t { closed, connecting, open };

  TcpLink();
  ~TcpLink();
  TcpLink(const TcpLink&) = delete;
  TcpLink& operator=(const TcpLink&) = delete;

  /// Begins to connect, closing what is open. Real-time safe, but for the kernel's own work.
  void connect(const Endpoint& server) noexcept;
  /// Looks whether a connection that was begun stands or has failed. Real-time safe.
  [[nodiscard]] State state() noexcept;
  /// Bytes that have come: none, nothing, or as many as fit. Nothing: the connection is closed.
  /// Real-time safe.
  [[nodiscard]] std::optional<std::size_t> receive(std::span<std::uint8_t> room) noexcept;
  /// Sends a short command; false: the connection is closed. Real-time safe.
  bool send(std::span<const std::uint8_t> bytes) noexcept;
  /// Until bytes come, a connection stands or fails, or `span` has passed. Real-time safe.
  void wait(Timestamp span) noexcept;
  void close() noexcept;

 private:
  struct Socket;
  std::unique_ptr<Socket> socket_;
  State state_ = State::closed;
};

}  // namespace isograsp
