// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/presenter/session_presenter.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "gui/library/task_groups.hpp"
#include "gui/words/texts.hpp"
#include "session/trial_setup.hpp"

namespace isograsp::gui {

namespace {

constexpr int kPoll_ms = 16;
constexpr double kScoreEvery_s = 1.0;

/// "The target is … : run …."
std::string sentence_of(const Error& error) {
  QString words = shown(error.what);
  if (!error.remedy.empty()) words += QStringLiteral(": ") + shown(error.remedy);
  words[0] = words[0].toUpper();
  return (words + QLatin1Char('.')).toStdString();
}

/// The first force that the task is scaled to and that was not measured, in words; empty: none.
std::string lack_of(const tasks::TaskSpec& spec, const tasks::ForceReferences& references) {
  for (const tasks::Scale scale :
       {tasks::Scale::of_maximum, tasks::Scale::of_comfortable, tasks::Scale::of_baseline})
    for (const ForceChannel channel : spec.channels_needed(scale)) {
      const auto unit = references.unit_N(scale, channel, spec.largest_level());
      if (!unit) return sentence_of(unit.error());
    }
  return "";
}

}  // namespace

SessionPresenter::SessionPresenter(const GuiConfig& config, Clinic& clinic,
                                   const SettingsFile& settings, QObject* parent)
    : QObject(parent),
      config_(config),
      clinic_(clinic),
      settings_(settings),
      seating_(clinic),
      device_uri_(config.device_uri) {
  take_library(
      read_session_library(config_.library, session::own_library_folder(config_.database)));
  select_first(TaskKind::rest);
  connect(&clinic_, &Clinic::opened, this, &SessionPresenter::update);
  connect(&clinic_, &Clinic::open_failed, this, [this](const QString& why) {
    database_error_ = why.toStdString();
    update();
  });
  connect(&timer_, &QTimer::timeout, this, &SessionPresenter::poll);
  connect(&seating_, &Seating::changed, this, &SessionPresenter::store_presentation);
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.start(kPoll_ms);
  update();
}

SessionPresenter::~SessionPresenter() = default;

void SessionPresenter::select_first(TaskKind kind) {
  const auto& tasks = library_.tasks;
  const auto found = std::find_if(tasks.begin(), tasks.end(), [&](const tasks::TaskSpec& spec) {
    return kind_of(spec) == kind;
  });
  if (found != tasks.end()) task_ = static_cast<int>(found - tasks.begin());
  look_at_task();
}

/// A target that follows the force just measured.
void SessionPresenter::select_task_after_maximum() {
  const auto& references = session_->references();
  const auto& tasks = library_.tasks;
  const auto found = std::find_if(tasks.begin(), tasks.end(), [&](const tasks::TaskSpec& spec) {
    return kind_of(spec) == TaskKind::force_tracking && lack_of(spec, references).empty();
  });
  if (found != tasks.end()) task_ = static_cast<int>(found - tasks.begin());
  look_at_task();
}

/// Once per choice and measurement: the flow is decided sixty times a second.
void SessionPresenter::look_at_task() {
  task_lacks_.clear();
  const auto* spec = next_task();
  // What a protocol asks is not refused beforehand: it is left out, with the reason.
  if (spec == nullptr || session_ == nullptr || follows()) return;
  task_lacks_ = lack_of(*spec, session_->references());
}

const tasks::TaskSpec* SessionPresenter::next_task() const noexcept {
  if (follows()) return act_task_ ? &*act_task_ : nullptr;
  if (session_ == nullptr && has_protocol()) return nullptr;  // the protocol will say
  return task_ < 0 ? nullptr : &library_.tasks[static_cast<std::size_t>(task_)];
}

FlowFacts SessionPresenter::facts() const {
  FlowFacts facts;
  facts.database_open = clinic_.is_open();
  facts.database_error = database_error_;
  facts.look_only = config_.look_only;
  facts.patient_chosen = !patient_.empty();
  facts.hand_to_confirm = hand_to_confirm();
  facts.hand_chosen = hand_ && !facts.hand_to_confirm;
  facts.screened = screening_.complete();
  facts.earlier_sought = looking_;
  facts.earlier_undecided = earlier_.has_value() && !resume_;
  facts.device_chosen = !device_uri_.empty();
  facts.connection = connection_;
  facts.connection_error = connection_error_;
  facts.recorded = recorded();
  if (session_ != nullptr) {
    facts.anything_arrived = snapshot_.frames > 0;
    const Timestamp now = clock_.now();
    facts.frozen = snapshot_.stage != session::Stage::finished &&
                   (facts.anything_arrived ? to_seconds(now - snapshot_.published) > kFrozenAfter_s
                                           : to_seconds(now - opened_) > kFirstFrameWithin_s);
    facts.stage = snapshot_.stage;
    facts.pause_cause = snapshot_.pause_cause;
    facts.at_rest = rest_watch_.at_rest();
    facts.health = snapshot_.health;
    facts.zeroed = snapshot_.zeroed;
    facts.restarted = snapshot_.restarted;
    facts.maximum_force_N = session_->maximum_force_N();
    facts.settling_s = static_cast<int>(std::ceil(session_->settling_s()));
  }
  facts.zero_refusal = zero_refusal_;
  facts.zero_only_changed = zero_only_changed_;
  facts.zero_remark = zero_remark_;
  facts.strapped = strapped_;
  facts.straps_due = session_ != nullptr && strapped_ && limits_.straps_due(session_time_s());
  facts.hand_out = rest_done_ && !strapped_ && facts.zeroed && !facts.recorded;
  facts.rest_words = rest_words_;
  facts.rest_done = rest_done_ || (follows() && !guide_.asks_rest());
  facts.maximum_attempts = maximum_attempts_;
  facts.task_done = task_done_;
  facts.zero_asked = zero_asked_;
  // From the press of Start until the trial's outcome is stored, with the trial itself in between.
  facts.starting = starting_ || (running_ != nullptr && facts.stage == session::Stage::idle);
  facts.stop_reason = stop_reason_.empty() ? limits_.reason_to_stop().value_or("") : stop_reason_;
  if (follows()) facts.protocol = protocol_facts();
  if (last_task_) facts.last_kind = kind_of(*last_task_);
  const auto* spec = running_ != nullptr ? running_.get() : next_task();
  facts.task_chosen = spec != nullptr;
  if (spec != nullptr) {
    facts.task_kind = kind_of(*spec);
    facts.task_name = spec->name;
    facts.task_lacks = task_lacks_;
  }
  return facts;
}

void SessionPresenter::update() {
  view_ = decide(facts());
  Q_EMIT changed();
}

void SessionPresenter::refuse(const Error& error) {
  Q_EMIT failed(shown(error));
}

void SessionPresenter::choose_patient(const std::string& code) {
  if (connection_ != Connection::none || code == patient_) return;
  patient_ = code;
  ask_anew();
  forget_failure();
  last_trial_.reset();
  live_score_.clear();
  clinic_.load_history(code);
  clinic_.load_profile(code);
  seating_.look(code, hand_);
  update();
}

void SessionPresenter::choose_hand(Hand hand) {
  if (!view_.may_change_hand) return;
  forget_failure();
  if (hand_ != hand) screening_ = {};  // its outcome is that of one hand
  hand_ = hand;
  hand_confirmed_ = false;
  look_for_earlier();
  seating_.look(patient_, hand_);
  update();
}

/// Looked up whenever it is asked: what is known of the person may be read, or told, after the hand
/// was chosen. A session that is open has its hand.
bool SessionPresenter::hand_to_confirm() const noexcept {
  const auto& file = clinic_.file();
  if (!hand_ || hand_confirmed_ || connection_ != Connection::none) return false;
  if (!file || clinic_.file_of() != patient_) return false;
  return file->profile.affected ==
         (*hand_ == Hand::right ? storage::Side::left : storage::Side::right);
}

/// Whoever goes on with the next session has read why the last one ended.
void SessionPresenter::forget_failure() {
  connection_error_.clear();
  broken_off_ = false;
  clock_asked_ = false;  // nobody sees the question any more
}

void SessionPresenter::confirm_hand() {
  if (!hand_to_confirm()) return;
  hand_confirmed_ = true;
  update();
}

/// Before every session: hand and screening.
void SessionPresenter::ask_anew() {
  hand_.reset();
  screening_ = {};
  look_for_earlier();  // for nobody yet: what was asked before counts no more
}

void SessionPresenter::choose_device(const std::string& uri) {
  if (!view_.may_change_device) return;
  device_uri_ = uri;
  forget_failure();
  look_for_earlier();
  update();
}

void SessionPresenter::choose_task(int index) {
  if (!view_.may_choose_task || index == task()) return;
  example_.stop();
  guide_.go_on(false);
  by_hand_ = true;
  task_ = index;
  look_at_task();
  update();
}

void SessionPresenter::set_practice(bool practice) {
  practice_ = practice;
}

void SessionPresenter::connect_device() {
  if (!view_.may_connect) return;
  example_.stop();
  session::SessionConfig config;
  config.database = config_.database;
  config.patient_code = patient_;
  config.hand = *hand_;
  config.device_uri = device_uri_;
  config.library = config_.library;
  config.software_version = config_.software_version;
  config.operator_name = !operator_.empty()               ? operator_
                         : !config_.operator_name.empty() ? config_.operator_name
                                                          : settings_.now().operator_name;
  config.realtime = config_.realtime;
  config.allowed = screening_.allowed;
  config.ceiling_N = screening_.ceiling_N;
  config.answers = stored(screening_);
  add_screen_answers(config.answers);
  config.display_delay_s = settings_.now().display_delay_s;
  config.resume = resume_.value_or(false);
  config.clock_is_right = clock_asked_;
  if (has_protocol()) {
    const auto& protocol = library_.protocols[static_cast<std::size_t>(protocol_)].spec;
    config.protocol_name = protocol.name;
    config.protocol_text = protocol.text;
  }
  config.settle_after_strapping_s = config_.settle_after_strapping_s;
  connection_ = Connection::opening;
  lost_.reset();
  forget_failure();
  opening_ = {};
  using Opened = Result<std::unique_ptr<session::Session>>;
  worker_.run(
      [config, stop = opening_.get_token()]() -> Opened {
        if (stop.stop_requested()) return cancelled();
        auto opened = session::Session::open(config);
        if (stop.stop_requested()) return cancelled();
        return opened;
      },
      [this, stop = opening_.get_token()](Opened opened) {
        if (stop.stop_requested()) {
          // Cancelled after the worker had looked: closing takes its time.
          if (opened) close_on_worker(*std::move(opened), [](const std::optional<Error>&) {});
          return;
        }
        if (opened) {
          begin_session(*std::move(opened));
        } else {
          connection_ = Connection::none;
          Error error = opened.error();
          clock_asked_ = error.field == "clock";
          if (clock_asked_) error.remedy = "set the clock, or connect again if it is right";
          connection_error_ = shown(error).toStdString();
          room_.begin();  // perhaps the disk is full
        }
        update();
        Q_EMIT settled();
      });
  update();
}

void SessionPresenter::cancel_connecting() {
  if (connection_ != Connection::opening) return;
  opening_.request_stop();
  connection_ = Connection::none;
  update();
  Q_EMIT settled();
}

void SessionPresenter::begin_session(std::unique_ptr<session::Session> session) {
  session_ = std::move(session);
  opened_ = clock_.now();
  connection_ = Connection::open;
  snapshot_ = {};
  forces_.clear();
  faults_.clear();
  compensation_ = {};
  limits_.begin(screening_.applies[static_cast<std::size_t>(Caution::skin)]);
  take_earlier_work();
  shift_noted_ = {};
  worst_lateness_s_ = 0.0;
  zero_refusal_.clear();
  zero_remark_.clear();
  rest_words_.clear();
  zero_only_changed_ = strapped_ = false;
  zeroed_at_.reset();
  if (const auto got = realtime(); !got.empty() && !std::exchange(realtime_said_, true))
    std::fprintf(stderr, "isograsp: note: acquisition with %s\n", got.c_str());
  zero_asked_ = rest_done_ = task_done_ = starting_ = just_completed_ = false;
  maximum_attempts_ = 0;
  running_.reset();
  last_trial_.reset();
  last_task_.reset();
  live_score_.clear();
  helped_ = false;
  rated_.reset();
  ask_rating_anew();
  stop_reason_.clear();
  select_first(recorded() ? TaskKind::observe : TaskKind::rest);
  begin_protocol();
}

/// The hand has worked before the session was interrupted.
void SessionPresenter::take_earlier_work() {
  for (const auto& [trial, measures, ended_s] : session_->earlier().trials) {
    const auto spec = tasks::parse_task(trial.task_text, trial.task_name);
    if (spec && kind_of(*spec) != TaskKind::rest)
      limits_.worked(static_cast<double>(trial.samples) / session_->record().rate_Hz);
    if (!trial.practice && !trial.helped) limits_.tried(measures);
  }
}

void SessionPresenter::disconnect_device() {
  if (view_.may_disconnect) close_session("");
}

void SessionPresenter::end_session() {
  cancel_connecting();
  if (session_ != nullptr) close_session("");
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

void SessionPresenter::close_session(const std::string& why) {
  example_.stop();
  connection_ = Connection::closing;
  broken_off_ = !why.empty();
  connection_error_ = why;
  if (!why.empty()) keep_broken_trial(why);
  snapshot_ = {};
  compensation_ = {};  // nothing is measured any more
  running_.reset();
  starting_ = zero_asked_ = false;
  guide_.end();
  act_task_.reset();
  close_on_worker(std::move(session_), [this](const std::optional<Error>& lost) {
    connection_ = Connection::none;
    lost_ = lost;
    if (lost && !broken_off_) {  // the last look found it
      broken_off_ = true;
      connection_error_ = shown(*lost).toStdString();
    }
    ask_anew();
    clinic_.load_history(patient_);
    update();
    Q_EMIT settled();
  });
  update();
}

/// What was measured of a trial that could not be ended is that trial's, and no other one's.
void SessionPresenter::keep_broken_trial(const std::string& why) {
  room_.begin();
  if (running_ == nullptr) return;
  last_trial_ = session::TrialOutcome{};
  last_trial_->trial.task_name = running_->name;
  last_trial_->trial.practice = last_practice_;
  last_trial_->trial.status = storage::TrialStatus::interrupted;
  last_trial_->reason = why;
  last_trial_->measures = live_score_;
  Q_EMIT score_changed();
}

void SessionPresenter::set_zero(bool accept_changed) {
  if (!(accept_changed ? view_.may_accept_changed : view_.may_zero)) return;
  example_.stop();
  zero_refusal_.clear();
  zero_remark_.clear();
  zero_only_changed_ = false;
  session::ZeroRequest request;
  request.device_is_empty = true;
  request.accept_changed = accept_changed;
  if (auto started = session_->start_zero(request); started) {
    zero_asked_ = true;
    strapped_ = false;  // the hand is out
  } else {
    refuse(started.error());
  }
  update();
}

std::string SessionPresenter::realtime() const {
  return session_ == nullptr ? "" : session::describe(session_->realtime());
}

void SessionPresenter::start() {
  if (!view_.may_start) return;
  if (follows()) guide_.go_on(by_itself_);
  if (!view_.may_begin) return update();  // it waits for its time
  begin_next();
}

void SessionPresenter::begin_next() {
  if (!follows()) {
    auto spec = at_chosen_level(*next_task());
    auto begun = spec ? begin_trial(*spec, practice_, std::nullopt) : Result<void>(spec.error());
    if (!begun) refuse(begun.error());
    return;
  }
  const auto act = guide_.act();
  if (!act_task_) return;
  if (auto begun = begin_trial(*act_task_, act->practice, act->place); !begun) {
    if (begun.error().code != Error::Code::bad_input) {
      guide_.go_on(false);
      return refuse(begun.error());
    }
    leave_out(begun.error());
  }
}

Result<void> SessionPresenter::begin_trial(const tasks::TaskSpec& spec, bool practice,
                                           std::optional<storage::TrialPlace> place) {
  example_.stop();
  zero_refusal_.clear();
  zero_only_changed_ = false;
  const tasks::TaskContext context = session_->next_context();
  if (auto started = session_->start_trial(spec, practice, place); !started) return started;
  starting_ = true;
  just_completed_ = false;
  last_view_ = {};
  helped_ = false;
  if (corrects_rating_) ask_rating_anew();
  last_task_ = spec;
  last_practice_ = practice;
  picture_age_.clear();
  live_score_.clear();
  prepare_picture(spec, context);
  Q_EMIT score_changed();
  update();
  return {};
}

void SessionPresenter::prepare_picture(const tasks::TaskSpec& spec,
                                       const tasks::TaskContext& context) {
  running_ = std::make_shared<tasks::TaskSpec>(spec);
  preview_ = std::make_shared<TargetPreview>(preview_target(spec, context));
  scene_.reset();
  // The session has just read the same file: a failure here would have been refused there.
  auto read = session::read_trial_scene(spec, session_->record().hand,
                                        session_->contact_thresholds_N(), config_.library);
  if (!read) return refuse(read.error());
  if (read->scene) scene_ = std::make_shared<Scene>(*std::move(read->scene));
}

void SessionPresenter::show_how() {
  if (example_.showing()) {
    example_.stop();
    return update();
  }
  if (!view_.may_show_how) return;
  guide_.go_on(false);
  example_.show(*next_task(),
                session_ == nullptr ? tasks::ForceReferences{} : session_->references(),
                hand_.value_or(Hand::right), config_.library, [this](const Result<void>& shown) {
                  if (!shown) refuse(shown.error());
                  update();
                });
  update();
}

void SessionPresenter::pause() {
  if (view_.may_pause) session_->pause();
}

void SessionPresenter::resume() {
  if (view_.may_resume) session_->resume();
}

void SessionPresenter::stop() {
  if (view_.may_stop) session_->abort();
}

void SessionPresenter::start_pause_resume() {
  if (view_.may_pause) return pause();
  if (view_.may_resume) return resume();
  // What would begin by itself is held: the key never makes it begin sooner.
  if (view_.may_stand_by) return stand_by();
  start();
}

void SessionPresenter::note(const std::string& text) {
  if (session_ != nullptr && !text.empty()) session_->note(text);
}

void SessionPresenter::poll() {
  const FlowView before = view_;
  if (example_.playing()) {
    example_.tick();
    if (!view_.may_show_how) example_.stop();
    if (!example_.showing()) Q_EMIT changed();
  }
  if (session_ != nullptr) {
    const DeviceHealth health = snapshot_.health;
    snapshot_ = session_->snapshot();
    remember_fault(health);
    forces_.add(snapshot_);
    watch_compensation();
    if (snapshot_.stage == session::Stage::paused)
      rest_watch_.add(snapshot_);
    else
      rest_watch_.begin(session_->references().resting_C);
    worst_lateness_s_ = std::max(worst_lateness_s_, snapshot_.lateness_s);
    const bool running =
        snapshot_.stage == session::Stage::trial || snapshot_.stage == session::Stage::paused;
    if (running) starting_ = false;
    if (running) last_view_ = snapshot_.task;
    for (const auto& news : session_->take_news()) {
      take(news);
      if (session_ == nullptr) break;
    }
    if (running && session_ != nullptr && to_seconds(clock_.now() - scored_) > kScoreEvery_s) {
      scored_ = clock_.now();
      live_score_ = session_->live_score();
      Q_EMIT score_changed();
    }
  }
  if (!connection_error_.empty() && connection_ == Connection::none && room_.has_come_back())
    forget_failure();
  if (newer_library_ && connection_ != Connection::opening && !view_.may_stop && !starting_)
    take_library(*std::exchange(newer_library_, std::nullopt));
  follow_time();
  view_ = decide(facts());
  if (!(before == view_)) Q_EMIT changed();
  Q_EMIT frame();
}

void SessionPresenter::take(const session::SessionNews& news) {
  if (news.zero) {
    zero_asked_ = false;
    zero_refusal_ = news.zero->accepted ? "" : news.zero->reason;
    zero_only_changed_ = news.zero->only_changed;
    zero_remark_ = news.zero->remark;
    if (news.zero->accepted) {
      if (!rest_done_) select_first(TaskKind::rest);
      guide_.zeroed(session_time_s());
      zeroed_at_ = clock_.now();
      look_at_act();
    }
    Q_EMIT changed();
  }
  if (news.trial) take_trial(*news.trial);
  if (news.failure) close_session(shown(*news.failure).toStdString());
}

void SessionPresenter::take_trial(const session::TrialOutcome& outcome) {
  starting_ = false;
  last_trial_ = outcome;
  live_score_ = outcome.measures;
  if (outcome.rest) rest_words_ = outcome.rest->words;
  just_completed_ = outcome.trial.status == storage::TrialStatus::completed;
  just_missed_ = just_completed_ && last_view_.targets_reached < last_view_.target_count;
  if (just_completed_ && running_ != nullptr) {
    switch (kind_of(*running_)) {
      case TaskKind::rest:
        if (!rest_done_) select_first(TaskKind::maximum);
        rest_done_ = true;
        break;
      case TaskKind::maximum:
        ++maximum_attempts_;
        if (!task_done_ && session_->maximum_force_N() > 0.0) select_task_after_maximum();
        break;
      default: task_done_ = task_done_ || group_of(*running_) != TaskGroup::rest_and_maximum;
    }
  }
  if (running_ != nullptr) watch_limits(outcome);
  if (follows()) guide_.trial_ended(outcome, session_time_s());
  look_at_act();
  running_.reset();
  clinic_.load_history(patient_);
  Q_EMIT score_changed();
  Q_EMIT changed();
  Q_EMIT trial_ended();
}

/// Work that should end does not go on by itself.
void SessionPresenter::watch_limits(const session::TrialOutcome& outcome) {
  const bool ended_before = limits_.reason_to_stop().has_value();
  if (kind_of(*running_) != TaskKind::rest) limits_.worked(last_view_.task_time_s);
  last_view_ = {};
  const bool counts =
      outcome.trial.status == storage::TrialStatus::completed && !outcome.trial.practice;
  limits_.tried(counts ? outcome.measures : std::vector<Measure>{});
  limits_.helped(helped_);
  if (!ended_before && limits_.reason_to_stop()) guide_.go_on(false);
}

bool SessionPresenter::simulated() const noexcept {
  if (session_ != nullptr) return session_->device().simulated;
  return device_uri_.rfind("sim://", 0) == 0;
}

bool SessionPresenter::recorded() const noexcept {
  return session_ != nullptr && session_->device().recorded;
}

const DeviceInfo* SessionPresenter::device_info() const noexcept {
  return session_ == nullptr ? nullptr : &session_->device();
}

void SessionPresenter::remember_fault(const DeviceHealth& before) {
  const DeviceHealth& now = snapshot_.health;
  if (now.fault == DeviceFault::none || (now.fault == before.fault && now.finger == before.finger))
    return;
  faults_.push_back({snapshot_.session_time_s, std::string(describe(now.fault, now.finger))});
}

std::string SessionPresenter::device_description() const {
  return session_ == nullptr ? "" : session_->device().description;
}

}  // namespace isograsp::gui
