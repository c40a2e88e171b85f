// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/presenter/session_flow.hpp"

#include <algorithm>
#include <cmath>

#include "gui/library/task_groups.hpp"
#include "gui/presenter/next_words.hpp"
#include "gui/words/texts.hpp"
#include "gui/words/words.hpp"
#include "session/demonstration.hpp"
#include "tasks/kinds/arm/pose_following.hpp"
#include "tasks/kinds/arm/pose_matching.hpp"
#include "tasks/kinds/hand/virtual_pick_place.hpp"

namespace isograsp::gui {

namespace {

ProtocolFacts protocol_facts(const ProtocolGuide& guide, bool by_itself, double session_time_s) {
  using Act = session::ProtocolWalk::Act;
  ProtocolFacts facts;
  facts.active = true;
  facts.goes_on = guide.goes_on();
  facts.by_itself = by_itself;
  const auto& act = guide.act();
  if (!act) return facts;
  switch (act->kind) {
    case Act::Kind::instrument_zero:
    case Act::Kind::start_posture:
    case Act::Kind::hand_entry: facts.act = ProtocolFacts::Act::zero; break;
    case Act::Kind::pause: facts.act = ProtocolFacts::Act::pause; break;
    case Act::Kind::trial: facts.act = ProtocolFacts::Act::trial; break;
  }
  facts.act_words = words_of(*act);
  facts.wait_s = static_cast<int>(std::ceil(guide.wait_s(session_time_s)));
  facts.start_in_s = static_cast<int>(std::ceil(guide.start_in_s(session_time_s)));
  return facts;
}

/// It is done by what the picture shows: an object goes to its target.
bool by_picture(const tasks::TaskSpec& spec) {
  return spec.kind.get_if<tasks::PoseMatchingSpec>() != nullptr ||
         spec.kind.get_if<tasks::PoseFollowingSpec>() != nullptr ||
         spec.kind.get_if<tasks::VirtualPickPlaceSpec>() != nullptr;
}

void add_camera_facts(const session::ArmSnapshot& now, FlowFacts& facts) {
  facts.health.state = now.health.state;
  facts.camera_fault = now.health.fault;
  facts.at_rest = now.picture && !stops_markers(now.health.fault);
}

/// Of the newest frame of two platforms; health and restart stand in the snapshot already.
void add_both_facts(const OpenSession& open, FlowFacts& facts) {
  const tasks::TwoHandsReferences& known = open.session->known().two_hands;
  const HandsSafety& safety = open.preparation.safety;
  facts.health_side = fault_side(*open.both);
  facts.restarted_side = restarted_side(*open.both);
  facts.platforms_checked = open.crosstalk.settled();
  facts.platforms_pressed = open.crosstalk.running();
  facts.stop_tested = safety.stop_tested;
  facts.within_reach = safety.within_reach;
  if (open.trial)
    facts.at_rest =
        open.trial->rest_watches.left.at_rest() && open.trial->rest_watches.right.at_rest();
  if (known.of.left.maximum_N && known.of.right.maximum_N) {
    facts.maximum_force_N = std::min(*known.of.left.maximum_N, *known.of.right.maximum_N);
    facts.maximum_attempts = 2;  // its task has several itself
  }
}

void add_tracker_facts(const session::HandSnapshot& now, FlowFacts& facts) {
  facts.health.state = now.health.state;
  facts.hand_fault = now.health.fault;
  facts.at_rest = !stops_hand(now.health.fault);
  facts.entry = now.entry;
  facts.object_there = now.grasp.object_there && !now.grasp.helped;
}

}  // namespace

SessionFlow::SessionFlow(const SessionState& state, const Clinic& clinic, const PersonFile& file,
                         const Clock& clock)
    : state_(state), clinic_(clinic), file_(file), clock_(clock) {
  connect(&clinic_, &Clinic::opened, this, &SessionFlow::update);
  connect(&clinic_, &Clinic::open_failed, this, [this](const QString& why) {
    database_error_ = why.toStdString();
    update();
  });
}

bool SessionFlow::hand_to_confirm() const noexcept {
  const auto& records = file_.records();
  const auto& today = state_.choices.today;
  if (!today.hand || today.hand_confirmed || state_.busy()) return false;
  if (!records || file_.code() != state_.choices.patient) return false;
  return records->profile.affected ==
         (*today.hand == Hand::right ? storage::Side::left : storage::Side::right);
}

bool SessionFlow::under_way() const noexcept {
  const auto& open = state_.open;
  const bool asked = open && (open->preparation.zero_asked || open->starting());
  return asked || view_.may_stop || view_.may_stand_by || state_.guide().goes_on();
}

void SessionFlow::decide() {
  view_ = gui::decide(facts());
}

void SessionFlow::update() {
  decide();
  Q_EMIT changed();
}

void SessionFlow::refuse(const Error& error) {
  Q_EMIT failed(translated(error));
}

FlowFacts SessionFlow::facts() const {
  const Choices& choices = state_.choices;
  FlowFacts facts;
  facts.database_open = clinic_.is_open();
  facts.database_error = database_error_;
  facts.look_only = state_.config.look_only;
  facts.patient_chosen = !choices.patient.empty();
  facts.hand_to_confirm = hand_to_confirm();
  facts.follows_other_hand = choices.today.follows_other_hand;
  facts.both_hands = measures_both(state_);
  facts.hand_chosen = choices.today.both || (choices.today.hand && !facts.hand_to_confirm);
  facts.screened = state_.measures_arm()    ? choices.today.arm_screening.complete()
                   : state_.measures_hand() ? choices.today.hand_screening.complete()
                   : facts.both_hands       ? complete(choices.today.screenings)
                                            : choices.today.screening.complete();
  facts.earlier_sought = choices.interrupted.sought;
  facts.earlier_undecided = choices.interrupted.acts.has_value() && !choices.interrupted.go_on;
  facts.device_chosen = !choices.device_uri.empty();
  facts.connection = state_.connection.phase;
  if (state_.connection.failure) {
    facts.connection_error = state_.connection.failure->happened;
    facts.connection_remedy = state_.connection.failure->remedy;
    facts.broken_off = state_.connection.failure->broken_off;
    if (!state_.connection.lost)
      facts.stored_until = local_clock(state_.connection.failure->stored_until_utc).toStdString();
    facts.basis_missing = state_.connection.failure->asks_basis;
  }
  facts.recorded = state_.recorded();
  facts.start_posture = state_.measures_arm();
  facts.hand_entry = state_.measures_hand();
  facts.asks_rest = !facts.is_seen();  // until the device says it itself
  if (state_.open) add_session_facts(*state_.open, facts);
  add_task_facts(facts);
  return facts;
}

void SessionFlow::add_session_facts(const OpenSession& open, FlowFacts& facts) const {
  const session::Snapshot& now = open.snapshot;
  const Preparation& preparation = open.preparation;
  const bool follows = open.work.follows();
  facts.anything_arrived = now.frames > 0;
  const Timestamp time = clock_.now();
  facts.frozen = now.stage != session::Stage::finished &&
                 (facts.anything_arrived ? to_seconds(time - now.published) > kFrozenAfter_s
                                         : to_seconds(time - open.opened) > kFirstFrameWithin_s);
  facts.stage = now.stage;
  facts.pause_cause = now.pause_cause;
  facts.at_rest = open.trial && open.trial->rest_watch.at_rest();
  facts.health = now.health;
  if (facts.stage == session::Stage::trial || facts.stage == session::Stage::paused)
    facts.stored_until = local_clock(session::stored_until_utc(*open.session)).toStdString();
  if (open.arm) add_camera_facts(*open.arm, facts);
  // People in software and their cameras are of one make, and nobody can move them.
  facts.picture_unsure =
      facts.is_seen() && !state_.simulated() && !state_.recorded() && !open.picture_check.good();
  facts.picture_watched = open.picture_check.running();
  if (open.hand) add_tracker_facts(*open.hand, facts);
  facts.asks_zero =
      open.session->known().asks_for(session::PreparationStep::zero) || facts.is_seen();
  facts.asks_rest = open.session->known().asks_for(session::PreparationStep::rest);
  facts.zeroed = now.zeroed;
  facts.restarted = now.restarted;
  facts.maximum_force_N = open.session->known().maximum_force_N();
  facts.settling_s = static_cast<int>(std::ceil(open.session->settling_s()));
  facts.zero_refusal = preparation.zero_refusal;
  facts.zero_only_changed = preparation.zero_only_changed;
  facts.zero_remark = preparation.zero_remark;
  facts.zero_asked = preparation.zero_asked;
  facts.strapped = preparation.strapped;
  facts.straps_due = preparation.strapped && open.limits.straps_due(open.time_s());
  facts.hand_out =
      preparation.rest_done && !preparation.strapped && facts.zeroed && !facts.recorded;
  facts.rest_words = preparation.rest_words;
  facts.rest_done =
      preparation.rest_done || !facts.asks_rest || (follows && !open.work.guide.asks_rest());
  facts.maximum_attempts = open.work.maximum_attempts;
  facts.task_done = open.work.task_done;
  // From the press of Start until the trial's outcome is stored, with the trial itself in between.
  facts.starting = open.trial && (!open.trial->arrived || facts.stage == session::Stage::idle);
  const auto& reason = open.rating.stop_reason;
  facts.stop_reason = reason.empty() ? open.limits.reason_to_stop().value_or(Text()) : reason;
  if (follows)
    facts.protocol = protocol_facts(open.work.guide, state_.choices.by_itself, open.time_s());
  if (open.rating.questions.due()) facts.protocol.goes_on = false;
  if (open.both) add_both_facts(open, facts);
  if (open.ended) {
    facts.last_rested = is_rest(*open.ended->task);
    facts.last_in_picture = by_picture(*open.ended->task);
  }
}

void SessionFlow::add_task_facts(FlowFacts& facts) const {
  const auto& open = state_.open;
  const auto* spec = open && open->trial ? open->trial->task.get() : state_.next_task();
  facts.task_chosen = spec != nullptr;
  if (spec == nullptr) return;
  facts.task_rests = is_rest(*spec) && facts.asks_rest;
  facts.task_in_picture = by_picture(*spec);
  facts.task_needs_entry = spec->kind.get_if<tasks::VirtualPickPlaceSpec>() != nullptr;
  facts.task_not_shown = session::why_not_shown(*spec);
  facts.task_name = spec->name;
  if (open) facts.task_lacks = open->work.task_lacks;
}

}  // namespace isograsp::gui
