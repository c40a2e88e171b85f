// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/trial_pages/two_hands_replay.hpp"

#include <algorithm>
#include <cmath>

#include "hand/two_hands_columns.hpp"

namespace isograsp::gui {

namespace {

/// Whole and from 0 to `last`; else 0.
int counted(const Signals& signals, Place column, std::size_t row, int last) {
  const double value = value_at(signals, column, row);
  return value >= 0.0 && value <= last ? static_cast<int>(std::lround(value)) : 0;
}

std::optional<double> known(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

Cue cue_at(const Signals& signals, Place column, std::size_t row) {
  return static_cast<Cue>(counted(signals, column, row, static_cast<int>(Cue::close)));
}

}  // namespace

bool TwoHandsReplay::is_of_two_hands(const TrialReplay& replay) noexcept {
  return replay.signals().has(columns::hand_cue.left);
}

TwoHandsReplay::TwoHandsReplay(const TrialReplay& replay, const std::string& scene,
                               const tasks::TaskSpec* task) {
  carries_ = replay.signals().has(columns::both_hold);
  if (!scene.empty() && (carries_ || replay.signals().has(columns::hand_contact.left)))
    if (auto read = bimanual::parse_hands_scene(scene, "")) scene_ = *std::move(read);
  if (task != nullptr) {
    band_ = task->tolerance().value_or(tasks::PoseTolerance());
    lifts_ = task->repetitions();
  }
  const Signals& signals = replay.signals();
  for (const Hand hand : kBothHands)
    of_[hand] = {
        signals.find(columns::hand_grip[hand]), signals.find(columns::target_hand_grip[hand]),
        signals.find(columns::hand_cue[hand]), signals.find(columns::hand_force_shown[hand])};
  target_sum_N_ = signals.find(columns::target_sum_force_N);
  sum_shown_ = signals.find(columns::sum_force_shown);
  segment_ = signals.find(columns::segment);
  cue_ = signals.find(columns::cue);
  look_ahead(signals);
}

void TwoHandsReplay::look_ahead(const Signals& signals) {
  constexpr int kMostParts = 10000;  // more are no parts of a trial
  TargetPreview preview;
  TargetPreview::Hands& hands = preview.hands;
  for (std::size_t row = 0; row < signals.rows(); ++row) {
    const tasks::TwoHandsView asked = asked_at(signals, row);
    const auto part = static_cast<std::size_t>(counted(signals, segment_, row, kMostParts));
    if (part >= hands.cues.size()) hands.cues.resize(part + 1, {Cue::relax, Cue::relax});
    hands.most_sum_N = std::max(hands.most_sum_N, asked.target_sum_N.value_or(0.0));
    for (const Hand hand : kBothHands) {
      hands.most_N[hand] = std::max(hands.most_N[hand], asked.of[hand].target_N.value_or(0.0));
      hands.cues[part][hand] = asked.of[hand].cue;
    }
  }
  preview_ = std::make_shared<const TargetPreview>(std::move(preview));
}

tasks::TwoHandsView TwoHandsReplay::asked_at(const Signals& signals, std::size_t row) const {
  tasks::TwoHandsView view;
  view.target_sum_N = known(value_at(signals, target_sum_N_, row));
  view.sum_shown = value_at(signals, sum_shown_, row) > 0.0;
  for (const Hand hand : kBothHands) {
    tasks::HandAsked& of = view.of[hand];
    const HandPlaces& places = of_[hand];
    const auto force_N = known(value_at(signals, places.force_N, row));
    of.cue = cue_at(signals, places.cue, row);
    of.force_N = force_N.value_or(0.0);
    of.force_shown = force_N && value_at(signals, places.force_shown, row) > 0.0;
    of.target_N = known(value_at(signals, places.target_N, row));
    if (!force_N) view.sum_shown = false;
  }
  return view;
}

session::LiftedView TwoHandsReplay::lifted_at(const Signals& signals, std::size_t row) const {
  const auto stored = [&](const Column& column) {
    return known(value_at(signals, signals.find(column), row)).value_or(0.0);
  };
  session::LiftedView seen;
  seen.size_m = scene_->object.size_m;
  for (std::size_t a = 0; a < 3; ++a)
    seen.object.X_WO.p[static_cast<Eigen::Index>(a)] = stored(columns::actual_position[a]);
  seen.object.angle_rad = stored(columns::actual_angle_rad);
  seen.object.X_WO.q = Quat(Eigen::AngleAxisd(seen.object.angle_rad, Vec3::UnitZ()));
  for (std::size_t side = 0; side < kBothHands.size(); ++side) {
    const Hand hand = kBothHands[side];
    const auto& contacts = scene_->contacts[side].contacts;
    if (!contacts.empty()) seen.of[hand].end_O = contacts.front().p_OC;
    seen.of[hand].touches = stored(columns::hand_contact[hand]) > 0.0;
    seen.of[hand].slips = stored(columns::hand_slip[hand]) > 0.0;
  }
  return seen;
}

session::CarriedView TwoHandsReplay::carried_at(const Signals& signals, std::size_t row) const {
  const auto stored = [&](const Column& column) {
    return known(value_at(signals, signals.find(column), row)).value_or(0.0);
  };
  const auto place = [&](const columns::OfAxes& axes) {
    return Vec3(stored(axes[0]), stored(axes[1]), stored(axes[2]));
  };
  session::CarriedView seen;
  seen.size_m = scene_->object.size_m;
  seen.half_size_m = scene_->hands.half_size_m;
  seen.object.X_WO.p = place(columns::actual_position);
  seen.object.angle_rad = stored(columns::actual_angle_rad);
  seen.object.X_WO.q = Quat(Eigen::AngleAxisd(seen.object.angle_rad, Vec3::UnitZ()));
  for (const Hand hand : kBothHands)
    seen.of[hand] = {place(columns::hand_point[hand]), place(columns::hand_bubble[hand]),
                     stored(columns::hand_excess[hand]), stored(columns::hand_squeeze_N[hand])};
  seen.held = stored(columns::both_hold) > 0.0;
  seen.clutch = stored(columns::clutch_held) > 0.0;
  return seen;
}

tasks::MovedView TwoHandsReplay::moved_at(const Signals& signals, std::size_t row) const {
  const auto stored = [&](const Column& column, std::size_t at) {
    return known(value_at(signals, signals.find(column), at));
  };
  tasks::MovedView asked;
  asked.band = band_;
  asked.on_rest = stored(columns::on_rest, row).value_or(0.0) > 0.0;
  const auto target_y_m = stored(columns::target_position[1], row);
  asked.target_shown = target_y_m.has_value();
  asked.X_WT.p =
      Vec3(stored(columns::target_position[0], row).value_or(0.0), target_y_m.value_or(0.0), 0.0);
  asked.rest_X_WO.p.y() = stored(columns::actual_position[1], 0).value_or(0.0);
  asked.fetched = asked.target_shown && asked.on_rest;
  return asked;
}

session::TwoPlatformsSnapshot TwoHandsReplay::at(const TrialReplay& replay,
                                                 const ReplayState& state) const {
  session::TwoPlatformsSnapshot now;
  now.stage = state.phase == tasks::Phase::paused ? session::Stage::paused : session::Stage::trial;
  now.task.phase = state.phase;
  now.session_time_s = state.t_s;
  if (replay.rows() == 0) return now;
  const Signals& signals = replay.signals();
  const std::size_t row = replay.row_at(state.t_s);
  now.frames = static_cast<std::int64_t>(row) + 1;
  now.task.cue = cue_at(signals, cue_, row);
  now.task.segment = counted(signals, segment_, row, static_cast<int>(preview_->hands.cues.size()));
  tasks::TwoHandsView asked = asked_at(signals, row);
  if (state.quality == SampleQuality::missing) {
    asked.sum_shown = false;
    for (const Hand hand : kBothHands) asked.of[hand].force_shown = false;
  }
  if (scene_) {
    if (carries_)
      now.carried = carried_at(signals, row);
    else
      now.lifted = lifted_at(signals, row);
    asked.moved = moved_at(signals, row);
    now.task.targets_reached = state.targets_reached;
    now.task.target_count = lifts_;
  }
  now.special.special = asked;
  return now;
}

}  // namespace isograsp::gui
