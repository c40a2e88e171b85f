// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/acquisition/acquisition.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp::session {

namespace {
/// Items that may wait for the recorder: every frame of `seconds`, and a few commands and events.
std::size_t ring_capacity(double seconds, double period_s) {
  constexpr std::size_t kCommandsAndEvents = 64;
  return static_cast<std::size_t>(std::ceil(seconds / period_s)) + kCommandsAndEvents;
}
constexpr std::size_t kCommands = 64;
}  // namespace

Acquisition::Acquisition(Apparatus& apparatus, Clock& clock, double ring_s)
    : apparatus_(apparatus),
      clock_(clock),
      period_s_(apparatus.info().period_s),
      commands_(kCommands),
      records_(ring_capacity(ring_s, period_s_)),
      now_(apparatus.now()) {}

bool Acquisition::tick() noexcept {
  for (Command command; commands_.pop(command);) obey(command);
  if (!apparatus_.next()) {
    finish();
    return false;
  }
  const Timestamp frame_ready = clock_.now();
  process();
  publish(frame_ready);
  apparatus_.show();
  return true;
}

void Acquisition::process() noexcept {
  ++now_.frames;
  if (now_.stage == Stage::zeroing) prepare();
  const Reception frame = apparatus_.receive();
  if (frame.gap) ++now_.frames_with_gap;
  guard(frame.sight);
  tell_fault();
  if (trial_ != nullptr) run_trial();
}

void Acquisition::run_trial() noexcept {
  const bool moving = now_.stage == Stage::trial;
  if (moving) apparatus_.step();
  item_.row.clear();
  apparatus_.write({.t_s = static_cast<double>(trial_frames_++) * period_s_,
                    .phase = moving ? now_.task.phase : tasks::Phase::paused,
                    .task = now_.task,
                    .lateness_s = apparatus_.lateness_s(),
                    .compute_s = last_compute_s_},
                   item_.row);
  push(RecordItem::Kind::sample);
  if (!moving) return;
  apparatus_.move();
  if (now_.task.phase == tasks::Phase::done) end_trial(storage::TrialStatus::completed, ""_text);
}

void Acquisition::obey(const Command& command) noexcept {
  switch (command.kind) {
    case Command::Kind::prepare:
      preparation_ = command.preparation;
      apparatus_.begin(*preparation_);
      now_.zero_progress = 0.0;
      now_.stage = Stage::zeroing;
      break;
    case Command::Kind::begin: begin_trial(*command.setup); break;
    case Command::Kind::pause:
      if (now_.stage == Stage::trial) pause(PauseCause::therapist);
      break;
    case Command::Kind::resume:
      if (now_.stage == Stage::paused) resume();
      break;
    case Command::Kind::let_go:
      if (trial_ == nullptr || !apparatus_.let_go()) break;
      push_event(kLetGoEvent, "The therapist let the object go."_text);
      break;
    case Command::Kind::clutch: now_.clutch_held = command.held; break;
    case Command::Kind::abort:
      if (trial_ != nullptr) end_trial(storage::TrialStatus::aborted, command.reason);
      break;
  }
}

void Acquisition::prepare() noexcept {
  if (!apparatus_.measure(*preparation_)) return;
  item_.preparation = preparation_;
  now_.stage = Stage::idle;
  push(RecordItem::Kind::prepared);
}

void Acquisition::guard(Reception::Sight sight) noexcept {
  const bool by_itself = now_.stage == Stage::paused && goes_on_by_itself(now_.pause_cause);
  if (sight == Reception::Sight::clear) {
    if (by_itself ||
        (now_.stage == Stage::paused && is_fault(now_.pause_cause) && apparatus_.info().recorded))
      resume();
  } else if (sight == Reception::Sight::occluded) {
    if (now_.stage == Stage::trial) pause(PauseCause::occluded);
  } else if (sight == Reception::Sight::let_go) {
    if (now_.stage == Stage::trial || (by_itself && now_.pause_cause != PauseCause::object_lost))
      pause(PauseCause::object_lost);
  } else if (now_.stage == Stage::trial || by_itself) {
    pause(apparatus_.fault().number == 0 ? PauseCause::missing_samples : PauseCause::device_fault);
  }
}

