// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/platform/force_platform.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/csv.hpp"
#include "hand/platform_records.hpp"
#include "session/platform/contact_threshold.hpp"
#include "session/platform/prepare_trial.hpp"

namespace isograsp::session {

namespace {
constexpr std::array<PreparationStep, 2> kSteps{PreparationStep::zero, PreparationStep::rest};

/// How counts became forces, a line a finger; empty if the device has no counts.
std::string calibration_text(const DeviceInfo& info) {
  std::string text;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    if (info.units_per_count[f].isZero(0.0)) continue;
    text += std::string(kFingerNames[f]) + ": N or N m per count";
    for (const double unit : info.units_per_count[f]) text += " " + format_number(unit);
    if (!info.calibration[f].empty()) text += "; matrix " + info.calibration[f];
    text += "\n";
  }
  return text;
}

}  // namespace

ForcePlatform::ForcePlatform(std::unique_ptr<ForceDevice> device,
                             std::unique_ptr<virtual_patient::VirtualPatient> person,
                             PlatformOptions options)
    : person_(std::move(person)), device_(std::move(device)), options_(std::move(options)) {
  const DeviceInfo& of = device_->info();
  info_ = {kKind,      of.description, of.simulated, of.recorded, of.frame_period_s,
           of.delay_s, of.provenance};
}

std::span<const PreparationStep> ForcePlatform::steps() const noexcept {
  return kSteps;
}

Result<void> ForcePlatform::start(Clock& clock) {
  if (auto started = device_->start(clock); !started) return started;
  streaming_ = true;
  clock_ = &clock;
  frames_.emplace(*device_, clock, device_->now(clock));
  return {};
}

void ForcePlatform::stop() noexcept {
  if (std::exchange(streaming_, false)) device_->stop();
}

Result<void> ForcePlatform::ready() {
  const Snapshot& now = snapshots_.read();
  if (standing_of_zero(info_.recorded, now.zeroed, now.restarted.has_value()) !=
      ZeroStanding::outdated)
    return {};
  return failed("since the zero was set a sensor started anew (%1)"_text(
                    Known{std::string(name_of(*now.restarted))}),
                "take the hand out and set the zero again"_text)
      .about("zero");
}

std::optional<double> ForcePlatform::resolution_N() const noexcept {
  double coarsest_N = 0.0;
  for (const Vec6& unit : device().units_per_count)
    coarsest_N = std::max(coarsest_N, unit.head<3>().cwiseAbs().maxCoeff());
  return coarsest_N > 0.0 ? std::optional(coarsest_N) : std::nullopt;  // 0: it has no counts
}

void ForcePlatform::describe(storage::SessionRecord& session) const {
  for (const Finger finger : kFingers)
    session.sensors.push_back(
        {std::string(name_of(finger)), device().serial_numbers[index_of(finger)]});
  session.calibration = calibration_text(device());
}

Result<std::unique_ptr<Preparation>> ForcePlatform::make_preparation(const ZeroRequest& request) {
  if (!request.device_is_empty)
    return refused("nobody has confirmed that the device is empty"_text,
                   "take the hand out, let nothing touch the supports, and confirm that"_text);
  auto zero = std::make_unique<InstrumentZero>();
  zero->settle_s = request.settle_s;
  zero->accept_changed = request.accept_changed;
  return std::unique_ptr<Preparation>(std::move(zero));
}

Result<std::unique_ptr<TrialSetup>> ForcePlatform::make_trial(const tasks::TaskSpec& spec,
                                                              const tasks::TaskContext& context) {
  const tasks::ForceReferences& references = context.references;
  const auto scene =
      read_trial_scene(spec, options_.hand, contact_thresholds(references), options_.library);
  if (!scene) return scene.error();
  auto prepared = prepare_trial(spec, context, *scene);
  if (!prepared) return prepared.error();
  auto trial = *std::move(prepared);
  trial->constants.device_delay_s = device().delay_s;
  trial->constants.display_delay_s = options_.display_delay_s;
  trial->constants.resolution_N = references.resolution_N;
  storage::set_value(trial->record.references, platform::kMaximumForce_N, references.maximum({}));
  storage::set_value(trial->record.references, platform::kRestingForce_N, references.resting({}));
  return std::unique_ptr<TrialSetup>(std::move(trial));
}

bool ForcePlatform::next() noexcept {
  if (!frames_->next(now_.forces)) return false;
  now_.session_time_s = now_.forces.t_s;
  return true;
}

void ForcePlatform::begin(Preparation& preparation) noexcept {
  auto& zero = static_cast<InstrumentZero&>(preparation);
  zero.zeroing = Zeroing(info_.period_s);
  zero.wait_s = zero.settle_s;
  for (std::size_t f = 0; f < kFingerCount; ++f) zero.restarts[f] = now_.health.sensors[f].restarts;
}

bool ForcePlatform::measure(Preparation& preparation) noexcept {
  auto& zero = static_cast<InstrumentZero&>(preparation);
  if (zero.wait_s > 0.0) {
    zero.wait_s -= info_.period_s;
    return false;
  }
  zero.zeroing.add(now_.forces);
  now_.zero_progress = zero.zeroing.progress();
  if (!zero.zeroing.complete() && !zero.zeroing.hopeless()) return false;
  judge(zero);
  if (!zero.refusal) {
    zero_ = zero.statistics.mean;
    restarts_at_zero_ = zero.restarts;
  }
  now_.zeroed = zero_.has_value();
  return true;
}

