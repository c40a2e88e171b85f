// SPDX-License-Identifier: GPL-3.0-or-later
// One platform of three sensors as a session reads it: frames on one grid, less the zero that was
// measured, with the last values in place of missing ones. Frames of contact, SI units.
//
// Order of calls: start() -> begin() -> next(), measure() while a zero is taken, receive() … ->
// stop(). The owner's functions before the threads of the session begin or after their end; those
// that say so are real-time safe and belong to the acquisition thread.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/result.hpp"
#include "core/time.hpp"
#include "device/sensors/force_device.hpp"
#include "device/sensors/frame_reader.hpp"
#include "hand/stale.hpp"
#include "session/acquisition/apparatus.hpp"
#include "session/platform/instrument_zero.hpp"

namespace isograsp::session {

class PlatformReader {
 public:
  explicit PlatformReader(std::unique_ptr<ForceDevice> device);

  [[nodiscard]] const DeviceInfo& info() const noexcept { return device_->info(); }
  /// Coarsest step of a force component; nothing: the device has no counts.
  [[nodiscard]] std::optional<double> resolution_N() const noexcept;
  /// How counts became forces, a line a finger; empty if the device has no counts.
  [[nodiscard]] std::string calibration() const;
  /// The device begins to stream on `clock`, which outlives it.
  [[nodiscard]] Result<void> start(Clock& clock);
  /// On the axis of its stamps.
  [[nodiscard]] Timestamp now() const noexcept { return device_->now(*clock_); }
  /// The grid of frames begins at `start`. @pre start() was
  void begin(Timestamp start);
  void stop() noexcept;
  /// Of the same device in an earlier session. Before the first zero of this one.
  void set_last_zero(const SixAxes& mean) noexcept { last_zero_ = mean; }

  // Every frame, in this order. Real-time safe.
  /// Waits for the next frame; false: no frame will come.
  [[nodiscard]] bool next(FingerFrame& frame) noexcept { return frames_->next(frame); }
  /// Adds the frame, as it came, to a zero that is taken; true: that has ended, and
  /// InstrumentZero::refusal says how. It is not in force before accept().
  [[nodiscard]] bool measure(InstrumentZero& zero, const FingerFrame& frame) noexcept;
  /// Subtracts the zero and applies the stale rule to the fingers that are `used`.
  [[nodiscard]] Reception receive(FingerFrame& frame,
                                  const std::array<bool, kFingerCount>& used) noexcept;

  // When it is asked for. Real-time safe.
  void begin(InstrumentZero& zero) noexcept;
  /// The zero that measure() has found good is in force from now on.
  void accept(const InstrumentZero& zero) noexcept;

  // Of the newest frame. Real-time safe.
  [[nodiscard]] bool zeroed() const noexcept { return zero_.has_value(); }
  [[nodiscard]] const DeviceHealth& health() const noexcept { return health_; }
  /// Looks at the device again: when no further frame comes.
  void look() noexcept { health_ = device_->health(); }
  /// Whose sensor has started anew since the zero was measured: it is older than the restart.
  [[nodiscard]] std::optional<Finger> restarted() const noexcept { return restarted_; }
  /// Different faults have different numbers, below kFaultNumbers.
  [[nodiscard]] ApparatusFault fault() const noexcept;
  static constexpr int kFaultNumbers = static_cast<int>(kDeviceFaultCount * (1 + kFingerCount));
  /// From the instant of the frame to now.
  [[nodiscard]] double lateness_s(const FingerFrame& frame) const noexcept {
    return frames_->lateness_s(frame);
  }
  /// Stamp of the sample that completed the frame; nothing: its time was up.
  [[nodiscard]] const std::optional<Timestamp>& completed_by() const noexcept {
    return frames_->completed_by();
  }

 private:
  void judge(InstrumentZero& zero) const noexcept;
  void watch_restarts() noexcept;
  void subtract_zero(FingerFrame& frame) const noexcept;
  [[nodiscard]] Reception::Sight hold_missing(FingerFrame& frame,
                                              const std::array<bool, kFingerCount>& used) noexcept;

  std::unique_ptr<ForceDevice> device_;
  const Clock* clock_ = nullptr;
  std::optional<FrameReader> frames_;  ///< once the grid has begun
  bool streaming_ = false;
  StaleRule stale_;
  DeviceHealth health_;
  std::optional<SixAxes> last_zero_;  ///< of an earlier session
  std::optional<SixAxes> zero_;       ///< in force; nothing: none yet
  std::array<std::uint64_t, kFingerCount> restarts_at_zero_{};
  std::optional<Finger> restarted_;
};

}  // namespace isograsp::session
