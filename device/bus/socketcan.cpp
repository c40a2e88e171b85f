// SPDX-License-Identifier: GPL-3.0-or-later
// SocketCAN: the rules for a bus that is full, down, off or unplugged (docs/devices.md). Waits
// through Boost.Asio.
#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <utility>

#include <boost/asio/basic_raw_socket.hpp>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/generic/raw_protocol.hpp>
#include <boost/asio/io_context.hpp>
#include <linux/can.h>

#include "device/bus/bus.hpp"
#include "device/bus/can_error.hpp"
#include "device/bus/can_interfaces.hpp"
#include "device/bus/can_socket.hpp"
#include "device/bus/kernel_bus.hpp"
#include "device/bus/ready_wait.hpp"

namespace isograsp {

namespace asio = boost::asio;

namespace {

constexpr Timestamp kLookAtInterface =
    std::chrono::milliseconds(100);  // interface switched off or unplugged

class SocketCan final : public KernelBus {
 public:
  SocketCan(std::string interface, std::span<const std::uint32_t> ids)
      : interface_(std::move(interface)), ids_(ids.begin(), ids.end()) {}

  /// errno of the step that failed, or 0.
  int open() {
    boost::system::error_code ignored;
    socket_.close(ignored);
    while (io_.poll_one() > 0) {  // the wait on the old socket ends with "aborted"
    }
    const CanSocket opened = open_can_socket(interface_, ids_);
    if (opened.failure != 0) return opened.failure;
    socket_.assign(asio::generic::raw_protocol(PF_CAN, CAN_RAW), opened.descriptor);
    gone_ = down_ = false;
    drops_told_ = 0;
    off_ = is_off_the_bus(interface_);  // the error frame was sent before this socket was open
    if (off_) tell(BusEvent::bus_off);
    return 0;
  }

  BusEvent receive(Timestamp deadline, ReceivedFrame& out) noexcept override {
    while (true) {
      if (!works() && clock_->now() >= look_at_) look_again();
      send_waiting(clock_->now());
      // Told before the frames that arrived after the restart. Frames from before the loss have
      // been read already, when the loss was told.
      if (untold_ == bit(BusEvent::restarted)) return next_untold(out);
      BusEvent event;
      // The wire cannot bring frames as fast as they are read here, so this ends.
      while (true) {
        const Read read = read_one(event, out);
        if (read == Read::event) return event;
        if (read == Read::nothing) break;
      }
      if (untold_ != 0) return next_untold(out);
      if (clock_->now() >= deadline) return BusEvent::timeout;
      wait_until(deadline);
    }
  }

 private:
  using Socket =
      asio::basic_raw_socket<asio::generic::raw_protocol, asio::io_context::executor_type>;
  enum class Read : std::uint8_t { event, no_news, nothing };

  [[nodiscard]] bool works() const noexcept { return !gone_ && !down_; }
  static constexpr unsigned bit(BusEvent event) noexcept {
    return 1U << static_cast<unsigned>(event);
  }
  void tell(BusEvent event) noexcept { untold_ |= bit(event); }
  [[nodiscard]] bool is_untold(BusEvent event) const noexcept {
    return (untold_ & bit(event)) != 0;
  }
  /// In the order in which they can have happened, so that the last one stays true.
  BusEvent next_untold(ReceivedFrame& out) noexcept {
    constexpr unsigned kLast = bit(BusEvent::restarted);
    const unsigned first = untold_ == kLast ? untold_ : untold_ & ~kLast;
    const auto event = static_cast<BusEvent>(std::countr_zero(first));
    untold_ &= ~bit(event);
    out.frame = {};
    return event;
  }

  [[nodiscard]] std::string name() const override { return interface_; }
  [[nodiscard]] bool write(const BusFrame& frame) noexcept override {
    if (gone_) {
      ++counters_.unsent;
      return true;
    }
    const int failure = write_can_socket(socket_.native_handle(), frame);
    // poll() cannot wait for room: it reports a full transmit queue as writable, too.
    if (failure == ENOBUFS || failure == EAGAIN) return false;
    if (failure == 0) {
      if (down_) note_up();
      if (off_) ++counters_.unsent;  // the kernel accepts frames that it cannot send
    } else {
      ++counters_.unsent;
      note_failure(failure);
    }
    return true;
  }

  Read read_one(BusEvent& event, ReceivedFrame& out) noexcept {
    if (!socket_.is_open()) return Read::nothing;
    CanReading in;
    if (const int failure = read_can_socket(socket_.native_handle(), in); failure != 0) {
      // The kernel tells a failure once. Frames that arrived before it can still be read, so they
      // come first.
      return note_failure(failure) ? Read::no_news : Read::nothing;
    }
    if (in.notes.dropped) {
      counters_.kernel_drops += *in.notes.dropped - drops_told_;  // modulo 2^32
      drops_told_ = *in.notes.dropped;
    }
    out.frame = in.frame;
    out.wall_time = in.notes.wall_time;
    out.stamp = clock_map_.to_steady(out.wall_time);
    if (in.frame.error) return read_error(event, in.frame);
    if (down_ && !is_untold(BusEvent::interface_down)) note_up();
    if (!in.from_this_computer) off_ = false;
    event = BusEvent::frame;
    return Read::event;
  }

