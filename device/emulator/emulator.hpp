// SPDX-License-Identifier: GPL-3.0-or-later
// Three sensors in software, as they look from the bus: the protocol's own behaviour, each with its
// own clock, and faults on purpose. No bus and no real clock: frames and times in, frames out. The
// same seed and the same commands give the same frames.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "core/time.hpp"
#include "device/config/device_config.hpp"
#include "device/config/rft_sensor.hpp"
#include "device/emulator/emulated_sensor.hpp"
#include "device/emulator/fault.hpp"
#include "device/emulator/finger_play.hpp"
#include "hand/finger.hpp"

namespace isograsp {

struct EmulatorOptions {
  /// Of a family whose sensors can be emulated (FamilyFacts::on_wire).
  DeviceConfig config = DeviceConfig::standard(kRftFamily);
  std::uint64_t seed = 1;
  double clock_error = 200e-6;  ///< each sensor's own, uniform within plus or minus this
  int noise_counts = 0;         ///< each axis, uniform within plus or minus this
  bool filtered = false;        ///< the low-pass of the sensor acts; false for a file
  std::vector<Fault> faults;
};

/// What was done; in samples unless it says frames.
struct EmulatorCounters {
  std::uint64_t samples = 0;       ///< measurements made while streaming, or on demand
  std::uint64_t lost_first = 0;    ///< frames that a fault swallowed
  std::uint64_t lost_second = 0;   ///< frames
  std::uint64_t lost_samples = 0;  ///< measurements with at least one frame swallowed
  std::uint64_t broken = 0;        ///< measurements that cannot arrive: lost, swapped or cut
  std::uint64_t swapped = 0;
  std::uint64_t duplicated = 0;
  std::uint64_t delayed = 0;
  std::uint64_t frozen = 0;
  std::uint64_t foreign = 0;  ///< frames added
  std::uint64_t cut = 0;      ///< frames sent too short
  std::uint64_t answers = 0;  ///< that nobody asked for
  std::uint64_t burst = 0;    ///< frames added
  std::uint64_t restarts = 0;
};

class Emulator final : private EmulatorWorld {
 public:
  Emulator(EmulatorOptions options, FingerPlay play);

  /// A frame from the bus; those that are no command to these sensors are ignored.
  void receive(const BusFrame& frame, Timestamp now);
  /// The next frame that should have left by `now`; false if there is none.
  [[nodiscard]] bool take(Timestamp now, BusFrame& out);
  /// When take() will have something; Timestamp::max() while idle.
  [[nodiscard]] Timestamp next() const noexcept;
  /// Ends measuring; what was measured before is still sent.
  void finish(Timestamp now);
  [[nodiscard]] const std::array<EmulatorCounters, kFingerCount>& counters() const noexcept {
    return counters_;
  }
  /// Since the first sensor began to play; negative before.
  [[nodiscard]] double play_time_s(Timestamp now) const noexcept;

 private:
  struct Departure {
    Timestamp when;
    BusFrame frame;
  };
  void send_sample(std::size_t finger, Timestamp when, std::span<const BusFrame> frames) override;
  void send_answer(std::size_t finger, Timestamp now, std::span<const BusFrame> frames) override;
  [[nodiscard]] Wrench feel(std::size_t finger, double play_s) override;
  [[nodiscard]] int noise_counts() override;
  [[nodiscard]] bool filtered() const override { return options_.filtered; }
  [[nodiscard]] std::string serial_number(std::size_t finger) const override;
  [[nodiscard]] double clock_factor(std::size_t finger) const override;
  [[nodiscard]] double phase(std::size_t finger) const override { return phase_[finger]; }

  void make_measurements(Timestamp now);
  /// Faults that happen at one instant and have come due by `now`.
  void strike(Timestamp now);
  [[nodiscard]] Timestamp next_strike() const noexcept;
  [[nodiscard]] bool silent(std::size_t finger, Timestamp now) const noexcept;
  [[nodiscard]] const Fault* acting(Fault::Kind kind, std::size_t finger,
                                    double t_s) const noexcept;
  /// Draws for every fault of this kind whether it happens now; returns the one that does.
  [[nodiscard]] const Fault* hit(Fault::Kind kind, std::size_t finger);
  [[nodiscard]] Timestamp instant_of(const Fault& fault) const noexcept;
  void depart(Timestamp when, const BusFrame& frame);
  [[nodiscard]] double uniform() noexcept;

  EmulatorOptions options_;
  FingerPlay play_;
  std::mt19937_64 random_;
  std::array<std::unique_ptr<EmulatedSensor>, kFingerCount> sensors_;
  std::array<double, kFingerCount> clock_error_{};
  std::array<double, kFingerCount> phase_{};
  std::array<EmulatorCounters, kFingerCount> counters_{};
  std::array<std::vector<BusFrame>, kFingerCount> last_sample_;
  std::array<bool, kFingerCount> lose_first_of_next_{};
  std::vector<Departure> departures_;  ///< in the order of their times
  std::vector<bool> struck_;           ///< faults with an instant happen once
  Timestamp play_start_ = Timestamp::max();
  bool finished_ = false;
};

}  // namespace isograsp
