// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/trial_pages/loaded_trial.hpp"

#include <QObject>

#include "gui/words/texts.hpp"
#include "hand/platform_records.hpp"

namespace isograsp::gui {

namespace {
/// Steps of the drawn path: about a pixel in the pictures of a workspace of some 200 mm.
constexpr double kPathStep_m = 0.0005;
}  // namespace

Result<LoadedTrial> load_trial(storage::SessionStore& store, const storage::SessionRecord& session,
                               const storage::TrialRecord& trial) {
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
  if (!trial.scene_text.empty())
    if (auto scene = parse_scene(trial.scene_text, trial.task_name))
      loaded.scene = std::make_shared<const Scene>(for_hand(*std::move(scene), session.hand));
  loaded.path = loaded.replay.path(kPathStep_m);
  return loaded;
}

PatientPicture picture_at(const LoadedTrial& trial, const ReplayState& state) {
  PatientFacts facts;
  facts.session_open = true;
  facts.hand = trial.opened.session.hand;
  facts.task = trial.task;
  facts.scene = trial.scene;
  facts.maximum_force_N =
      storage::value_of(trial.opened.trial.references, platform::kMaximumForce_N).value_or(0.0);
  session::Snapshot& now = facts.snapshot;
  now.stage = session::Stage::trial;
  now.frames = 1;
  now.has_object = true;
  now.task.phase = state.phase;
  now.task.target_index = state.target_index;
  now.task.targets_reached = state.targets_reached;
  auto& view = now.special.special.emplace<tasks::ObjectView>();
  view.pose_target_shown = state.X_WT.has_value();
  view.X_WT = state.X_WT.value_or(Pose{});
  now.object.X_WO = state.X_WO.value_or(Pose{});
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    now.forces.wrench_C[f].force = state.fingers[f].force_C;
    now.grasp.contact[f] = state.fingers[f].touching;
  }
  auto picture = picture_for(facts);
  for (std::size_t f = 0; f < kFingerCount; ++f)
    if (state.fingers[f].quality == SampleQuality::missing) picture.fingers[f].shown = false;
  return picture;
}

}  // namespace isograsp::gui
