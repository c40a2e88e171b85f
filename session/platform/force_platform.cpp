// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/platform/force_platform.hpp"

#include <array>
#include <string>
#include <utility>

#include "hand/platform_records.hpp"
#include "session/platform/contact_threshold.hpp"
#include "session/platform/prepare_trial.hpp"

namespace isograsp::session {

namespace {
constexpr std::array<PreparationStep, 2> kSteps{PreparationStep::zero, PreparationStep::rest};
}  // namespace

ForcePlatform::ForcePlatform(std::unique_ptr<ForceDevice> device,
                             std::unique_ptr<virtual_patient::VirtualPatient> person,
                             PlatformOptions options)
    : person_(std::move(person)), platform_(std::move(device)), options_(std::move(options)) {
  const DeviceInfo& of = platform_.info();
  info_ = {kKind,      of.description, of.simulated, of.recorded, of.frame_period_s,
           of.delay_s, of.provenance};
}

std::span<const PreparationStep> ForcePlatform::steps() const noexcept {
  return kSteps;
}

Result<void> ForcePlatform::start(Clock& clock) {
  if (auto started = platform_.start(clock); !started) return started;
  platform_.begin(platform_.now());
  return {};
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

void ForcePlatform::describe(storage::SessionRecord& session) const {
  for (const Finger finger : kFingers)
    session.sensors.push_back(
        {std::string(name_of(finger)), device().serial_numbers[index_of(finger)]});
  session.calibration = platform_.calibration();
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
  if (!platform_.next(now_.forces)) return false;
  now_.session_time_s = now_.forces.t_s;
  return true;
}

void ForcePlatform::begin(Preparation& preparation) noexcept {
  platform_.begin(static_cast<InstrumentZero&>(preparation));
}

bool ForcePlatform::measure(Preparation& preparation) noexcept {
  auto& zero = static_cast<InstrumentZero&>(preparation);
  const bool ended = platform_.measure(zero, now_.forces);
  now_.zero_progress = zero.zeroing.progress();
  if (!ended) return false;
  if (!zero.refusal) platform_.accept(zero);
  now_.zeroed = platform_.zeroed();
  return true;
}

Reception ForcePlatform::receive() noexcept {
  std::array<bool, kFingerCount> used{true, true, true};
  if (trial_ != nullptr && trial_->plan) used = trial_->plan->scene().fingers_used();
  const Reception reception = platform_.receive(now_.forces, used);
  now_.health = platform_.health();
  now_.restarted = platform_.restarted();
  now_.grip_N = force_of(now_.forces.wrench_C, {});
  now_.push = net_push(device().platform, now_.forces, now_.grip_N);
  for (std::size_t f = 0; f < kFingerCount; ++f)
    now_.centre_of_pressure[f] = (now_.forces.flags[f] & bit(SampleFlag::missing)) != 0
                                     ? std::nullopt
                                     : centre_of_pressure(now_.forces.wrench_C[f]);
  return reception;
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
  if (now_.stage == Stage::finished) {
    platform_.look();
    now_.health = platform_.health();
  }
  snapshots_.publish(now_);
}

void ForcePlatform::show() noexcept {
  if (person_ != nullptr) person_->see(screen_of(now_));
}

std::optional<double> ForcePlatform::latency_s() const noexcept {
  const auto& stamp = platform_.completed_by();
  if (!stamp) return std::nullopt;
  return to_seconds(platform_.now() - *stamp);
}

}  // namespace isograsp::session
