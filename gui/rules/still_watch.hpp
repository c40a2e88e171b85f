// SPDX-License-Identifier: GPL-3.0-or-later
// Whether an arm could be measured as a start posture now: the light beside the button. The same
// rule as that of the measurement (session/arm/start_posture.hpp), on what was seen in its last
// second. Deterministic, no clock.
#pragma once

#include <array>
#include <deque>

#include "session/arm/arm_snapshot.hpp"

namespace isograsp::gui {

class StillWatch {
 public:
  enum class State : std::uint8_t {
    unseen,  ///< a part of the chain is not in sight
    moving,  ///< or not seen for long enough yet
    still
  };

  /// Takes a snapshot if it is a new frame.
  void add(const session::ArmSnapshot& now);
  [[nodiscard]] State state() const noexcept { return state_; }
  /// Of session::kArmChain: what was not in sight.
  [[nodiscard]] const std::array<bool, session::kArmChain.size()>& unseen() const noexcept {
    return unseen_;
  }

 private:
  struct Row {
    double t_s = 0.0;
    std::array<Pose, session::kArmChain.size()> X_W;
  };
  std::deque<Row> rows_;  ///< of the last second, without a gap
  double last_s_ = -1.0;
  State state_ = State::unseen;
  std::array<bool, session::kArmChain.size()> unseen_{true, true, true, true};
};

}  // namespace isograsp::gui
