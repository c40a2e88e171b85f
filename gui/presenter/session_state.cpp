// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/presenter/session_state.hpp"

#include <algorithm>

#include "gui/words/texts.hpp"
#include "session/open_two_platforms.hpp"

namespace isograsp::gui {

namespace {

/// What is shown while no session is open.
struct NoSession {
  session::Snapshot snapshot;
  session::Compensation compensation;
  ProtocolGuide guide;
  Rating rating;
  Text rest_words;
  std::vector<Measure> score;
};

const NoSession& no_session() noexcept {
  static const NoSession kNoSession;
  return kNoSession;
}

}  // namespace

ConnectionState::Failure ConnectionState::Failure::of(Error error) {
  Failure failure;
  failure.remedy = translated(error.remedy).toStdString();
  error.remedy = {};
  failure.happened = translated(error).toStdString();
  return failure;
}

Result<tasks::TaskSpec> Work::at_chosen_level(const tasks::TaskSpec& spec,
                                              std::optional<tasks::Look> look) const {
  const auto chosen = levels.find(spec.file);
  if (chosen == levels.end() || !spec.difficulty) return spec;
  return tasks::at_level(spec, chosen->second, look);
}

bool TrialQuestions::due() const noexcept {
  return std::ranges::any_of(said, [](const auto& answer) { return !answer.has_value(); });
}

void HandsAtRest::add(const session::TwoPlatformsSnapshot& now) noexcept {
  if (now.session_time_s <= last_s_) return;
  last_s_ = now.session_time_s;
  ++frames_;
  for (const Hand hand : kBothHands)
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      sum_C_[hand][f].force += now.of[hand].forces.wrench_C[f].force;
      sum_C_[hand][f].torque += now.of[hand].forces.wrench_C[f].torque;
    }
}

std::optional<FingerWrenches> HandsAtRest::mean(Hand hand) const noexcept {
  if (frames_ == 0) return std::nullopt;
  FingerWrenches mean_C = sum_C_[hand];
  for (Wrench& wrench : mean_C) {
    wrench.force /= frames_;
    wrench.torque /= frames_;
  }
  return mean_C;
}

session::Snapshot side_of(const session::TwoPlatformsSnapshot& both, Hand hand) {
  session::Snapshot side;
  static_cast<session::Moment&>(side) = both;
  side.health = both.of[hand].health;
  side.forces = both.of[hand].forces;
  side.restarted = both.of[hand].restarted;
  side.grip_N = both.of[hand].grip_N;
  return side;
}

std::optional<Hand> fault_side(const session::TwoPlatformsSnapshot& both) noexcept {
  for (const Hand hand : kBothHands)
    if (both.of[hand].health.state == DeviceState::faulted) return hand;
  for (const Hand hand : kBothHands)
    if (both.of[hand].health.fault != DeviceFault::none) return hand;
  return std::nullopt;
}

std::optional<Hand> restarted_side(const session::TwoPlatformsSnapshot& both) noexcept {
  for (const Hand hand : kBothHands)
    if (both.of[hand].restarted) return hand;
  return std::nullopt;
}

bool is_simulated(const std::string& uri) {
  const auto both = session::two_platforms_in(uri);
  return (both ? both->left : uri).starts_with("sim://");
}

void OpenSession::look() {
  if (const auto* const seen = session::two_platforms_of(*session)) {
    both = *seen;
    snapshot = side_of(*seen, fault_side(*seen).value_or(Hand::left));
    snapshot.forces = {};  // of neither hand alone
    snapshot.grip_N = 0.0;
    snapshot.restarted.reset();
    if (const auto side = restarted_side(*seen)) snapshot.restarted = seen->of[*side].restarted;
    traces.hands.add(*seen);
    return;
  }
  if (const session::HandSnapshot* const seen = session::hand_of(*session)) {
    hand = *seen;
    static_cast<session::Moment&>(snapshot) = *seen;  // one frame, not two
    traces.tracker.add(*seen);
    return;
  }
  const session::ArmSnapshot* const newest = session::arm_of(*session);
  if (newest == nullptr) {
    snapshot = session->snapshot();
    return;
  }
  arm = *newest;
  static_cast<session::Moment&>(snapshot) = *newest;
  still.add(*arm);
  traces.markers.add(*arm);
  traces.practice.add(*arm, trial && trial->practice);
  traces.turns.add(*arm);
}

std::optional<Vec3> OpenSession::moved_on_screen() const {
  if (hand) {
    if (hand->hand.held || !hand->pose) return std::nullopt;
    return hand->pose->pose.X_WP.p;  // the tracker's axes are those of the screen
  }
  if (!arm || !arm_space) return std::nullopt;
  const FramePose& object = arm->segment(ArmSegment::object);
  if (!has_pose(object.state)) return std::nullopt;
  return arm_space->place(object.X_W.p, Vec3::Zero());
}

bool SessionState::measures_arm() const noexcept {
  return open ? open->arm_space != nullptr : choices.apparatus == kArm;
}

bool measures_both(const SessionState& state) noexcept {
  return state.open ? state.open->session->known().apparatus.kind == kTwoPlatforms
                    : state.choices.today.both;
}

bool SessionState::measures_hand() const noexcept {
  return (open ? open->session->known().apparatus.kind : choices.apparatus) == kTrackedHand;
}

bool SessionState::watches_hand() const noexcept {
  if (open) return measures_hand() && open->session->known().apparatus.watches_person;
  return measures_hand() && !simulated() && choices.device_uri.rfind("replay://", 0) != 0;
}

bool SessionState::simulated() const noexcept {
  if (open) return open->session->known().device.simulated;
  return is_simulated(choices.device_uri);
}

bool SessionState::recorded() const noexcept {
  return open && open->session->known().device.recorded;
}

const DeviceInfo* SessionState::device() const noexcept {
  return open ? &open->session->known().device : nullptr;
}

Text SessionState::realtime() const {
  return open ? session::words_of(open->session->known().realtime) : Text();
}

const session::Snapshot& SessionState::snapshot() const noexcept {
  return open ? open->snapshot : no_session().snapshot;
}

const session::Compensation& SessionState::compensation() const noexcept {
  return open ? open->compensation : no_session().compensation;
}

const ProtocolGuide& SessionState::guide() const noexcept {
  return open ? open->work.guide : no_session().guide;
}

const Rating& SessionState::rating() const noexcept {
  return open ? open->rating : no_session().rating;
}

const Text& SessionState::rest_words() const noexcept {
  return open ? open->preparation.rest_words : no_session().rest_words;
}

bool SessionState::helped() const noexcept {
  if (!open) return false;
  return open->trial ? open->trial->helped : open->ended && open->ended->helped;
}

const std::vector<Measure>& SessionState::live_score() const noexcept {
  if (open && open->trial) return open->trial->score;
  return traces().last_trial ? traces().last_trial->measures : no_session().score;
}

bool SessionState::has_protocol() const noexcept {
  return choices.protocol && choices.device_uri.rfind("replay://", 0) != 0;
}

const tasks::TaskSpec* SessionState::next_task() const noexcept {
  if (follows()) return open->work.act_task ? &*open->work.act_task : nullptr;
  if (!open && has_protocol()) return nullptr;  // the protocol decides
  const auto task = task_by_hand();
  return task ? &library.tasks[static_cast<std::size_t>(*task)] : nullptr;
}

bool SessionState::zero_is_next() const noexcept {
  const auto& act = guide().act();
  return act && act->kind == session::ProtocolWalk::Act::Kind::instrument_zero;
}

}  // namespace isograsp::gui
