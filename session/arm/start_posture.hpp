// SPDX-License-Identifier: GPL-3.0-or-later
// The start posture as a preparation: the arm is held still in the initial posture for a second;
// from its mean all references of the session are adapted to this arm (kinematics/postures.hpp).
#pragma once

#include <span>

#include "kinematics/postures.hpp"
#include "session/acquisition/apparatus.hpp"
#include "session/arm/arm_rig.hpp"

namespace isograsp::session {

/// PreparationRecord::kind.
inline constexpr const char* kStartPosture = "start_posture";

/// What a start posture must be.
struct StartPostureLimits {
  double duration_s = 1.0;
  double longest_s = 10.0;      ///< so long the whole chain is waited for
  double largest_sd_m = 0.003;  ///< an arm that moves has no start posture
};

class StartPostureCapture final : public Preparation {
 public:
  enum class Refusal : std::uint8_t { none, not_seen, moved };

  explicit StartPostureCapture(double period_s, double settle_s);

  /// One frame, the poses of kArmChain; true: it has ended. Real-time safe.
  [[nodiscard]] bool add(std::span<const Pose> X_W) noexcept;
  [[nodiscard]] double progress() const noexcept;
  [[nodiscard]] Refusal refusal() const noexcept { return refusal_; }
  /// @pre it has ended and was not refused
  [[nodiscard]] const StartPostureMean& mean() const noexcept { return mean_; }

  [[nodiscard]] PreparationOutcome outcome() const override;

 private:
  double period_s_;
  double wait_s_;
  double waited_s_ = 0.0;
  StartPostureMean mean_{kArmChain.size()};
  Refusal refusal_ = Refusal::none;
};

}  // namespace isograsp::session
