// SPDX-License-Identifier: GPL-3.0-or-later
// Serial lines through Boost.Asio: one port per sensor, 8N1, raw. A frame is a piece of the stream,
// stamped when it was read.
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <exception>
#include <string>
#include <utility>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/basic_stream_descriptor.hpp>
#include <boost/asio/serial_port.hpp>
#include <linux/serial.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include "device/bus/bus.hpp"
#include "device/bus/kernel_bus.hpp"
#include "device/bus/kernel_stamp.hpp"
#include "device/bus/ready_wait.hpp"

namespace isograsp {

namespace asio = boost::asio;

namespace {

constexpr std::size_t kPiece = 16;  // bytes: none completes two packets of 19
constexpr Timestamp kReopen = std::chrono::milliseconds(250);  // adapter unplugged

/// Of one port; outlives the io_context.
struct PortWait {
  WaitMemory memory;
  bool pending = false;
};

/// The port of one sensor.
class Port {
 public:
  Port(asio::io_context& io, PortWait& wait) : io_(io), wait_(wait), descriptor_(io) {}

  void set(std::string name, unsigned baud) {
    name_ = std::move(name);
    baud_ = baud;
  }
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] bool is_open() const noexcept { return descriptor_.is_open(); }

  /// What failed, or no error.
  boost::system::error_code open() {
    using asio::serial_port;
    boost::system::error_code failure;
    serial_port port(io_);
    if (port.open(name_, failure)) return failure;
    if (port.set_option(serial_port::baud_rate(baud_), failure)) return failure;
    if (port.set_option(serial_port::character_size(8), failure)) return failure;
    if (port.set_option(serial_port::parity(serial_port::parity::none), failure)) return failure;
    if (port.set_option(serial_port::stop_bits(serial_port::stop_bits::one), failure))
      return failure;
    if (port.set_option(serial_port::flow_control(serial_port::flow_control::none), failure))
      return failure;
    // Asio's serial port cannot be waited for without reading; a descriptor can.
    const int own = ::dup(port.native_handle());
    if (own < 0) return {errno, boost::system::system_category()};
    if (descriptor_.assign(own, failure)) {
      ::close(own);
      return failure;
    }
    descriptor_.non_blocking(true, failure);
    prefer_prompt_bytes(own);
    ::tcflush(own, TCIOFLUSH);  // bytes from before are too old
    return failure;
  }
  void close() noexcept {
    boost::system::error_code ignored;
    descriptor_.close(ignored);
  }
  /// 0, or errno.
  int write(const BusFrame& frame) noexcept {
    const auto bytes = frame.bytes();
    if (!is_open()) return ENODEV;
    const auto n = ::write(descriptor_.native_handle(), bytes.data(), bytes.size());
    if (n < 0) return errno;
    // A command that was sent in part is a failure: the conversation asks again.
    return static_cast<std::size_t>(n) == bytes.size() ? 0 : EIO;
  }
  /// 0, or errno (EAGAIN: nothing).
  int read(BusFrame& frame) noexcept {
    const auto n = ::read(descriptor_.native_handle(), frame.data.data(), kPiece);
    if (n < 0) return errno;
    if (n == 0) return ENODEV;  // hung up
    frame.length = static_cast<std::uint8_t>(n);
    return 0;
  }
  void begin_wait() {
    if (wait_.pending || !is_open()) return;
    wait_.pending = true;
    descriptor_.async_wait(Descriptor::wait_read, WaitOver{&wait_.pending, &wait_.memory});
  }

 private:
  using Descriptor = asio::posix::basic_stream_descriptor<asio::io_context::executor_type>;

  /// Drivers of USB adapters collect bytes for 16 ms unless this is switched off. Not every driver
  /// allows it.
  static void prefer_prompt_bytes(int descriptor) noexcept {
    (void)::ioctl(descriptor, TIOCEXCL);
    serial_struct settings{};
    if (::ioctl(descriptor, TIOCGSERIAL, &settings) != 0) return;
    settings.flags |= ASYNC_LOW_LATENCY;
    (void)::ioctl(descriptor, TIOCSSERIAL, &settings);
  }

  asio::io_context& io_;
  std::string name_;
  unsigned baud_ = 115200;
  PortWait& wait_;
  Descriptor descriptor_;
};

class Serial final : public KernelBus {
 public:
  [[nodiscard]] Port& port(std::size_t sensor) noexcept { return ports_[sensor]; }

