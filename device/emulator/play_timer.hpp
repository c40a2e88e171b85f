// SPDX-License-Identifier: GPL-3.0-or-later
// For emulators only: when the pictures of a play are due on our clock, and when it breaks its
// connections.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/time.hpp"

namespace isograsp {

/// `Scene` gives a picture after the other: next_s(), nothing at the end, and take().
template <class Scene>
class PlayTimer {
 public:
  explicit PlayTimer(Scene scene) : scene_(std::move(scene)) {}

  /// At this instant of the play all connections are broken.
  void close_at(double play_s) {
    closings_s_.insert(std::upper_bound(closings_s_.begin(), closings_s_.end(), play_s), play_s);
  }
  void begin(Timestamp now) {
    if (!began_) began_ = now;
  }
  /// Since the play began; negative before.
  [[nodiscard]] double play_s(Timestamp now) const noexcept {
    return began_ ? to_seconds(now - *began_) : -1.0;
  }
  /// Of the next picture. Timestamp::max() before the play and after it.
  [[nodiscard]] Timestamp due() const noexcept { return instant(scene_.next_s()); }
  /// Of the next closing, likewise.
  [[nodiscard]] Timestamp closing() const noexcept {
    return instant(closings_s_.empty() ? std::nullopt : std::optional(closings_s_.front()));
  }
  /// Whether a closing has come since this was asked before.
  [[nodiscard]] bool closes(Timestamp now) {
    const auto coming = std::upper_bound(closings_s_.begin(), closings_s_.end(), play_s(now));
    const bool any = coming != closings_s_.begin();
    closings_s_.erase(closings_s_.begin(), coming);
    return any;
  }
  [[nodiscard]] bool over() const noexcept { return began_ && !scene_.next_s(); }
  [[nodiscard]] Scene& scene() noexcept { return scene_; }
  [[nodiscard]] const Scene& scene() const noexcept { return scene_; }

 private:
  [[nodiscard]] Timestamp instant(std::optional<double> play_s) const noexcept {
    return began_ && play_s ? *began_ + from_seconds(*play_s) : Timestamp::max();
  }

  Scene scene_;
  std::vector<double> closings_s_;  ///< that are still to come, in order
  std::optional<Timestamp> began_;
};

}  // namespace isograsp
