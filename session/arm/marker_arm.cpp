// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/arm/marker_arm.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/files.hpp"
#include "device/markers/marker_reader.hpp"
#include "kinematics/pose_series.hpp"
#include "kinematics/pose_task.hpp"
#include "kinematics/postures.hpp"
#include "session/library/library.hpp"
#include "storage/crypto/content_hash.hpp"
#include "tasks/kinds/arm/pose_matching.hpp"

namespace isograsp::session {

namespace {
constexpr std::array<PreparationStep, 1> kArmSteps{PreparationStep::start_posture};

bool lasts_longer_than_a_stand_in(double seconds) noexcept {
  return seconds > kLongestStandIn_s + kMarkerTimeSlack_s;
}
}  // namespace

MarkerArm::MarkerArm(std::unique_ptr<MarkerDevice> device, ArmRig rig, ArmOptions options,
                     std::unique_ptr<MarkerSource> person)
    : person_(std::move(person)),
      device_(std::move(device)),
      rig_(std::move(rig)),
      options_(std::move(options)) {
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
  auto frames = ArmFrames::compile(rig_.rig, of.labels);
  if (!frames) return frames.error();
  frames_ = *std::move(frames);
  auto recorded = recorded_markers(rig_.rig, of.labels);
  if (!recorded) return recorded.error();
  recorded_ = *std::move(recorded);
  p_W_.resize(of.labels.size());
  poses_.resize(frames_->frames());
  now_.marker_count = recorded_.size();
  pictures_.emplace(*device_, info_.period_s, device_->now(clock));
  return {};
}

void MarkerArm::stop() noexcept {
  if (std::exchange(streaming_, false)) device_->stop();
}

std::span<const PreparationStep> MarkerArm::steps() const noexcept {
  return kArmSteps;
}

void MarkerArm::describe(storage::SessionRecord& session) const {
  session.calibration = rig_.text;
}

Result<std::unique_ptr<Preparation>> MarkerArm::make_preparation(const ZeroRequest& request) {
  return std::unique_ptr<Preparation>(
      std::make_unique<StartPostureCapture>(info_.period_s, request.settle_s));
}

Result<MarkerArm::References> MarkerArm::references(const tasks::TaskSpec& spec) const {
  References references;
  const auto* const matching = spec.kind.get_if<tasks::PoseMatchingSpec>();
  if (matching == nullptr) return references;
  if (!start_)
    return failed("the start posture of this arm is not known"_text,
                  "hold the start posture for a second first"_text)
        .about("start_posture");
  const auto path = find_in_library(options_.library, "postures", matching->postures, spec.file);
  if (!path) return path.error();
  const auto text = read_text(*path);
  if (!text) return text.error();
  auto library = parse_postures(*text, *path);
  if (!library) return library.error();
  if (library->chain != rig_.chain)
    return refused("is of another chain of frames than the rig"_text,
                   "use postures that were recorded with such a rig"_text)
        .at(*path)
        .about("chain");
  references.postures_hash = storage::hex_of(storage::content_hash(*text));
  const Postures postures = part_of_the_way(*std::move(library), matching->way);
  const StartPosture start = start_->mean();
  for (std::size_t j = 0; j < postures.postures.size(); ++j)
    references.poses.push_back(
        {postures.postures[j].name, adapted(postures, j, start, matching->scale)});
  return references;
}

Result<std::unique_ptr<TrialSetup>> MarkerArm::make_trial(const tasks::TaskSpec& spec,
                                                          const tasks::TaskContext& context) {
  auto brought_to = references(spec);
  if (!brought_to) return brought_to.error();
  tasks::TaskContext of_this_arm = context;
  of_this_arm.references_of_poses = std::move(brought_to->poses);
  auto task = tasks::make_task(spec, of_this_arm);
  if (!task) return task.error();
  auto trial = std::make_unique<ArmTrial>();
  trial->spec = spec;
  trial->task = *std::move(task);
  trial->markers = marker_columns(recorded_);
  for (std::size_t s = 0; s < kArmSegmentCount; ++s)
    trial->has_segment[s] = rig_.frame_of[s].has_value();
  storage::TrialRecord& record = trial->record;
  record.task_name = spec.name;
  record.task_version = spec.version;
  record.task_text = spec.text;
  record.seed = context.seed;
  if (const auto* matching = spec.kind.get_if<tasks::PoseMatchingSpec>()) {
    auto compiled = tasks::pose_task_of(*matching, of_this_arm.references_of_poses);
    if (!compiled) return compiled.error();
    compiled->name = spec.name;
    compiled->frame = rig_.chain.back();
    compiled->postures_hash = brought_to->postures_hash;
    record.scene_text = pose_task_text(*compiled);
    trial->hand_to_object_m = start_->mean().X_L.back().p.norm();
  }
  return std::unique_ptr<TrialSetup>(std::move(trial));
}

bool MarkerArm::next() noexcept {
  if (!pictures_->next()) return false;
  now_.session_time_s = pictures_->t_s();
  see_arm();
  return true;
}

void MarkerArm::see_arm() noexcept {
  const MarkerSample* const picture = pictures_->picture();
  now_.picture = picture != nullptr;
  const bool left = options_.hand == Hand::left;
  for (std::size_t i = 0; i < p_W_.size(); ++i)
    p_W_[i] = picture == nullptr ? unseen_marker()
              : left             ? mirrored(picture->p_W[i])
                                 : picture->p_W[i];
  frames_->solve(p_W_, poses_);
  for (std::size_t s = 0; s < kArmSegmentCount; ++s)
    now_.segments[s] = rig_.frame_of[s] ? poses_[*rig_.frame_of[s]] : FramePose{};
  for (std::size_t k = 0; k < kArmLinkCount; ++k) {
    const Pose& parent = now_.segment(kArmChain[k]).X_W;
    const Pose& child = now_.segment(kArmChain[k + 1]).X_W;
    now_.link_angles[k] = is_missing(parent) || is_missing(child)
                              ? unseen_marker()
                              : link_angles(parent.q.conjugate() * child.q, rig_.links[k]);
  }
  for (std::size_t m = 0; m < recorded_.size(); ++m)
    now_.markers_W[m] = picture == nullptr ? unseen_marker() : picture->p_W[recorded_[m].label];
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
    start_ = capture.mean();  // a copy of fixed size
    now_.zeroed = true;
  }
  return true;
}

