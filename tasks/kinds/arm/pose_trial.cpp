// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/kinds/arm/pose_trial.hpp"

#include <algorithm>
#include <utility>

#include "hand/arm_columns.hpp"
#include "tasks/kinds/arm/segment_poses.hpp"

namespace isograsp::tasks {

namespace {

/// Of the segments that every trial of an arm records.
Rig rig_of_segments() {
  Rig rig;
  const auto link = [&](std::string_view name, std::string_view parent, std::string_view child) {
    rig.links.push_back(
        {std::string(name), std::string(parent), std::string(child), AngleSequence::rpy, {}});
  };
  link("forearm", "elbow", "forearm");
  link("wrist", "forearm", "dorsum");
  link("fingers", "dorsum", "object");
  link("object", kWorld, "object");
  rig.score = RigScore{"forearm", "object", "object"};
  return rig;
}

class PoseTrialReading {
 public:
  PoseTrialReading(const PoseMatchingSpec& spec, const Record& record)
      : spec_(spec), record_(record) {
    trial_.rig = rig_of_segments();
    read_rows();
    read_targets();
    run();
    find_unseen();
    measure_movements();
  }

  [[nodiscard]] PoseTrial take() { return std::move(trial_); }

 private:
  void read_rows() {
    const Signals& signals = record_.signals();
    const auto t_s = signals.column(columns::t_s);
    for (std::size_t row = 0; row < record_.rows(); ++row)
      if (!record_.paused(row)) rows_.push_back(row);
    trial_.series.source = "the recorded signals";
    for (std::size_t s = 0; s < kArmSegmentCount; ++s) {
      const auto& columns = columns::segment_pose[s];
      const SegmentPoses poses(signals, columns.position, columns.attitude);
      if (!poses.known()) continue;
      trial_.series.frames.emplace_back(kArmSegmentNames[s]);
      trial_.series.X_W.emplace_back();
      for (const std::size_t row : rows_) trial_.series.X_W.back().push_back(poses.at(row));
    }
    for (const std::size_t row : rows_) trial_.series.t_s.push_back(t_s[row]);
    trial_.rig.score->brace = recorded(ArmSegment::brace);
    trial_.rig.score->elbow = recorded(ArmSegment::elbow);
  }

  [[nodiscard]] std::optional<std::string> recorded(ArmSegment segment) const {
    const std::string name(kArmSegmentNames[index_of(segment)]);
    return trial_.series.frame(name) ? std::optional(name) : std::nullopt;
  }

  /// The reference of each target is where it was first shown.
  void read_targets() {
    const auto index = record_.signals().column(columns::target_index);
    const SegmentPoses reference = reference_poses(record_.signals());
    task_.position_tolerance_m = spec_.position_tolerance_m;
    task_.angle_tolerance_rad = spec_.angle_tolerance_rad;
    task_.hold_s = spec_.hold_s;
    task_.display_s = spec_.display_s;
    task_.time_limit_s = spec_.time_limit_s;
    for (const std::size_t row : rows_) {
      const std::size_t next = task_.references.size();
      if (next == spec_.targets()) break;
      if (index[row] != static_cast<double>(next)) continue;
      const Pose X_WR = reference.at(row);
      if (is_missing(X_WR)) continue;
      task_.references.push_back({spec_.sequence[next % spec_.sequence.size()], X_WR});
      task_.targets.push_back(next);
    }
  }

  void run() {
    if (task_.targets.empty()) return;
    const std::vector<Pose>& X_WO =
        trial_.series.X_W[*trial_.series.frame(kArmSegmentNames[index_of(ArmSegment::object)])];
    PoseTaskRun run(task_);
    double sought_s = 0.0;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      if (const auto event = run.step(trial_.series.t_s[k], X_WO[k]))
        trial_.events.push_back(*event);
      sought_s = run.sought_s(trial_.series.t_s[k]);
    }
    const bool sought = run.started() && !run.finished() && !run.matched();
    if (sought) trial_.unended = UnendedTarget{run.target(), sought_s};
    if (const auto event = run.finish()) trial_.events.push_back(*event);
  }

  void find_unseen() {
    const auto t_s = record_.signals().column(columns::t_s);
    const SegmentPoses object = object_poses(record_.signals());
    for (const PoseEvent& event : trial_.events) {
      double all_s = 0.0;
      double unseen_s = 0.0;
      for (std::size_t row = 0; row < record_.rows(); ++row) {
        if (t_s[row] < event.cue_s || t_s[row] >= event.done_s) continue;
        all_s += record_.hold_s(row);
        if (is_missing(object.at(row))) unseen_s += record_.hold_s(row);
      }
      trial_.unseen.push_back(all_s > 0.0 ? unseen_s / all_s : 0.0);
    }
  }

  void measure_movements() {
    std::vector<PoseTarget> targets;
    for (const PoseEvent& event : trial_.events)
      targets.push_back({task_.references[event.reference].name, event.cue_s, event.enter_s,
                         task_.references[event.reference].X_WR});
    auto scores = score_movements(trial_.rig, trial_.series, std::move(targets));
    if (scores)
      trial_.movements = *std::move(scores);
    else
      trial_.unmeasured = scores.error().what;
  }

  const PoseMatchingSpec& spec_;
  const Record& record_;
  std::vector<std::size_t> rows_;  ///< not paused
  PoseTask task_;                  ///< of the targets that were shown
  PoseTrial trial_;
};

}  // namespace

bool append(PoseTrial& all, PoseTrial more) {
  if (more.series.t_s.empty()) return true;
  if (all.series.t_s.empty()) {
    all = std::move(more);
    return true;
  }
  if (all.series.frames != more.series.frames) return false;
  constexpr double kApart_s = 1.0;  // a hole in which no movement is
  const double later_s = all.series.t_s.back() + kApart_s - more.series.t_s.front();
  for (const double t_s : more.series.t_s) all.series.t_s.push_back(t_s + later_s);
  for (std::size_t frame = 0; frame < all.series.X_W.size(); ++frame)
    all.series.X_W[frame].insert(all.series.X_W[frame].end(), more.series.X_W[frame].begin(),
                                 more.series.X_W[frame].end());
  for (PoseEvent& event : more.events) {
    event.cue_s += later_s;
    if (event.enter_s) *event.enter_s += later_s;
    event.done_s += later_s;
    all.events.push_back(event);
  }
  for (PoseTarget& target : more.movements.targets) {
    target.cue_s += later_s;
    if (target.matched_s) *target.matched_s += later_s;
    all.movements.targets.push_back(std::move(target));
  }
  for (std::vector<LinkMovement>& links : more.movements.links) {
    for (LinkMovement& link : links)
      for (double& t_s : link.t_s) t_s += later_s;
    all.movements.links.push_back(std::move(links));
  }
  if (all.unmeasured.empty()) all.unmeasured = std::move(more.unmeasured);
  all.unseen.insert(all.unseen.end(), more.unseen.begin(), more.unseen.end());
  all.unended = more.unended;
  return true;
}

PoseTrial pose_trial(const PoseMatchingSpec& spec, const Signals& signals) {
  const Record record(signals);
  for (const std::string& name : columns_of_pose_trial())
    if (!signals.has(name)) return {};
  return PoseTrialReading(spec, record).take();
}

}  // namespace isograsp::tasks
