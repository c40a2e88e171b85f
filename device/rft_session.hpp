// SPDX-License-Identifier: GPL-3.0-or-later
// The conversation with one RFT sensor: stop, identify, check filter and rate, start, watch. No bus
// and no clock: frames and times in, commands out. No allocation after construction.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/time.hpp"
#include "device/can_bus.hpp"
#include "device/rft_codec.hpp"

namespace isograsp {

struct RftSessionOptions {
  RftIds ids;
  std::string serial_number;  ///< that the sensor must have; empty: any
  std::uint8_t rate_code = 4;
  std::uint8_t filter_code = 8;
};

class RftSession {
 public:
  enum class Failure : std::uint8_t { none, no_answer, wrong_serial, refused };

  explicit RftSession(RftSessionOptions options);

  /// Begins the conversation anew: stop first, whatever the sensor does now. It pauses before the
  /// start command, so that all sensors of a device can start together.
  void begin(Timestamp now) noexcept;
  /// The command that is due now; call until there is none. Moves on after waiting times and tries
  /// again after a time-out: 100 ms, three tries.
  [[nodiscard]] std::optional<CanFrame> poll(Timestamp now) noexcept;
  /// When poll() wants to be asked again.
  [[nodiscard]] Timestamp due() const noexcept { return due_; }
  /// Takes a frame that carries one of the sensor's identifiers; a measurement comes out while
  /// streaming. Stamps must not decrease.
  [[nodiscard]] std::optional<RftCounts> take(const CanFrame& frame, Timestamp stamp) noexcept;

  /// Configured; go() lets it start.
  [[nodiscard]] bool ready() const noexcept { return step_ == Step::ready; }
  /// @pre ready()
  void go(Timestamp now) noexcept { enter(Step::start, now); }
  [[nodiscard]] bool streaming() const noexcept { return step_ == Step::streaming; }
  [[nodiscard]] Failure failure() const noexcept { return failure_; }
  /// The failure in words for people. `place` is the bus.
  [[nodiscard]] Error error(std::string_view finger, const std::string& place) const;
  /// As the sensor said it; empty before.
  [[nodiscard]] std::string_view serial_number() const noexcept;
  [[nodiscard]] const RftIds& ids() const noexcept { return options_.ids; }

  /// Counters begin anew; gaps are counted from the next measurement on.
  void reset_counters() noexcept;
  /// Measurements that never came, from gaps between arrivals.
  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_; }
  [[nodiscard]] std::uint64_t torn() const noexcept { return pairing_.torn(); }
  [[nodiscard]] std::uint64_t foreign() const noexcept { return pairing_.foreign(); }

 private:
  enum class Step : std::uint8_t {
    idle,
    stop,
    serial_number,
    read_filter,
    set_filter,
    read_rate,
    set_rate,
    clear_bias,
    ready,
    start,
    streaming,
    failed
  };
  void enter(Step step, Timestamp now) noexcept;
  void fail(Failure failure) noexcept;
  void time_out(Timestamp now) noexcept;
  [[nodiscard]] CanFrame command() const noexcept;
  [[nodiscard]] Timestamp waiting_time() const noexcept;
  void answer(const RftPacket& packet, Timestamp now) noexcept;
  void count_gap(Timestamp stamp) noexcept;

  RftSessionOptions options_;
  RftPairing pairing_;
  Timestamp period_;
  Timestamp silence_;  ///< longest silence of a healthy sensor
  Step step_ = Step::idle;
  bool sent_ = false;
  int tries_ = 0;
  Failure failure_ = Failure::none;
  std::uint8_t refusal_ = 0;  ///< R2 of the answer that says no
  Timestamp due_ = Timestamp::max();
  std::array<char, 15> serial_{};
  std::optional<Timestamp> last_sample_;
  std::uint64_t lost_ = 0;
};

}  // namespace isograsp
