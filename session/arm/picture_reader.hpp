// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of cameras as the frames of a session, by their places in the grid of the cameras: a
// picture that was lost leaves its frame empty, and a stream that falls silent does not stop the
// frames.
#pragma once

#include <cstdint>
#include <optional>

#include "core/time.hpp"
#include "device/cameras/marker_device.hpp"

namespace isograsp::session {

class PictureReader {
 public:
  /// A picture that does not come is waited for this long beyond its time: longer than a network
  /// delays one, no longer than what counts as silence.
  static constexpr double kPatience_s = 0.05;

  PictureReader(MarkerDevice& device, double period_s, Timestamp start) noexcept
      : device_(device), period_s_(period_s), last_(start) {}

  /// The next frame; false: there will be none any more. Real-time safe.
  [[nodiscard]] bool next() noexcept;

  /// Time of the frame since the first one [s].
  [[nodiscard]] double t_s() const noexcept { return static_cast<double>(frame_) * period_s_; }
  /// Its picture; null: there is none.
  [[nodiscard]] const MarkerSample* picture() const noexcept {
    return has_picture_ ? &sample_ : nullptr;
  }
  /// When it was taken, or should have been.
  [[nodiscard]] Timestamp stamp() const noexcept { return stamp_; }

 private:
  [[nodiscard]] Timestamp expected() const noexcept;

  MarkerDevice& device_;
  double period_s_;
  Timestamp last_;               ///< stamp of the newest picture, or the start
  std::int64_t last_frame_ = 0;  ///< its frame
  std::int64_t frame_ = -1;
  std::optional<std::int64_t> first_number_;  ///< of the picture that belongs to frame 0
  MarkerSample sample_;
  bool waiting_ = false;      ///< sample_ belongs to a later frame
  bool has_picture_ = false;  ///< sample_ belongs to this one
  Timestamp stamp_{0};
};

}  // namespace isograsp::session
