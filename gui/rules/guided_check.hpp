// SPDX-License-Identifier: GPL-3.0-or-later
// The guided check of the connected device, fed with what the session publishes. No widget.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "device/sensors/device_check.hpp"
#include "session/platform/snapshot.hpp"

namespace isograsp::gui {

class GuidedCheck {
 public:
  enum class State : std::uint8_t {
    idle,      ///< not begun, or stopped
    empty,     ///< everything is to be taken off; what the device shows becomes its zero
    pressing,  ///< a support is to be pressed
    over
  };

  /// `hand`: for which the platform stands. What an earlier check found is forgotten.
  void begin(double frame_period_s, Hand hand, std::int64_t frames);
  void stop();
  /// The newest snapshot. Snapshots may skip frames: each counts for the time since the one before.
  /// @return something changed that is shown.
  bool look(const session::Snapshot& snapshot);

  [[nodiscard]] State state() const noexcept { return state_; }
  /// What to do now, for the therapist. @pre state() is empty or pressing
  [[nodiscard]] Text instruction() const;
  /// @pre state() == pressing
  [[nodiscard]] const CheckStep& step() const { return check_->step(); }
  [[nodiscard]] std::vector<CheckResult> results() const;
  [[nodiscard]] bool passed() const noexcept { return check_ != nullptr && check_->passed(); }
  /// "Guided check passed.", or the first thing that was wrong. @pre state() == over
  [[nodiscard]] Text outcome() const;

 private:
  State state_ = State::idle;
  std::unique_ptr<DeviceCheck> check_;
  std::int64_t frames_ = 0;  ///< of the newest snapshot
};

}  // namespace isograsp::gui
