// SPDX-License-Identifier: GPL-3.0-or-later
// The presenter's part that opens and closes sessions, on the worker.
#include <cstdio>
#include <utility>

#include "gui/library/task_groups.hpp"
#include "gui/presenter/session_presenter.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

void SessionPresenter::connect_device() {
  if (!view_.may_connect) return;
  example_.stop();
  const auto config = session_config(connection_.failure && connection_.failure->asks_clock);
  connection_ = {};
  connection_.phase = Connection::opening;
  using Opened = Result<std::unique_ptr<session::Session>>;
  worker_.run(
      [config, stop = connection_.opening.get_token()]() -> Opened {
        if (stop.stop_requested()) return cancelled();
        auto opened = session::Session::open(config);
        if (stop.stop_requested()) return cancelled();
        return opened;
      },
      [this, stop = connection_.opening.get_token(),
       stored = seating_.presentation()](Opened opened) {
        if (stop.stop_requested()) {
          // Cancelled after the worker had looked: closing takes its time.
          if (opened) close_on_worker(*std::move(opened), [](const std::optional<Error>&) {});
          return;
        }
        take_opened(std::move(opened), stored);
      });
  update();
}

session::SessionConfig SessionPresenter::session_config(bool clock_is_right) const {
  const Screening& screening = choices_.today.screening;
  session::SessionConfig config;
  config.database = config_.database;
  config.patient_code = choices_.patient;
  config.hand = *choices_.today.hand;
  config.device_uri = choices_.device_uri;
  config.library = config_.library;
  config.software_version = config_.software_version;
  config.operator_name = !operator_.empty()               ? operator_
                         : !config_.operator_name.empty() ? config_.operator_name
                                                          : settings_.now().operator_name;
  config.realtime = config_.realtime;
  config.allowed = screening.allowed;
  config.ceiling_N = screening.ceiling_N;
  config.answers = stored(screening);
  for (auto& answer : screen_answers()) config.answers.push_back(std::move(answer));
  config.display_delay_s = settings_.now().display_delay_s;
  config.resume = choices_.interrupted.go_on.value_or(false);
  config.clock_is_right = clock_is_right;
  if (has_protocol()) {
    const auto& protocol = library_.protocols[static_cast<std::size_t>(choices_.protocol)].spec;
    config.protocol_name = protocol.name;
    config.protocol_text = protocol.text;
  }
  config.settle_after_strapping_s = config_.settle_after_strapping_s;
  return config;
}

void SessionPresenter::take_opened(Result<std::unique_ptr<session::Session>> opened,
                                   const Presentation& stored) {
  if (opened) {
    begin_session(*std::move(opened), stored);
  } else {
    connection_.phase = Connection::none;
    Error error = opened.error();
    const bool asks_clock = error.field == "clock";
    if (asks_clock) error.remedy = "set the clock, or connect again if it is right";
    connection_.failure = {shown(error).toStdString(), false, asks_clock};
    room_.begin();  // perhaps the disk is full
  }
  update();
  Q_EMIT settled();
}

void SessionPresenter::cancel_connecting() {
  if (connection_.phase != Connection::opening) return;
  connection_.opening.request_stop();
  connection_.phase = Connection::none;
  update();
  Q_EMIT settled();
}

void SessionPresenter::begin_session(std::unique_ptr<session::Session> session,
                                     const Presentation& stored) {
  const bool numb_skin = choices_.today.screening.applies[static_cast<std::size_t>(Caution::skin)];
  const auto task = first_task(session->device().recorded ? is_free_handling : is_rest);
  left_ = {};
  open_.emplace(std::move(session), clock_.now(), numb_skin, stored, task.value_or(choices_.task));
  connection_.phase = Connection::open;
  take_earlier_work();
  if (const auto got = realtime(); !got.empty() && !std::exchange(realtime_said_, true))
    std::fprintf(stderr, "isograsp: note: acquisition with %s\n", got.c_str());
  begin_protocol();
}

/// The hand has worked before the session was interrupted.
void SessionPresenter::take_earlier_work() {
  session::WorkLimits& limits = open_->limits;
  for (const auto& [trial, measures, ended_s] : open_->session->earlier().trials) {
    const auto spec = tasks::parse_task(trial.task_text, trial.task_name);
    if (spec && !is_rest(*spec))
      limits.worked(static_cast<double>(trial.samples) / open_->session->record().rate_Hz);
    if (!trial.practice && !trial.helped) limits.tried(measures);
  }
}

void SessionPresenter::disconnect_device() {
  if (view_.may_disconnect) close_session("");
}

void SessionPresenter::end_session() {
  cancel_connecting();
  if (open_) close_session("");
}

template <class Closed>
void SessionPresenter::close_on_worker(std::unique_ptr<session::Session> session, Closed closed) {
  worker_.run(
      [leaving = std::make_shared<std::unique_ptr<session::Session>>(std::move(session))] {
        (*leaving)->close();
        auto lost = (*leaving)->failure();
        leaving->reset();
        return lost;
      },
      [closed = std::move(closed)](const std::optional<Error>& lost) { closed(lost); });
}

/// `why`: it could not go on; empty: the therapist ends it.
void SessionPresenter::close_session(const std::string& why) {
  example_.stop();
  connection_.phase = Connection::closing;
  connection_.failure.reset();
  if (!why.empty()) {
    connection_.failure = {why, true, false};
    keep_broken_trial(why);
  }
  auto leaving = std::move(open_->session);
  left_ = std::move(open_->traces);
  open_.reset();
  close_on_worker(std::move(leaving), [this](const std::optional<Error>& lost) {
    connection_.phase = Connection::none;
    connection_.lost = lost;
    if (lost && !broken_off())  // the last look found it
      connection_.failure = {shown(*lost).toStdString(), true, false};
    ask_anew();
    clinic_.load_history(choices_.patient);
    update();
    Q_EMIT settled();
  });
  update();
}

/// What was measured of a trial that could not be ended is that trial's, and no other one's.
void SessionPresenter::keep_broken_trial(const std::string& why) {
  room_.begin();
  if (!open_->trial) return;
  session::TrialOutcome& outcome = open_->traces.last_trial.emplace();
  outcome.trial.task_name = open_->trial->task->name;
  outcome.trial.practice = open_->trial->practice;
  outcome.trial.status = storage::TrialStatus::interrupted;
  outcome.reason = why;
  outcome.measures = open_->trial->score;
  Q_EMIT score_changed();
}

}  // namespace isograsp::gui
