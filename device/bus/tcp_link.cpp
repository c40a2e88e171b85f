// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/bus/tcp_link.hpp"

#include <cerrno>
#include <utility>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include "device/bus/readable_wait.hpp"

namespace isograsp {

namespace asio = boost::asio;

struct TcpLink::Socket {
  asio::io_context io{1};
  asio::ip::tcp::socket tcp{io};
};

namespace {

/// Without an acknowledgement for so long the connection counts as closed [ms]: a computer that was
/// unplugged says nothing.
constexpr unsigned kUnacknowledged_ms = 5000;

template <class T>
void set_tcp(int descriptor, int option, const T& value) noexcept {
  static_cast<void>(setsockopt(descriptor, IPPROTO_TCP, option, &value, sizeof value));
}

}  // namespace

TcpLink::TcpLink() : socket_(std::make_unique<Socket>()) {}
TcpLink::~TcpLink() = default;

void TcpLink::connect(const Endpoint& server) noexcept {
  close();
  boost::system::error_code failure;
  if (socket_->tcp.open(asio::ip::tcp::v4(), failure) || socket_->tcp.non_blocking(true, failure))
    return;
  const int descriptor = socket_->tcp.native_handle();
  set_tcp(descriptor, TCP_NODELAY, 1);
  set_tcp(descriptor, TCP_USER_TIMEOUT, kUnacknowledged_ms);
  const asio::ip::tcp::endpoint peer(asio::ip::address_v4(server.address), server.port);
  if (::connect(descriptor, peer.data(), static_cast<socklen_t>(peer.size())) == 0)
    state_ = State::open;
  else if (errno == EINPROGRESS)
    state_ = State::connecting;
  else
    close();
}

TcpLink::State TcpLink::state() noexcept {
  if (state_ != State::connecting) return state_;
  pollfd polled{socket_->tcp.native_handle(), POLLOUT, 0};
  if (poll(&polled, 1, 0) != 1) return state_;
  int failure = 0;
  socklen_t size = sizeof failure;
  if (getsockopt(polled.fd, SOL_SOCKET, SO_ERROR, &failure, &size) != 0 || failure != 0)
    close();
  else
    state_ = State::open;
  return state_;
}

std::optional<std::size_t> TcpLink::receive(std::span<std::uint8_t> room) noexcept {
  if (state() != State::open) {
    if (state_ == State::connecting) return 0;
    return std::nullopt;
  }
  const auto n = ::recv(socket_->tcp.native_handle(), room.data(), room.size(), MSG_DONTWAIT);
  if (n > 0) return static_cast<std::size_t>(n);
  if (n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) return 0;
  close();
  return std::nullopt;
}

bool TcpLink::send(std::span<const std::uint8_t> bytes) noexcept {
  if (state() != State::open) return false;
  const auto n =
      ::send(socket_->tcp.native_handle(), bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
  if (n == static_cast<ssize_t>(bytes.size())) return true;
  close();  // a part of a command, or no room for one: nobody reads at the other end
  return false;
}

void TcpLink::wait(Timestamp span) noexcept {
  const int descriptor = state_ == State::closed ? -1 : socket_->tcp.native_handle();
  wait_for<1>({Awaited{descriptor, state_ == State::connecting}}, span);
}

void TcpLink::close() noexcept {
  boost::system::error_code ignored;
  socket_->tcp.close(ignored);
  state_ = State::closed;
}

}  // namespace isograsp
