// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/two_platforms/two_platforms.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "hand/two_hands_columns.hpp"
#include "session/platform/zeroing.hpp"
#include "session/two_platforms/two_zeros.hpp"

namespace isograsp::session {

namespace {

constexpr std::array<PreparationStep, 2> kStepsOfTwo{PreparationStep::zero, PreparationStep::rest};
constexpr std::array<bool, kFingerCount> kAllFingers{true, true, true};
/// A lag of one hand behind the other would be off by the difference of their delays: a frame of
/// the fastest grid is the most that is let pass.
constexpr double kLargestDelayDifference_s = 0.001;

Number milliseconds(double duration_s) {
  constexpr double kMilliseconds = 1e3;
  return fixed(duration_s * kMilliseconds, 1);
}

ApparatusInfo info_of(const DeviceInfo& left, const DeviceInfo& right) {
  ApparatusInfo info;
  info.kind = TwoPlatforms::kKind;
  info.description = "left: %1; right: %2"_text(left.description, right.description);
  info.simulated = left.simulated;
  info.period_s = left.frame_period_s;
  info.delay_s = std::max(left.delay_s, right.delay_s);
  for (const std::string& line : left.provenance) info.provenance.push_back("left: " + line);
  for (const std::string& line : right.provenance) info.provenance.push_back("right: " + line);
  return info;
}

/// A sensor that says the same serial number on both platforms is one sensor: each hand would be
/// given half of what one hand does. Software has none.
Result<void> check_sensors(const DeviceInfo& left, const DeviceInfo& right) {
  if (left.simulated) return {};
  for (const std::string& serial : left.serial_numbers)
    if (!serial.empty() &&
        std::count(right.serial_numbers.begin(), right.serial_numbers.end(), serial) > 0)
      return refused("the sensor with the serial number %1 is in both platforms"_text(serial),
                     "give each hand the configuration of its own platform"_text)
          .at(right.uri)
          .about("serial_number");
  return {};
}

}  // namespace

Result<void> TwoPlatforms::check(const Devices& devices) {
  const DeviceInfo& left = devices.left->info();
  const DeviceInfo& right = devices.right->info();
  if (left.recorded || right.recorded)
    return refused("recorded forces of one hand cannot stand beside another device"_text,
                   "score a record of two hands with isograsp score --affected"_text)
        .at(left.recorded ? left.uri : right.uri);
  if (left.simulated != right.simulated)
    return refused("one platform is simulated and the other one is not"_text,
                   "use two devices, or sim://pair for both"_text)
        .at(left.simulated ? left.uri : right.uri);
  if (left.frame_period_s != right.frame_period_s)
    return refused("the platforms have other rates: a frame takes %1 ms and %2 ms"_text(
                       milliseconds(left.frame_period_s), milliseconds(right.frame_period_s)),
                   "set both to one rate"_text)
        .at(right.uri)
        .about("rate");
  if (std::abs(left.delay_s - right.delay_s) > kLargestDelayDifference_s)
    return refused("the platforms have other delays: %1 ms and %2 ms"_text(
                       milliseconds(left.delay_s), milliseconds(right.delay_s)),
                   "set both to one rate and filter, or one hand would seem to lag"_text)
        .at(right.uri)
        .about("filter");
  return {};
}

TwoPlatforms::TwoPlatforms(Devices devices, std::unique_ptr<virtual_patient::VirtualPair> pair,
                           std::optional<double> display_delay_s, std::string library)
    : pair_(std::move(pair)),
      sides_{PlatformReader(std::move(devices.left)), PlatformReader(std::move(devices.right))},
      display_delay_s_(display_delay_s),
      library_(std::move(library)),
      info_(info_of(sides_.left.info(), sides_.right.info())) {}

std::span<const PreparationStep> TwoPlatforms::steps() const noexcept {
  return kStepsOfTwo;
}

/// Both grids begin at one instant.
Result<void> TwoPlatforms::start(Clock& clock) {
  for (const Hand hand : kBothHands)
    if (auto started = sides_[hand].start(clock); !started) {
      stop();
      return started;
    }
  if (auto two = check_sensors(sides_.left.info(), sides_.right.info()); !two) {
    stop();
    return two;
  }
  const Timestamp begin = std::max(sides_.left.now(), sides_.right.now());
  for (const Hand hand : kBothHands) sides_[hand].begin(begin);
  return {};
}

void TwoPlatforms::stop() noexcept {
  for (const Hand hand : kBothHands) sides_[hand].stop();
}

void TwoPlatforms::describe(storage::SessionRecord& session) const {
  for (const Hand hand : kBothHands) {
    const std::string side(name_of(hand));
    for (const Finger finger : kFingers)
      session.sensors.push_back({side + " " + std::string(name_of(finger)),
                                 device(hand).serial_numbers[index_of(finger)]});
    if (const std::string text = sides_[hand].calibration(); !text.empty())
      session.calibration += side + "\n" + text;
  }
}

Result<void> TwoPlatforms::ready() {
  const TwoPlatformsSnapshot& now = snapshots_.read();
  for (const Hand hand : kBothHands) {
    const auto& restarted = now.of[hand].restarted;
    if (standing_of_zero(info_.recorded, now.zeroed, restarted.has_value()) ==
        ZeroStanding::outdated)
      return failed("since the zeros were set a sensor started anew (%1 %2)"_text(
                        Known{std::string(name_of(hand))}, Known{std::string(name_of(*restarted))}),
                    "take both hands out and set the zeros again"_text)
          .about("zero");
  }
  return {};
}

Result<std::unique_ptr<Preparation>> TwoPlatforms::make_preparation(const ZeroRequest& request) {
  if (!request.device_is_empty)
    return refused("nobody has confirmed that both platforms are empty"_text,
                   "take both hands out, let nothing touch the supports, and confirm that"_text);
  auto zeros = std::make_unique<TwoZeros>();
  for (const Hand hand : kBothHands) {
    zeros->of[hand].settle_s = request.settle_s;
    zeros->of[hand].accept_changed = request.accept_changed;
  }
  return std::unique_ptr<Preparation>(std::move(zeros));
}

Result<std::unique_ptr<TrialSetup>> TwoPlatforms::make_trial(const tasks::TaskSpec& spec,
                                                             const tasks::TaskContext& context) {
  auto trial = std::make_unique<TwoPlatformsTrial>();
  tasks::TaskContext known = context;
  if (spec.hands_load()) {
    auto object = LiftedObject::read(spec, context, library_);
    if (!object) return object.error();
    constexpr Eigen::Index kUp = 1;
    known.lift_N_m = object->scene().stiffness[kUp];
    trial->record.scene_text = object->text();
    trial->object = *std::move(object);
  }
  if (const auto carry = spec.hands_carry()) {
    if (auto fits = fits_session(*carry, context); !fits) return fits.error();
    auto carried = CarriedByHands::read(spec, context, library_);
    if (!carried) return carried.error();
    known.carries_left = tasks::kMostCarries - carries_.carries;
    trial->record.scene_text = carried->text();
    trial->carried = *std::move(carried);
  }
  auto task = tasks::make_task(spec, known);
  if (!task) return task.error();
  trial->spec = spec;
  trial->task = *std::move(task);
  trial->references = context.two_hands;
  trial->device_delay_s = info_.delay_s;
  trial->display_delay_s = display_delay_s_;
  trial->record.task_name = spec.name;
  trial->record.task_version = spec.version;
  trial->record.task_text = spec.text;
  trial->record.seed = context.seed;
  for (const Hand hand : kBothHands) {
    const tasks::HandReferences& of = context.two_hands.of[hand];
    storage::set_value(trial->record.references, columns::hand_maximum_force_N[hand], of.maximum_N);
    storage::set_value(trial->record.references, columns::hand_resting_force_N[hand], of.resting_N);
  }
  return std::unique_ptr<TrialSetup>(std::move(trial));
}

/// A patient carries in one way: the next one would be learned from the first.
Result<void> TwoPlatforms::fits_session(const tasks::HandsCarry& carry,
                                        const tasks::TaskContext& context) const {
  if (!context.two_hands.affected || !carries_.as) return {};
  if (carry.clutch == carries_.as->clutch && carry.pinch == carries_.as->pinch) return {};
  return refused(
             "a patient has carried in another way in this session"_text,
             "keep to one technique in a session; several are a study of healthy volunteers"_text)
      .about("technique");
}

bool TwoPlatforms::next() noexcept {
  for (const Hand hand : kBothHands)
    if (!sides_[hand].next(now_.of[hand].forces)) return false;
  now_.session_time_s = now_.of.left.forces.t_s;
  const auto& left = sides_.left.completed_by();
  const auto& right = sides_.right.completed_by();
  now_.skew_s = left && right ? std::optional(to_seconds(*right - *left)) : std::nullopt;
  return true;
}

void TwoPlatforms::begin(Preparation& preparation) noexcept {
  auto& zeros = static_cast<TwoZeros&>(preparation);
  for (const Hand hand : kBothHands) sides_[hand].begin(zeros.of[hand]);
}

bool TwoPlatforms::measure(Preparation& preparation) noexcept {
  auto& zeros = static_cast<TwoZeros&>(preparation);
  for (const Hand hand : kBothHands)
    if (!zeros.ended[hand])
      zeros.ended[hand] = sides_[hand].measure(zeros.of[hand], now_.of[hand].forces);
  now_.zero_progress =
      std::min(zeros.of.left.zeroing.progress(), zeros.of.right.zeroing.progress());
  if (!zeros.ended.left || !zeros.ended.right) return false;
  if (!zeros.of.left.refusal && !zeros.of.right.refusal)
    for (const Hand hand : kBothHands) sides_[hand].accept(zeros.of[hand]);
  now_.zeroed = sides_.left.zeroed() && sides_.right.zeroed();
  return true;
}

Reception TwoPlatforms::receive() noexcept {
  Reception both;
  for (const Hand hand : kBothHands) {
    PlatformSide& side = now_.of[hand];
    const Reception one = sides_[hand].receive(side.forces, kAllFingers);
    both.gap = both.gap || one.gap;
    if (one.sight != Reception::Sight::clear) both.sight = one.sight;
    side.health = sides_[hand].health();
    side.restarted = sides_[hand].restarted();
    side.grip_N = force_of(side.forces.wrench_C, {});
    side.push_W.reset();
    if (!side.forces.any(SampleFlag::missing))
      side.push_W =
          push_in_view(hand, net_wrench(sides_[hand].info().platform, side.forces.wrench_C).force);
  }
  return both;
}

void TwoPlatforms::begin(TrialSetup& setup) noexcept {
  trial_ = &static_cast<TwoPlatformsTrial&>(setup);
  now_.special = {};
  now_.lifted.reset();
  now_.carried.reset();
  now_.clutch_held = false;
  auto& object = trial_->object;
  if (object) object->begin(now_.lifted.emplace());
  if (trial_->carried) {
    trial_->carried->begin(now_.carried.emplace());
    carries_.add(trial_->spec);
  }
  if (pair_ == nullptr) return;
  // A simulated person gets to know the object before the trial.
  OfHands<std::optional<Scene>> halves;
  if (object)
    for (const Hand hand : kBothHands)
      halves[hand] =
          object->half_of(hand, sides_[hand].info().platform, trial_->spec.hands_load()->height_m);
  pair_->meet_object(halves);
  OfHands<std::optional<virtual_patient::CarryKnown>> known;
  if (trial_->carried)
    for (const Hand hand : kBothHands)
      known[hand] = trial_->carried->known_to(hand, sides_[hand].info().platform);
  pair_->meet_points(known);
}

void TwoPlatforms::end(TrialSetup&) noexcept {
  for (const Hand hand : kBothHands) trial_->health[hand] = now_.of[hand].health;
  trial_ = nullptr;
}

void TwoPlatforms::step() noexcept {
  tasks::TwoHandsInput input{{now_.of.left.forces.wrench_C, now_.of.right.forces.wrench_C}};
  if (trial_->object) {
    LiftedView& lifted = *now_.lifted;
    // A hand without a value presses on as before; soon the trial stands still.
    if (now_.of.left.push_W && now_.of.right.push_W)
      trial_->object->press({*now_.of.left.push_W, *now_.of.right.push_W}, lifted);
    input.object = &lifted.object;
    for (const Hand hand : kBothHands) {
      input.touches[hand] = lifted.of[hand].touches;
      input.slips[hand] = lifted.of[hand].slips;
    }
  }
  if (trial_->carried) {
    CarriedView& carried = *now_.carried;
    const bool clutch = now_.clutch_held || (pair_ != nullptr && pair_->holds_clutch());
    if (now_.of.left.push_W && now_.of.right.push_W)
      trial_->carried->press({*now_.of.left.push_W, *now_.of.right.push_W}, clutch, carried);
    input.object = &carried.object;
    input.touches = {carried.held, carried.held};
  }
  const tasks::TaskView view = trial_->task->step(input);
  now_.task = view;
  now_.special = view;
}

void TwoPlatforms::write(const RowFrame& frame, TrialRow& row) noexcept {
  trial_->write(frame, now_, row);
}

void TwoPlatforms::move() noexcept {
  const auto& asked = now_.special.two_hands().moved;
  if (trial_->carried) {
    if (asked && asked->on_rest)
      trial_->carried->stay(asked->rest_X_WO, asked->home, *now_.carried);
    else
      trial_->carried->move(*now_.carried);
  }
  if (!trial_->object) return;
  if (asked && asked->on_rest)
    trial_->object->stay(asked->rest_X_WO, *now_.lifted);
  else
    trial_->object->move(*now_.lifted);
}

void TwoPlatforms::publish() noexcept {
  if (now_.stage == Stage::finished)
    for (const Hand hand : kBothHands) {
      sides_[hand].look();
      now_.of[hand].health = sides_[hand].health();
    }
  snapshots_.publish(now_);
}

void TwoPlatforms::show() noexcept {
  if (pair_ != nullptr) pair_->see(screen_of(now_));
}

/// The left one's first, if both have one.
ApparatusFault TwoPlatforms::fault() const noexcept {
  ApparatusFault fault = sides_.left.fault();
  if (fault.number != 0) {
    fault.where = "Left platform: %1"_text;
    return fault;
  }
  fault = sides_.right.fault();
  if (fault.number == 0) return fault;
  fault.number += PlatformReader::kFaultNumbers;
  fault.where = "Right platform: %1"_text;
  return fault;
}

double TwoPlatforms::lateness_s() const noexcept {
  return std::max(sides_.left.lateness_s(now_.of.left.forces),
                  sides_.right.lateness_s(now_.of.right.forces));
}

std::optional<double> TwoPlatforms::latency_s() const noexcept {
  const auto& left = sides_.left.completed_by();
  const auto& right = sides_.right.completed_by();
  if (!left || !right) return std::nullopt;
  return to_seconds(sides_.right.now() - std::max(*left, *right));
}

}  // namespace isograsp::session
