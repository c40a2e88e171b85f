// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/emulator/slcan_adapter.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <net/if.h>
#include <poll.h>
#include <spawn.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include "device/bus/kernel_stamp.hpp"

namespace isograsp {

namespace {

constexpr int kSlcanDiscipline = 17;  // N_SLCAN
constexpr Timestamp kLongestSwitchingOn = std::chrono::seconds(5);
constexpr Timestamp kLookAtPort = std::chrono::milliseconds(10);

Error system_error(const std::string& interface, const Text& what) {
  return failed("%1: %2"_text(what, Known{std::strerror(errno)}),
                "run as root on a kernel with the module slcan"_text)
      .about(interface);
}

/// @pre the interface is switched off. False: errno says why.
bool rename_interface(const char* from, const std::string& to) {
  const int fd = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (fd < 0) return false;
  ifreq request{};
  std::string_view(from).copy(request.ifr_name, IFNAMSIZ - 1);
  to.copy(request.ifr_newname, IFNAMSIZ - 1);
  const bool done = ioctl(fd, SIOCSIFNAME, &request) == 0;
  const int failure = errno;
  ::close(fd);
  errno = failure;
  return done;
}

}  // namespace

SlcanAdapter::SlcanAdapter(std::string interface, unsigned bit_rate)
    : interface_(std::move(interface)), bit_rate_(bit_rate) {}

SlcanAdapter::~SlcanAdapter() {
  unplug();
}

Result<std::unique_ptr<SlcanAdapter>> SlcanAdapter::open(const std::string& interface,
                                                         unsigned bit_rate) {
  if (interface.empty() || interface.size() >= IFNAMSIZ)
    return refused("no interface can have this name"_text, "use slcan:can0"_text).about(interface);
  std::unique_ptr<SlcanAdapter> adapter(new SlcanAdapter(interface, bit_rate));
  if (auto plugged = adapter->plug_in(); !plugged) return plugged.error();
  const Timestamp give_up_at = adapter->clock_->now() + kLongestSwitchingOn;
  ReceivedFrame ignored;
  while (adapter->switching_on_ >= 0 && adapter->clock_->now() < give_up_at)
    if (adapter->receive(adapter->clock_->now() + kLookAtPort, ignored) == BusEvent::interface_gone)
      return failed("the interface could not be switched on"_text,
                    "run as root; the program ip must be installed"_text)
          .about(interface);
  if (!adapter->open_)
    return failed("the kernel did not open the adapter"_text,
                  "use the kernel's slcan driver of Linux 6.0 or later"_text)
        .about(interface);
  return adapter;
}

Result<void> SlcanAdapter::plug_in() {
  if (if_nametoindex(interface_.c_str()) != 0)
    return refused("there is an interface of this name already"_text,
                   "choose another name for the adapter"_text)
        .about(interface_);
  auto done = attach();
  if (done) done = begin_switching_on();
  if (!done) unplug();
  return done;
}

Result<void> SlcanAdapter::attach() {
  master_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  char name[64];
  if (master_ < 0 || grantpt(master_) != 0 || unlockpt(master_) != 0 ||
      ptsname_r(master_, name, sizeof name) != 0)
    return system_error(interface_, "no pseudo-terminal can be made"_text);
  slave_ = ::open(name, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  termios settings{};
  if (slave_ < 0 || tcgetattr(slave_, &settings) != 0)
    return system_error(interface_, "the pseudo-terminal cannot be opened"_text);
  cfmakeraw(&settings);  // no echo
  if (tcsetattr(slave_, TCSANOW, &settings) != 0)
    return system_error(interface_, "the pseudo-terminal cannot be set"_text);
  if (ioctl(slave_, TIOCSETD, &kSlcanDiscipline) != 0)
    return system_error(interface_, "the kernel makes no CAN interface of a serial line"_text);
  ifreq request{};
  if (ioctl(slave_, SIOCGIFNAME, request.ifr_name) != 0)
    return system_error(interface_, "the kernel does not name its new interface"_text);
  if (interface_ != request.ifr_name && !rename_interface(request.ifr_name, interface_))
    return system_error(interface_, "the new interface cannot have this name"_text);
  return {};
}

Result<void> SlcanAdapter::begin_switching_on() {
  std::string bit_rate = std::to_string(bit_rate_);
  std::array<std::string, 9> words{"ip",   "link", "set",     interface_, "up",
                                   "type", "can",  "bitrate", bit_rate};
  std::array<char*, words.size() + 1> arguments{};
  std::transform(words.begin(), words.end(), arguments.begin(),
                 [](std::string& word) { return word.data(); });
  const int failure =
      posix_spawnp(&switching_on_, "ip", nullptr, nullptr, arguments.data(), environ);
  if (failure == 0) return {};
  switching_on_ = -1;
  return failed("ip cannot be run: %1"_text(Known{std::strerror(failure)}), "install iproute2"_text)
      .about(interface_);
}

std::optional<int> SlcanAdapter::switching_on_ended() noexcept {
  int status = 0;
  if (switching_on_ < 0 || waitpid(switching_on_, &status, WNOHANG) != switching_on_)
    return std::nullopt;
  switching_on_ = -1;
  return status;
}

void SlcanAdapter::unplug() noexcept {
  for (int* end : {&master_, &slave_})
    if (*end >= 0) ::close(std::exchange(*end, -1));
  // The program that switches on ends at once when the adapter is gone.
  if (switching_on_ >= 0) (void)waitpid(std::exchange(switching_on_, -1), nullptr, 0);
  open_ = off_ = stalled_ = false;
  told_bit_rate_ = 0;
  lines_ = {};
  in_first_ = in_size_ = rest_size_ = 0;
}

void SlcanAdapter::inject(AdapterFault fault) noexcept {
  switch (fault) {
    // Warning and passive begin at 96 and 128 errors, bus-off at 256.
    case AdapterFault::error_warning: return write(format_slcan_state(SlcanState::warning, 97, 0));
    case AdapterFault::error_passive: return write(format_slcan_state(SlcanState::passive, 128, 0));
    case AdapterFault::bus_off:
      write(format_slcan_state(SlcanState::bus_off, 256, 0));
      off_ = true;
      return;
    case AdapterFault::error_active:
      write(format_slcan_state(SlcanState::active, 0, 0));
      off_ = false;
      return;
    case AdapterFault::bit_error: return write(format_slcan_error(SlcanError::bit));
    case AdapterFault::missing_acknowledgement:
      return write(format_slcan_error(SlcanError::acknowledgement));
    case AdapterFault::receive_overflow:
      return write(format_slcan_error(SlcanError::receive_overflow));
    case AdapterFault::transmit_overflow:
      return write(format_slcan_error(SlcanError::transmit_overflow));
    case AdapterFault::stall: stalled_ = true; return;
    case AdapterFault::resume: stalled_ = false; return;
    case AdapterFault::unplug: return unplug();
    case AdapterFault::plug_in:
      if (plugged_in()) return;
      try {
        failed_ = !plug_in();
      } catch (const std::exception&) {
        failed_ = true;
      }
      return;
  }
}

Result<void> SlcanAdapter::start(Clock& clock) {
  if (clock.is_virtual())
    return refused("a real adapter does not run in virtual time"_text, "use the real clock"_text)
        .about(interface_);
  clock_ = &clock;
  return {};
}

bool SlcanAdapter::send(const BusFrame& frame) noexcept {
  const SlcanText text = format_slcan(frame);
  const bool possible = plugged_in() && open_ && !off_ && !stalled_;
  if (!possible || rest_size_ + text.view().size() > rest_.size()) {
    ++counters_.unsent;
    return false;
  }
  write(text);
  return true;
}

void SlcanAdapter::write(const SlcanText& text) noexcept {
  const std::string_view characters = text.view();
  if (!plugged_in() || rest_size_ + characters.size() > rest_.size()) return;
  std::copy(characters.begin(), characters.end(),
            rest_.begin() + static_cast<std::ptrdiff_t>(rest_size_));
  rest_size_ += characters.size();
  write_rest();
}

void SlcanAdapter::write_rest() noexcept {
  if (!plugged_in() || stalled_ || rest_size_ == 0) return;
  const auto n = ::write(master_, rest_.data(), rest_size_);
  if (n <= 0) return;
  const auto written = static_cast<std::size_t>(n);
  std::copy(rest_.begin() + n, rest_.begin() + static_cast<std::ptrdiff_t>(rest_size_),
            rest_.begin());
  rest_size_ -= written;
}

bool SlcanAdapter::obey(std::string_view line, BusFrame& out) noexcept {
  const auto command = parse_slcan(line);
  write(format_slcan_answer(command));
  if (!command) return false;
  switch (command->kind) {
    case SlcanCommand::Kind::frame: out = command->frame; return open_ && !off_;
    case SlcanCommand::Kind::bit_rate: told_bit_rate_ = command->bit_rate; return false;
    case SlcanCommand::Kind::open:
    case SlcanCommand::Kind::listen:
      open_ = true;
      off_ = false;
      return false;
    case SlcanCommand::Kind::close: open_ = false; return false;
    case SlcanCommand::Kind::read_flags: return false;
  }
  return false;
}

bool SlcanAdapter::read_frame(BusFrame& out) noexcept {
  if (!plugged_in() || stalled_) return false;
  while (true) {
    while (in_first_ < in_size_)
      if (const auto line = lines_.take(in_[in_first_++]); line && obey(*line, out)) return true;
    const auto n = ::read(master_, in_.data(), in_.size());
    if (n <= 0) return false;
    in_first_ = 0;
    in_size_ = static_cast<std::size_t>(n);
  }
}

BusEvent SlcanAdapter::receive(Timestamp deadline, ReceivedFrame& out) noexcept {
  while (true) {
    if (const auto status = switching_on_ended(); status && *status != 0) failed_ = true;
    if (std::exchange(failed_, false)) return BusEvent::interface_gone;
    write_rest();
    if (read_frame(out.frame)) {
      out.stamp = clock_->now();
      out.wall_time = read_clock(CLOCK_REALTIME);
      return BusEvent::frame;
    }
    if (clock_->now() >= deadline) return BusEvent::timeout;
    wait_until(deadline);
  }
}

void SlcanAdapter::wait_until(Timestamp deadline) noexcept {
  const Timestamp now = clock_->now();
  if (switching_on_ >= 0) deadline = std::min(deadline, now + kLookAtPort);
  if (!plugged_in() || stalled_) return clock_->wait_until(deadline);
  const Timestamp rest = std::max(deadline - now, Timestamp{0});
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(rest);
  const timespec longest{seconds.count(), (rest - seconds).count()};
  pollfd terminal{master_, static_cast<short>(rest_size_ > 0 ? POLLIN | POLLOUT : POLLIN), 0};
  (void)ppoll(&terminal, 1, &longest, nullptr);
}

}  // namespace isograsp
