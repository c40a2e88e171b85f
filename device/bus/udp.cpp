// SPDX-License-Identifier: GPL-3.0-or-later
// Datagrams through Boost.Asio: one connected UDP socket per sensor, with the kernel's arrival
// stamps and drop counter. Whatever has arrived is handed out at once and in the order of its
// arrival, so no backlog makes values old.
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <exception>
#include <string>
#include <utility>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>
#include <sys/socket.h>

#include "device/bus/bus.hpp"
#include "device/bus/endpoint.hpp"
#include "device/bus/kernel_bus.hpp"
#include "device/bus/kernel_stamp.hpp"
#include "device/bus/ready_wait.hpp"

namespace isograsp {

namespace asio = boost::asio;

namespace {

constexpr int kDatagramBuffer = 1 << 20;  // 1 MiB: a second of datagrams at 1000 Hz
constexpr Timestamp kReconnect = std::chrono::milliseconds(250);  // the network is gone
constexpr int kMostErrors = 8;                                    // that wait in a socket
constexpr std::size_t kLongestFrame = 255;                        // longest that BusFrame can tell

/// The way to the sensor is gone: a cable, an adapter or an address of this computer.
bool is_network_failure(int failure) noexcept {
  return failure == ENETDOWN || failure == ENETUNREACH || failure == EADDRNOTAVAIL ||
         failure == ENODEV || failure == EINVAL;
}

template <class T>
bool set(int descriptor, int option, const T& value) noexcept {
  return setsockopt(descriptor, SOL_SOCKET, option, &value, sizeof value) == 0;
}

/// Of one sensor; outlives the io_context.
struct DatagramWait {
  WaitMemory memory;
  bool pending = false;
};

/// The socket of one sensor.
class Channel {
 public:
  using Socket = asio::basic_datagram_socket<asio::ip::udp, asio::io_context::executor_type>;

  Channel(asio::io_context& io, DatagramWait& wait) : wait_(wait), socket_(io) {}

