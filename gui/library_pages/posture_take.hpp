// SPDX-License-Identifier: GPL-3.0-or-later
// A posture of the arm that is connected, held still for a second: its mean, and how much it
// moved. The limits are those of the start posture (session/arm/start_posture.hpp); nothing of the
// session changes by it. Deterministic, no clock.
#pragma once

#include <vector>

#include "kinematics/postures.hpp"
#include "session/arm/arm_snapshot.hpp"

namespace isograsp::gui {

class PostureTake {
 public:
  enum class State : std::uint8_t {
    idle,
    running,
    taken,
    moved,    ///< it was not still
    not_seen  ///< the whole chain was not in sight for long enough
  };

  void begin();
  void stop() noexcept { state_ = State::idle; }
  /// Takes a snapshot if it is a new frame; true: it has ended with this one.
  bool add(const session::ArmSnapshot& now);

  [[nodiscard]] State state() const noexcept { return state_; }
  [[nodiscard]] bool running() const noexcept { return state_ == State::running; }
  /// 0 … 1
  [[nodiscard]] double progress() const noexcept;
  /// Largest standard deviation of a position [m]. @pre taken, or moved
  [[nodiscard]] double sd_m() const noexcept { return mean_.largest_sd_m(); }
  /// Links of session::kArmChain. @pre taken
  [[nodiscard]] std::vector<Pose> links() const { return mean_.mean().X_L; }

 private:
  State state_ = State::idle;
  StartPostureMean mean_{session::kArmChain.size()};
  double began_s_ = -1.0;  ///< session time; below 0: no frame yet
  double first_s_ = -1.0;  ///< the same of the rows of the mean
  double last_s_ = -1.0;
};

}  // namespace isograsp::gui
