// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/trial_pages/hand_replay.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hand/hand_columns.hpp"
#include "session/tracked_hand/entry_capture.hpp"
#include "session/tracked_hand/hand_size.hpp"
#include "tasks/kinds/hand/virtual_pick_place.hpp"
#include "virtual_hand/hand_pose.hpp"
#include "virtual_hand/study_plan.hpp"

namespace isograsp::gui {

namespace {

bool is_said(const Signals& signals, Place column, std::size_t row) {
  return value_at(signals, column, row) > 0.0;
}

/// 0 … most; -1: none.
int number_at(const Signals& signals, Place column, std::size_t row, int most) {
  const double value = value_at(signals, column, row);
  return value >= 0.0 && value <= most ? static_cast<int>(value) : -1;
}

}  // namespace

Result<virtual_hand::HandModel> hand_of_trial(storage::SessionStore& store,
                                              const storage::SessionRecord& session,
                                              const storage::TrialRecord& trial,
                                              const std::string& library) {
  const Hand side = session.hand.value_or(Hand::right);
  auto usual = session::usual_hand(library, trial.task_name);
  if (!usual) return usual.error();
  usual->side = side;
  const auto preparations = store.preparations(session.id);
  if (!preparations) return preparations.error();
  const auto entry = std::find_if(preparations->begin(), preparations->end(), [&](const auto& one) {
    return one.kind == session::kHandEntry &&
           std::find(trial.preparations.begin(), trial.preparations.end(), one.id) !=
               trial.preparations.end();
  });
  if (entry == preparations->end()) return usual;
  return session::hand_of_size(*entry, *usual, side);
}

bool HandReplay::is_of_hand(const TrialReplay& replay) noexcept {
  return replay.signals().has(columns::thumb_index_gap_m);
}

HandReplay::HandReplay(const TrialReplay& replay, virtual_hand::HandModel hand,
                       const tasks::TaskSpec* task)
    : hand_(std::move(hand)), story_(grasp_story(replay.signals())) {
  if (task != nullptr)
    if (const auto* placing = task->kind.get_if<tasks::VirtualPickPlaceSpec>())
      table_m_ = placing->table_m;
  find(replay.signals());
}

void HandReplay::find(const Signals& signals) {
  seen_.palm = find_pose(signals, columns::palm_position, columns::palm_attitude);
  virtual_.palm =
      find_pose(signals, columns::virtual_palm_position, columns::virtual_palm_attitude);
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    seen_.angles[d][0] = signals.find(columns::abduction[d]);
    for (std::size_t k = 0; k < 3; ++k)
      seen_.angles[d][k + 1] = signals.find(columns::flexion[d][k]);
    for (std::size_t k = 0; k < virtual_hand::kAngleCount; ++k)
      virtual_.angles[d][k] = signals.find(columns::virtual_angle[d][k]);
    digits_[d] = {signals.find(columns::grasp_state[d]), signals.find(columns::pull_N[d]),
                  signals.find(columns::touch_N[d]), signals.find(columns::gap_m[d])};
  }
  object_ = find_pose(signals, columns::actual_position, columns::actual_attitude);
  target_ = find_pose(signals, columns::target_position, columns::target_attitude);
  choice_ = find_choice(signals);
  const std::array<std::pair<Place*, const Column*>, 14> kOthers{
      {{&pause_cause_, &columns::pause_cause},
       {&unseen_s_, &columns::unseen_s},
       {&gap_m_, &columns::thumb_index_gap_m},
       {&placement_, &columns::placement},
       {&study_object_, &columns::study_object},
       {&assistance_, &columns::assistance},
       {&eased_, &columns::eased},
       {&fails_, &columns::placement_fails},
       {&let_go_asked_, &columns::let_go_asked},
       {&helped_, &columns::object_helped},
       {&held_, &columns::object_held},
       {&supported_, &columns::object_supported},
       {&release_N_, &columns::release_pull_N},
       {&tracked_gap_m_, &columns::tracked_gap_m}}};
  for (const auto& [place, column] : kOthers) *place = signals.find(*column);
}

std::optional<virtual_hand::HandPose> HandReplay::hand_at(const Signals& signals,
                                                          const HandPlaces& places,
                                                          std::size_t row) {
  virtual_hand::HandPose hand;
  hand.X_WP = pose_at(signals, places.palm, row);
  bool whole = !is_missing(hand.X_WP);
  for (std::size_t d = 0; d < kDigitCount; ++d)
    for (std::size_t k = 0; k < virtual_hand::kAngleCount; ++k) {
      hand.angles[d][k] = value_at(signals, places.angles[d][k], row);
      whole &= std::isfinite(hand.angles[d][k]);
    }
  return whole ? std::optional(hand) : std::nullopt;
}

