// SPDX-License-Identifier: GPL-3.0-or-later
// SocketCAN through Boost.Asio: a raw socket with exact filters, error frames, drop counter and the
// kernel's arrival stamps (CLOCK_REALTIME, mapped to CLOCK_MONOTONIC).
#include "device/can_bus.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>
#include <optional>
#include <utility>

#include <boost/asio/basic_raw_socket.hpp>
#include <boost/asio/basic_waitable_timer.hpp>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/generic/raw_protocol.hpp>
#include <boost/asio/io_context.hpp>
#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

namespace isograsp {

namespace asio = boost::asio;

namespace {

constexpr int kReceiveBuffer = 1 << 20;  // 1 MiB: seconds of frames, not half of one
constexpr Timestamp kRetry = std::chrono::milliseconds(3);        // transmit queue full
constexpr Timestamp kReopen = std::chrono::milliseconds(250);     // adapter unplugged
constexpr Timestamp kRefresh = std::chrono::seconds(1);           // of the clock mapping
constexpr Timestamp kClockStep = std::chrono::microseconds(500);  // more than jitter: clock was set

/// Memory for the one pending wait: the handler's associated allocator, so that Asio never calls
/// operator new on the real-time path.
class WaitMemory {
 public:
  void* take(std::size_t size) {
    if (used_ || size > sizeof bytes_) throw std::bad_alloc();
    used_ = true;
    return bytes_;
  }
  void give_back() noexcept { used_ = false; }

 private:
  alignas(std::max_align_t) std::byte bytes_[512];
  bool used_ = false;
};

template <class T>
struct WaitAllocator {
  using value_type = T;
  WaitMemory* memory;

  explicit WaitAllocator(WaitMemory* m) noexcept : memory(m) {}
  template <class U>
  WaitAllocator(const WaitAllocator<U>& other) noexcept : memory(other.memory) {}  // NOLINT
  T* allocate(std::size_t n) { return static_cast<T*>(memory->take(n * sizeof(T))); }
  void deallocate(T*, std::size_t) noexcept { memory->give_back(); }
  template <class U>
  bool operator==(const WaitAllocator<U>& other) const noexcept {
    return memory == other.memory;
  }
};

/// Clears a flag when the wait is over, whatever ended it: the socket itself is asked next.
struct WaitOver {
  using allocator_type = WaitAllocator<std::byte>;
  bool* pending;
  WaitMemory* memory;
  [[nodiscard]] allocator_type get_allocator() const noexcept { return allocator_type(memory); }
  void operator()(const boost::system::error_code&) const noexcept { *pending = false; }
};

Timestamp read_clock(clockid_t id) noexcept {
  timespec t{};
  clock_gettime(id, &t);
  return std::chrono::seconds(t.tv_sec) + std::chrono::nanoseconds(t.tv_nsec);
}

/// CLOCK_REALTIME minus CLOCK_MONOTONIC, refreshed once per second and at once after a step of the
/// wall clock.
class ClockMap {
 public:
  [[nodiscard]] Timestamp to_steady(Timestamp wall) noexcept {
    const Timestamp now = read_clock(CLOCK_MONOTONIC);
    const Timestamp present = read_clock(CLOCK_REALTIME) - now;
    const bool stepped = present - offset_ > kClockStep || offset_ - present > kClockStep;
    if (!known_ || stepped || now - measured_ > kRefresh) measure();
    return std::min(wall - offset_, now);
  }

 private:
  /// The reading between two close readings of the other clock; the closest of five.
  void measure() noexcept {
    Timestamp best = Timestamp::max();
    for (int i = 0; i < 5; ++i) {
      const Timestamp before = read_clock(CLOCK_MONOTONIC);
      const Timestamp wall = read_clock(CLOCK_REALTIME);
      const Timestamp after = read_clock(CLOCK_MONOTONIC);
      if (after - before >= best) continue;
      best = after - before;
      offset_ = wall - before - best / 2;
      measured_ = after;
    }
    known_ = true;
  }

