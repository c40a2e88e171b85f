// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/simulated/sensor_model.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp {

Vec6 sensor_resolution(double fz_step_N) noexcept {
  const Vec6 usual = (Vec6() << 0.04, 0.04, kSensorStep_N, 0.002, 0.002, 0.002).finished();
  return usual * (fz_step_N / kSensorStep_N);
}

Vec6 sensor_range() noexcept {
  return (Vec6() << 150, 150, 300, 8, 8, 8).finished();
}

SensorModel::SensorModel(std::uint64_t seed, std::uint64_t stream, const Vec6& resolution)
    : filter_(butterworth2(kSensorModelRate_Hz, kSensorCutoff_Hz)),
      resolution_(resolution),
      noise_(seed, stream) {
  line_.fill(Vec6::Zero());
}

void SensorModel::step(const Wrench& wrench_C) noexcept {
  Vec6 x;
  x << wrench_C.force, wrench_C.torque;
  const Vec6 y =
      filter_.b0 * x + filter_.b1 * x1_ + filter_.b2 * x2_ - filter_.a1 * y1_ - filter_.a2 * y2_;
  x2_ = x1_;
  x1_ = x;
  y2_ = y1_;
  y1_ = y;
  newest_ = (newest_ + 1) % line_.size();
  line_[newest_] = y;
}

Vec6 SensorModel::delayed() const noexcept {
  const auto back = [this](std::size_t samples) -> const Vec6& {
    return line_[(newest_ + line_.size() - samples) % line_.size()];
  };
  return (1.0 - kFraction) * back(kWholeSamples) + kFraction * back(kWholeSamples + 1);
}

SensorModel::Reading SensorModel::read() noexcept {
  const Vec6 exact = delayed();
  const Vec6& resolution = resolution_;
  const Vec6 range = sensor_range();
  Reading reading;
  Vec6 measured;
  for (Eigen::Index axis = 0; axis < 6; ++axis) {
    const double noisy = exact[axis] + kSensorNoise_counts * resolution[axis] * noise_.gaussian();
    const double clipped = std::clamp(noisy, -range[axis], range[axis]);
    const auto counts = static_cast<std::int32_t>(std::lround(clipped / resolution[axis]));
    reading.raw_counts[static_cast<std::size_t>(axis)] = counts;
    measured[axis] = counts * resolution[axis];
    if (std::abs(measured[axis]) >= kSaturatedFraction * range[axis])
      reading.flags |= bit(SampleFlag::saturated);
  }
  reading.wrench_C.force = measured.head<3>();
  reading.wrench_C.torque = measured.tail<3>();
  return reading;
}

}  // namespace isograsp
