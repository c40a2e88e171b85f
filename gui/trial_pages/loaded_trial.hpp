// SPDX-License-Identifier: GPL-3.0-or-later
// A stored trial made ready to be looked at: replay, object, path and words. Loading is for the
// worker; what it gives is never changed.
#pragma once

#include <QString>
#include <memory>
#include <vector>

#include "gui/picture/patient_picture.hpp"
#include "gui/trial_pages/arm_replay.hpp"
#include "gui/trial_pages/hand_replay.hpp"
#include "gui/trial_pages/opened_trial.hpp"
#include "gui/trial_pages/trial_replay.hpp"
#include "gui/trial_pages/two_hands_replay.hpp"

namespace isograsp::gui {

struct LoadedTrial {
  OpenedTrial opened;   ///< without its signals: these are in the replay
  QString why_nothing;  ///< why the replay is empty; empty: it is not
  TrialReplay replay;
  std::vector<TrialFact> facts;
  std::shared_ptr<const tasks::TaskSpec> task;  ///< null: its text cannot be read
  std::shared_ptr<const Scene> scene;           ///< turned for the hand; null: no object
  std::vector<Vec3> path;  ///< of the object's centre, in the world; NaN: interrupted
  /// Of an arm seen by cameras, whose world is then that of the screens; null: of anything else.
  std::shared_ptr<const ArmReplay> arm;
  std::shared_ptr<const HandReplay> tracked;        ///< of a tracked hand; null: of anything else
  std::shared_ptr<const TwoHandsReplay> two_hands;  ///< of both hands; null: of anything else
  QString why_no_picture;  ///< arm or hand was recorded and cannot be drawn; empty: it can
};

/// `library`: folder of the shipped one, which knows the axes of a hand.
[[nodiscard]] Result<LoadedTrial> load_trial(storage::SessionStore& store,
                                             const storage::SessionRecord& session,
                                             const storage::TrialRecord& trial,
                                             const std::string& library);

/// What the patient's scene draws of this state. A finger without a value is not there.
/// @pre trial.task; trial.scene, trial.arm, trial.tracked or trial.two_hands
[[nodiscard]] PatientPicture picture_at(const LoadedTrial& trial, const ReplayState& state);

}  // namespace isograsp::gui
