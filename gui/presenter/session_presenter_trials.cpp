// SPDX-License-Identifier: GPL-3.0-or-later
// The presenter's part that runs trials, and what is said of them: helped, effort, pain, a note.
#include <memory>
#include <utility>

#include "gui/library/task_groups.hpp"
#include "gui/presenter/session_presenter.hpp"
#include "session/trial_setup.hpp"

namespace isograsp::gui {

void SessionPresenter::start() {
  if (!view_.may_start) return;
  if (follows()) open_->work.guide.go_on(choices_.by_itself);
  if (!view_.may_begin) return update();  // it waits for its time
  begin_next();
}

void SessionPresenter::begin_next() {
  if (!follows()) {
    auto spec = at_chosen_level(*next_task());
    auto begun =
        spec ? begin_trial(*spec, choices_.practice, std::nullopt) : Result<void>(spec.error());
    if (!begun) refuse(begun.error());
    return;
  }
  const auto act = guide().act();
  if (!open_->work.act_task) return;
  if (auto begun = begin_trial(*open_->work.act_task, act->practice, act->place); !begun) {
    if (begun.error().code != Error::Code::bad_input) {
      hold();
      return refuse(begun.error());
    }
    leave_out(begun.error());
  }
}

Result<void> SessionPresenter::begin_trial(const tasks::TaskSpec& spec, bool practice,
                                           std::optional<storage::TrialPlace> place) {
  example_.stop();
  open_->preparation.zero_refusal.clear();
  open_->preparation.zero_only_changed = false;
  const tasks::TaskContext context = open_->session->next_context();
  if (auto started = open_->session->start_trial(spec, practice, place); !started) return started;
  open_->trial.emplace();
  open_->trial->practice = practice;
  if (open_->rating.corrects) ask_rating_anew();
  prepare_picture(spec, context);
  Q_EMIT score_changed();
  update();
  return {};
}

void SessionPresenter::prepare_picture(const tasks::TaskSpec& spec,
                                       const tasks::TaskContext& context) {
  RunningTrial& trial = *open_->trial;
  trial.task = std::make_shared<tasks::TaskSpec>(spec);
  trial.preview = std::make_shared<TargetPreview>(preview_target(spec, context));
  const session::Session& session = *open_->session;
  // The session has just read the same file: a failure here would have been refused there.
  auto read = session::read_trial_scene(spec, session.record().hand, session.contact_thresholds_N(),
                                        config_.library);
  if (!read) return refuse(read.error());
  if (read->scene) trial.scene = std::make_shared<Scene>(*std::move(read->scene));
}

void SessionPresenter::take_trial(const session::TrialOutcome& outcome) {
  open_->traces.last_trial = outcome;
  if (outcome.rest) open_->preparation.rest_words = outcome.rest->words;
  // The trial is over; what follows from it is decided with what was known of it.
  if (open_->trial) {
    RunningTrial& trial = *open_->trial;
    const bool completed = outcome.trial.status == storage::TrialStatus::completed;
    const bool missed = completed && trial.view.targets_reached < trial.view.target_count;
    open_->ended = EndedTrial{trial.task, trial.practice, trial.helped, completed, missed};
    if (completed) take_progress(*trial.task);
    watch_limits(outcome);
  }
  if (follows()) open_->work.guide.trial_ended(outcome, open_->time_s());
  look_at_act();
  open_->trial.reset();
  clinic_.load_history(choices_.patient);
  Q_EMIT score_changed();
  Q_EMIT changed();
  Q_EMIT trial_ended();
}

/// A completed trial: the list of tasks goes on to what comes next.
void SessionPresenter::take_progress(const tasks::TaskSpec& task) {
  Work& work = open_->work;
  if (is_rest(task)) {
    if (!open_->preparation.rest_done) select(first_task(is_grip_maximum));
    open_->preparation.rest_done = true;
  } else if (is_grip_maximum(task)) {
    ++work.maximum_attempts;
    if (!work.task_done && open_->session->maximum_force_N() > 0.0) select_task_after_maximum();
  } else {
    work.task_done = work.task_done || task.kind->group != TaskGroup::rest_and_maximum;
  }
}

/// Work that should end does not go on by itself.
void SessionPresenter::watch_limits(const session::TrialOutcome& outcome) {
  session::WorkLimits& limits = open_->limits;
  const RunningTrial& trial = *open_->trial;
  const bool ended_before = limits.reason_to_stop().has_value();
  if (!is_rest(*trial.task)) limits.worked(trial.view.task_time_s);
  const bool counts =
      outcome.trial.status == storage::TrialStatus::completed && !outcome.trial.practice;
  limits.tried(counts ? outcome.measures : std::vector<Measure>{});
  limits.helped(trial.helped);
  if (!ended_before && limits.reason_to_stop()) hold();
}

void SessionPresenter::pause() {
  if (view_.may_pause) open_->session->pause();
}

void SessionPresenter::resume() {
  if (view_.may_resume) open_->session->resume();
}

void SessionPresenter::stop() {
  if (view_.may_stop) open_->session->abort();
}

void SessionPresenter::start_pause_resume() {
  if (view_.may_pause) return pause();
  if (view_.may_resume) return resume();
  // What would begin by itself is held: the key never makes it begin sooner.
  if (view_.may_stand_by) return stand_by();
  start();
}

bool SessionPresenter::may_repeat() const noexcept {
  return view_.may_repeat;
}

void SessionPresenter::repeat() {
  if (!may_repeat()) return;
  hold();
  const EndedTrial last = *open_->ended;
  if (auto begun = begin_trial(*last.task, last.practice, std::nullopt); !begun)
    refuse(begun.error());
}

bool SessionPresenter::helped() const noexcept {
  if (!open_) return false;
  return open_->trial ? open_->trial->helped : open_->ended && open_->ended->helped;
}

bool SessionPresenter::may_help() const noexcept {
  if (!open_) return false;
  const bool starting = open_->trial && !open_->trial->arrived;
  return view_.may_stop || (open_->ended && !starting);
}

void SessionPresenter::toggle_helped() {
  if (!may_help()) return;
  const bool ended_before = open_->limits.reason_to_stop().has_value();
  const bool now = !helped();
  if (open_->trial) {
    open_->trial->helped = now;
  } else {
    open_->ended->helped = now;
    open_->limits.helped(now);
  }
  open_->session->mark_helped(now);
  if (!ended_before && open_->limits.reason_to_stop()) hold();
  clinic_.load_history(choices_.patient);
  update();
}

void SessionPresenter::rate_effort(int effort) {
  if (!open_) return;
  open_->rating.effort = effort;
  store_rating();
}

void SessionPresenter::rate_pain(int pain) {
  if (!open_) return;
  open_->rating.pain = pain;
  store_rating();
}

void SessionPresenter::store_rating() {
  Rating& rating = open_->rating;
  if (rating.effort && rating.pain) {
    const auto reason = rating.corrects
                            ? open_->session->correct_rating(*rating.effort, *rating.pain)
                            : open_->session->rate(*rating.effort, *rating.pain);
    rating.stop_reason = reason.value_or("");
    if (!rating.stop_reason.empty()) hold();
    if (!rating.corrects) open_->work.guide.rated();
    rating.last = Rating::Answer{*rating.effort, *rating.pain};
    rating.corrects = true;
  }
  update();
}

void SessionPresenter::ask_rating_anew() {
  open_->rating.effort.reset();
  open_->rating.pain.reset();
  open_->rating.corrects = false;
}

void SessionPresenter::show_rated() {
  if (!rating().last) return;
  open_->rating.effort = rating().last->effort;
  open_->rating.pain = rating().last->pain;
  open_->rating.corrects = true;
  update();
}

void SessionPresenter::show_how() {
  if (example_.showing()) {
    example_.stop();
    return update();
  }
  if (!view_.may_show_how) return;
  hold();
  example_.show(*next_task(), open_ ? open_->session->references() : tasks::ForceReferences{},
                choices_.today.hand.value_or(Hand::right), config_.library,
                [this](const Result<void>& shown) {
                  if (!shown) refuse(shown.error());
                  update();
                });
  update();
}

void SessionPresenter::note(const std::string& text) {
  if (open_ && !text.empty()) open_->session->note(text);
}

}  // namespace isograsp::gui
