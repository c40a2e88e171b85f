// SPDX-License-Identifier: GPL-3.0-or-later
// A hand before a tracker that does what a test says, with the joints of a whole hand.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "core/files.hpp"
#include "hand/hand_source.hpp"
#include "tests/support/must.hpp"
#include "virtual_hand/hand_model.hpp"
#include "virtual_hand/hand_pose.hpp"

namespace isograsp::test {

/// A hand of usual size.
inline virtual_hand::HandModel usual_hand(Hand side = Hand::right) {
  const std::string path = std::string(ISOGRASP_SOURCE_DIR) + "/library/hands/default.toml";
  virtual_hand::HandModel hand = must(virtual_hand::parse_hand(must(read_text(path)), path));
  hand.side = side;
  return hand;
}

/// Above the tracker, `open` from 0 (a fist) to 1 (spread); a slow wave makes no picture the same.
inline virtual_hand::HandPose hand_posture(double open, double t_s) {
  virtual_hand::HandPose pose;
  pose.X_WP.p = Vec3(0.0, 0.2 + 1e-4 * std::sin(t_s), 0.1);
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    const double bent = d == 0 ? 0.5 : 1.2;
    for (std::size_t k = 1; k < virtual_hand::kAngleCount; ++k)
      pose.angles[d][k] = bent * (1.0 - open);
  }
  return pose;
}

/// The picture of a hand; not tracked: no joint is given.
inline HandFrame picture_of(const virtual_hand::HandModel& hand, const virtual_hand::HandPose& pose,
                            bool tracked = true) {
  HandFrame frame;
  frame.side = hand.side;
  frame.tracked = tracked;
  frame.confidence = tracked ? 1.0 : 0.0;
  const auto joints = virtual_hand::joint_poses(virtual_hand::hand_in_space(hand, pose));
  for (std::size_t j = 0; j < kHandJointCount; ++j)
    frame.joints[j] =
        tracked ? joints[j].p : Vec3(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  return frame;
}

/// Opens and closes as the screen says, half a second after the cue, in half a second.
class ScriptedUser final : public HandSource {
 public:
  explicit ScriptedUser(Hand side = Hand::right) : hand_(usual_hand(side)) {}

  void see(const Stimulus& stimulus) noexcept override {
    if (stimulus.cue == seen_.cue) return;
    from_ = open_at(t_s_);
    since_s_ = t_s_;
    seen_ = stimulus;
  }
  [[nodiscard]] HandFrame at(double t_s) noexcept override {
    t_s_ = t_s;
    HandFrame frame = picture_of(hand_, hand_posture(open_at(t_s), t_s), !hidden || !hidden(t_s));
    if (flipped && flipped(t_s)) frame.side = hand_.side == Hand::right ? Hand::left : Hand::right;
    return frame;
  }
  /// When the tracker does not see it, or takes it for the other hand.
  std::function<bool(double t_s)> hidden;
  std::function<bool(double t_s)> flipped;
  double opens = 1.0;  ///< as far as it goes: 0 a fist

 private:
  [[nodiscard]] double open_at(double t_s) const noexcept {
    const double share = std::clamp((t_s - since_s_ - 0.5) / 0.5, 0.0, 1.0);
    const double to = seen_.cue == Cue::open ? opens : seen_.cue == Cue::close ? 0.0 : 0.3 * opens;
    return from_ + share * (to - from_);
  }

  virtual_hand::HandModel hand_;
  Stimulus seen_;
  double from_ = 0.3;
  double since_s_ = -10.0;
  double t_s_ = 0.0;
};

}  // namespace isograsp::test
