// SPDX-License-Identifier: GPL-3.0-or-later
// What a JR3-class six-axis sensor makes of a wrench: low-pass, delay, noise, resolution, range.
// Pure: no clock, no I/O. Contact frame; SI units; axes in the order Fx Fy Fz Tx Ty Tz.
#pragma once

#include <array>
#include <cstdint>

#include "core/butterworth.hpp"
#include "core/random.hpp"
#include "core/spatial.hpp"
#include "hand/finger.hpp"

namespace isograsp {

/// Constants of the simulated sensor (docs/devices.md). Filter and pure delay together: 32 ms.
inline constexpr double kSensorModelRate_Hz = 1000.0;
inline constexpr double kSensorCutoff_Hz = 31.25;
inline constexpr double kSensorPureDelay_s = 0.0248;
inline constexpr double kSensorDelay_s = 0.032;     ///< of a slow signal; 7.2 ms are the filter's
inline constexpr double kSensorNoise_counts = 0.4;  ///< SD before quantisation
inline constexpr double kSaturatedFraction = 0.98;  ///< of the range of an axis
/// 0.04 0.04 0.08 N, 0.002 N m, or all of it in proportion for another step of Fz.
inline constexpr double kSensorStep_N = 0.08;
[[nodiscard]] Vec6 sensor_resolution(double fz_step_N = kSensorStep_N) noexcept;
[[nodiscard]] Vec6 sensor_range() noexcept;  ///< 150 150 300 N, 8 N m

/// One sensor. Same seed and input: same readings, bit for bit.
class SensorModel {
 public:
  struct Reading {
    Wrench wrench_C;  ///< a whole number of counts times the resolution
    RawCounts raw_counts{};
    std::uint8_t flags = 0;  ///< SampleFlag::saturated
  };

  explicit SensorModel(std::uint64_t seed, std::uint64_t stream = 0,
                       const Vec6& resolution = sensor_resolution());

  /// The wrench of the next millisecond. Real-time safe.
  void step(const Wrench& wrench_C) noexcept;
  /// What the sensor would send now. Real-time safe.
  [[nodiscard]] Reading read() noexcept;
  /// Filtered and delayed, before noise and quantisation. Real-time safe.
  [[nodiscard]] Vec6 delayed() const noexcept;

 private:
  // The delay is 24.8 samples: the value between the 24th and the 25th sample back is interpolated
  // linearly. That is exact for a straight line and costs 0.03 dB at the cut-off.
  static constexpr std::size_t kWholeSamples = 24;
  static constexpr double kFraction = 0.8;

  LowPass2 filter_;
  Vec6 resolution_;
  Vec6 x1_ = Vec6::Zero(), x2_ = Vec6::Zero(), y1_ = Vec6::Zero(), y2_ = Vec6::Zero();
  std::array<Vec6, kWholeSamples + 2> line_;  ///< ring of filtered values
  std::size_t newest_ = 0;
  Random noise_;
};

}  // namespace isograsp