  /// errno of the step that failed, or 0.
  int open(const Endpoint& peer) noexcept {
    peer_ = asio::ip::udp::endpoint(asio::ip::address_v4(peer.address), peer.port);
    boost::system::error_code failure;
    if (socket_.open(asio::ip::udp::v4(), failure)) return failure.value();
    const int descriptor = socket_.native_handle();
    if (!set(descriptor, SO_TIMESTAMPNS, 1) || !set(descriptor, SO_RXQ_OVFL, 1)) return errno;
    // The larger buffer needs a privilege or a raised net.core.rmem_max; as much as allowed is
    // fine.
    if (!set(descriptor, SO_RCVBUFFORCE, kDatagramBuffer))
      (void)set(descriptor, SO_RCVBUF, kDatagramBuffer);
    if (socket_.non_blocking(true, failure)) return failure.value();
    return connect();
  }
  /// Connects again, with the present address of this computer. Its port may be another one after
  /// that, so the sensor has to be started again.
  int connect() noexcept {
    sockaddr none{};
    none.sa_family = AF_UNSPEC;
    (void)::connect(socket_.native_handle(), &none, sizeof none);
    if (::connect(socket_.native_handle(), peer_.data(), static_cast<socklen_t>(peer_.size())) != 0)
      return errno;
    return 0;
  }
  /// 0, or errno.
  int send(const BusFrame& frame) noexcept {
    const auto bytes = frame.bytes();
    for (int attempt = 0;; ++attempt) {
      const auto n = ::send(socket_.native_handle(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (n >= 0) return 0;
      // The kernel tells the failure of an earlier datagram to the next call, and does not send
      // this one then: send it again.
      if (errno != ECONNREFUSED || attempt > 0) return errno;
    }
  }
  /// 0, or errno (EAGAIN: nothing).
  int receive(ReceivedFrame& out, std::uint64_t& dropped) noexcept {
    iovec part{out.frame.data.data(), out.frame.data.size()};
    KernelNotesRoom room{};
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = room.bytes;
    message.msg_controllen = sizeof room.bytes;
    // MSG_TRUNC: the true length, also of a datagram that does not fit.
    const auto n = ::recvmsg(socket_.native_handle(), &message, MSG_DONTWAIT | MSG_TRUNC);
    if (n < 0) return errno;
    const KernelNotes notes = read_kernel_notes(message);
    if (notes.dropped) {
      dropped += *notes.dropped - drops_told_;  // modulo 2^32
      drops_told_ = *notes.dropped;
    }
    out.wall_time = notes.wall_time;
    out.frame.length = static_cast<std::uint8_t>(
        std::min<std::size_t>(static_cast<std::size_t>(n), kLongestFrame));
    return 0;
  }
  void begin_wait() {
    if (wait_.pending) return;
    wait_.pending = true;
    socket_.async_wait(Socket::wait_read, WaitOver{&wait_.pending, &wait_.memory});
  }

 private:
  DatagramWait& wait_;
  Socket socket_;
  asio::ip::udp::endpoint peer_;
  std::uint32_t drops_told_ = 0;
};

class Udp final : public KernelBus {
 public:
  /// errno of the step that failed, or 0.
  int open(std::size_t sensor, const Endpoint& peer) noexcept {
    return channels_[sensor].open(peer);
  }

  BusEvent receive(Timestamp deadline, ReceivedFrame& out) noexcept override {
    while (true) {
      keep_sending();
      if (read_one(out)) return BusEvent::frame;
      if (std::exchange(untold_, false)) {
        out.frame = {};
        return BusEvent::interface_down;
      }
      if (clock_->now() >= deadline) return BusEvent::timeout;
      wait_until(deadline);
    }
  }

 private:
  [[nodiscard]] std::string name() const override { return ""; }
  [[nodiscard]] bool write(const BusFrame& frame) noexcept override {
    const bool known = frame.id < kFingerCount && frame.length <= frame.data.size();
    const int failure = known ? channels_[frame.id].send(frame) : EDESTADDRREQ;
    if (failure == EAGAIN || failure == ENOBUFS) return false;
    if (failure == 0) {
      down_[frame.id] = false;
      return true;
    }
    ++counters_.unsent;
    if (known) note_failure(frame.id, failure);
    return true;
  }

  /// A sensor that is not there (ECONNREFUSED, EHOSTUNREACH) is found by its silence, like one that
  /// was unplugged. The bus itself reports only that the way to the sensor has failed.
  void note_failure(std::size_t sensor, int failure) noexcept {
    ++counters_.error_frames;
    if (!is_network_failure(failure)) return;
    if (!is_down()) {
      untold_ = true;
      reconnect_at_ = clock_->now() + kReconnect;
    }
    down_[sensor] = true;
  }
  [[nodiscard]] bool is_down() const noexcept { return down_[0] || down_[1] || down_[2]; }

  void keep_sending() noexcept {
    if (waiting_.empty() && !is_down()) return;
    const Timestamp now = clock_->now();
    send_waiting(now);
    if (is_down() && now >= reconnect_at_) {
      for (std::size_t f = 0; f < kFingerCount; ++f)
        if (down_[f]) (void)channels_[f].connect();
      reconnect_at_ = now + kReconnect;
    }
  }

  /// False if no socket has anything. The sensors take turns.
  bool read_one(ReceivedFrame& out) noexcept {
    for (std::size_t i = 0; i < kFingerCount; ++i) {
      const std::size_t sensor = (next_ + i) % kFingerCount;
      out.frame = {};
      int failure = channels_[sensor].receive(out, counters_.kernel_drops);
      // Failures of earlier datagrams are told first, one by each call.
      for (int told = 0; failure != 0 && failure != EAGAIN && told < kMostErrors; ++told) {
        note_failure(sensor, failure);
        failure = channels_[sensor].receive(out, counters_.kernel_drops);
      }
      if (failure != 0) continue;
      down_[sensor] = false;
      out.frame.id = static_cast<std::uint32_t>(sensor);
      out.stamp = clock_map_.to_steady(out.wall_time);
      next_ = sensor + 1;
      return true;
    }
    return false;
  }

  void wait_until(Timestamp deadline) noexcept {
    deadline = sooner(deadline);
    if (is_down()) deadline = std::min(deadline, reconnect_at_);
    try {
      for (auto& channel : channels_) channel.begin_wait();
      // steady_clock is CLOCK_MONOTONIC, as is the clock of Timestamp.
      io_.run_one_until(std::chrono::steady_clock::time_point(deadline));
    } catch (const std::exception&) {  // no wait is possible: at least never spin
      clock_->wait_until(std::min(deadline, clock_->now() + kRetry));
    }
  }

  ClockMap clock_map_;
  std::array<DatagramWait, kFingerCount> waits_;
  asio::io_context io_{1};
  asio::executor_work_guard<asio::io_context::executor_type> work_{io_.get_executor()};
  std::array<Channel, kFingerCount> channels_{Channel(io_, waits_[0]), Channel(io_, waits_[1]),
                                              Channel(io_, waits_[2])};
  std::size_t next_ = 0;
  std::array<bool, kFingerCount> down_{};  ///< there is no way to this sensor now
  bool untold_ = false;                    ///< interface_down has to be reported
  Timestamp reconnect_at_{0};
};

}  // namespace

Result<std::unique_ptr<Bus>> open_udp(const std::array<std::string, kFingerCount>& addresses) {
  auto bus = std::make_unique<Udp>();
  std::array<Endpoint, kFingerCount> peers;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const auto peer = parse_endpoint(addresses[f]);
    if (!peer)
      return refused("this is no address in numbers with a port"_text,
                     "write it as 192.168.1.1:49152"_text)
          .about(addresses[f]);
    if (std::find(peers.begin(), peers.begin() + static_cast<std::ptrdiff_t>(f), *peer) !=
        peers.begin() + static_cast<std::ptrdiff_t>(f))
      return refused("two sensors have this address"_text, "give every sensor its own"_text)
          .about(addresses[f]);
    peers[f] = *peer;
    if (const int failure = bus->open(f, *peer); failure != 0)
      return failed(
                 "there is no way to this address: %1"_text(Known{std::strerror(failure)}),
                 "plug in the network cable and give this computer an address in the same network"_text)
          .about(addresses[f]);
  }
  return std::unique_ptr<Bus>(std::move(bus));
}

}  // namespace isograsp
