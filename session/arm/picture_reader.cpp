// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/arm/picture_reader.hpp"

namespace isograsp::session {

Timestamp PictureReader::expected() const noexcept {
  return last_ + from_seconds(static_cast<double>(frame_ - last_frame_) * period_s_);
}

bool PictureReader::next() noexcept {
  ++frame_;
  has_picture_ = false;
  while (!waiting_) {
    switch (device_.read(expected() + from_seconds(kPatience_s), sample_)) {
      case ReadStatus::finished: return false;
      case ReadStatus::timeout: stamp_ = expected(); return true;
      case ReadStatus::sample: break;
    }
    if (!first_number_) first_number_ = sample_.number - frame_;
    waiting_ = sample_.number >= *first_number_ + frame_;  // else too late: its frame has passed
  }
  has_picture_ = sample_.number == *first_number_ + frame_;
  if (has_picture_) {
    waiting_ = false;
    last_ = sample_.stamp;
    last_frame_ = frame_;
  }
  stamp_ = has_picture_ ? sample_.stamp : expected();
  return true;
}

}  // namespace isograsp::session
