// SPDX-License-Identifier: GPL-3.0-or-later
// Do two empty platforms move each other? One is pressed, then the other; what the other one feels
// is compared. Above the limit what is measured of one hand is partly of the other, and a share of
// either means nothing. Deterministic, no clock, no widget.
#pragma once

#include <optional>
#include <vector>

#include "hand/hands.hpp"
#include "session/two_platforms/two_platforms_snapshot.hpp"
#include "storage/records/profile.hpp"

namespace isograsp::gui {

class CrossTalkCheck {
 public:
  static constexpr double kPress_N = 20.0;           ///< at least, on the platform that is pressed
  static constexpr double kMostMoved_percent = 1.0;  ///< that the other one may feel of it
  static constexpr double kPress_s = 0.5;            ///< so long
  enum class State : std::uint8_t { idle, press_left, press_right, over, skipped };
  /// What came of pressing one platform.
  struct Way {
    double pressed_N = 0.0;      ///< mean net push on it
    double moved_percent = 0.0;  ///< of that, what the other one felt, from what it felt before
  };

  void begin() noexcept;  ///< whatever was found before is forgotten
  void stop() noexcept;   ///< nothing is found
  void skip() noexcept;
  /// Takes the snapshot if it is a new frame. @return something changed that is shown.
  bool add(const session::TwoPlatformsSnapshot& now) noexcept;

  [[nodiscard]] State state() const noexcept { return state_; }
  [[nodiscard]] bool running() const noexcept {
    return state_ == State::press_left || state_ == State::press_right;
  }
  /// Both ways are measured, or it is said that they are not.
  [[nodiscard]] bool settled() const noexcept {
    return state_ == State::over || state_ == State::skipped;
  }
  /// Of the platform that was pressed; nothing: it was not.
  [[nodiscard]] const OfHands<std::optional<Way>>& ways() const noexcept { return ways_; }
  /// One moves the other by more than the limit; nothing: not measured.
  [[nodiscard]] std::optional<bool> coupled() const noexcept;
  /// The larger of both ways [%]. @pre state() == over
  [[nodiscard]] double moved_percent() const noexcept;

 private:
  struct Mean {
    Vec3 sum = Vec3::Zero();
    int frames = 0;
    void add(const Vec3& value) noexcept;
    [[nodiscard]] Vec3 value() const noexcept;
  };
  void begin_way(State state) noexcept;

  State state_ = State::idle;
  OfHands<std::optional<Way>> ways_;
  double last_s_ = -1.0;
  std::optional<double> since_s_;  ///< of the press
  Mean before_;                    ///< of the other platform, while nobody presses
  Mean pressed_;
  Mean felt_;
};

/// As stored with the session. @pre check.settled()
[[nodiscard]] std::vector<storage::SessionAnswer> stored(const CrossTalkCheck& check);

}  // namespace isograsp::gui
