// SPDX-License-Identifier: GPL-3.0-or-later
// The conversation with one sensor: asked step by step who it is and how it is set, then started
// and watched. A protocol gives the questions and understands the answers; waiting, trying again
// and counting are the same for all. No bus and no clock: frames and times in, frames out. No
// allocation after construction.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/result.hpp"
#include "core/time.hpp"
#include "device/bus/frame.hpp"
#include "hand/finger.hpp"

namespace isograsp {

/// One sample of one sensor in the sensor frame, before zero, mounting and clinic's calibration.
struct Measurement {
  Timestamp stamp{0};         ///< arrival of the frame that completed it
  RawCounts raw_counts{};     ///< as sent
  Wrench wrench_S;            ///< [N, N m]
  bool valid = true;          ///< false: no meaning, by the sensor's own word or a saturated gage
  bool overload = false;      ///< the sensor's own overload sign
  bool saturated = false;     ///< a value is at the end of its number range
  bool status_error = false;  ///< the sensor itself reports that something is wrong
  bool numbered = false;      ///< the sensor numbers its samples and this number is new
  std::uint32_t status = 0;   ///< the protocol's own status word
};

/// What a conversation counts; never decreases between two calls of reset_counters().
struct SessionCounters {
  std::uint64_t torn = 0;       ///< halves of samples without the other half
  std::uint64_t duplicate = 0;  ///< frames that came twice
  std::uint64_t late = 0;       ///< answers that came too late
  std::uint64_t lost = 0;       ///< samples missing by count, by question or by time
  std::uint64_t foreign = 0;    ///< frames with the sensor's address that it does not send
  std::uint64_t restarts = 0;   ///< times that the sensor forgot its state and was set up again
};

class SensorSession {
 public:
  enum class Failure : std::uint8_t {
    none,
    no_answer,
    wrong_serial,
    wrong_calibration,  ///< not the one that the configuration names, or the sensor calls it bad
    refused             ///< the sensor refuses a setting
  };

  virtual ~SensorSession() = default;

  /// Begins the conversation anew, whatever the sensor does now. It pauses before the start, so
  /// that all sensors of a device can start together.
  void begin(Timestamp now) noexcept;
  /// The frame that is due now; call until there is none. Moves on after waiting times and tries
  /// again after a time-out: three tries.
  [[nodiscard]] std::optional<BusFrame> poll(Timestamp now) noexcept;
  /// When poll() wants to be asked again.
  [[nodiscard]] Timestamp due() const noexcept;
  /// Whether the frame comes from this sensor's address.
  [[nodiscard]] virtual bool owns(const BusFrame& frame) const noexcept = 0;
  /// Takes a frame that this session owns; true: `out` holds a measurement. Stamps must not
  /// decrease.
  [[nodiscard]] bool take(const BusFrame& frame, Timestamp stamp, Measurement& out) noexcept;

  /// Configured; go() lets it start.
  [[nodiscard]] bool ready() const noexcept { return phase_ == Phase::ready; }
  /// @pre ready()
  void go(Timestamp now) noexcept;
  [[nodiscard]] bool streaming() const noexcept { return phase_ == Phase::streaming; }
  /// The frame that stops the sensor from sending, if its protocol has one.
  [[nodiscard]] virtual std::optional<BusFrame> stop_frame() const noexcept { return std::nullopt; }

  [[nodiscard]] Failure failure() const noexcept { return failure_; }
  /// The failure in words for people. `place` is the bus.
  [[nodiscard]] Error error(std::string_view finger, const std::string& place) const;
  /// As the sensor said it; empty before, or if its protocol does not tell.
  [[nodiscard]] std::string_view serial_number() const noexcept { return serial_number_; }
  /// Units per count, sensor frame; known when ready(). Zero: a count has no scale of its own,
  /// because each axis is computed from all gages.
  [[nodiscard]] virtual Vec6 units_per_count() const noexcept = 0;
  /// Known delay from force to stamp inside the sensor [s].
  [[nodiscard]] virtual double sensor_delay_s() const noexcept { return 0.0; }

  [[nodiscard]] SessionCounters counters() const noexcept;
  /// Counters begin anew; gaps are counted from the next measurement on.
  void reset_counters() noexcept;

 protected:
  struct Options {
    std::string serial_number;  ///< that the sensor must have; empty: any
    std::string address;        ///< for people: "identifier 0x64"
    double period_s = 0.01;     ///< of the samples
  };
  /// One step of the set-up.
  struct Question {
    std::optional<BusFrame> frame;  ///< none: only waits
    Timestamp wait;                 ///< for the answer, or before the next step
    bool answered = true;           ///< false: there is no answer to wait for
  };
  enum class Heard : std::uint8_t {
    nothing,      ///< half an answer, or nothing for us
    answer,       ///< what the present step asked for
    measurement,  ///< `out` is filled
    alive,        ///< a measurement that must not be used, e.g. a repeated one
    restarted,    ///< the sensor has forgotten its state
    refusal,
    wrong_serial,
    wrong_calibration
  };

  explicit SensorSession(Options options);

  /// The set-up is steps 0 … steps() - 1; one without a question is skipped.
  [[nodiscard]] virtual int steps() const noexcept = 0;
  [[nodiscard]] virtual std::optional<Question> question(int step) const noexcept = 0;
  /// `step` is the one whose answer is awaited; nothing: none is.
  [[nodiscard]] virtual Heard hear(std::optional<int> step, const BusFrame& frame, Timestamp stamp,
                                   Measurement& out) noexcept = 0;
  /// Begins to stream; the frame that asks for it, if there is one.
  [[nodiscard]] virtual std::optional<BusFrame> start(Timestamp now) noexcept = 0;
  /// What has to be sent regularly while streaming (questions, synchronisation).
  [[nodiscard]] virtual std::optional<BusFrame> pace(Timestamp now) noexcept;
  [[nodiscard]] virtual Timestamp pace_due() const noexcept { return Timestamp::max(); }
  /// For protocols that do not number their samples: lost ones are counted from gaps in the stamps.
  void count_gap(Timestamp stamp) noexcept;
  /// Half an answer is forgotten: the conversation begins anew.
  virtual void forget() noexcept {}
  virtual void reset_protocol_counters() noexcept {}
  /// What the protocol's own pairing counts is added by it.
  [[nodiscard]] virtual SessionCounters protocol_counters() const noexcept { return {}; }
  /// Why a setting or calibration was refused, in a few words.
  [[nodiscard]] virtual Text refusal() const { return {}; }
  /// What to do about a sensor that does not answer.
  [[nodiscard]] virtual Text no_answer_remedy() const {
    return "check its power, its cable and the 120 ohm at both ends of the bus"_text;
  }
  /// Compares with what the configuration says and keeps it.
  [[nodiscard]] Heard hear_serial(std::string_view text) noexcept;

  [[nodiscard]] Timestamp period() const noexcept { return period_; }
  SessionCounters counters_;

 private:
  enum class Phase : std::uint8_t { idle, setup, ready, streaming, failed };
  void enter(int step, Timestamp now) noexcept;
  void advance(Timestamp now) noexcept;
  void time_out(Timestamp now) noexcept;
  void fail(Failure failure, Timestamp now) noexcept;

  Options options_;
  Timestamp period_;
  Timestamp silence_;  ///< longest silence of a healthy sensor
  Phase phase_ = Phase::idle;
  int step_ = 0;
  bool sent_ = false;
  int tries_ = 0;
  Failure failure_ = Failure::none;
  Timestamp due_ = Timestamp::max();
  std::string serial_number_;
  std::optional<Timestamp> last_sample_;
};

}  // namespace isograsp