  BusEvent receive(Timestamp deadline, ReceivedFrame& out) noexcept override {
    while (true) {
      const Timestamp now = clock_->now();
      if (now >= reopen_at_) reopen(now);
      send_waiting(now);
      if (read_one(out)) return BusEvent::frame;
      if (std::exchange(untold_, false)) {
        out.frame = {};
        return BusEvent::interface_gone;
      }
      if (clock_->now() >= deadline) return BusEvent::timeout;
      wait_until(deadline);
    }
  }

 private:
  [[nodiscard]] std::string name() const override { return ports_[0].name(); }
  [[nodiscard]] bool write(const BusFrame& frame) noexcept override {
    const bool known = frame.id < kFingerCount && frame.length <= frame.data.size();
    const int failure = known ? ports_[frame.id].write(frame) : EDESTADDRREQ;
    if (failure == EAGAIN) return false;
    if (failure == 0) return true;
    ++counters_.unsent;
    if (known) note_failure(ports_[frame.id], failure);
    return true;
  }

  void note_failure(Port& port, int failure) noexcept {
    if (failure == EIO && port.is_open()) ++counters_.error_frames;
    if (!port.is_open()) return;
    port.close();
    untold_ = true;
    reopen_at_ = std::min(reopen_at_, clock_->now() + kReopen);
  }

  void reopen(Timestamp now) noexcept {
    reopen_at_ = Timestamp::max();
    for (auto& port : ports_) {
      if (port.is_open()) continue;
      try {
        if (port.open()) port.close();
      } catch (const std::exception&) {
        port.close();
      }
      if (!port.is_open()) reopen_at_ = now + kReopen;
    }
  }

  /// False if no port has anything. The sensors take turns.
  bool read_one(ReceivedFrame& out) noexcept {
    for (std::size_t i = 0; i < kFingerCount; ++i) {
      const std::size_t sensor = (next_ + i) % kFingerCount;
      Port& port = ports_[sensor];
      if (!port.is_open()) continue;
      out.frame = {};
      const int failure = port.read(out.frame);
      if (failure == EAGAIN || failure == EINTR) continue;
      if (failure != 0) {
        note_failure(port, failure);
        continue;
      }
      out.frame.id = static_cast<std::uint32_t>(sensor);
      out.stamp = clock_->now();
      out.wall_time = read_clock(CLOCK_REALTIME);
      next_ = sensor + 1;
      return true;
    }
    return false;
  }

  void wait_until(Timestamp deadline) noexcept {
    deadline = sooner(deadline);
    deadline = std::min(deadline, reopen_at_);
    try {
      for (auto& port : ports_) port.begin_wait();
      // steady_clock is CLOCK_MONOTONIC, as is the clock of Timestamp.
      io_.run_one_until(std::chrono::steady_clock::time_point(deadline));
    } catch (const std::exception&) {  // cannot wait: sleep, so as not to spin
      clock_->wait_until(std::min(deadline, clock_->now() + kRetry));
    }
  }

  std::array<PortWait, kFingerCount> waits_;
  asio::io_context io_{1};
  asio::executor_work_guard<asio::io_context::executor_type> work_{io_.get_executor()};
  std::array<Port, kFingerCount> ports_{Port(io_, waits_[0]), Port(io_, waits_[1]),
                                        Port(io_, waits_[2])};
  std::size_t next_ = 0;
  bool untold_ = false;  ///< interface_gone has to be reported
  Timestamp reopen_at_ = Timestamp::max();
};

}  // namespace

Result<std::unique_ptr<Bus>> open_serial(const std::array<std::string, kFingerCount>& ports,
                                         unsigned baud) {
  auto bus = std::make_unique<Serial>();
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    if (std::count(ports.begin(), ports.end(), ports[f]) > 1)
      return refused("two sensors have this serial port"_text, "give every sensor its own"_text)
          .about(ports[f]);
    bus->port(f).set(ports[f], baud);
    try {
      const auto failure = bus->port(f).open();
      if (!failure) continue;
      const bool no_such_port = failure == boost::system::errc::no_such_file_or_directory;
      const auto error = no_such_port ? refused : failed;
      return error("the serial port cannot be opened: %1"_text(Known{failure.message()}),
                   failure == boost::system::errc::permission_denied
                       ? "ask an administrator to put you into the group dialout"_text
                       : "plug in the adapter and check the name of the port"_text)
          .about(ports[f]);
    } catch (const std::exception& problem) {
      return failed("the serial port cannot be opened: %1"_text(problem.what()),
                    "close other programs and try again"_text)
          .about(ports[f]);
    }
  }
  return std::unique_ptr<Bus>(std::move(bus));
}

}  // namespace isograsp
