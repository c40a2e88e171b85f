// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/trial_pages/loaded_trial.hpp"

#include <QObject>
#include <algorithm>

#include "gui/presenter/patient_facts.hpp"
#include "gui/words/texts.hpp"
#include "hand/platform_records.hpp"

namespace isograsp::gui {

namespace {
/// Steps of the drawn path: about a pixel in the pictures of a workspace of some 200 mm.
constexpr double kPathStep_m = 0.0005;
}  // namespace

Result<LoadedTrial> load_trial(storage::SessionStore& store, const storage::SessionRecord& session,
                               const storage::TrialRecord& trial, const std::string& library) {
  auto opened = open_trial(store, session, trial);
  if (!opened) return opened.error();
  LoadedTrial loaded;
  loaded.opened = *std::move(opened);
  loaded.facts = facts_of(loaded.opened);
  if (auto replay = TrialReplay::make(std::move(loaded.opened.signals))) {
    loaded.replay = *std::move(replay);
  } else if (loaded.opened.damage.empty()) {
    loaded.why_nothing =
        QObject::tr("There is nothing to replay: %1.").arg(translated(replay.error().what));
  }
  loaded.opened.signals = {};
  if (auto task = tasks::parse_task(trial.task_text, trial.task_name))
    loaded.task = std::make_shared<const tasks::TaskSpec>(*std::move(task));
  if (ArmReplay::is_of_arm(loaded.replay)) {
    if (auto arm = ArmReplay::make(session, loaded.replay)) {
      loaded.arm = std::make_shared<const ArmReplay>(*std::move(arm));
      loaded.path = loaded.arm->path(loaded.replay, kPathStep_m);
    } else {
      loaded.why_no_picture =
          QObject::tr("The arm cannot be drawn: %1.").arg(translated(arm.error().what));
    }
    return loaded;
  }
  if (HandReplay::is_of_hand(loaded.replay)) {
    if (auto hand = hand_of_trial(store, session, trial, library))
      loaded.tracked =
          std::make_shared<const HandReplay>(loaded.replay, *std::move(hand), loaded.task.get());
    else
      loaded.why_no_picture =
          QObject::tr("The hand cannot be drawn: %1.").arg(translated(hand.error().what));
    loaded.path = loaded.replay.path(kPathStep_m);
    return loaded;
  }
  if (TwoHandsReplay::is_of_two_hands(loaded.replay)) {
    loaded.two_hands =
        std::make_shared<const TwoHandsReplay>(loaded.replay, trial.scene_text, loaded.task.get());
    return loaded;
  }
  if (!trial.scene_text.empty())
    if (auto scene = parse_scene(trial.scene_text, trial.task_name))
      loaded.scene = std::make_shared<const Scene>(
          for_hand(*std::move(scene), session.hand.value_or(Hand::right)));
  loaded.path = loaded.replay.path(kPathStep_m);
  return loaded;
}

PatientPicture picture_at(const LoadedTrial& trial, const ReplayState& state) {
  PatientFacts facts;
  if (trial.arm) {
    const session::ArmSnapshot now = trial.arm->at(trial.replay, state);
    facts.session_open = facts.arrived = true;
    facts.hand = trial.opened.session.hand.value_or(Hand::right);
    facts.task = trial.task;
    facts.stage = session::Stage::trial;
    facts.stimulus = session::screen_of(now);
    facts.arm = trial.arm->space();
    facts.centre_W = trial.arm->centre_W();
    return picture_for(facts);
  }
  if (trial.tracked) {
    facts = patient_facts(trial.tracked->at(trial.replay, state));
    facts.session_open = facts.arrived = true;
    facts.hand = trial.opened.session.hand.value_or(Hand::right);
    facts.task = trial.task;
    facts.stage = session::Stage::trial;
    return picture_for(facts);
  }
  if (trial.two_hands) {
    facts = patient_facts(trial.two_hands->at(trial.replay, state));
    facts.session_open = true;
    facts.task = trial.task;
    facts.preview = trial.two_hands->preview();
    return picture_for(facts);
  }
  facts.session_open = true;
  facts.hand = trial.opened.session.hand.value_or(Hand::right);
  facts.task = trial.task;
  facts.scene = trial.scene;
  facts.maximum_force_N =
      storage::value_of(trial.opened.trial.references, platform::kMaximumForce_N);
  facts.arrived = true;
  facts.stage = session::Stage::trial;
  Stimulus& screen = facts.stimulus;
  screen.progress.holding = state.phase == tasks::Phase::hold;
  screen.progress.target_index = state.target_index;
  screen.progress.targets_reached = state.targets_reached;
  screen.object_shown = true;
  screen.X_WO = state.X_WO.value_or(Pose{});
  screen.pose_target_shown = state.X_WT.has_value();
  screen.X_WT = state.X_WT.value_or(screen.X_WO);
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    screen.press_N[f] = std::max(0.0, state.fingers[f].force_C.z());
    screen.contact[f] = state.fingers[f].touching;
  }
  auto picture = picture_for(facts);
  for (std::size_t f = 0; f < kFingerCount; ++f)
    if (state.fingers[f].quality == SampleQuality::missing) picture.fingers[f].shown = false;
  return picture;
}

}  // namespace isograsp::gui
