// SPDX-License-Identifier: GPL-3.0-or-later
// The presenter's part that looks: what is known becomes the view, news become state.
#include "gui/presenter/session_presenter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gui/library/task_groups.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

constexpr int kPoll_ms = 16;
constexpr double kScoreEvery_s = 1.0;

}  // namespace

SessionPresenter::SessionPresenter(const GuiConfig& config, Clinic& clinic,
                                   const SettingsFile& settings, QObject* parent)
    : QObject(parent), config_(config), clinic_(clinic), settings_(settings), seating_(clinic) {
  choices_.device_uri = config.device_uri;
  take_library(
      read_session_library(config_.library, session::own_library_folder(config_.database)));
  select(first_task(is_rest));
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

FlowFacts SessionPresenter::facts() const {
  FlowFacts facts;
  facts.database_open = clinic_.is_open();
  facts.database_error = database_error_;
  facts.look_only = config_.look_only;
  facts.patient_chosen = !choices_.patient.empty();
  facts.hand_to_confirm = hand_to_confirm();
  facts.hand_chosen = choices_.today.hand && !facts.hand_to_confirm;
  facts.screened = choices_.today.screening.complete();
  const auto& interrupted = choices_.interrupted;
  facts.earlier_sought = interrupted.sought;
  facts.earlier_undecided = interrupted.acts.has_value() && !interrupted.go_on;
  facts.device_chosen = !choices_.device_uri.empty();
  facts.connection = connection_.phase;
  if (connection_.failure) facts.connection_error = connection_.failure->words;
  facts.recorded = recorded();
  if (open_) add_session_facts(facts);
  add_task_facts(facts);
  return facts;
}

void SessionPresenter::add_session_facts(FlowFacts& facts) const {
  const OpenSession& open = *open_;
  const session::Snapshot& now = open.snapshot;
  const Preparation& preparation = open.preparation;
  facts.anything_arrived = now.frames > 0;
  const Timestamp time = clock_.now();
  facts.frozen = now.stage != session::Stage::finished &&
                 (facts.anything_arrived ? to_seconds(time - now.published) > kFrozenAfter_s
                                         : to_seconds(time - open.opened) > kFirstFrameWithin_s);
  facts.stage = now.stage;
  facts.pause_cause = now.pause_cause;
  facts.at_rest = open.trial && open.trial->rest_watch.at_rest();
  facts.health = now.health;
  facts.zeroed = now.zeroed;
  facts.restarted = now.restarted;
  facts.maximum_force_N = open.session->maximum_force_N();
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
  facts.rest_done = preparation.rest_done || (follows() && !open.work.guide.asks_rest());
  facts.maximum_attempts = open.work.maximum_attempts;
  facts.task_done = open.work.task_done;
  // From the press of Start until the trial's outcome is stored, with the trial itself in between.
  facts.starting = open.trial && (!open.trial->arrived || facts.stage == session::Stage::idle);
  const auto& said = open.rating.stop_reason;
  facts.stop_reason = said.empty() ? open.limits.reason_to_stop().value_or("") : said;
  if (follows()) facts.protocol = protocol_facts();
  if (open.ended) facts.last_rested = is_rest(*open.ended->task);
}

void SessionPresenter::add_task_facts(FlowFacts& facts) const {
  const auto* spec = open_ && open_->trial ? open_->trial->task.get() : next_task();
  facts.task_chosen = spec != nullptr;
  if (spec == nullptr) return;
  facts.task_rests = is_rest(*spec);
  facts.task_name = spec->name;
  if (open_) facts.task_lacks = open_->work.task_lacks;
}

void SessionPresenter::update() {
  view_ = decide(facts());
  Q_EMIT changed();
}

void SessionPresenter::refuse(const Error& error) {
  Q_EMIT failed(shown(error));
}

void SessionPresenter::hold() {
  if (open_) open_->work.guide.go_on(false);
}

void SessionPresenter::poll() {
  const FlowView before = view_;
  if (example_.playing()) {
    example_.tick();
    if (!view_.may_show_how) example_.stop();
    if (!example_.showing()) Q_EMIT changed();
  }
  if (open_) look_at_session();
  if (connection_.failure && connection_.phase == Connection::none && room_.has_come_back())
    connection_.failure.reset();
  const bool starting = open_ && open_->trial && !open_->trial->arrived;
  if (newer_library_ && connection_.phase != Connection::opening && !view_.may_stop && !starting)
    take_library(*std::exchange(newer_library_, std::nullopt));
  follow_time();
  view_ = decide(facts());
  if (!(before == view_)) Q_EMIT changed();
  Q_EMIT frame();
}

void SessionPresenter::look_at_session() {
  const DeviceHealth before = open_->snapshot.health;
  open_->snapshot = open_->session->snapshot();
  const session::Snapshot& now = open_->snapshot;
  SessionTraces& traces = open_->traces;
  if (now.health.fault != DeviceFault::none &&
      (now.health.fault != before.fault || now.health.finger != before.finger))
    traces.faults.push_back(
        {now.session_time_s, std::string(describe(now.health.fault, now.health.finger))});
  traces.forces.add(now);
  traces.worst_lateness_s = std::max(traces.worst_lateness_s, now.lateness_s);
  watch_compensation();
  const bool paused = now.stage == session::Stage::paused;
  const bool running = paused || now.stage == session::Stage::trial;
  if (auto& trial = open_->trial) {
    if (paused)
      trial->rest_watch.add(now);
    else
      trial->rest_watch.begin(open_->session->references().resting_C);
    if (running) trial->arrived = true;
    if (running) trial->view = now.task;
  }
  for (const auto& news : open_->session->take_news()) {
    take(news);
    if (!open_) return;
  }
  auto& trial = open_->trial;
  if (running && trial && to_seconds(clock_.now() - trial->scored) > kScoreEvery_s) {
    trial->scored = clock_.now();
    trial->score = open_->session->live_score();
    Q_EMIT score_changed();
  }
}

void SessionPresenter::take(const session::SessionNews& news) {
  if (news.zero) take_zero(*news.zero);
  if (news.trial) take_trial(*news.trial);
  if (news.failure) close_session(shown(*news.failure).toStdString());
}

bool SessionPresenter::under_way() const noexcept {
  const bool asked =
      open_ && (open_->preparation.zero_asked || (open_->trial && !open_->trial->arrived));
  return asked || view_.may_stop || view_.may_stand_by || guide().goes_on();
}

const std::vector<Measure>& SessionPresenter::live_score() const noexcept {
  if (open_ && open_->trial) return open_->trial->score;
  return traces().last_trial ? traces().last_trial->measures : nothing_.score;
}

std::string SessionPresenter::realtime() const {
  return open_ ? session::describe(open_->session->realtime()) : "";
}

bool SessionPresenter::simulated() const noexcept {
  if (open_) return open_->session->device().simulated;
  return choices_.device_uri.rfind("sim://", 0) == 0;
}

bool SessionPresenter::recorded() const noexcept {
  return open_ && open_->session->device().recorded;
}

const DeviceInfo* SessionPresenter::device_info() const noexcept {
  return open_ ? &open_->session->device() : nullptr;
}

}  // namespace isograsp::gui
