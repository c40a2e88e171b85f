// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/acquisition/acquisition.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace isograsp::session {

namespace {
/// Items that may wait for the recorder: every frame of `seconds`, and a few commands and events.
std::size_t ring_capacity(double seconds, double period_s) {
  constexpr std::size_t kCommandsAndEvents = 64;
  return static_cast<std::size_t>(std::ceil(seconds / period_s)) + kCommandsAndEvents;
}
constexpr std::size_t kCommands = 64;
}  // namespace

Acquisition::Acquisition(ForceDevice& device, Clock& clock, Timestamp start, const Options& options)
    : device_(device),
      clock_(clock),
      options_(options),
      frames_(device, clock, start),
      commands_(kCommands),
      records_(ring_capacity(options.ring_s, device.info().frame_period_s)) {}

bool Acquisition::tick() noexcept {
  for (Command command; commands_.pop(command);) obey(command);
  if (!frames_.next(now_.forces)) {
    if (trial_ != nullptr) {
      const bool whole = trial_->spec.kind->free;
      end_trial(whole ? storage::TrialStatus::completed : storage::TrialStatus::aborted,
                "The recording ended.");
    }
    now_.stage = Stage::finished;
    now_.health = device_.health();
    push(RecordItem::Kind::finished);
    publish(clock_.now());
    return false;
  }
  const Timestamp frame_ready = clock_.now();
  process(now_.forces);
  publish(frame_ready);
  show_to_viewer();
  return true;
}

void Acquisition::obey(const Command& command) noexcept {
  switch (command.kind) {
    case Command::Kind::zero:
      zeroing_ = Zeroing(frames_.period_s());
      settle_s_ = command.settle_s;
      accept_changed_ = command.accept_changed;
      for (std::size_t f = 0; f < kFingerCount; ++f)
        restarts_before_zeroing_[f] = now_.health.sensors[f].restarts;
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
    case Command::Kind::abort:
      if (trial_ != nullptr) end_trial(storage::TrialStatus::aborted, command.reason);
      break;
  }
}

void Acquisition::process(FingerFrame& frame) noexcept {
  ++now_.frames;
  now_.session_time_s = frame.t_s;
  now_.health = device_.health();
  if (frame.any(SampleFlag::missing)) ++now_.frames_with_gap;
  if (now_.stage == Stage::zeroing) add_to_zero(frame);
  watch_restarts();
  subtract_zero(frame);
  guard(frame);
  tell_fault();
  now_.grip_N = force_of(frame.wrench_C, {});
  now_.push = net_push(device_.info().platform, frame, now_.grip_N);
  for (std::size_t f = 0; f < kFingerCount; ++f)
    now_.centre_of_pressure[f] = (frame.flags[f] & bit(SampleFlag::missing)) != 0
                                     ? std::nullopt
                                     : centre_of_pressure(frame.wrench_C[f]);
  if (trial_ != nullptr) run_trial(frame);
}

void Acquisition::add_to_zero(const FingerFrame& frame) noexcept {
  if (settle_s_ > 0.0) {
    settle_s_ -= frames_.period_s();
    return;
  }
  zeroing_.add(frame);
  now_.zero_progress = zeroing_.progress();
  if (!zeroing_.complete() && !zeroing_.hopeless()) return;
  item_.zero_refusal = ZeroRefusal{};
  item_.zero_change_N.reset();
  item_.zero_drift_N.reset();
  item_.change_confirmed = false;
  if (zeroing_.complete()) {
    item_.zero = zeroing_.statistics();
    const auto& last = zero_ ? zero_ : options_.last_zero;
    item_.zero_refusal = check_zero(item_.zero, accept_changed_ ? std::nullopt : last);
    item_.change_confirmed = accept_changed_ && check_zero(item_.zero, last).has_value();
    if (last) item_.zero_change_N = largest_force_change_N(item_.zero.mean, *last);
    if (zero_) item_.zero_drift_N = largest_force_change_N(item_.zero.mean, *zero_);
  }
  if (!item_.zero_refusal) {
    zero_ = item_.zero.mean;
    restarts_at_zero_ = restarts_before_zeroing_;
  }
  now_.zeroed = zero_.has_value();
  now_.stage = Stage::idle;
  push(RecordItem::Kind::zero);
}

