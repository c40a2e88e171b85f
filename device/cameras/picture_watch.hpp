// SPDX-License-Identifier: GPL-3.0-or-later
// Inside device/cameras/ only. Whether pictures come, as all devices of markers judge it.
#pragma once

#include <algorithm>
#include <optional>

#include "core/time.hpp"
#include "device/cameras/marker_device.hpp"

namespace isograsp {

/// Real-time safe.
class PictureWatch {
 public:
  /// Without a picture for longer the cameras are silent: as long as the last value may stand in.
  static constexpr Timestamp kSilence = std::chrono::milliseconds(50);
  /// How long damage is told.
  static constexpr Timestamp kRecent = std::chrono::seconds(1);

  void begin(Timestamp now, double period_s) {
    constexpr double kPeriods = 1.5;  // of slow cameras: one picture may be late by a half
    patience_ = std::max(kSilence, from_seconds(kPeriods * period_s));
    last_picture_ = now;
    last_damage_.reset();
  }
  /// A picture came; `lost` before it did not.
  void picture(Timestamp now, std::uint64_t lost) noexcept {
    last_picture_ = now;
    if (lost > 0) last_damage_ = now;
  }
  void damage(Timestamp now) noexcept { last_damage_ = now; }
  [[nodiscard]] bool silent(Timestamp now) const noexcept {
    return now - last_picture_ > patience_;
  }
  /// silence, damaged_samples or none.
  [[nodiscard]] MarkerFault fault(Timestamp now) const noexcept {
    if (silent(now)) return MarkerFault::silence;
    return last_damage_ && now - *last_damage_ < kRecent ? MarkerFault::damaged_samples
                                                         : MarkerFault::none;
  }
  /// Streaming, degraded or faulted, as the fault says.
  static void set(MarkerHealth& health, MarkerFault fault) noexcept {
    health.fault = fault;
    health.state = fault == MarkerFault::none ? DeviceState::streaming
                   : stops_markers(fault)     ? DeviceState::faulted
                                              : DeviceState::degraded;
  }

 private:
  Timestamp patience_ = kSilence;
  Timestamp last_picture_{0};
  std::optional<Timestamp> last_damage_;
};

}  // namespace isograsp
