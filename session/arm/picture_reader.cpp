// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/arm/picture_grid.hpp"

namespace isograsp::session {

Timestamp PictureGrid::expected() const noexcept {
  return last_ + from_seconds(static_cast<double>(frame_ - last_frame_) * period_s_);
}

bool PictureGrid::next() noexcept {
  ++frame_;
  has_picture_ = false;
  while (!waiting_) {
    switch (device_.read(expected() + from_seconds(kPatience_s), sample_)) {
      case ReadStatus::finished: return false;
      case ReadStatus::timeout:
        was_silent_ = true;
        stamp_ = expected();
        return true;
      case ReadStatus::sample: break;
    }
    // After silence cameras may count on from where they were: the grid goes on from here.
    const bool counts_anew = base_ && was_silent_ && sample_.number < *base_ + frame_;
    if (!base_ || counts_anew) base_ = sample_.number - frame_;
    if (sample_.number < *base_ + frame_) continue;  // too late: its frame has passed
    was_silent_ = false;
    waiting_ = true;
  }
  const std::int64_t number = *base_ + frame_;
  has_picture_ = sample_.number == number;
  if (has_picture_) {
    waiting_ = false;
    last_ = sample_.stamp;
    last_frame_ = frame_;
  }
  stamp_ = has_picture_ ? sample_.stamp : expected();
  return true;
}

}  // namespace isograsp::session