void Acquisition::watch_restarts() noexcept {
  now_.restarted.reset();
  if (!zero_) return;
  for (const Finger finger : kFingers)
    if (now_.health.sensors[index_of(finger)].restarts != restarts_at_zero_[index_of(finger)])
      now_.restarted = finger;
}

void Acquisition::tell_fault() noexcept {
  const DeviceHealth& health = now_.health;
  if (health.fault == told_fault_ && health.finger == told_finger_) return;
  told_fault_ = health.fault;
  told_finger_ = health.finger;
  if (health.fault != DeviceFault::none)
    push_event(kFaultEvent, describe(health.fault, health.finger));
}

void Acquisition::subtract_zero(FingerFrame& frame) const noexcept {
  if (!zero_) return;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    frame.wrench_C[f].force -= (*zero_)[f].head<3>();
    frame.wrench_C[f].torque -= (*zero_)[f].tail<3>();
  }
}

void Acquisition::guard(FingerFrame& frame) noexcept {
  std::array<bool, kFingerCount> present{};
  for (std::size_t f = 0; f < kFingerCount; ++f)
    present[f] = (frame.flags[f] & bit(SampleFlag::missing)) == 0;
  std::array<bool, kFingerCount> used{true, true, true};
  if (trial_ != nullptr && trial_->plan) used = trial_->plan->scene().fingers_used();
  const auto verdict = stale_.apply(frame.wrench_C, present, used, frames_.period_s());
  for (std::size_t f = 0; f < kFingerCount; ++f)
    if (stale_.held(f)) frame.flags[f] = bit(SampleFlag::held);
  if (verdict == StaleRule::Verdict::frozen) {
    if (now_.stage == Stage::trial)
      pause(now_.health.fault == DeviceFault::none ? PauseCause::missing_samples
                                                   : PauseCause::device_fault);
  } else if (now_.stage == Stage::paused && now_.pause_cause != PauseCause::therapist &&
             options_.resume_by_itself) {
    resume();
  }
}

void Acquisition::run_trial(const FingerFrame& frame) noexcept {
  TrialSetup& trial = *trial_;
  const bool moving = now_.stage == Stage::trial;
  if (moving) {
    if (trial.plan) now_.grasp = trial.plan->grasp(frame.wrench_C, now_.object);
    now_.task =
        trial.task->step({frame.wrench_C, trial.plan ? &now_.object : nullptr, now_.grasp.contact});
  }
  write_row({.t_s = static_cast<double>(trial_frames_++) * frames_.period_s(),
             .forces = frame,
             .push = now_.push,
             .phase = moving ? now_.task.phase : tasks::Phase::paused,
             .task = now_.task,
             .constants = trial.constants,
             .object = now_.object,
             .grasp = now_.grasp,
             .lateness_s = frames_.lateness_s(frame),
             .compute_s = last_compute_s_},
            trial.plan.has_value(), item_.row);
  push(RecordItem::Kind::sample);
  if (!moving) return;
  if (trial.plan && now_.task.object_placed)
    now_.object = trial.plan->at_rest(now_.task.placed_X_WO);
  else if (trial.plan)
    trial.plan->move(now_.grasp, now_.object);
  if (now_.task.phase == tasks::Phase::done) end_trial(storage::TrialStatus::completed, "");
}

void Acquisition::begin_trial(TrialSetup& setup) noexcept {
  trial_ = &setup;
  trial_frames_ = 0;
  dropped_before_trial_ = now_.recorder_dropped;
  worst_lateness_s_ = 0.0;
  worst_compute_s_ = 0.0;
  now_.trial_number = setup.record.number;
  now_.task = {};
  now_.has_object = setup.plan.has_value();
  now_.object = setup.plan ? setup.plan->initial_state() : ObjectState{};
  now_.grasp = {};
  now_.stage = Stage::trial;
  now_.pause_cause = PauseCause::none;
  // A simulated person gets acquainted with the object; nobody else is here to be disturbed.
  if (options_.viewer != nullptr)
    options_.viewer->meet_object(setup.plan ? std::optional(setup.plan->scene()) : std::nullopt);
  item_.setup = &setup;
  push(RecordItem::Kind::begin);
}

