// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/tracked_hand/tracked_hand.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/csv.hpp"
#include "session/tracked_hand/hand_sight.hpp"
#include "session/tracked_hand/hand_size.hpp"
#include "tasks/kinds/hand/virtual_pick_place.hpp"

namespace isograsp::session {

namespace {

constexpr std::array<PreparationStep, 1> kHandSteps{PreparationStep::hand_entry};
constexpr double kMillimetres = 1e3;

}  // namespace

std::string tracker_text(const HandDeviceInfo& device) {
  const std::string scheme = device.uri.substr(0, device.uri.find("://"));
  return "format = \"" + std::string(kTrackerFormat) + "\"\ntracker = \"" + scheme +
         "\"\nservice = \"" + device.service + "\"\nmounting = \"" + device.mounting +
         "\"\ndelay = " +
         (device.delay_s ? format_number(*device.delay_s * kMillimetres) + " # ms"
                         : std::string("\"not measured\"")) +
         "\n";
}

TrackedHand::TrackedHand(std::unique_ptr<HandDevice> device, HandSetup setup,
                         std::unique_ptr<HandSource> person)
    : person_(std::move(person)), device_(std::move(device)), setup_(std::move(setup)) {
  setup_.model.side = setup_.side;
  show_hand_of(setup_.model);
  const HandDeviceInfo& of = device_->info();
  info_.kind = kKind;
  info_.description = of.description;
  info_.simulated = of.simulated;
  info_.recorded = of.recorded;
  info_.period_s = kPeriod_s;
  info_.provenance = of.provenance;
  info_.watches_person = is_live();
}

bool TrackedHand::is_live() const noexcept {
  return !device_->info().simulated && !device_->info().recorded;
}

Result<void> TrackedHand::know_person(const std::optional<storage::PreparationRecord>& other_hand,
                                      bool keeps_joints) {
  keeps_joints_ = keeps_joints;
  if (!other_hand) return {};
  auto size = hand_of_size(*other_hand, setup_.model, setup_.side);
  if (!size) return size.error();
  other_hand_ = *std::move(size);
  return {};
}

Result<void> TrackedHand::start(Clock& clock) {
  if (auto started = device_->start(clock); !started) return started;
  streaming_ = true;
  clock_ = &clock;
  const HandDeviceInfo& of = device_->info();
  // What is shown is one period of the tracker old.
  info_.delay_s = of.delay_s.value_or(0.0) + of.period_s;
  start_ = device_->now(clock);
  reader_.emplace(*device_, setup_.side, kPeriod_s, start_);
  now_.camera_on = is_live();
  return {};
}

void TrackedHand::stop() noexcept {
  if (!std::exchange(streaming_, false)) return;
  device_->stop();
  now_.camera_on = false;
  snapshots_.publish(now_);
}

std::span<const PreparationStep> TrackedHand::steps() const noexcept {
  return kHandSteps;
}

void TrackedHand::describe(storage::SessionRecord& session) const {
  session.calibration = tracker_text(device_->info());
}

Result<std::unique_ptr<Preparation>> TrackedHand::make_preparation(const ZeroRequest& request) {
  if (setup_.size_of_other && !other_hand_)
    return failed("the size of the other hand is not known"_text,
                  "do the entry test with the other hand first, in a session of its own"_text)
        .about("size");
  return std::unique_ptr<Preparation>(
      std::make_unique<EntryCapture>(kPeriod_s, request.settle_s, setup_.side, setup_.model,
                                     setup_.size_of_other ? other_hand_ : std::nullopt));
}

Result<void> TrackedHand::fits(const tasks::TaskSpec& spec) const {
  const auto* const placing = spec.kind.get_if<tasks::VirtualPickPlaceSpec>();
  if (placing == nullptr) return {};
  if (entry_ == nullptr)
    return failed("the entry test of this hand has not been done"_text,
                  "do it first: ten seconds at rest, then open and close three times"_text)
        .about("hand_entry");
  if (entry_->entry().refusal() != HandEntry::Refusal::none)
    return refused("the entry test bars this hand"_text, words_of(entry_->entry().refusal()))
        .at(spec.file)
        .about("hand_entry");
  for (const auto& item : placing->items) {
    const virtual_hand::StudyObject& object = virtual_hand::study_objects()[item.object];
    const double width_m = 2.0 * object.shape.half_m.x();
    if (width_m > entry_->entry().widest_object_m())
      return refused("'%1' is %2 mm wide, this hand is offered %3 mm at most"_text(
                         Known{std::string(object.name)}, std::lround(width_m * kMillimetres),
                         static_cast<int>(entry_->entry().widest_object_m() * kMillimetres)),
                     "choose a task with narrower objects"_text)
          .at(spec.file)
          .about("object");
  }
  return {};
}

Result<std::unique_ptr<TrialSetup>> TrackedHand::make_trial(const tasks::TaskSpec& spec,
                                                            const tasks::TaskContext& context) {
  if (context.references.allowed == tasks::Effort::none)
    return refused("the screening allows this hand no movement"_text,
                   "leave the task out, or repeat the screening"_text)
        .at(spec.file)
        .about("kind");
  if (auto fitting = fits(spec); !fitting) return fitting.error();
  tasks::TaskContext of_this_hand = context;
  of_this_hand.placements_left = tasks::kMostPlacements - placements_begun_;
  auto task = tasks::make_task(spec, of_this_hand);
  if (!task) return task.error();
  auto trial = std::make_unique<HandTrial>();
  trial->spec = spec;
  trial->task = *std::move(task);
  trial->keeps_joints = keeps_joints_;
  trial->model = setup_.model;
  storage::TrialRecord& record = trial->record;
  if (entry_ != nullptr && entry_->entry().refusal() == HandEntry::Refusal::none) {
    auto measured = entry_->hand();
    if (!measured) return measured.error();
    trial->model = *std::move(measured);
    record.references.emplace("hand_length_m", trial->model.length_m);
    record.references.emplace("opening_m", entry_->entry().opening_m());
  }
  if (const auto* placing = spec.kind.get_if<tasks::VirtualPickPlaceSpec>())
    trial->objects = std::make_unique<VirtualObjects>(trial->model, kPeriod_s, placing->table_m);
  record.task_name = spec.name;
  record.task_version = spec.version;
  record.task_text = spec.text;
  record.seed = context.seed;
  return std::unique_ptr<TrialSetup>(std::move(trial));
}

void TrackedHand::show_hand_of(const virtual_hand::HandModel& model) noexcept {
  shown_model_ = model;
  for (std::size_t d = 0; d < kDigitCount; ++d) now_.link_radii_m[d] = model.digits[d].radii_m;
}

bool TrackedHand::next() noexcept {
  if (!reader_->next()) return false;
  now_.session_time_s = reader_->t_s();
  now_.hand = reader_->hand();
  if (now_.hand.held) return true;  // all of it is as it was
  now_.thumb_index_gap_m = thumb_index_gap(now_.hand.frame);
  now_.pose = virtual_hand::fitted_pose(shown_model_, now_.hand.frame);
  now_.seen_hand.reset();
  if (now_.pose) now_.seen_hand = virtual_hand::hand_in_space(shown_model_, now_.pose->pose);
  return true;
}

void TrackedHand::begin(Preparation&) noexcept {
  now_.entry.emplace();
}

bool TrackedHand::measure(Preparation& preparation) noexcept {
  auto& capture = static_cast<EntryCapture&>(preparation);
  const bool ended = capture.add(now_.hand, now_.thumb_index_gap_m);
  now_.zero_progress = capture.progress();
  now_.entry = capture.shown();
  if (!ended) return false;
  entry_ = &capture;
  now_.entry.reset();
  now_.zeroed = capture.entry().refusal() == HandEntry::Refusal::none;
  now_.opening_m = now_.zeroed ? capture.entry().opening_m() : 0.0;
  return true;
}

Reception TrackedHand::receive() noexcept {
  now_.health = device_->health();
  return hand_reception(now_.hand, now_.health.fault);
}

void TrackedHand::begin(TrialSetup& setup) noexcept {
  trial_ = &static_cast<HandTrial&>(setup);
  show_hand_of(trial_->model);
  frames_ = lost_ = 0;
  let_go_ = false;
  forget_grasp();
  if (trial_->objects)  // nothing stands on it yet
    now_.ground = {trial_->objects->places.front().ground.table_m, std::nullopt};
}

void TrackedHand::end(TrialSetup&) noexcept {
  trial_->health = now_.health;
  trial_ = nullptr;
  forget_grasp();
}

void TrackedHand::forget_grasp() noexcept {
  now_.special = {};
  now_.grasp = {};
  now_.release_N = tasks::kNotMeasured;
  now_.grasping_hand.reset();
  now_.ground.reset();
}

bool TrackedHand::let_go() noexcept {
  if (!now_.grasp.object_there || now_.grasp.helped || let_go_) return false;
  let_go_ = true;
  return true;
}

void TrackedHand::step() noexcept {
  ++frames_;
  lost_ += now_.hand.held ? 1 : 0;
  if (trial_->objects) {
    trial_->objects->grasp.frame(now_.hand.frame, now_.hand.held);
    now_.grasp = trial_->objects->grasp.state();
    if (now_.grasp.hand_there)
      now_.grasping_hand = virtual_hand::hand_in_space(trial_->model, now_.grasp.hand);
  }
  tasks::HandInput input;
  input.seen = !now_.hand.held;
  input.thumb_index_gap_m = now_.thumb_index_gap_m;
  input.held = now_.grasp.held;
  input.touched = touches(now_.grasp);
  input.supported = now_.grasp.supported;
  if (now_.grasp.object_there) input.X_WO = now_.grasp.object.X_WO;
  input.frames = frames_;
  input.lost = lost_;
  input.let_go = let_go_;
  const tasks::TaskView view = trial_->task->step(input);
  now_.task = view;
  now_.special = view;
}

void TrackedHand::write(const RowFrame& frame, TrialRow& row) noexcept {
  // Of a pause only what was out of sight is held against the picture of the tracker.
  if (now_.stage == Stage::paused && now_.pause_cause == PauseCause::occluded) {
    ++frames_;
    lost_ += now_.hand.held ? 1 : 0;
  }
  trial_->write(frame, now_, row);
}

void TrackedHand::move() noexcept {
  if (!trial_->objects) return;
  const tasks::HandView& task = now_.special.hand();
  if (task.order == tasks::ObjectOrder::place) {
    ++placements_begun_;
    let_go_ = false;
    now_.ground = trial_->objects->places[static_cast<std::size_t>(task.object)].ground;
  }
  trial_->objects->obey(task);
  now_.grasp = trial_->objects->grasp.state();
  now_.release_N = now_.grasp.level == hand_world::AssistanceLevel::off
                       ? tasks::kNotMeasured
                       : trial_->objects->grasp.gains().release_N;
}

void TrackedHand::show() noexcept {
  if (person_ != nullptr) person_->see(screen_of(now_));
}

ApparatusFault TrackedHand::fault() const noexcept {
  const HandFault fault = now_.health.fault;
  if (fault == HandFault::none) return {};
  return {static_cast<int>(fault), words_of(fault)};
}

double TrackedHand::lateness_s() const noexcept {
  return to_seconds(device_->now(*clock_) - start_) - now_.session_time_s;
}

}  // namespace isograsp::session
