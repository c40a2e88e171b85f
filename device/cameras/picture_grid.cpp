// SPDX-License-Identifier: GPL-3.0-or-later
// A picture with stamp c on the cameras' clock that arrives at a was on its way for d = a - c + k,
// k unknown but constant. The smallest d so far is taken for the way without any waiting: the
// picture was taken at c - k' = a - (d - smallest d). Clocks drift: the smallest d follows slowly.
#include "device/cameras/picture_grid.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp {

namespace {

constexpr std::int64_t kReordered = 10;  ///< frames: a datagram overtakes no more others
constexpr double kBelievable_s = 1.0;    ///< between the count of frames and the time that passed
constexpr double kClockDrift = 100e-6;   ///< of two computers, at most
constexpr double kLateFor_s = 2.0;       ///< of pictures that come too late
constexpr double kWholeRate = 1e-3;      ///< relative

}  // namespace

void PictureGrid::begin(double period_s) noexcept {
  *this = {};
  period_s_ = period_s;
}

std::optional<PlacedPicture> PictureGrid::place(std::int64_t frame, double camera_s,
                                                Timestamp arrival) noexcept {
  if (first_) {
    first_ = false;
    origin_ = arrival_ = stamp_ = arrival;
    frame_ = frame;
    camera_s_ = camera_s;
    way_s_ = -camera_s;
    jitter_s_ = 0.0;
    return PlacedPicture{0, arrival, 0};
  }
  const double passed_s = to_seconds(arrival - arrival_);
  std::int64_t step = frame - frame_;
  if (step <= 0 && step > -kReordered) return std::nullopt;
  // Cameras count and tell time alike, and no picture comes from the future; one that waited here
  // until it was read may come much later than the last one.
  const double counted_s = static_cast<double>(step) * period_s_;
  const bool believed = step > 0 && std::abs(counted_s - (camera_s - camera_s_)) <= kBelievable_s &&
                        counted_s <= passed_s + kBelievable_s;
  if (!believed) step = std::max<std::int64_t>(1, std::llround(passed_s / period_s_));
  frame_ = frame;
  number_ += step;
  stamp_ = std::max(taken(camera_s, arrival, !believed), stamp_ + Timestamp{1});
  arrival_ = arrival;
  return PlacedPicture{number_, stamp_, static_cast<std::uint64_t>(step - 1)};
}

Timestamp PictureGrid::taken(double camera_s, Timestamp arrival, bool other_clock) noexcept {
  const double way_s = to_seconds(arrival - origin_) - camera_s;
  const double passed_s = std::max(0.0, camera_s - camera_s_);
  camera_s_ = camera_s;
  // Too late for too long: the cameras stood still and their clock with them.
  late_s_ = way_s - way_s_ > kBelievable_s ? late_s_ + period_s_ : 0.0;
  if (way_s < way_s_ || other_clock || late_s_ > kLateFor_s) {
    way_s_ = way_s;
    late_s_ = 0.0;
  } else {
    way_s_ += std::min(way_s - way_s_, kClockDrift * passed_s);
  }
  jitter_s_ = way_s - way_s_;
  return arrival - from_seconds(*jitter_s_);
}

void PeriodEstimate::add(std::int64_t frame, double camera_s) {
  if (!any_ || frame <= last_frame_ || camera_s <= last_s_) {
    any_ = true;
    first_frame_ = frame;
    first_s_ = camera_s;
  }
  last_frame_ = frame;
  last_s_ = camera_s;
}

std::optional<double> PeriodEstimate::period_s() const {
  if (!any_ || frames() < 1) return std::nullopt;
  const double rate_Hz = static_cast<double>(frames()) / (last_s_ - first_s_);
  const double whole_Hz = std::round(rate_Hz);
  return 1.0 / (whole_Hz >= 1.0 && std::abs(rate_Hz - whole_Hz) < kWholeRate * whole_Hz ? whole_Hz
                                                                                        : rate_Hz);
}

}  // namespace isograsp