void Acquisition::end_trial(storage::TrialStatus status, const char* reason) noexcept {
  item_.setup = trial_;
  item_.status = status;
  item_.reason = reason;
  item_.health = now_.health;
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
  const DeviceHealth& health = now_.health;
  const bool fault = cause == PauseCause::device_fault;
  item_.pauses = cause != PauseCause::therapist;
  item_.told_before = fault && health.fault == told_fault_ && health.finger == told_finger_;
  if (fault) {
    told_fault_ = health.fault;
    told_finger_ = health.finger;
  }
  push_event(cause == PauseCause::therapist ? "pause" : kFaultEvent,
             fault ? describe(health.fault, health.finger) : describe(cause));
  item_.pauses = item_.told_before = false;
}

void Acquisition::resume() noexcept {
  now_.stage = Stage::trial;
  now_.pause_cause = PauseCause::none;
  push_event("resume", "");
}

void Acquisition::push(RecordItem::Kind kind) noexcept {
  item_.kind = kind;
  item_.session_time_s = now_.session_time_s;
  if (!records_.push(item_)) ++now_.recorder_dropped;
}

void Acquisition::push_event(const char* kind, const char* text) noexcept {
  item_.event_kind = kind;
  item_.reason = text;
  push(RecordItem::Kind::event);
}

void Acquisition::publish(Timestamp frame_ready) noexcept {
  const Timestamp now = clock_.now();
  now_.published = now;
  now_.compute_s = to_seconds(now - frame_ready);
  now_.lateness_s = frames_.lateness_s(now_.forces);
  last_compute_s_ = now_.compute_s;
  worst_compute_s_ = std::max(worst_compute_s_, now_.compute_s);
  worst_lateness_s_ = std::max(worst_lateness_s_, now_.lateness_s);
  if (now_.stage != Stage::finished) measure_timing();
  snapshots_.publish(now_);
}

void Acquisition::measure_timing() noexcept {
  const auto add = [this](Timing& timing) {
    if (last_published_) timing.period.add(to_seconds(now_.published - *last_published_));
    timing.lateness.add(now_.lateness_s);
    timing.compute.add(now_.compute_s);
    if (const auto& stamp = frames_.completed_by())
      timing.latency.add(to_seconds(device_.now(clock_) - *stamp));
  };
  add(timing_);
  if (trial_ != nullptr) add(trial_->timing);
  last_published_ = now_.published;
  constexpr double kRenewEvery_s = 1.0;
  const auto every = static_cast<std::int64_t>(std::ceil(kRenewEvery_s / frames_.period_s()));
  if (now_.frames % every == 0) now_.timing = summary_of(timing_);
}

void Acquisition::show_to_viewer() noexcept {
  if (options_.viewer == nullptr) return;
  Stimulus screen;
  screen.t_s = now_.session_time_s;
  screen.shown_force_N = now_.grip_N;
  if (trial_ == nullptr) {
    screen.cue = now_.stage == Stage::zeroing || !now_.zeroed ? Cue::hand_out : Cue::relax;
  } else {
    screen.cue = now_.stage == Stage::paused ? Cue::relax : now_.task.cue;
    screen.channel = now_.task.channel;
    screen.force_target_shown = now_.task.force_target_shown;
    screen.target_force_N = now_.task.target_force_N;
    screen.force_shown = now_.task.force_shown;
    screen.shown_force_N = now_.task.actual_force_N;
    screen.digit_targets = now_.task.digit_targets;
    screen.object_shown = now_.has_object;
    screen.X_WO = now_.object.X_WO;
    screen.X_WT = now_.task.pose_target_shown ? now_.task.X_WT : now_.object.X_WO;
    screen.contact = now_.grasp.contact;
  }
  options_.viewer->see(screen);
}

}  // namespace isograsp::session