void ForcePlatform::judge(InstrumentZero& zero) noexcept {
  zero.refusal = ZeroRefusal{};
  if (!zero.zeroing.complete()) return;
  zero.statistics = zero.zeroing.statistics();
  const SixAxes& mean = zero.statistics.mean;
  const auto& last = zero_ ? zero_ : last_zero_;
  zero.refusal = check_zero(zero.statistics, zero.accept_changed ? std::nullopt : last);
  zero.change_confirmed = zero.accept_changed && check_zero(zero.statistics, last).has_value();
  if (last) zero.change_N = largest_force_change_N(mean, *last);
  if (zero_) zero.drift_N = largest_force_change_N(mean, *zero_);
}

Reception ForcePlatform::receive() noexcept {
  now_.health = device_->health();
  Reception reception;
  reception.gap = now_.forces.any(SampleFlag::missing);
  watch_restarts();
  subtract_zero();
  reception.sight = hold_missing();
  now_.grip_N = force_of(now_.forces.wrench_C, {});
  now_.push = net_push(device_->info().platform, now_.forces, now_.grip_N);
  for (std::size_t f = 0; f < kFingerCount; ++f)
    now_.centre_of_pressure[f] = (now_.forces.flags[f] & bit(SampleFlag::missing)) != 0
                                     ? std::nullopt
                                     : centre_of_pressure(now_.forces.wrench_C[f]);
  return reception;
}

void ForcePlatform::watch_restarts() noexcept {
  now_.restarted.reset();
  if (!zero_) return;
  for (const Finger finger : kFingers)
    if (now_.health.sensors[index_of(finger)].restarts != restarts_at_zero_[index_of(finger)])
      now_.restarted = finger;
}

void ForcePlatform::subtract_zero() noexcept {
  if (!zero_) return;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    now_.forces.wrench_C[f].force -= (*zero_)[f].head<3>();
    now_.forces.wrench_C[f].torque -= (*zero_)[f].tail<3>();
  }
}

Reception::Sight ForcePlatform::hold_missing() noexcept {
  FingerFrame& frame = now_.forces;
  std::array<bool, kFingerCount> present{};
  for (std::size_t f = 0; f < kFingerCount; ++f)
    present[f] = (frame.flags[f] & bit(SampleFlag::missing)) == 0;
  std::array<bool, kFingerCount> used{true, true, true};
  if (trial_ != nullptr && trial_->plan) used = trial_->plan->scene().fingers_used();
  const auto verdict = stale_.apply(frame.wrench_C, present, used, info_.period_s);
  for (std::size_t f = 0; f < kFingerCount; ++f)
    if (stale_.held(f)) frame.flags[f] = bit(SampleFlag::held);
  return verdict == StaleRule::Verdict::frozen ? Reception::Sight::lost : Reception::Sight::clear;
}

void ForcePlatform::begin(TrialSetup& setup) noexcept {
  trial_ = &static_cast<PlatformTrial&>(setup);
  const auto& plan = trial_->plan;
  now_.special = {};
  now_.has_object = plan.has_value();
  now_.object = plan ? plan->initial_state() : ObjectState{};
  now_.grasp = {};
  // A simulated person gets to know the object before the trial.
  if (person_ != nullptr) person_->meet_object(plan ? std::optional(plan->scene()) : std::nullopt);
}

void ForcePlatform::end(TrialSetup&) noexcept {
  trial_->health = now_.health;
  trial_ = nullptr;
}

void ForcePlatform::step() noexcept {
  const FingerWrenches& wrench_C = now_.forces.wrench_C;
  if (trial_->plan) now_.grasp = trial_->plan->grasp(wrench_C, now_.object);
  const tasks::TaskView view =
      trial_->plan
          ? trial_->task->step(tasks::ObjectInput{wrench_C, &now_.object, now_.grasp.contact})
          : trial_->task->step(tasks::ForceInput{wrench_C});
  now_.task = view;
  now_.special = view;
}

void ForcePlatform::write(const RowFrame& frame, TrialRow& row) noexcept {
  write_row(frame,
            {now_.forces, now_.push, now_.special, trial_->constants,
             trial_->plan ? &now_.object : nullptr, now_.grasp},
            row);
}

void ForcePlatform::move() noexcept {
  if (!trial_->plan) return;
  const tasks::ObjectView& task = now_.special.object();
  if (task.object_placed)
    now_.object = trial_->plan->at_rest(task.placed_X_WO);
  else
    trial_->plan->move(now_.grasp, now_.object);
}

void ForcePlatform::publish() noexcept {
  if (now_.stage == Stage::finished) now_.health = device_->health();
  snapshots_.publish(now_);
}

void ForcePlatform::show() noexcept {
  if (person_ != nullptr) person_->see(screen_of(now_));
}

ApparatusFault ForcePlatform::fault() const noexcept {
  const DeviceHealth& health = now_.health;
  if (health.fault == DeviceFault::none) return {};
  // One number for each pair of fault and finger.
  const auto finger = health.finger ? 1 + index_of(*health.finger) : 0;
  return {static_cast<int>(static_cast<std::size_t>(health.fault) * (1 + kFingerCount) + finger),
          words_of(health.fault, health.finger)};
}

double ForcePlatform::lateness_s() const noexcept {
  return frames_->lateness_s(now_.forces);
}

std::optional<double> ForcePlatform::latency_s() const noexcept {
  const auto& stamp = frames_->completed_by();
  if (!stamp) return std::nullopt;
  return to_seconds(device_->now(*clock_) - *stamp);
}

}  // namespace isograsp::session