tasks::HandView HandReplay::task_at(const Signals& signals, std::size_t row) const {
  constexpr int kMost = 1'000'000;  // larger numbers count nothing
  tasks::HandView task;
  task.about_object = has_object();
  task.object =
      number_at(signals, study_object_, row, static_cast<int>(virtual_hand::kStudyObjects) - 1);
  task.placement = number_at(signals, placement_, row, kMost);
  task.assistance = static_cast<virtual_hand::AssistanceLevel>(std::max(
      0,
      number_at(signals, assistance_, row, static_cast<int>(virtual_hand::AssistanceLevel::off))));
  task.eased = is_said(signals, eased_, row);
  task.fails = std::max(0, number_at(signals, fails_, row, kMost));
  task.X_WT = pose_at(signals, target_, row);
  task.target_shown = !is_missing(task.X_WT);
  task.let_go_asked = is_said(signals, let_go_asked_, row);
  task.helped = is_said(signals, helped_, row);
  return task;
}

hand_world::GraspState HandReplay::grasp_at(const Signals& signals, std::size_t row) const {
  hand_world::GraspState grasp;
  const Pose X_WO = pose_at(signals, object_, row);
  grasp.object_there = !is_missing(X_WO);
  if (grasp.object_there) grasp.object.X_WO = X_WO;
  constexpr int kStates = static_cast<int>(virtual_hand::kDigitStateNames.size());
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    hand_world::DigitGrasp& digit = grasp.digits[d];
    digit.state = static_cast<virtual_hand::DigitState>(
        std::max(0, number_at(signals, digits_[d].state, row, kStates - 1)));
    digit.pull_N = value_at(signals, digits_[d].pull_N, row);
    digit.normal_N = value_at(signals, digits_[d].touch_N, row);
    digit.gap_m = value_at(signals, digits_[d].gap_m, row);
    digit.touching = digit.state == virtual_hand::DigitState::contact || digit.normal_N > 0.0;
  }
  grasp.supported = is_said(signals, supported_, row);
  grasp.held = is_said(signals, held_, row);
  grasp.choice = choice_at(signals, choice_, row);
  grasp.tracked_gap_m = value_at(signals, tracked_gap_m_, row);
  return grasp;
}

session::HandSnapshot HandReplay::at(const TrialReplay& replay, const ReplayState& state) const {
  session::HandSnapshot now;
  now.stage = state.phase == tasks::Phase::paused ? session::Stage::paused : session::Stage::trial;
  now.task.phase = state.phase;
  now.task.target_index = state.target_index;
  now.task.targets_reached = state.targets_reached;
  for (std::size_t d = 0; d < kDigitCount; ++d) now.link_radii_m[d] = hand_.digits[d].radii_m;
  if (replay.rows() == 0) return now;
  const Signals& signals = replay.signals();
  const std::size_t row = replay.row_at(state.t_s);
  const double since_s = state.t_s - signals.column(columns::t_s)[row];
  const bool gap = replay.gap_after(row) && since_s >= replay.period_s();
  now.frames = static_cast<std::int64_t>(row) + 1;
  now.session_time_s = state.t_s;
  now.pause_cause = static_cast<session::PauseCause>(std::max(
      0,
      number_at(signals, pause_cause_, row, static_cast<int>(session::PauseCause::object_lost))));
  now.hand.unseen_s = value_at(signals, unseen_s_, row) + (gap ? since_s : 0.0);
  now.hand.held = gap || now.hand.unseen_s > 0.0;
  now.thumb_index_gap_m = value_at(signals, gap_m_, row);
  if (const auto seen = hand_at(signals, seen_, row)) {
    now.hand.known = true;
    now.pose = virtual_hand::FittedPose{*seen, 0.0};
    now.seen_hand = virtual_hand::hand_in_space(hand_, *seen);
  }
  if (!has_object()) return now;
  tasks::HandView task = task_at(signals, row);
  task.at_target = state.phase == tasks::Phase::hold;
  now.grasp = grasp_at(signals, row);
  now.grasp.level = task.assistance;
  now.release_N = value_at(signals, release_N_, row);
  if (const auto hand = hand_at(signals, virtual_, row)) {
    now.grasp.hand_there = true;
    now.grasp.hand = *hand;
    now.grasping_hand = virtual_hand::hand_in_space(hand_, *hand);
  }
  now.ground = hand_world::Ground{table_m_, std::nullopt};
  if (task.object >= 0)
    now.ground =
        hand_world::start_place(
            virtual_hand::study_objects()[static_cast<std::size_t>(task.object)], table_m_, 0, 0)
            .ground;
  now.special.special = task;
  return now;
}

}  // namespace isograsp::gui
