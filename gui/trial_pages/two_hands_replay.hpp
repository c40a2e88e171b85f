// SPDX-License-Identifier: GPL-3.0-or-later
// A stored trial of both hands at any instant: what was asked of them and what of it was on the
// screen, from its row again. SI units.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "bimanual/read_hands.hpp"
#include "gui/picture/target_preview.hpp"
#include "gui/trial_pages/recorded_values.hpp"
#include "gui/trial_pages/trial_replay.hpp"
#include "session/two_platforms/two_platforms_snapshot.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::gui {

class TwoHandsReplay {
 public:
  [[nodiscard]] static bool is_of_two_hands(const TrialReplay& replay) noexcept;
  /// `scene`: the text of that of the trial; empty: it has no object. `task`: null if it is not
  /// known. @pre is_of_two_hands(replay)
  TwoHandsReplay(const TrialReplay& replay, const std::string& scene, const tasks::TaskSpec* task);

  /// What was asked at most, and of which hand in which part: bars stand as they stood live.
  [[nodiscard]] const std::shared_ptr<const TargetPreview>& preview() const noexcept {
    return preview_;
  }
  /// What was shown then; in a gap, or where samples are missing, no force.
  /// @pre `state` is of `replay`, which this was made of
  [[nodiscard]] session::TwoPlatformsSnapshot at(const TrialReplay& replay,
                                                 const ReplayState& state) const;

 private:
  struct HandPlaces {
    Place force_N, target_N, cue, force_shown;
  };
  [[nodiscard]] tasks::TwoHandsView asked_at(const Signals& signals, std::size_t row) const;
  void look_ahead(const Signals& signals);

  /// The object that both lift, and what was asked of it. @pre scene_
  [[nodiscard]] session::LiftedView lifted_at(const Signals& signals, std::size_t row) const;
  [[nodiscard]] session::CarriedView carried_at(const Signals& signals, std::size_t row) const;
  [[nodiscard]] tasks::MovedView moved_at(const Signals& signals, std::size_t row) const;

  OfHands<HandPlaces> of_;
  std::optional<bimanual::HandsScene> scene_;  ///< nothing: the trial has no object
  tasks::PoseTolerance band_;
  int lifts_ = 0;
  bool carries_ = false;  ///< the object is carried, not lifted
  Place target_sum_N_, sum_shown_, segment_, cue_;
  std::shared_ptr<const TargetPreview> preview_;
};

}  // namespace isograsp::gui