void Acquisition::tell_fault() noexcept {
  const ApparatusFault fault = apparatus_.fault();
  if (fault.number == told_fault_) return;
  told_fault_ = fault.number;
  if (fault.number != 0) push_event(kFaultEvent, fault.words, fault.where);
}

void Acquisition::begin_trial(TrialSetup& setup) noexcept {
  trial_ = &setup;
  trial_frames_ = 0;
  dropped_before_trial_ = now_.recorder_dropped;
  worst_lateness_s_ = 0.0;
  worst_compute_s_ = 0.0;
  now_.trial_number = setup.record.number;
  now_.task = {};
  now_.stage = Stage::trial;
  now_.pause_cause = PauseCause::none;
  apparatus_.begin(setup);
  item_.setup = &setup;
  push(RecordItem::Kind::begin);
}

void Acquisition::end_trial(storage::TrialStatus status, Words reason) noexcept {
  apparatus_.end(*trial_);
  item_.setup = trial_;
  item_.status = status;
  item_.reason = reason;
  item_.worst_lateness_s = worst_lateness_s_;
  item_.worst_compute_s = worst_compute_s_;
  item_.dropped = static_cast<std::int64_t>(now_.recorder_dropped - dropped_before_trial_);
  push(RecordItem::Kind::end);
  trial_ = nullptr;
  now_.trial_number = 0;
  now_.stage = Stage::idle;
  now_.pause_cause = PauseCause::none;
}

void Acquisition::pause(PauseCause cause) noexcept {
  now_.stage = Stage::paused;
  now_.pause_cause = cause;
  const ApparatusFault fault =
      cause == PauseCause::device_fault ? apparatus_.fault() : ApparatusFault{};
  item_.pauses = is_fault(cause);
  item_.told_before = fault.number != 0 && fault.number == told_fault_;
  if (fault.number != 0) told_fault_ = fault.number;
  push_event(item_.pauses                       ? kFaultEvent
             : cause == PauseCause::occluded    ? "occluded"
             : cause == PauseCause::object_lost ? kObjectLostEvent
                                                : "pause",
             (fault.number != 0 ? fault.words : words_of(cause)), fault.where);
  item_.pauses = item_.told_before = false;
}

void Acquisition::resume() noexcept {
  now_.stage = Stage::trial;
  now_.pause_cause = PauseCause::none;
  push_event("resume", ""_text);
}

void Acquisition::finish() noexcept {
  if (trial_ != nullptr)
    end_trial(
        trial_->spec.kind->free ? storage::TrialStatus::completed : storage::TrialStatus::aborted,
        "The recording ended."_text);
  now_.stage = Stage::finished;
  push(RecordItem::Kind::finished);
  publish(clock_.now());
}

void Acquisition::push(RecordItem::Kind kind) noexcept {
  item_.kind = kind;
  item_.session_time_s = now_.session_time_s;
  if (!records_.push(item_)) ++now_.recorder_dropped;
}

void Acquisition::push_event(const char* kind, Words text,
                             std::optional<Phrase<1>> where) noexcept {
  item_.event_kind = kind;
  item_.reason = text;
  item_.where = where;
  push(RecordItem::Kind::event);
}

void Acquisition::publish(Timestamp frame_ready) noexcept {
  now_.published = clock_.now();
  now_.compute_s = to_seconds(now_.published - frame_ready);
  now_.lateness_s = apparatus_.lateness_s();
  last_compute_s_ = now_.compute_s;
  worst_compute_s_ = std::max(worst_compute_s_, now_.compute_s);
  worst_lateness_s_ = std::max(worst_lateness_s_, now_.lateness_s);
  if (now_.stage != Stage::finished) measure_timing();
  apparatus_.publish();
}

void Acquisition::measure_timing() noexcept {
  const auto add = [this](Timing& timing) {
    if (last_published_) timing.period.add(to_seconds(now_.published - *last_published_));
    timing.lateness.add(now_.lateness_s);
    timing.compute.add(now_.compute_s);
    if (const auto latency_s = apparatus_.latency_s()) timing.latency.add(*latency_s);
  };
  add(timing_);
  if (trial_ != nullptr) add(trial_->timing);
  last_published_ = now_.published;
  constexpr double kRenewEvery_s = 1.0;
  const auto every = static_cast<std::int64_t>(std::ceil(kRenewEvery_s / period_s_));
  if (now_.frames % every == 0) now_.timing = summary_of(timing_);
}

}  // namespace isograsp::session
