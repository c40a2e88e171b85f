// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/presenter/session_presenter.hpp"

#include <algorithm>

#include "gui/words/texts.hpp"
#include "session/open_two_platforms.hpp"

namespace isograsp::gui {

namespace {

constexpr int kPoll_ms = 16;

SessionState state_at_start(const GuiConfig& config) {
  SessionState state;
  state.config = config;
  // Both hands are chosen in every session, as one hand is.
  if (const auto both = session::two_platforms_in(config.device_uri)) {
    state.choices.platforms = *both;
    return state;
  }
  state.choices.device_uri = config.device_uri;
  state.choices.apparatus = session::kind_of_apparatus(config.device_uri, config.apparatuses);
  return state;
}

/// Of the newest frame.
std::optional<DeviceFaultSeen> fault_of(const OpenSession& open) {
  const double t_s = open.snapshot.session_time_s;
  if (open.arm && open.arm->health.fault != MarkerFault::none)
    return DeviceFaultSeen{t_s, words_of(open.arm->health.fault)};
  if (open.hand && open.hand->health.fault != HandFault::none)
    return DeviceFaultSeen{t_s, words_of(open.hand->health.fault)};
  const DeviceHealth& health = open.snapshot.health;
  if (health.fault == DeviceFault::none) return std::nullopt;
  return DeviceFaultSeen{t_s, words_of(health.fault, health.finger),
                         open.both ? fault_side(*open.both) : std::nullopt};
}

}  // namespace

SessionPresenter::SessionPresenter(const GuiConfig& config, Clinic& clinic, PersonFile& file,
                                   const SettingsFile& settings, QObject* parent)
    : QObject(parent),
      state_(state_at_start(config)),
      flow_(state_, clinic, file, clock_),
      seating_(clinic),
      example_(worker_, clock_),
      context_{state_, flow_, clinic, file, settings, seating_, worker_, example_, clock_},
      next_(state_, flow_),
      choices_(context_),
      library_(context_, choices_, next_),
      connecting_(context_, choices_, next_),
      preparing_(context_, next_),
      protocol_(context_, next_),
      tasks_(context_, next_),
      remarks_(context_),
      trials_(context_, next_, protocol_, remarks_),
      patient_view_(context_) {
  connect(&seating_, &Seating::changed, this, [this] { patient_view_.store_presentation(); });
  connect(&timer_, &QTimer::timeout, this, &SessionPresenter::poll);
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.start(kPoll_ms);
  flow_.update();
}

SessionPresenter::~SessionPresenter() = default;

void SessionPresenter::poll() {
  const FlowView before = flow_.view();
  tasks_.look();
  if (state_.open) look_at_session();
  connecting_.look();
  library_.look();
  trials_.follow_time();
  flow_.decide();
  if (!(before == flow_.view())) Q_EMIT flow_.changed();
  Q_EMIT flow_.frame();
}

void SessionPresenter::look_at_session() {
  const std::optional<DeviceFaultSeen> before = fault_of(*state_.open);
  state_.open->look();
  look_at_device(before);
  preparing_.look();
  trials_.look();
  for (const auto& news : state_.open->session->take_news()) {
    if (news.prepared) preparing_.take(*news.prepared);
    if (news.trial) trials_.take(*news.trial);
    if (news.failure) return connecting_.break_off(*news.failure);
  }
  trials_.renew_score();
}

/// What is to be seen of the stream: forces, faults, lateness.
void SessionPresenter::look_at_device(const std::optional<DeviceFaultSeen>& before) {
  const session::Snapshot& now = state_.open->snapshot;
  SessionTraces& traces = state_.open->traces;
  const auto fault = fault_of(*state_.open);
  if (fault && !(before && before->words == fault->words && before->side == fault->side))
    traces.faults.push_back(*fault);
  if (!state_.open->arm && !state_.open->hand && !state_.open->both) traces.forces.add(now);
  traces.worst_lateness_s = std::max(traces.worst_lateness_s, now.lateness_s);
}

}  // namespace isograsp::gui
