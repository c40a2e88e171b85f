// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/bus/udp_port.hpp"

#include <cerrno>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/multicast.hpp>
#include <boost/asio/ip/udp.hpp>
#include <sys/socket.h>

#include "device/bus/readable_wait.hpp"

namespace isograsp {

namespace asio = boost::asio;

struct UdpPort::Socket {
  asio::io_context io{1};
  asio::ip::udp::socket udp{io};
};

namespace {

constexpr int kBuffer = 1 << 20;  // 1 MiB: seconds of frames

}  // namespace

UdpPort::UdpPort() : socket_(std::make_unique<Socket>()) {}
UdpPort::~UdpPort() = default;

Result<void> UdpPort::open(const Endpoint& local, bool shared) {
  close();
  auto& udp = socket_->udp;
  boost::system::error_code failure;
  const asio::ip::udp::endpoint at(asio::ip::address_v4(local.address), local.port);
  if (udp.open(asio::ip::udp::v4(), failure) ||
      (shared && udp.set_option(asio::socket_base::reuse_address(true), failure)) ||
      udp.non_blocking(true, failure) || udp.bind(at, failure)) {
    close();
    return failed("this port cannot be heard: %1"_text(Known{failure.message()}),
                  "end the program that has it, or give another address"_text)
        .about(local.text());
  }
  // The larger buffer needs a privilege or a raised net.core.rmem_max; as much as allowed is fine.
  if (setsockopt(udp.native_handle(), SOL_SOCKET, SO_RCVBUFFORCE, &kBuffer, sizeof kBuffer) != 0)
    udp.set_option(asio::socket_base::receive_buffer_size(kBuffer), failure);
  return {};
}

Result<void> UdpPort::join(std::uint32_t group, std::uint32_t local) {
  boost::system::error_code failure;
  socket_->udp.set_option(
      asio::ip::multicast::join_group(asio::ip::address_v4(group), asio::ip::address_v4(local)),
      failure);
  if (failure)
    return failed("the multicast group cannot be joined: %1"_text(Known{failure.message()}),
                  "give the address of this computer in the network of the cameras as local="_text)
        .about(Endpoint{group, 0}.address_text());
  return {};
}

void UdpPort::send_groups_through(std::uint32_t local) noexcept {
  boost::system::error_code ignored;
  socket_->udp.set_option(asio::ip::multicast::outbound_interface(asio::ip::address_v4(local)),
                          ignored);
  socket_->udp.set_option(asio::ip::multicast::enable_loopback(true), ignored);
}

bool UdpPort::is_open() const noexcept {
  return socket_->udp.is_open();
}

Endpoint UdpPort::local() const noexcept {
  boost::system::error_code failure;
  const auto at = socket_->udp.local_endpoint(failure);
  if (failure) return {};
  return {at.address().to_v4().to_uint(), at.port()};
}

bool UdpPort::send(const Endpoint& to, std::span<const std::uint8_t> bytes) noexcept {
  const asio::ip::udp::endpoint peer(asio::ip::address_v4(to.address), to.port);
  const auto send_once = [&] {
    return ::sendto(descriptor(), bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL,
                    peer.data(), static_cast<socklen_t>(peer.size())) >= 0;
  };
  // The kernel tells the failure of an earlier datagram to the next call, and does not send this
  // one then.
  return send_once() || (errno == ECONNREFUSED && send_once());
}

std::optional<std::size_t> UdpPort::receive(std::span<std::uint8_t> room, Endpoint& from) noexcept {
  asio::ip::udp::endpoint peer;
  constexpr int kMostErrors = 8;  // of earlier datagrams, one told by each call
  for (int attempt = 0; attempt < kMostErrors; ++attempt) {
    auto size = static_cast<socklen_t>(peer.capacity());
    const auto n = ::recvfrom(descriptor(), room.data(), room.size(), MSG_DONTWAIT | MSG_TRUNC,
                              peer.data(), &size);
    if (n >= 0) {
      from = {peer.address().to_v4().to_uint(), peer.port()};
      return static_cast<std::size_t>(n);
    }
    if (errno != ECONNREFUSED && errno != EHOSTUNREACH) return std::nullopt;
  }
  return std::nullopt;
}

void UdpPort::close() noexcept {
  boost::system::error_code ignored;
  socket_->udp.close(ignored);
}

int UdpPort::descriptor() const noexcept {
  return socket_->udp.is_open() ? socket_->udp.native_handle() : -1;
}

void UdpPort::wait(const UdpPort& one, const UdpPort& other, Timestamp span) noexcept {
  wait_for<2>({Awaited{one.descriptor()}, Awaited{other.descriptor()}}, span);
}

}  // namespace isograsp