  Timestamp offset_{0};
  Timestamp measured_{0};
  bool known_ = false;
};

CanFrame from_kernel(const can_frame& in) noexcept {
  CanFrame frame;
  frame.extended = (in.can_id & CAN_EFF_FLAG) != 0;
  frame.remote = (in.can_id & CAN_RTR_FLAG) != 0;
  frame.error = (in.can_id & CAN_ERR_FLAG) != 0;
  frame.id = in.can_id & (frame.extended || frame.error ? CAN_EFF_MASK : CAN_SFF_MASK);
  frame.length = std::min<std::uint8_t>(in.len, CAN_MAX_DLEN);
  std::copy_n(in.data, frame.length, frame.data.begin());
  return frame;
}

can_frame to_kernel(const CanFrame& frame) noexcept {
  can_frame out{};
  out.can_id = frame.id | (frame.extended ? CAN_EFF_FLAG : 0U) |
               (frame.remote ? CAN_RTR_FLAG : 0U) | (frame.error ? CAN_ERR_FLAG : 0U);
  out.len = frame.length;
  std::copy_n(frame.data.begin(), frame.length, out.data);
  return out;
}

class SocketCan final : public CanBus {
 public:
  SocketCan(std::string interface, std::span<const std::uint32_t> ids)
      : interface_(std::move(interface)), ids_(ids.begin(), ids.end()) {}

  /// errno of the step that failed, or 0.
  int open() noexcept {
    boost::system::error_code failure;
    socket_.close(failure);
    io_.restart();
    while (io_.poll_one() > 0) {  // the wait on the old socket ends with "aborted"
    }
    const asio::generic::raw_protocol protocol(PF_CAN, CAN_RAW);
    if (socket_.open(protocol, failure)) return failure.value();

    const unsigned index = if_nametoindex(interface_.c_str());
    if (index == 0) return ENODEV;
    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = static_cast<int>(index);
    if (int e = set_options(); e != 0) return e;
    if (socket_.bind({&address, sizeof address, CAN_RAW}, failure)) return failure.value();
    if (socket_.non_blocking(true, failure)) return failure.value();
    gone_ = false;
    return 0;
  }

  Result<void> start(Clock& clock) override {
    if (clock.is_virtual())
      return Error{Error::Code::bad_input,
                   "a real bus does not run in virtual time",
                   "leave out --fast, or use sim:// or replay://",
                   "",
                   0,
                   interface_};
    clock_ = &clock;
    return {};
  }

  bool send(const CanFrame& frame) noexcept override {
    if (waiting_count_ == 0 && write_now(frame)) return true;
    if (waiting_count_ == waiting_.size()) return false;
    waiting_[(waiting_first_ + waiting_count_++) % waiting_.size()] = frame;
    if (waiting_count_ == 1) retry_at_ = clock_->now() + kRetry;
    return true;
  }

  BusEvent receive(Timestamp deadline, ReceivedFrame& out) noexcept override {
    while (true) {
      if (gone_ && clock_->now() >= reopen_at_) try_reopen();
      if (!gone_) {
        send_waiting();
        if (BusEvent event; read_now(event, out)) return event;
      }
      if (untold_) return *std::exchange(untold_, std::nullopt);
      if (clock_->now() >= deadline) return BusEvent::timeout;
      wait_until(deadline);
    }
  }

  std::uint64_t drops() const noexcept override { return drops_before_reopen_ + drops_; }

 private:
  using Socket =
      asio::basic_raw_socket<asio::generic::raw_protocol, asio::io_context::executor_type>;

