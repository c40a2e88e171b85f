// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/presenter/trials.hpp"

#include <memory>
#include <utility>

#include "gui/library/task_groups.hpp"
#include "session/platform/contact_threshold.hpp"
#include "session/platform/prepare_trial.hpp"

namespace isograsp::gui {

namespace {

constexpr double kScoreEvery_s = 1.0;

bool is_running(const session::Snapshot& now) {
  return now.stage == session::Stage::trial || now.stage == session::Stage::paused;
}

}  // namespace

Trials::Trials(const ActContext& with, NextWork& next, ProtocolActs& protocol, Remarks& remarks)
    : state_(with.state),
      flow_(with.flow),
      clinic_(with.clinic),
      example_(with.example),
      clock_(with.clock),
      next_(next),
      protocol_(protocol),
      remarks_(remarks) {}

void Trials::start() {
  if (!flow_.view().may_start) return;
  if (state_.follows()) state_.open->work.guide.go_on(state_.choices.by_itself);
  if (!flow_.view().may_begin) return flow_.update();  // it waits for its time
  begin_next();
}

void Trials::begin_next() {
  const Work& work = state_.open->work;
  if (!work.follows()) {
    auto spec = work.at_chosen_level(*state_.next_task());
    auto begun =
        spec ? begin(*spec, state_.choices.practice, std::nullopt) : Result<void>(spec.error());
    if (!begun) flow_.refuse(begun.error());
    return;
  }
  const auto act = work.guide.act();
  if (!work.act_task) return;
  if (auto begun = begin(*work.act_task, act->practice, act->place); !begun) {
    if (begun.error().code != Error::Code::bad_input) {
      next_.hold();
      return flow_.refuse(begun.error());
    }
    protocol_.leave_out(begun.error());
  }
}

Result<void> Trials::begin(const tasks::TaskSpec& spec, bool practice,
                           std::optional<storage::TrialPlace> place) {
  example_.stop();
  OpenSession& open = *state_.open;
  // A hand that its entry test bars stays barred until the next one.
  if (!open.hand) open.preparation.zero_refusal = {};
  open.preparation.zero_only_changed = false;
  const tasks::TaskContext context = open.session->known().next_context();
  if (auto started = open.session->start_trial(spec, practice, place); !started) return started;
  open.trial.emplace();
  open.trial->practice = practice;
  remarks_.ask_rating_anew();
  open.rating.questions = {};
  prepare_picture(spec, context);
  Q_EMIT flow_.score_changed();
  flow_.update();
  return {};
}

void Trials::prepare_picture(const tasks::TaskSpec& spec, const tasks::TaskContext& context) {
  RunningTrial& trial = *state_.open->trial;
  trial.task = std::make_shared<tasks::TaskSpec>(spec);
  if (is_rest(spec)) state_.open->hands_at_rest.begin();
  trial.preview = std::make_shared<TargetPreview>(preview_target(spec, context));
  // What an arm moves is real, what a tracked hand moves comes with its frames.
  if (state_.open->arm_space != nullptr || state_.measures_hand() || measures_both(state_)) return;
  const session::Session& session = *state_.open->session;
  // The session has just read the same file: a failure here would have been refused there.
  auto read = session::read_trial_scene(spec, session.known().record.hand.value_or(Hand::right),
                                        session::contact_thresholds(session.known().references),
                                        state_.config.library);
  if (!read) return flow_.refuse(read.error());
  if (read->scene) trial.scene = std::make_shared<Scene>(*std::move(read->scene));
}

void Trials::pause() {
  if (flow_.view().may_pause) state_.open->session->pause();
}

void Trials::resume() {
  if (flow_.view().may_resume) state_.open->session->resume();
}

bool Trials::test_stop() {
  if (!flow_.view().may_test_stop) return false;
  OpenSession& open = *state_.open;
  open.preparation.safety.stop_tested = true;
  open.session->note("The stop was pressed as a test.");
  flow_.update();
  return true;
}

void Trials::stop() {
  if (test_stop()) return;
  if (flow_.view().may_stop) state_.open->session->abort();
}

void Trials::let_go() {
  if (flow_.view().may_let_go) session::let_go(*state_.open->session);
}

void Trials::hold_clutch(bool held) {
  if (state_.open) session::hold_clutch(*state_.open->session, held);
}

void Trials::start_pause_resume() {
  if (test_stop()) return;
  const FlowView& view = flow_.view();
  if (view.may_pause) return pause();
  if (view.may_resume) return resume();
  // The key holds back what would begin by itself; it never makes it begin sooner.
  if (view.may_stand_by) return protocol_.stand_by();
  start();
}

void Trials::repeat() {
  if (!flow_.view().may_repeat) return;
  next_.hold();
  const EndedTrial last = *state_.open->ended;
  if (auto begun = begin(*last.task, last.practice, std::nullopt); !begun)
    flow_.refuse(begun.error());
}

void Trials::follow_time() {
  if (!state_.follows()) return;
  OpenSession& open = *state_.open;
  ProtocolGuide& guide = open.work.guide;
  const auto before = guide.act();
  guide.tick(open.time_s());
  if (before.has_value() != guide.act().has_value() ||
      (before && before->step != guide.act()->step))
    next_.look_at_act();
  if (!guide.goes_on() || !open.work.act_task || open.rating.questions.due()) return;
  flow_.decide();
  const FlowView& view = flow_.view();
  if (view.must_stand_by) return next_.hold();
  // Nothing begins by itself before the therapist says that the hand is in.
  const bool hand_is_in =
      view.situation != Situation::strap_in && view.situation != Situation::strap_again &&
      view.situation != Situation::check_platforms && view.situation != Situation::test_stop &&
      view.situation != Situation::promise_reach;
  if (view.may_begin && hand_is_in && guide.start_in_s(open.time_s()) <= 0.0) begin_next();
}

void Trials::look() {
  OpenSession& open = *state_.open;
  if (!open.trial) return;
  RunningTrial& trial = *open.trial;
  const session::Snapshot& now = open.snapshot;
  if (open.both) {
    look_at_both(*open.both, trial);
  } else if (now.stage == session::Stage::paused) {
    trial.rest_watch.add(now);
  } else {
    trial.rest_watch.begin(open.session->known().references.resting_C);
  }
  if (!is_running(now)) return;
  trial.arrived = true;
  trial.view = now.task;
}

/// Both hands rest as they did when their resting force was measured.
void Trials::look_at_both(const session::TwoPlatformsSnapshot& now, RunningTrial& trial) {
  HandsAtRest& rest = state_.open->hands_at_rest;
  if (now.stage == session::Stage::trial && is_rest(*trial.task)) rest.add(now);
  for (const Hand hand : kBothHands) {
    session::RestWatch& watch = trial.rest_watches[hand];
    if (now.stage == session::Stage::paused)
      watch.add(now.session_time_s, now.of[hand].forces);
    else
      watch.begin(rest.mean(hand));
  }
}

void Trials::renew_score() {
  OpenSession& open = *state_.open;
  if (!open.trial || !is_running(open.snapshot)) return;
  if (to_seconds(clock_.now() - open.trial->scored) <= kScoreEvery_s) return;
  open.trial->scored = clock_.now();
  open.trial->score = open.session->live_score();
  Q_EMIT flow_.score_changed();
}

void Trials::take(const session::TrialOutcome& outcome) {
  OpenSession& open = *state_.open;
  open.traces.last_trial = outcome;
  if (outcome.rest) open.preparation.rest_words = outcome.rest->words;
  if (open.both && open.trial && is_rest(*open.trial->task)) take_rest_of_both();
  // The trial is over; what follows from it is decided with what was known of it.
  if (open.trial) {
    const RunningTrial& trial = *open.trial;
    const bool completed = outcome.trial.status == storage::TrialStatus::completed;
    const bool missed = completed && trial.view.targets_reached < trial.view.target_count;
    open.ended = EndedTrial{trial.task, trial.practice, trial.helped, completed, missed};
    if (completed) take_progress(*trial.task);
    if (const auto* asked = trial.task->questionnaire; completed && asked != nullptr)
      open.rating.questions = {asked,
                               decltype(open.rating.questions.said)(asked->questions.size())};
    watch_limits(outcome);
  }
  if (open.work.follows()) open.work.guide.trial_ended(outcome, open.time_s());
  next_.look_at_act();
  open.trial.reset();
  clinic_.load_history(state_.choices.patient);
  Q_EMIT flow_.score_changed();
  Q_EMIT flow_.changed();
  Q_EMIT flow_.trial_ended();
}

void Trials::take_rest_of_both() {
  const tasks::TwoHandsReferences& known = state_.open->session->known().two_hands;
  const auto& left_N = known.of.left.resting_N;
  const auto& right_N = known.of.right.resting_N;
  if (left_N && right_N)
    state_.open->preparation.rest_words =
        "At rest left %1 N, right %2 N."_text(fixed(*left_N, 1), fixed(*right_N, 1));
}

/// A completed trial: the list of tasks goes on to what comes next.
void Trials::take_progress(const tasks::TaskSpec& task) {
  OpenSession& open = *state_.open;
  Work& work = open.work;
  if (is_rest(task)) {
    if (!open.preparation.rest_done) next_.select_first(is_grip_maximum);
    open.preparation.rest_done = true;
  } else if (is_grip_maximum(task)) {
    ++work.maximum_attempts;
    if (!work.task_done && open.session->known().maximum_force_N() > 0.0)
      next_.select_after_maximum();
  } else {
    work.task_done = work.task_done || task.kind->group != TaskGroup::rest_and_maximum;
  }
}

/// Work that should end does not go on by itself.
void Trials::watch_limits(const session::TrialOutcome& outcome) {
  session::WorkLimits& limits = state_.open->limits;
  const RunningTrial& trial = *state_.open->trial;
  const bool ended_before = limits.reason_to_stop().has_value();
  if (!is_rest(*trial.task)) limits.worked(trial.view.task_time_s);
  const bool counts =
      outcome.trial.status == storage::TrialStatus::completed && !outcome.trial.practice;
  limits.tried(counts ? outcome.measures : std::vector<Measure>{});
  limits.helped(trial.helped);
  if (!ended_before && limits.reason_to_stop()) next_.hold();
}

}  // namespace isograsp::gui