Reception MarkerArm::receive() noexcept {
  now_.health = device_->health();
  const double t_s = now_.session_time_s;
  if (now_.picture) last_picture_s_ = t_s;
  if (has_pose(now_.segment(ArmSegment::object).state)) last_seen_s_ = t_s;
  now_.unseen_s = t_s - last_seen_s_;
  held_.see(now_.segment(ArmSegment::dorsum).X_W, now_.segment(ArmSegment::object).X_W);
  Reception reception;
  reception.gap = !now_.picture;
  if (lasts_longer_than_a_stand_in(t_s - last_picture_s_))
    reception.sight = Reception::Sight::lost;
  else if (held_.is_lost())
    reception.sight = Reception::Sight::let_go;
  else if (lasts_longer_than_a_stand_in(now_.unseen_s))
    reception.sight = Reception::Sight::occluded;
  return reception;
}

void MarkerArm::begin(TrialSetup& setup) noexcept {
  trial_ = &static_cast<ArmTrial&>(setup);
  trial_rows_ = 0;
  now_.special = {};
  if (trial_->hand_to_object_m)
    held_.begin(*trial_->hand_to_object_m, info_.period_s);
  else
    held_.end();
}

void MarkerArm::end(TrialSetup&) noexcept {
  trial_->health = now_.health;
  trial_ = nullptr;
  held_.end();
}

void MarkerArm::step() noexcept {
  const FramePose& object = now_.segment(ArmSegment::object);
  // The same product as that of the row's own time: a score from the rows has the same bits.
  const tasks::TaskView view = trial_->task->step(
      tasks::ArmInput{static_cast<double>(trial_rows_) * info_.period_s, object.X_W});
  now_.task = view;
  now_.special = view;
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
