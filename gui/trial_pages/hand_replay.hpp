// SPDX-License-Identifier: GPL-3.0-or-later
// A stored trial of a tracked hand at any instant: the frame that both screens showed, from its row
// again; nothing is put between two rows. World of the tracker; SI units.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gui/trial_pages/grasp_story.hpp"
#include "gui/trial_pages/recorded_values.hpp"
#include "gui/trial_pages/trial_replay.hpp"
#include "session/tracked_hand/hand_snapshot.hpp"
#include "storage/records/session_store.hpp"
#include "virtual_hand/hand_model.hpp"

namespace isograsp::gui {

/// The hand as it was measured for this trial; of usual size where none was.
[[nodiscard]] Result<virtual_hand::HandModel> hand_of_trial(storage::SessionStore& store,
                                                            const storage::SessionRecord& session,
                                                            const storage::TrialRecord& trial,
                                                            const std::string& library);

class HandReplay {
 public:
  [[nodiscard]] static bool is_of_hand(const TrialReplay& replay) noexcept;
  /// `task`: for the height of the table; null: its text cannot be read. @pre is_of_hand(replay)
  HandReplay(const TrialReplay& replay, virtual_hand::HandModel hand, const tasks::TaskSpec* task);

  /// The task was about a virtual object.
  [[nodiscard]] bool has_object() const noexcept { return object_.position[0].has_value(); }
  /// Why each digit was tied and let go.
  [[nodiscard]] const std::vector<GraspEvent>& story() const noexcept { return story_; }
  /// What was shown then. In a gap the hand is not seen. @pre `state` is of `replay`, which this
  /// was made of
  [[nodiscard]] session::HandSnapshot at(const TrialReplay& replay, const ReplayState& state) const;

 private:
  struct HandPlaces {
    PosePlaces palm;
    std::array<std::array<Place, virtual_hand::kAngleCount>, kDigitCount> angles;
  };
  struct DigitPlaces {
    Place state, pull_N, touch_N, gap_m;
  };
  [[nodiscard]] static std::optional<virtual_hand::HandPose> hand_at(const Signals& signals,
                                                                     const HandPlaces& places,
                                                                     std::size_t row);
  void find(const Signals& signals);
  [[nodiscard]] tasks::HandView task_at(const Signals& signals, std::size_t row) const;
  [[nodiscard]] hand_world::GraspState grasp_at(const Signals& signals, std::size_t row) const;

  virtual_hand::HandModel hand_;
  double table_m_ = 0.0;
  std::vector<GraspEvent> story_;
  HandPlaces seen_, virtual_;
  PosePlaces object_, target_;
  std::array<DigitPlaces, kDigitCount> digits_;
  ChoicePlaces choice_;
  Place pause_cause_, unseen_s_, gap_m_, placement_, study_object_, assistance_, eased_, fails_,
      let_go_asked_, helped_, held_, supported_, release_N_, tracked_gap_m_;
};

}  // namespace isograsp::gui
