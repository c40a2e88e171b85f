// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/trial_pages/arm_replay.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "hand/arm_columns.hpp"

namespace isograsp::gui {

namespace {

constexpr std::string_view kFirstAxisOfMarker = "_x_m";

/// Of columns "marker_NAME_x_m": NAME.
std::vector<std::string> recorded_marker_names(const Signals& signals) {
  std::vector<std::string> names;
  for (const std::string& column : signals.names())
    if (column.starts_with(columns::kMarker) && column.ends_with(kFirstAxisOfMarker))
      names.push_back(
          column.substr(columns::kMarker.size(),
                        column.size() - columns::kMarker.size() - kFirstAxisOfMarker.size()));
  return names;
}

FrameState state_at(double number) {
  const bool known = number >= 0.0 && number <= static_cast<double>(FrameState::missing);
  return known ? static_cast<FrameState>(std::lround(number)) : FrameState::missing;
}

}  // namespace

bool ArmReplay::is_of_arm(const TrialReplay& replay) noexcept {
  const auto& names = replay.signals().names();
  return std::any_of(names.begin(), names.end(),
                     [](const std::string& name) { return name.starts_with(columns::kMarker); });
}

Result<ArmReplay> ArmReplay::make(const storage::SessionRecord& session,
                                  const TrialReplay& replay) {
  const Hand hand = session.hand.value_or(Hand::right);
  const auto rig = session::ArmRig::parse(session.calibration, session.device_uri, hand);
  if (!rig) return rig.error();
  const Signals& signals = replay.signals();
  ArmReplay arm;
  auto names = recorded_marker_names(signals);
  names.resize(std::min(names.size(), session::ArmRig::kMostMarkers));
  for (const std::string& name : names) {
    const std::string column = std::string(columns::kMarker) + name + "_";
    arm.markers_.push_back(
        {signals.find(column + "x_m"), signals.find(column + "y_m"), signals.find(column + "z_m")});
  }
  arm.find(signals);
  arm.space_ = std::make_shared<const ArmSpace>(session::setup_of(*rig, std::move(names)), hand);
  arm.look_for_object(signals);
  return arm;
}

void ArmReplay::find(const Signals& signals) {
  for (std::size_t s = 0; s < kArmSegmentCount; ++s) {
    const columns::OfSegment& of = columns::segment_pose[s];
    segments_[s] = {find_pose(signals, of.position, of.attitude), signals.find(of.residual_m),
                    signals.find(of.state)};
  }
  for (std::size_t link = 0; link < kArmLinkCount; ++link)
    for (std::size_t a = 0; a < 3; ++a)
      links_[link][a] = signals.find(columns::link_angle[link][a]);
  reference_ = find_pose(signals, columns::reference_position, columns::reference_attitude);
  matched_ = signals.find(columns::matched);
}

/// Where it was seen, and what the picture has in its middle: of an arm without object a marker.
void ArmReplay::look_for_object(const Signals& signals) {
  const PosePlaces& object = segments_[index_of(ArmSegment::object)].pose;
  std::optional<std::size_t> last;
  last_seen_.reserve(signals.rows());
  for (std::size_t row = 0; row < signals.rows(); ++row) {
    if (!is_missing(pose_at(signals, object, row))) {
      if (!last) centre_W_ = vector_at(signals, object.position, row);
      last = row;
    }
    last_seen_.push_back(last);
  }
  has_object_ = last.has_value();
  if (has_object_) return;
  for (std::size_t row = 0; row < signals.rows(); ++row)
    for (const auto& marker : markers_)
      if (const Vec3 p_W = vector_at(signals, marker, row); p_W.allFinite()) {
        centre_W_ = p_W;
        return;
      }
}

session::ArmSnapshot ArmReplay::at(const TrialReplay& replay, const ReplayState& state) const {
  session::ArmSnapshot now;
  now.stage = state.phase == tasks::Phase::paused ? session::Stage::paused : session::Stage::trial;
  now.task.phase = state.phase;
  now.task.target_index = state.target_index;
  now.task.targets_reached = state.targets_reached;
  now.start_p_WO = centre_W_;
  now.marker_count = markers_.size();
  now.markers_W.fill(Vec3::Constant(kMissing));
  for (Vec3& angles : now.link_angles) angles.setConstant(kMissing);
  if (replay.rows() == 0) return now;
  const Signals& signals = replay.signals();
  const std::size_t row = replay.row_at(state.t_s);
  const double row_s = signals.column(columns::t_s)[row];
  if (const auto seen = last_seen_[row]) {
    now.last_X_WO = pose_at(signals, segments_[index_of(ArmSegment::object)].pose, *seen);
    now.unseen_s = *seen == row ? 0.0 : state.t_s - signals.column(columns::t_s)[*seen];
  }
  if (replay.gap_after(row) && state.t_s - row_s >= replay.period_s()) {
    now.unseen_s = state.t_s - row_s;
    return now;
  }
  for (std::size_t s = 0; s < kArmSegmentCount; ++s) {
    FramePose& segment = now.segments[s];
    segment.state = state_at(value_at(signals, segments_[s].state, row));
    segment.X_W = pose_at(signals, segments_[s].pose, row);
    segment.residual_m = value_at(signals, segments_[s].residual_m, row);
    if (is_missing(segment.X_W) && has_pose(segment.state)) segment.state = FrameState::missing;
  }
  for (std::size_t link = 0; link < kArmLinkCount; ++link)
    now.link_angles[link] = vector_at(signals, links_[link], row);
  for (std::size_t m = 0; m < markers_.size(); ++m)
    now.markers_W[m] = vector_at(signals, markers_[m], row);
  tasks::ArmView task;
  task.X_WR = pose_at(signals, reference_, row);
  task.reference_shown = !is_missing(task.X_WR);
  task.matched = value_at(signals, matched_, row) > 0.0;
  now.special.special = task;
  return now;
}

std::vector<Vec3> ArmReplay::path(const TrialReplay& replay, double least_step_m) const {
  std::vector<Vec3> path;
  if (!has_object_) return path;
  const Signals& signals = replay.signals();
  const PosePlaces& object = segments_[index_of(ArmSegment::object)].pose;
  for (std::size_t row = 0; row < signals.rows(); ++row) {
    const Pose X_WO = pose_at(signals, object, row);
    const bool drawn = !path.empty() && path.back().allFinite();
    if (is_missing(X_WO)) {
      if (drawn) path.push_back(Vec3::Constant(kMissing));
      continue;
    }
    const Vec3 p_S = space_->box_at(X_WO, centre_W_).p;
    const bool interrupted = replay.gap_after(row);
    if (!drawn || interrupted || (p_S - path.back()).norm() >= least_step_m) path.push_back(p_S);
    if (interrupted) path.push_back(Vec3::Constant(kMissing));
  }
  return path;
}

}  // namespace isograsp::gui
