// SPDX-License-Identifier: GPL-3.0-or-later
// A USB-CAN adapter in software. It plays the adapter at one end of a pseudo-terminal; at the other
// end the kernel's slcan driver makes a CAN interface of it. This one has a bit rate, a short
// transmit queue and error states, which a virtual CAN interface does not have. Seen from here it
// is the Bus of the nodes that hang on the adapter.
//
// Needs the right to make interfaces (root), the kernel module slcan and the program ip.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <sys/types.h>

#include "device/bus/bus.hpp"
#include "device/emulator/slcan_codec.hpp"

namespace isograsp {

enum class AdapterFault : std::uint8_t {
  error_warning,
  error_passive,
  bus_off,       ///< until the interface is switched off and on
  error_active,  ///< back to normal; after bus_off the interface still has no carrier
  bit_error,
  missing_acknowledgement,
  receive_overflow,   ///< tells of one; loses nothing by itself
  transmit_overflow,  ///< as above
  stall,              ///< neither reads nor writes: the transmit queue of the kernel fills up
  resume,
  unplug,
  plug_in  ///< the interface is made again and switched on
};

class SlcanAdapter final : public Bus {
 public:
  /// Plugs in: makes the interface of this name, sets the bit rate and switches it on. Takes up to
  /// some seconds. Errors name the interface and what is missing.
  [[nodiscard]] static Result<std::unique_ptr<SlcanAdapter>> open(const std::string& interface,
                                                                  unsigned bit_rate = 1'000'000);
  ~SlcanAdapter() override;

  Result<void> start(Clock& clock) override;
  /// A frame from a node of the bus to the computer. Without effect, and counted as unsent, while
  /// the adapter is unplugged, stalled, bus-off or switched off.
  bool send(const BusFrame& frame) noexcept override;
  /// A frame from the computer to the nodes. Has to be called all the time, because the kernel
  /// waits for answers while an interface is being switched on. interface_gone: the interface could
  /// not be switched on after plugging in.
  [[nodiscard]] BusEvent receive(Timestamp deadline, ReceivedFrame& out) noexcept override;
  [[nodiscard]] BusCounters counters() const noexcept override { return counters_; }

  /// Not real-time safe.
  void inject(AdapterFault fault) noexcept;

  /// Switched on, as the kernel told the adapter.
  [[nodiscard]] bool is_open() const noexcept { return open_; }
  /// As the kernel told the adapter [bit/s]; 0: not yet.
  [[nodiscard]] unsigned bit_rate() const noexcept { return told_bit_rate_; }

 private:
  SlcanAdapter(std::string interface, unsigned bit_rate);
  [[nodiscard]] Result<void> plug_in();
  [[nodiscard]] Result<void> attach();
  [[nodiscard]] Result<void> begin_switching_on();
  /// Its exit status once the program that switches the interface on has ended.
  [[nodiscard]] std::optional<int> switching_on_ended() noexcept;
  void unplug() noexcept;

  [[nodiscard]] bool plugged_in() const noexcept { return master_ >= 0; }
  void write(const SlcanText& text) noexcept;
  void write_rest() noexcept;
  [[nodiscard]] bool read_frame(BusFrame& out) noexcept;
  [[nodiscard]] bool obey(std::string_view line, BusFrame& out) noexcept;
  void wait_until(Timestamp deadline) noexcept;

  std::string interface_;
  unsigned bit_rate_;
  SteadyClock steady_clock_;
  Clock* clock_ = &steady_clock_;
  int master_ = -1;
  int slave_ = -1;
  pid_t switching_on_ = -1;
  bool failed_ = false;  ///< to plug in or switch on: not yet reported
  bool open_ = false;
  bool off_ = false;
  bool stalled_ = false;
  unsigned told_bit_rate_ = 0;
  BusCounters counters_;

  SlcanLines lines_;
  std::array<char, 512> in_{};  ///< read from the terminal, not yet understood
  std::size_t in_first_ = 0;
  std::size_t in_size_ = 0;
  std::array<char, 4096> rest_{};  ///< that the terminal had no room for
  std::size_t rest_size_ = 0;
};

}  // namespace isograsp
