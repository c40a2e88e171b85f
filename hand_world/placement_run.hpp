// SPDX-License-Identifier: GPL-3.0-or-later
// Placements of a person in software without a session: a tracker sees their hand, the virtual hand
// grasps, the object is brought to its target, held, let go (docs/virtual_hand.md, "The simulated
// study"). In virtual time; the same person gives the same bits. SI units.
#pragma once

#include <optional>
#include <vector>

#include "hand/hand_source.hpp"
#include "hand_world/assisted_grasp.hpp"
#include "virtual_hand/placement.hpp"
#include "virtual_hand/study_plan.hpp"

namespace isograsp::hand_world {

struct PlacementResult {
  virtual_hand::PlacementScore score;
  double lost_share = 0.0;          ///< of its frames, in which the hand was not seen
  std::optional<double> release_s;  ///< from purple until nothing holds it; nothing: not completed
  bool helped = false;              ///< it was let go for them after kLongestRelease_s
  int strays = 0;                   ///< times that it was put back as it had rolled out of reach
  /// Held while the tracked hand was open already, longest time on end (PlacementRun::kOpen_m).
  double held_open_s = 0.0;
  double residual_m_s = 0.0;  ///< of the contact solver, largest
};

class PlacementRun {
 public:
  static constexpr double kFrame_s = 0.01;
  static constexpr double kLongest_s = 60.0;         ///< of a placement: then it is not completed
  static constexpr double kLongestRelease_s = 10.0;  ///< then the object lets go by itself
  static constexpr double kPause_s = 1.0;            ///< between placements
  /// An object that nothing holds so far from where it stood is put back: it was knocked away and
  /// rolls. It was not held, so that is no drop.
  static constexpr double kOutOfReach_m = 0.3;
  /// A hand is open where its skin is at least so much farther apart than the object is wide.
  static constexpr double kOpen_m = 0.02;

  /// `hand`: the virtual one. Both outlive the run.
  PlacementRun(const virtual_hand::HandModel& hand, HandSource& person);

  [[nodiscard]] PlacementResult place(const virtual_hand::StudyObject& object,
                                      const virtual_hand::StudyTarget& target,
                                      AssistanceLevel level);
  /// Processor time of each frame so far, for each step of the world [s].
  [[nodiscard]] const std::vector<double>& step_times_s() const noexcept { return step_times_s_; }

 private:
  /// One frame: what the person sees, what their hand does.
  void frame(const Stimulus& picture);
  [[nodiscard]] double tracked_gap_m() const noexcept;

  HandSource& person_;
  AssistedGrasp grasp_;
  HandFrame hand_;  ///< as seen last
  bool held_ = false;
  std::int64_t frame_ = 0;
  std::vector<double> step_times_s_;
};

}  // namespace isograsp::hand_world
