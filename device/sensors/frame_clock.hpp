// SPDX-License-Identifier: GPL-3.0-or-later
// Three free-running sensors to one strict grid of frames. Pure: no clock, no I/O, no allocation.
#pragma once

#include <array>
#include <cstdint>

#include "core/time.hpp"
#include "device/sensors/force_device.hpp"
#include "hand/finger.hpp"

namespace isograsp {

/// Grid point k lies at start + k * period. A sensor's value there is its sample at that instant.
/// For sensors that are not on the grid it is the linear interpolation between the valid samples
/// before and after, if these are at most two sensor periods apart (and 10 % for jitter). Otherwise
/// the value is missing, never invented. hand/stale.hpp holds values and freezes.
class FrameClock {
 public:
  FrameClock(double frame_period_s, double sample_period_s, bool on_grid, Timestamp start) noexcept;

  /// Takes a sample; those of one finger in the order of their stamps. Real-time safe.
  void push(const SensorSample& sample) noexcept;

  /// Closes the next slot if every finger is known there or `now` has passed its deadline.
  /// Real-time safe. The fingers that have no value are flagged missing.
  [[nodiscard]] bool pop(Timestamp now, FingerFrame& frame) noexcept;

  /// When pop() would close the next slot at the latest.
  [[nodiscard]] Timestamp deadline() const noexcept;
  /// Instant of the next grid point.
  [[nodiscard]] Timestamp slot_time() const noexcept { return time_of(slot_); }
  [[nodiscard]] double period_s() const noexcept { return frame_period_s_; }
  /// Samples that came after their slot was closed.
  [[nodiscard]] std::uint64_t late() const noexcept { return late_; }

 private:
  struct Track {
    SensorSample before{};  ///< newest sample at or before the slot
    bool has_before = false;
    std::array<SensorSample, 16> after{};  ///< samples after `before`, oldest first
    std::size_t count = 0;
    [[nodiscard]] SensorSample& last() noexcept { return after[count - 1]; }
  };
  [[nodiscard]] Timestamp time_of(std::int64_t slot) const noexcept;
  /// True if the finger's value at the slot is settled (known or known to be missing).
  [[nodiscard]] bool settled(const Track& track) const noexcept;
  /// Number of the grid point next to `stamp`; of the first one at or after it.
  [[nodiscard]] std::int64_t nearest_slot(Timestamp stamp) const noexcept;
  [[nodiscard]] std::int64_t interval(Timestamp stamp) const noexcept;
  /// Writes the finger's value at the slot into the frame.
  void close(const Track& track, FingerFrame& frame, std::size_t finger) const noexcept;
  /// Drops what a new slot no longer needs.
  void advance(Track& track) const noexcept;

  double frame_period_s_;
  double sample_period_s_;
  bool on_grid_;
  Timestamp start_;
  std::int64_t slot_ = 0;
  std::uint64_t late_ = 0;
  std::array<Track, kFingerCount> tracks_{};
};

}  // namespace isograsp
