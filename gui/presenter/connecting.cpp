// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/presenter/connecting.hpp"

#include <cstdio>
#include <utility>

#include "gui/library/task_groups.hpp"
#include "gui/words/texts.hpp"
#include "session/open_hand.hpp"

namespace isograsp::gui {

Connecting::Connecting(const ActContext& with, SessionChoices& choices, NextWork& next)
    : state_(with.state),
      flow_(with.flow),
      clinic_(with.clinic),
      settings_(with.settings),
      seating_(with.seating),
      worker_(with.worker),
      example_(with.example),
      clock_(with.clock),
      choices_(choices),
      next_(next),
      room_(with.state.config.database) {}

void Connecting::connect_device() {
  if (!flow_.view().may_connect) return;
  example_.stop();
  ConnectionState& connection = state_.connection;
  const auto config = session_config(connection.failure && connection.failure->asks_clock);
  connection = {};
  connection.phase = Connection::opening;
  using Opened = Result<std::unique_ptr<session::Session>>;
  worker_.run(
      [config, stop = connection.opening.get_token()]() -> Opened {
        if (stop.stop_requested()) return cancelled();
        auto opened = session::Session::open(config);
        if (stop.stop_requested()) return cancelled();
        return opened;
      },
      [this, stop = connection.opening.get_token(),
       stored = seating_.presentation()](Opened opened) {
        if (stop.stop_requested()) {
          // Cancelled after the worker had looked: closing takes its time.
          if (opened) close_on_worker(*std::move(opened), [](const std::optional<Error>&) {});
          return;
        }
        take(std::move(opened), stored);
      });
  flow_.update();
}

session::SessionConfig Connecting::session_config(bool clock_is_right) const {
  const Choices& choices = state_.choices;
  const GuiConfig& started = state_.config;
  const Settings& settings = settings_.now();
  session::SessionConfig config;
  config.database = started.database;
  config.patient_code = choices.patient;
  config.hand = choices.today.hand;  // nothing: both
  config.device_uri = choices.today.size_of_other && state_.measures_hand()
                          ? session::with_size_of_other(choices.device_uri)
                          : choices.device_uri;
  config.apparatuses = started.apparatuses;
  config.library = started.library;
  config.software_version = started.software_version;
  config.operator_name = !choices.operator_name.empty()   ? choices.operator_name
                         : !started.operator_name.empty() ? started.operator_name
                                                          : settings.operator_name;
  config.realtime = started.realtime;
  if (state_.measures_arm()) {
    config.allowed = choices.today.arm_screening.allowed;
    config.answers = stored(choices.today.arm_screening);
  } else if (state_.measures_hand()) {
    config.allowed = allowed(choices.today.hand_screening);
    config.answers = stored(choices.today.hand_screening);
  } else if (measures_both(state_)) {
    const BothScreenings& both = choices.today.screenings;
    config.allowed = allowed(both);
    for (const Hand hand : kBothHands) config.ceilings_N[hand] = both[hand].ceiling_N;
    config.answers = stored(both);
  } else {
    config.allowed = choices.today.screening.allowed;
    config.ceiling_N = choices.today.screening.ceiling_N;
    config.answers = stored(choices.today.screening);
  }
  for (auto& answer : stored(seating_.presentation())) config.answers.push_back(std::move(answer));
  const auto& delay_s = settings.display_delay_s;
  config.answers.push_back(
      {"screen", "display_delay_s",
       delay_s ? QString::number(*delay_s, 'f', 4).toStdString() : "not measured"});
  config.display_delay_s = delay_s;
  config.resume = choices.interrupted.go_on.value_or(false);
  config.clock_is_right = clock_is_right;
  if (state_.has_protocol()) {
    config.protocol_name = state_.chosen_protocol().spec.name;
    config.protocol_text = state_.chosen_protocol().spec.text;
    config.apparatus = state_.chosen_protocol().apparatus();
  }
  config.settle_after_strapping_s = started.settle_after_strapping_s;
  return config;
}

void Connecting::take(Result<std::unique_ptr<session::Session>> opened,
                      const Presentation& stored) {
  if (opened) {
    begin(*std::move(opened), stored);
  } else {
    state_.connection.phase = Connection::none;
    Error error = opened.error();
    const bool asks_clock = error.field == "clock";
    if (asks_clock) error.remedy = "set the clock, or connect again if it is right"_text;
    const bool asks_basis = error.field == "consent";
    auto failure = ConnectionState::Failure::of(std::move(error));
    if (asks_basis) {
      failure.happened =
          translated("No lawful basis is on record for a camera that sees this person."_text)
              .toStdString();
      failure.remedy =
          translated("Record it in the step Tracker, then connect again."_text).toStdString();
    }
    failure.asks_clock = asks_clock;
    failure.asks_basis = asks_basis;
    state_.connection.failure = std::move(failure);
    room_.begin();  // perhaps the disk is full
  }
  flow_.update();
  Q_EMIT flow_.settled();
}

void Connecting::begin(std::unique_ptr<session::Session> session, const Presentation& stored) {
  const Choices& choices = state_.choices;
  const bool numb_skin =
      choices.today.both ? applies_to_one(choices.today.screenings, Caution::skin)
                         : choices.today.screening.applies[static_cast<std::size_t>(Caution::skin)];
  const bool rests = !session->known().apparatus.recorded &&
                     session->known().asks_for(session::PreparationStep::rest);
  const auto task = session->known().arm || session->known().apparatus.kind == kTrackedHand
                        ? std::nullopt
                        : first_task(state_.library.tasks, rests ? is_rest : is_free_handling);
  state_.left = {};
  state_.open.emplace(std::move(session), clock_.now(), numb_skin, stored,
                      task ? task : choices.task);
  state_.connection.phase = Connection::open;
  take_earlier_work();
  if (const auto got = state_.realtime(); !got.empty() && !std::exchange(realtime_said_, true))
    std::fprintf(stderr, "isograsp: note: acquisition with %s\n", english(got).c_str());
  next_.begin();
}

/// The hand has worked before the session was interrupted.
void Connecting::take_earlier_work() {
  OpenSession& open = *state_.open;
  for (const session::EarlierTrial& earlier : open.session->known().earlier.trials) {
    const storage::TrialRecord& trial = earlier.record;
    const auto spec = tasks::parse_task(trial.task_text, trial.task_name);
    if (spec && !is_rest(*spec)) open.limits.worked(earlier.lasted_s);
    if (!trial.practice && !trial.helped) open.limits.tried(earlier.measures);
  }
}

void Connecting::cancel() {
  if (state_.connection.phase != Connection::opening) return;
  state_.connection.opening.request_stop();
  state_.connection.phase = Connection::none;
  flow_.update();
  Q_EMIT flow_.settled();
}

void Connecting::disconnect_device() {
  if (flow_.view().may_disconnect) end_session();
}

void Connecting::take_other_hand() {
  if (!flow_.view().may_take_other_hand) return;
  follows_ = other_than(*state_.open->session->known().record.hand);
  end_session();
}

void Connecting::try_again() {
  if (!flow_.view().may_try_again) return;
  if (state_.open) return end_session();  // its device sends nothing any more
  state_.connection.failure.reset();      // who tries again has not said that the clock is right
  flow_.update();
  connect_device();
}

void Connecting::end_session() {
  cancel();
  if (!state_.open) return;
  state_.connection.failure.reset();
  close();
}

void Connecting::basis_recorded() {
  if (!state_.connection.failure || !state_.connection.failure->asks_basis) return;
  state_.connection.failure.reset();
  flow_.update();
}

void Connecting::break_off(const Error& why) {
  auto failure = ConnectionState::Failure::of(why);
  failure.broken_off = true;
  failure.stored_until_utc = session::stored_until_utc(*state_.open->session);
  state_.connection.failure = std::move(failure);
  keep_broken_trial(translated(why).toStdString());
  close();
}

/// Measures of a trial that could not be ended must not be shown for another one.
void Connecting::keep_broken_trial(const std::string& why) {
  room_.begin();
  OpenSession& open = *state_.open;
  if (!open.trial) return;
  session::TrialOutcome& outcome = open.traces.last_trial.emplace();
  outcome.trial.task_name = open.trial->task->name;
  outcome.trial.practice = open.trial->practice;
  outcome.trial.status = storage::TrialStatus::interrupted;
  outcome.reason = Known{why};
  outcome.measures = open.trial->score;
  Q_EMIT flow_.score_changed();
}

void Connecting::close() {
  example_.stop();
  state_.connection.phase = Connection::closing;
  auto leaving = std::move(state_.open->session);
  state_.left = std::move(state_.open->traces);
  state_.open.reset();
  close_on_worker(std::move(leaving), [this](const std::optional<Error>& lost) {
    ConnectionState& connection = state_.connection;
    connection.phase = Connection::none;
    connection.lost = lost;
    if (lost && !state_.broken_off()) {  // the last look found it
      connection.failure = ConnectionState::Failure::of(*lost);
      connection.failure->broken_off = true;
    }
    choices_.ask_anew();
    if (const auto hand = std::exchange(follows_, std::nullopt); hand && !lost)
      choices_.follow_with(*hand);
    clinic_.load_history(state_.choices.patient);
    flow_.update();
    Q_EMIT flow_.settled();
  });
  flow_.update();
}

template <class Closed>
void Connecting::close_on_worker(std::unique_ptr<session::Session> session, Closed closed) {
  worker_.run(
      [leaving = std::make_shared<std::unique_ptr<session::Session>>(std::move(session))] {
        (*leaving)->close();
        auto lost = (*leaving)->failure();
        leaving->reset();
        return lost;
      },
      [closed = std::move(closed)](const std::optional<Error>& lost) { closed(lost); });
}

void Connecting::look() {
  bool& follows = state_.choices.today.follows_other_hand;
  if (follows && flow_.view().may_connect) {
    follows = false;  // what fails is tried again by a press
    connect_device();
  }
  ConnectionState& connection = state_.connection;
  if (connection.failure && connection.phase == Connection::none && room_.has_come_back())
    connection.failure.reset();
}

}  // namespace isograsp::gui
