// SPDX-License-Identifier: GPL-3.0-or-later
// From a device's samples to frames, one after the other: what both a session and the command line
// read.
#pragma once

#include <optional>

#include "core/time.hpp"
#include "device/sensors/force_device.hpp"
#include "device/sensors/frame_clock.hpp"

namespace isograsp {

class FrameReader {
 public:
  /// `device` streams on `clock`; the grid begins at `start`.
  FrameReader(ForceDevice& device, const Clock& clock, Timestamp start);

  /// Waits for the next frame; false: the device has finished. What has arrived is read before a
  /// value is called missing: after a pause of this computer frames are late, not empty. Real-time
  /// safe.
  [[nodiscard]] bool next(FingerFrame& frame) noexcept;

  [[nodiscard]] double period_s() const noexcept { return frames_.period_s(); }
  /// Of the sample that completed the frame; nothing: its time was up.
  [[nodiscard]] const std::optional<Timestamp>& completed_by() const noexcept {
    return completed_by_;
  }
  /// From the frame's grid instant to now.
  [[nodiscard]] double lateness_s(const FingerFrame& frame) const noexcept {
    return to_seconds(device_.now(clock_) - start_) - frame.t_s;
  }

 private:
  ForceDevice& device_;
  const Clock& clock_;
  Timestamp start_;
  FrameClock frames_;
  Timestamp newest_;  ///< every sample until then has been read
  std::optional<Timestamp> completed_by_;
};

}  // namespace isograsp
