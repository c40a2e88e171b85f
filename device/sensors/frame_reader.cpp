// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/sensors/frame_reader.hpp"

#include <algorithm>

namespace isograsp {

FrameReader::FrameReader(ForceDevice& device, const Clock& clock, Timestamp start)
    : device_(device),
      clock_(clock),
      start_(start),
      frames_(device.info().frame_period_s, device.info().sample_period_s, device.info().on_grid,
              start),
      newest_(start) {}

bool FrameReader::next(FingerFrame& frame) noexcept {
  // A slot is closed by the stamps of the samples, not by the clock: the two agree only when no
  // sample waits to be read.
  while (!frames_.pop(newest_, frame)) {
    SensorSample sample;
    switch (device_.read(frames_.deadline(), sample)) {
      case ReadStatus::sample:
        frames_.push(sample);
        newest_ = std::max(newest_, sample.stamp - Timestamp{1});  // equal stamps may still wait
        completed_by_ = sample.stamp;
        break;
      case ReadStatus::timeout:
        newest_ = std::max(newest_, device_.now(clock_));
        completed_by_.reset();
        break;
      case ReadStatus::finished: return false;
    }
  }
  return true;
}

}  // namespace isograsp