  Read read_error(BusEvent& event, const BusFrame& frame) noexcept {
    ++counters_.error_frames;
    const CanErrorNews news = read_can_error(frame);
    if (news.overflow) ++counters_.overflows;
    if (news.state) {
      event = *news.state;
      if (event == BusEvent::bus_off) off_ = true;
      if (event == BusEvent::restarted) off_ = false;
      if (news.overflow) tell(BusEvent::overflow);
      return Read::event;
    }
    event = BusEvent::overflow;
    return news.overflow ? Read::event : Read::no_news;
  }

  /// The kernel tells once that the interface is down or gone, to the reader or to the sender.
  /// False if that is known, or if it is another failure.
  bool note_failure(int failure) noexcept {
    if (failure == ENETDOWN) {  // the same socket works again when the interface is up
      if (down_) return false;
      down_ = true;
      note_loss(BusEvent::interface_down);
    } else if (!gone_ && (failure == ENODEV || failure == ENXIO)) {
      gone_ = true;
      note_loss(BusEvent::interface_gone);
    } else {
      return false;
    }
    return true;
  }

  void note_loss(BusEvent event) noexcept {
    off_ = false;
    waiting_.give_up_all();
    look_at_ = clock_->now() + kLookAtInterface;
    untold_ &= ~bit(BusEvent::restarted);
    tell(event);
  }
  void note_up() noexcept {
    down_ = false;
    tell(BusEvent::restarted);
  }

  void look_again() noexcept {
    look_at_ = clock_->now() + kLookAtInterface;
    if (!is_switched_on(interface_)) return;
    if (!gone_) return note_up();
    try {
      if (open() == 0 && !off_) note_up();
    } catch (const std::exception&) {  // tried again next time
    }
  }

  void wait_until(Timestamp deadline) noexcept {
    if (!works()) deadline = std::min(deadline, look_at_);
    if (gone_) return clock_->wait_until(deadline);
    deadline = sooner(deadline);
    try {
      if (!wait_pending_) {
        wait_pending_ = true;
        socket_.async_wait(Socket::wait_read, WaitOver{&wait_pending_, &wait_memory_});
      }
      // steady_clock is CLOCK_MONOTONIC, as is the clock of Timestamp.
      io_.run_one_until(std::chrono::steady_clock::time_point(deadline));
    } catch (const std::exception&) {  // the descriptor is closed
      gone_ = true;
      note_loss(BusEvent::interface_gone);
    }
  }

  std::string interface_;
  std::vector<std::uint32_t> ids_;
  ClockMap clock_map_;

  WaitMemory wait_memory_;
  bool wait_pending_ = false;
  asio::io_context io_{1};
  asio::executor_work_guard<asio::io_context::executor_type> work_{io_.get_executor()};
  Socket socket_{io_};

  std::uint32_t drops_told_ = 0;  ///< by the present socket
  unsigned untold_ = 0;           ///< events that receive() still has to report, a bit each
  bool off_ = false;              ///< bus-off, as far as error frames tell
  bool down_ = false;
  bool gone_ = false;
  Timestamp look_at_{0};  ///< when to look whether the interface is back
};

std::string names_of(const std::vector<CanInterface>& interfaces) {
  std::string names;
  for (const auto& i : interfaces) names += (names.empty() ? "" : ", ") + i.name;
  return names;
}

}  // namespace

Result<std::unique_ptr<Bus>> open_socketcan(const std::string& interface,
                                            std::span<const std::uint32_t> ids) {
  const auto present = list_can_interfaces();
  const auto found = std::find_if(present.begin(), present.end(),
                                  [&](const auto& i) { return i.name == interface; });
  if (found == present.end())
    return refused("there is no such CAN interface"_text,
                   present.empty() ? "plug in the CAN adapter and load its driver"_text
                                   : "use one of those present: %1"_text(names_of(present)))
        .about(interface);
  if (!found->up)
    return failed("the CAN interface is switched off"_text,
                  "run: sudo ip link set %1 up type can bitrate 1000000 restart-ms 100"_text(
                      interface))
        .about(interface);
  const auto not_opened = [&](const Text& why, Text remedy) {
    return failed("the CAN interface cannot be opened: %1"_text(why), std::move(remedy))
        .about(interface);
  };
  try {
    auto bus = std::make_unique<SocketCan>(interface, ids);
    if (const int failure = bus->open(); failure != 0)
      return not_opened(Known{std::strerror(failure)},
                        "check that the kernel modules can and can_raw are loaded"_text);
    return std::unique_ptr<Bus>(std::move(bus));
  } catch (const std::exception& problem) {
    return not_opened(Known{problem.what()}, "close other programs and try again"_text);
  }
}

}  // namespace isograsp
