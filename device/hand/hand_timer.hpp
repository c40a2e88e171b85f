// SPDX-License-Identifier: GPL-3.0-or-later
// Inside device/hand/ only. When the frames of a play are due on our clock.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "core/time.hpp"
#include "device/hand/hand_play.hpp"

namespace isograsp {

class HandTimer {
 public:
  explicit HandTimer(HandScene scene) : scene_(std::move(scene)) {}

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
  [[nodiscard]] HandScene& scene() noexcept { return scene_; }
  [[nodiscard]] const HandScene& scene() const noexcept { return scene_; }

 private:
  HandScene scene_;
  std::optional<Timestamp> began_;
};

/// The part of a message that comes where it breaks off.
[[nodiscard]] inline std::string cut_off(std::string message) {
  message.resize(message.size() / 2);
  return message;
}

}  // namespace isograsp
