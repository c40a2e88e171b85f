// SPDX-License-Identifier: GPL-3.0-or-later
// One sensor in software, as it looks from the bus. A protocol's emulated sensor understands the
// commands and makes the frames; the wrench, the clock, the noise and every fault come from the
// emulator around it. No bus and no real clock.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/spatial.hpp"
#include "core/time.hpp"
#include "device/bus/frame.hpp"
#include "hand/finger.hpp"

namespace isograsp {

/// What the emulator offers to its sensors.
class EmulatorWorld {
 public:
  virtual ~EmulatorWorld() = default;
  /// Frames of one sample, in order; faults may act on them.
  virtual void send_sample(std::size_t finger, Timestamp when,
                           std::span<const BusFrame> frames) = 0;
  /// An answer to a command, some time after `now`.
  virtual void send_answer(std::size_t finger, Timestamp now, std::span<const BusFrame> frames) = 0;
  /// The wrench at the sensor at `play_s` of the play, in the sensor frame [N, N m]: after drift
  /// and overload faults, before noise.
  [[nodiscard]] virtual Wrench feel(std::size_t finger, double play_s) = 0;
  /// A whole number of counts, uniform within plus or minus the noise of the emulator; 0: none.
  [[nodiscard]] virtual int noise_counts() = 0;
  /// True: the low-pass of a real sensor acts. False: the wrenches of a file are played unchanged.
  [[nodiscard]] virtual bool filtered() const = 0;
  [[nodiscard]] virtual std::string serial_number(std::size_t finger) const = 0;
  /// True seconds per second of the sensor's own clock.
  [[nodiscard]] virtual double clock_factor(std::size_t finger) const = 0;
  /// Of the first measurement after a start, in periods, 0 … 1.
  [[nodiscard]] virtual double phase(std::size_t finger) const = 0;
};

class EmulatedSensor {
 public:
  explicit EmulatedSensor(std::size_t finger) noexcept : finger_(finger) {}
  virtual ~EmulatedSensor() = default;

  /// A frame from the bus; one that is no command to this sensor is ignored.
  virtual void receive(const BusFrame& frame, Timestamp now, EmulatorWorld& world) = 0;
  /// When it measures next by itself; Timestamp::max() while it does not.
  [[nodiscard]] virtual Timestamp next_measurement() const = 0;
  /// @pre now >= next_measurement()
  virtual void measure(EmulatorWorld& world) = 0;
  /// Power off and on: settings survive as in the real sensor, the rest does not.
  virtual void power_dip(Timestamp now, EmulatorWorld& world) = 0;
  /// Sends an answer without a question in the middle of a stream, if the family has such an
  /// answer.
  virtual void answer_unasked(Timestamp, EmulatorWorld&) {}
  /// Since when the play runs for this sensor; Timestamp::max(): not yet.
  [[nodiscard]] virtual Timestamp play_start() const = 0;

 protected:
  [[nodiscard]] std::size_t finger() const noexcept { return finger_; }

 private:
  std::size_t finger_;
};

}  // namespace isograsp
