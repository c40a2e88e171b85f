// SPDX-License-Identifier: GPL-3.0-or-later
// Three RFT sensors in software, as they look from the bus: idle at power-up, deaf to all but stop
// and bias while they stream, each with its own clock. No bus and no clock: command frames and
// times in, frames out. The same seed and the same commands give the same frames.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

#include "core/finger.hpp"
#include "core/result.hpp"
#include "core/time.hpp"
#include "device/device_config.hpp"
#include "device/rft_codec.hpp"

namespace isograsp {

/// What the fingers do: wrenches in contact frames from times t_s on, each until the next. After
/// the last row the play begins again (repeat) or the last row holds.
struct FingerPlay {
  std::vector<double> t_s;  ///< strictly increasing, from 0
  std::vector<FingerWrenches> wrench_C;
  bool repeat = false;
  double duration_s = 0.0;  ///< of one round, for repeat

  [[nodiscard]] const FingerWrenches& at(double play_time_s) const noexcept;
};

/// One injected fault.
struct RftFault {
  enum class Kind : std::uint8_t { lose_first, lose_second, silence, power_dip };
  Kind kind = Kind::silence;
  Finger finger = Finger::thumb;
  double probability = 0.0;  ///< of losing a frame
  double at_s = 0.0;         ///< since the first start command

  /// "lose=FINGER:tx1:PROB", "lose=FINGER:tx2:PROB", "silence=FINGER@5s", "dip=FINGER@5s". Errors
  /// name the faults that exist.
  [[nodiscard]] static Result<RftFault> parse(std::string_view text);
};

struct RftEmulatorOptions {
  RftConfig config = RftConfig::standard();
  std::uint64_t seed = 1;
  double clock_error = 200e-6;  ///< each sensor's own, uniform within plus or minus this
  int noise_counts = 0;         ///< each axis, uniform within plus or minus this
  bool filtered = false;        ///< the sensor's low-pass acts; a file is played as it stands
  std::vector<RftFault> faults;
};

struct RftEmulatorCounters {
  std::uint64_t samples = 0;     ///< measurements made while streaming
  std::uint64_t lost_first = 0;  ///< frames that a fault swallowed
  std::uint64_t lost_second = 0;
  std::uint64_t lost_samples = 0;  ///< measurements with at least one frame swallowed
};

class RftEmulator {
 public:
  RftEmulator(RftEmulatorOptions options, FingerPlay play);

  /// A frame from the bus; those that are no command to these sensors are ignored.
  void receive(const CanFrame& frame, Timestamp now);
  /// The next frame that should have left by `now`; false if there is none.
  [[nodiscard]] bool take(Timestamp now, CanFrame& out);
  /// When take() will have something; Timestamp::max() while idle.
  [[nodiscard]] Timestamp next() const noexcept;
  [[nodiscard]] const std::array<RftEmulatorCounters, kFingerCount>& counters() const noexcept {
    return counters_;
  }

 private:
  struct Sensor {
    bool streaming = false;
    bool dead = false;
    std::uint8_t rate_code = 0;  ///< 0: the default, 200 Hz
    std::uint8_t filter_type = 0;
    std::uint8_t filter_code = 0;
    RftIds ids;
    RftIds ids_after_reboot;
    double clock_factor = 1.0;  ///< own seconds to true ones
    double phase = 0.5;         ///< of the first measurement, in periods
    Timestamp started{0};
    std::int64_t measured = 0;  ///< since start
    std::array<double, 6> filter_state{};
    bool filter_settled = false;
    std::array<std::int32_t, 6> bias{};
    std::array<std::uint8_t, 6> overload_counts{};
  };
  struct Departure {
    Timestamp when;
    CanFrame frame;
  };

  [[nodiscard]] double period_s(const Sensor& sensor) const noexcept;
  [[nodiscard]] Timestamp next_measurement(const Sensor& sensor) const noexcept;
  void obey(std::size_t finger, const CanFrame& frame, Timestamp now);
  void reply(std::size_t finger, std::uint8_t command, std::span<const std::uint8_t> content,
             Timestamp now);
  void depart(const std::array<CanFrame, 2>& frames, Timestamp when, bool first, bool second);
  [[nodiscard]] RftCounts measure(std::size_t finger);
  void make_measurements(Timestamp now);
  void strike_faults(Timestamp now);
  void reset(Sensor& sensor);
  [[nodiscard]] bool strikes(RftFault::Kind kind, std::size_t finger);
  [[nodiscard]] double uniform() noexcept;

  RftEmulatorOptions options_;
  FingerPlay play_;
  std::mt19937_64 random_;
  std::array<Sensor, kFingerCount> sensors_{};
  std::array<RftEmulatorCounters, kFingerCount> counters_{};
  std::vector<Departure> departures_;  ///< in the order of their times
  std::vector<bool> struck_;           ///< faults with an instant happen once
  Timestamp first_start_ = Timestamp::min();
};

}  // namespace isograsp