  int set_options() noexcept {
    const int fd = socket_.native_handle();
    const int on = 1;
    // The mask keeps out extended and remote frames that carry the same number.
    constexpr canid_t kExact = CAN_SFF_MASK | CAN_EFF_FLAG | CAN_RTR_FLAG;
    std::vector<can_filter> filters;
    for (const auto id : ids_) filters.push_back({id, kExact});
    if (!filters.empty() &&
        setsockopt(fd, SOL_CAN_RAW, CAN_RAW_FILTER, filters.data(),
                   static_cast<socklen_t>(filters.size() * sizeof(can_filter))) != 0)
      return errno;
    const can_err_mask_t errors =
        CAN_ERR_TX_TIMEOUT | CAN_ERR_CRTL | CAN_ERR_BUSOFF | CAN_ERR_RESTARTED;
    if (setsockopt(fd, SOL_CAN_RAW, CAN_RAW_ERR_FILTER, &errors, sizeof errors) != 0) return errno;
    if (setsockopt(fd, SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof on) != 0) return errno;
    if (setsockopt(fd, SOL_SOCKET, SO_RXQ_OVFL, &on, sizeof on) != 0) return errno;
    // The larger buffer needs a privilege or a raised net.core.rmem_max; as much as allowed is
    // fine.
    if (setsockopt(fd, SOL_SOCKET, SO_RCVBUFFORCE, &kReceiveBuffer, sizeof kReceiveBuffer) != 0)
      (void)setsockopt(fd, SOL_SOCKET, SO_RCVBUF, &kReceiveBuffer, sizeof kReceiveBuffer);
    return 0;
  }

  /// False if the frame should be tried again later.
  bool write_now(const CanFrame& frame) noexcept {
    if (gone_) return true;
    const can_frame out = to_kernel(frame);
    if (::send(socket_.native_handle(), &out, sizeof out, 0) == sizeof out) return true;
    // A full transmit queue is no matter of writability: poll says writable all the time.
    if (errno == ENOBUFS || errno == EAGAIN) return false;
    // The kernel tells once that the interface is gone or down, and it may tell the sender.
    note_failure(errno);
    return true;
  }

  void note_failure(int failure) noexcept {
    if (failure == ENETDOWN) {  // the same socket works again when the interface is up
      untold_ = BusEvent::interface_down;
    } else if (failure == ENODEV || failure == ENXIO || failure == EBADF) {
      gone_ = true;
      reopen_at_ = clock_->now() + kReopen;
      untold_ = BusEvent::interface_gone;
    }
  }

  void send_waiting() noexcept {
    if (waiting_count_ == 0 || clock_->now() < retry_at_) return;
    while (waiting_count_ > 0 && write_now(waiting_[waiting_first_])) {
      waiting_first_ = (waiting_first_ + 1) % waiting_.size();
      --waiting_count_;
    }
    retry_at_ = clock_->now() + kRetry;
  }

  /// Takes what the socket has; false if that is nothing.
  bool read_now(BusEvent& event, ReceivedFrame& out) noexcept {
    can_frame in{};
    iovec part{&in, sizeof in};
    alignas(cmsghdr) char control[128];
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = control;
    message.msg_controllen = sizeof control;
    const auto n = recvmsg(socket_.native_handle(), &message, MSG_DONTWAIT);
    if (n < 0) {
      note_failure(errno);
      return false;
    }
    if (n != sizeof in) return false;
    read_control(message, out);
    out.frame = from_kernel(in);
    event = out.frame.error && (out.frame.id & CAN_ERR_BUSOFF) != 0 ? BusEvent::bus_off
                                                                    : BusEvent::frame;
    return true;
  }

  void read_control(msghdr& message, ReceivedFrame& out) noexcept {
    out.wall_time = Timestamp{0};
    for (cmsghdr* c = CMSG_FIRSTHDR(&message); c != nullptr; c = CMSG_NXTHDR(&message, c)) {
      if (c->cmsg_level != SOL_SOCKET) continue;
      if (c->cmsg_type == SO_TIMESTAMPNS) {
        timespec t{};
        std::memcpy(&t, CMSG_DATA(c), sizeof t);
        out.wall_time = std::chrono::seconds(t.tv_sec) + std::chrono::nanoseconds(t.tv_nsec);
      } else if (c->cmsg_type == SO_RXQ_OVFL) {
        std::uint32_t dropped = 0;
        std::memcpy(&dropped, CMSG_DATA(c), sizeof dropped);
        drops_ = dropped;
      }
    }
    if (out.wall_time == Timestamp{0}) out.wall_time = read_clock(CLOCK_REALTIME);
    out.stamp = clock_map_.to_steady(out.wall_time);
  }

  void try_reopen() noexcept {
    reopen_at_ = clock_->now() + kReopen;
    try {
      drops_before_reopen_ += drops_;
      drops_ = 0;
      gone_ = open() != 0;
    } catch (const std::exception&) {
      gone_ = true;
    }
  }

