// SPDX-License-Identifier: GPL-3.0-or-later
// Inside device/emulator/ only. When the pictures of a play are due on our clock.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/time.hpp"
#include "device/emulator/marker_play.hpp"

namespace isograsp {

class MarkerTimer {
 public:
  explicit MarkerTimer(MarkerScene scene) : scene_(std::move(scene)) {}

  void begin(Timestamp now) {
    if (!began_) began_ = now;
  }
  /// Since the play began; negative before.
  [[nodiscard]] double play_s(Timestamp now) const noexcept {
    return began_ ? to_seconds(now - *began_) : -1.0;
  }
  /// Timestamp::max() before the play and after it.
  [[nodiscard]] Timestamp due() const noexcept {
    const auto next_s = scene_.next_s();
    return began_ && next_s ? *began_ + from_seconds(*next_s) : Timestamp::max();
  }
  [[nodiscard]] bool over() const noexcept { return began_ && !scene_.next_s(); }
  [[nodiscard]] std::vector<std::string> labels(Timestamp now) const {
    return scene_.labels(play_s(now));
  }
  [[nodiscard]] MarkerScene& scene() noexcept { return scene_; }
  [[nodiscard]] const MarkerScene& scene() const noexcept { return scene_; }

 private:
  MarkerScene scene_;
  std::optional<Timestamp> began_;
};

}  // namespace isograsp
