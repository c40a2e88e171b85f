// SPDX-License-Identifier: GPL-3.0-or-later
// Inside device/cameras/ only. What live systems share: pictures find their places, are counted and
// watched.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

#include "device/cameras/marker_device.hpp"
#include "device/cameras/picture_grid.hpp"
#include "device/cameras/picture_watch.hpp"

namespace isograsp {

/// Within so long a system must answer when it is opened.
inline constexpr Timestamp kMarkerPatience = std::chrono::seconds(5);
/// A system that is silent is asked again this often.
inline constexpr Timestamp kAskAgain = std::chrono::seconds(2);
/// Pictures that are looked at for the rate before measuring begins.
inline constexpr std::int64_t kLooks = 10;

/// The period that pictures show, where it differs from what the system says of itself by more than
/// this share; else that.
[[nodiscard]] inline double period_of(const PeriodEstimate& seen,
                                      std::optional<double> told_rate_Hz) {
  constexpr double kDiffers = 0.05;
  const auto period_s = seen.period_s();
  if (!told_rate_Hz) return period_s.value_or(MarkerDeviceInfo().period_s);
  if (period_s && std::abs(*period_s * *told_rate_Hz - 1.0) > kDiffers) return *period_s;
  return 1.0 / *told_rate_Hz;
}

/// Real-time safe.
struct LivePictures {
  PictureGrid grid;
  PictureWatch watch;
  MarkerCounters counters;

  void begin(Timestamp now, double period_s) {
    grid.begin(period_s);
    watch.begin(now, period_s);
    counters = {};
  }
  /// False: it was there already.
  [[nodiscard]] bool place(std::int64_t frame, double camera_s, Timestamp arrival,
                           std::span<const Vec3> p_W, MarkerSample& out) noexcept {
    const auto placed = grid.place(frame, camera_s, arrival);
    if (!placed) {
      ++counters.duplicate;
      return false;
    }
    ++counters.good;
    counters.lost += placed->lost;
    watch.picture(arrival, placed->lost);
    out = {placed->stamp, placed->number, p_W};
    return true;
  }
  /// What the stream has counted since start(); damage is told for a while.
  void count(std::uint64_t unlabelled, std::uint64_t damaged, Timestamp now) noexcept {
    if (unlabelled != counters.unlabelled || damaged != counters.damaged) watch.damage(now);
    counters.unlabelled = unlabelled;
    counters.damaged = damaged;
  }
};

/// Live systems run in real time.
[[nodiscard]] inline Result<void> require_real_time(const Clock& clock, const std::string& uri) {
  if (clock.is_virtual())
    return refused("cameras do not run in virtual time"_text,
                   "leave out --fast, or use sim:// or replay://"_text)
        .at(uri);
  return {};
}

}  // namespace isograsp