  void wait_until(Timestamp deadline) noexcept {
    if (gone_) {
      clock_->wait_until(std::min(deadline, reopen_at_));
      return;
    }
    if (waiting_count_ > 0) deadline = std::min(deadline, retry_at_);
    try {
      if (!wait_pending_) {
        wait_pending_ = true;
        socket_.async_wait(Socket::wait_read, WaitOver{&wait_pending_, &memory_});
      }
      // steady_clock is CLOCK_MONOTONIC, as is the clock of Timestamp.
      io_.run_one_until(std::chrono::steady_clock::time_point(deadline));
    } catch (const std::exception&) {  // the descriptor is no more
      gone_ = true;
      reopen_at_ = clock_->now() + kReopen;
    }
  }

  std::string interface_;
  std::vector<std::uint32_t> ids_;
  Clock* clock_ = nullptr;
  ClockMap clock_map_;

  WaitMemory memory_;
  bool wait_pending_ = false;
  asio::io_context io_{1};
  asio::executor_work_guard<asio::io_context::executor_type> work_{io_.get_executor()};
  Socket socket_{io_};

  std::array<CanFrame, 32> waiting_{};  ///< frames that found the transmit queue full
  std::size_t waiting_first_ = 0;
  std::size_t waiting_count_ = 0;
  Timestamp retry_at_{0};
  std::optional<BusEvent> untold_;  ///< a failure that receive() still has to report
  bool gone_ = false;
  Timestamp reopen_at_{0};
  std::uint64_t drops_ = 0;
  std::uint64_t drops_before_reopen_ = 0;
};

Error interface_error(Error::Code code, const std::string& interface, std::string what,
                      std::string remedy) {
  return {code, std::move(what), std::move(remedy), "", 0, interface};
}

bool is_up(const std::string& interface) {
  const int fd = ::socket(AF_UNIX, SOCK_DGRAM, 0);
  if (fd < 0) return false;
  ifreq request{};
  interface.copy(request.ifr_name, IFNAMSIZ - 1);
  const bool up = ioctl(fd, SIOCGIFFLAGS, &request) == 0 && (request.ifr_flags & IFF_UP) != 0;
  ::close(fd);
  return up;
}

std::string names_of(const std::vector<CanInterface>& interfaces) {
  std::string names;
  for (const auto& i : interfaces) names += (names.empty() ? "" : ", ") + i.name;
  return names;
}

}  // namespace

std::vector<CanInterface> list_can_interfaces() {
  std::vector<CanInterface> found;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator("/sys/class/net", ignored)) {
    int type = 0;
    std::ifstream(entry.path() / "type") >> type;
    const auto name = entry.path().filename().string();
    if (type == ARPHRD_CAN) found.push_back({name, is_up(name)});
  }
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  return found;
}

Result<std::unique_ptr<CanBus>> open_socketcan(const std::string& interface,
                                               std::span<const std::uint32_t> ids) {
  using Code = Error::Code;
  const auto present = list_can_interfaces();
  const auto found = std::find_if(present.begin(), present.end(),
                                  [&](const auto& i) { return i.name == interface; });
  if (found == present.end())
    return interface_error(Code::bad_input, interface, "there is no such CAN interface",
                           present.empty() ? "plug in the CAN adapter and load its driver"
                                           : "use one of those present: " + names_of(present));
  if (!found->up)
    return interface_error(
        Code::failed, interface, "the CAN interface is switched off",
        "run: sudo ip link set " + interface + " up type can bitrate 1000000 restart-ms 100");
  try {
    auto bus = std::make_unique<SocketCan>(interface, ids);
    if (const int e = bus->open(); e != 0)
      return interface_error(Code::failed, interface,
                             std::string("the CAN interface cannot be opened: ") + strerror(e),
                             "check that the kernel modules can and can_raw are loaded");
    return std::unique_ptr<CanBus>(std::move(bus));
  } catch (const std::exception& problem) {
    return interface_error(Code::failed, interface,
                           std::string("the CAN interface cannot be opened: ") + problem.what(),
                           "close other programs and try again");
  }
}

}  // namespace isograsp
