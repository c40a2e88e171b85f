// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/arm/marker_arm.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include "core/files.hpp"
#include "kinematics/pose_series.hpp"
#include "kinematics/pose_task.hpp"
#include "kinematics/postures.hpp"
#include "session/arm/passive_range.hpp"
#include "session/library/library.hpp"
#include "storage/crypto/content_hash.hpp"
#include "tasks/kinds/arm/active_range.hpp"
#include "tasks/kinds/arm/pose_matching.hpp"

namespace isograsp::session {

namespace {
constexpr std::array<PreparationStep, 1> kArmSteps{PreparationStep::start_posture};

Error no_chain() {
  return refused("needs a rig with a chain of elbow, forearm, back of the hand and object"_text,
                 "use such a rig, kurillo15 for example"_text);
}

/// Takes in the angle that is asked for; not finite: it is not seen. `counts`: its range grows.
void add_to(ShownAngle& shown, double angle_rad, bool counts) noexcept {
  shown.seen = std::isfinite(angle_rad);
  if (!shown.seen) return;
  shown.now_rad = angle_rad;
  if (!counts) return;
  shown.least_rad = shown.ranged ? std::min(shown.least_rad, angle_rad) : angle_rad;
  shown.largest_rad = shown.ranged ? std::max(shown.largest_rad, angle_rad) : angle_rad;
  shown.ranged = true;
}
/// The person's own range of an angle as postures.
Result<tasks::ArmPostures> own_postures(LinkAngle asked, const std::vector<OwnRange>& ranges,
                                        const StartPosture& start, const ArmRig& rig) {
  const std::size_t link = index_of(asked.link);
  const auto range = std::find_if(ranges.begin(), ranges.end(), [&](const OwnRange& one) {
    return one.link == kArmLinkNames[link] && one.angle == asked.angle - 1;
  });
  if (range == ranges.end())
    return failed("the range of this angle has not been measured in this session"_text,
                  "measure it first: a task of the kind active_range, angle %1"_text(asked.angle))
        .about("own_range");
  // What is the same from day to day: not the range, which is what changes.
  const std::string what =
      "own range of " + std::string(kArmLinkNames[link]) + " angle " + std::to_string(asked.angle);
  return tasks::ArmPostures{own_range_postures(start, rig.chain, link, rig.links[link], *range),
                            start, what};
}

}  // namespace

MarkerArm::MarkerArm(std::unique_ptr<MarkerDevice> device, ArmRig rig, std::string library,
                     std::unique_ptr<MarkerSource> person)
    : person_(std::move(person)),
      device_(std::move(device)),
      rig_(std::move(rig)),
      library_(std::move(library)) {
  const MarkerDeviceInfo& of = device_->info();
  info_ = {kKind,       of.description, of.simulated, of.recorded,
           of.period_s, of.delay_s,     of.provenance};
}

Result<void> MarkerArm::start(Clock& clock) {
  if (auto started = device_->start(clock); !started) return started;
  streaming_ = true;
  clock_ = &clock;
  const MarkerDeviceInfo& of = device_->info();
  info_.period_s = of.period_s;
  info_.description = of.description;
  auto sight = ArmSight::compile(rig_, of.labels);
  if (!sight) return sight.error();
  sight_ = *std::move(sight);
  pictures_.emplace(*device_, info_.period_s, device_->now(clock));
  return {};
}

ArmSetup MarkerArm::setup() const {
  std::vector<std::string> markers;
  for (const RecordedMarker& marker : sight_->recorded()) markers.push_back(marker.name);
  return setup_of(rig_, std::move(markers));
}

void MarkerArm::stop() noexcept {
  if (std::exchange(streaming_, false)) device_->stop();
}

std::span<const PreparationStep> MarkerArm::steps() const noexcept {
  if (rig_.chain.empty()) return {};
  return kArmSteps;
}

void MarkerArm::describe(storage::SessionRecord& session) const {
  session.calibration = rig_.text;
}

Result<void> MarkerArm::fits(const tasks::TaskSpec& spec) const {
  if (rig_.chain.empty() && !spec.kind->unseen_goes_on) return no_chain().at(spec.file);
  if (spec.kind->markers == nullptr) return {};
  for (const std::string& name : spec.kind->markers(spec.kind))
    if (std::none_of(sight_->recorded().begin(), sight_->recorded().end(),
                     [&name](const RecordedMarker& marker) { return marker.name == name; }))
      return refused("needs the marker '%1', which rig or cameras do not have"_text(name),
                     "use a rig that names it, or name the marker in the task"_text)
          .at(spec.file);
  return {};
}

Result<std::unique_ptr<Preparation>> MarkerArm::make_preparation(const ZeroRequest& request) {
  if (rig_.chain.empty()) return no_chain();
  return std::unique_ptr<Preparation>(
      std::make_unique<StartPostureCapture>(info_.period_s, request.settle_s));
}

Result<std::optional<tasks::ArmPostures>> MarkerArm::postures(
    const tasks::TaskSpec& spec, const std::vector<OwnRange>& ranges) const {
  std::optional<tasks::ArmPostures> of_this_arm;
  if (spec.kind->postures == nullptr) return of_this_arm;
  if (!start_)
    return failed("the start posture of this arm is not known"_text,
                  "hold the start posture for a second first"_text)
        .about("start_posture");
  if (const auto* matching = spec.kind.get_if<tasks::PoseMatchingSpec>();
      matching != nullptr && matching->own_range) {
    auto own = own_postures(*matching->own_range, ranges, start_->mean(), rig_);
    if (!own) return Error(own.error()).at(spec.file);
    of_this_arm = *std::move(own);
    return of_this_arm;
  }
  const auto path =
      find_in_library(library_, "postures", spec.kind->postures(spec.kind), spec.file);
  if (!path) return path.error();
  auto text = read_text(*path);
  if (!text) return text.error();
  auto library = parse_postures(*text, *path);
  if (!library) return library.error();
  if (library->chain != rig_.chain)
    return refused("is of another chain of frames than the rig"_text,
                   "use postures that were recorded with such a rig"_text)
        .at(*path)
        .about("chain");
  of_this_arm = tasks::ArmPostures{*std::move(library), start_->mean(), *std::move(text)};
  return of_this_arm;
}

Result<std::unique_ptr<TrialSetup>> MarkerArm::make_trial(const tasks::TaskSpec& spec,
                                                          const tasks::TaskContext& context) {
  if (auto fitting = fits(spec); !fitting) return fitting.error();
  auto arm = postures(spec, context.ranges);
  if (!arm) return arm.error();
  if (auto allowed = check_screening(spec, *arm ? &(*arm)->library : nullptr, rig_.links,
                                     context.references.allowed, context.screening);
      !allowed)
    return allowed.error();
  tasks::TaskContext of_this_arm = context;
  of_this_arm.arm = *std::move(arm);
  auto task = tasks::make_task(spec, of_this_arm);
  if (!task) return task.error();
  auto trial = std::make_unique<ArmTrial>();
  if (of_this_arm.arm) trial->hand_to_object_m = of_this_arm.arm->start.X_L.back().p.norm();
  trial->spec = spec;
  trial->task = *std::move(task);
  trial->markers = marker_columns(sight_->recorded());
  for (std::size_t s = 0; s < kArmSegmentCount; ++s)
    trial->has_segment[s] = rig_.frame_of[s].has_value();
  if (const auto* range = spec.kind.get_if<tasks::ActiveRangeSpec>())
    trial->asked = {index_of(range->link), static_cast<Eigen::Index>(range->angle - 1)};
  storage::TrialRecord& record = trial->record;
  record.task_name = spec.name;
  record.task_version = spec.version;
  record.task_text = spec.text;
  record.seed = context.seed;
  if (const auto* matching = spec.kind.get_if<tasks::PoseMatchingSpec>()) {
    auto compiled = tasks::pose_task_of(*matching, of_this_arm.arm);
    if (!compiled) return compiled.error();
    compiled->name = spec.name;
    compiled->postures_hash = storage::uuid_of(of_this_arm.arm->text);
    record.scene_text = pose_task_text(*compiled);
  } else if (of_this_arm.arm) {
    record.scene_text = of_this_arm.arm->text;
  }
  return std::unique_ptr<TrialSetup>(std::move(trial));
}

bool MarkerArm::next() noexcept {
  if (!pictures_->next()) return false;
  now_.session_time_s = pictures_->t_s();
  const MarkerSample* const picture = pictures_->picture();
  now_.picture = picture != nullptr;
  sight_->see(picture == nullptr ? std::span<const Vec3>() : picture->p_W, now_);
  return true;
}

void MarkerArm::begin(Preparation&) noexcept {}

bool MarkerArm::measure(Preparation& preparation) noexcept {
  auto& capture = static_cast<StartPostureCapture&>(preparation);
  std::array<Pose, kArmChain.size()> X_W;
  for (std::size_t k = 0; k < kArmChain.size(); ++k) X_W[k] = now_.segment(kArmChain[k]).X_W;
  const bool ended = capture.add(X_W);
  now_.zero_progress = capture.progress();
  if (!ended) return false;
  if (capture.refusal() == StartPostureCapture::Refusal::none) {
    start_ = capture.mean();         // a copy of fixed size
    now_.start_p_WO = X_W.back().p;  // it was still, and the frame that ends it has all of it
    now_.zeroed = true;
  }
  return true;
}

bool MarkerArm::sight_matters() const noexcept {
  return trial_ == nullptr || !trial_->spec.kind->unseen_goes_on;
}

Reception MarkerArm::receive() noexcept {
  now_.health = device_->health();
  const double t_s = now_.session_time_s;
  if (now_.picture) last_picture_s_ = t_s;
  const FramePose& object = now_.segment(ArmSegment::object);
  if (has_pose(object.state)) {
    last_seen_s_ = t_s;
    now_.last_X_WO = object.X_W;
  }
  now_.unseen_s = t_s - last_seen_s_;
  held_.see(now_.segment(ArmSegment::dorsum).X_W, now_.segment(ArmSegment::object).X_W);
  Reception reception;
  reception.gap = !now_.picture;
  if (outlasts_a_stand_in(t_s - last_picture_s_))
    reception.sight = Reception::Sight::lost;
  else if (held_.is_lost())
    reception.sight = Reception::Sight::let_go;
  else if (sight_matters() && outlasts_a_stand_in(now_.unseen_s))
    reception.sight = Reception::Sight::occluded;
  return reception;
}

void MarkerArm::begin(TrialSetup& setup) noexcept {
  trial_ = &static_cast<ArmTrial&>(setup);
  trial_rows_ = 0;
  now_.special = {};
  now_.angle = {.shown = trial_->asked.has_value()};
  if (trial_->hand_to_object_m)
    held_.begin(*trial_->hand_to_object_m, info_.period_s);
  else
    held_.end();
}

void MarkerArm::end(TrialSetup&) noexcept {
  trial_->health = now_.health;
  trial_ = nullptr;
  now_.angle = {};
  held_.end();
}

void MarkerArm::step() noexcept {
  const FramePose& object = now_.segment(ArmSegment::object);
  // The same product as that of the row's own time: a score from the rows has the same bits.
  const tasks::TaskView view = trial_->task->step(
      tasks::ArmInput{static_cast<double>(trial_rows_) * info_.period_s, object.X_W});
  now_.task = view;
  now_.special = view;
  if (!trial_->asked) return;
  const auto [link, angle] = *trial_->asked;
  add_to(now_.angle, now_.link_angles[link][angle], view.phase == tasks::Phase::active);
}

void MarkerArm::write(const RowFrame& frame, TrialRow& row) noexcept {
  trial_->write(frame, now_, row);
  ++trial_rows_;
}

void MarkerArm::show() noexcept {
  if (person_ != nullptr) person_->see(screen_of(now_));
}

ApparatusFault MarkerArm::fault() const noexcept {
  const MarkerFault fault = now_.health.fault;
  if (fault == MarkerFault::none) return {};
  return {static_cast<int>(fault), words_of(fault)};
}

double MarkerArm::lateness_s() const noexcept {
  return to_seconds(device_->now(*clock_) - pictures_->stamp());
}

std::optional<double> MarkerArm::latency_s() const noexcept {
  if (!now_.picture) return std::nullopt;
  return lateness_s();
}

}  // namespace isograsp::session
