// SPDX-License-Identifier: GPL-3.0-or-later
// A frame of two directions u and v, for axes a and b, c being the third:
//   s = +1 if (a, b, c) is cyclic, else -1
//   e_a = u / |u|,   e_c = s (e_a x v) / |e_a x v|,   e_b = s (e_c x e_a)
#include "kinematics/arm_frames.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace isograsp {

std::string name_of(const FramePose& pose, const RigFrame& frame) {
  switch (pose.state) {
    case FrameState::ok: return "ok";
    case FrameState::rejected: {
      const auto* cluster = std::get_if<ClusterFrame>(&frame.method);
      return "ok+rejected_" + (cluster != nullptr && pose.rejected
                                   ? cluster->markers[*pose.rejected]
                                   : std::string());
    }
    case FrameState::few: return "few";
    case FrameState::collinear: return "collinear";
    case FrameState::residual: return "residual";
    case FrameState::missing: return "missing";
  }
  return "";
}

std::optional<Quat> attitude_from_axes(const Vec3& primary, int a, const Vec3& secondary,
                                       int b) noexcept {
  constexpr double kLeastSine = 0.087155742747658173558;  // sin 5 degrees
  const double length_u = primary.norm();
  const double length_v = secondary.norm();
  const Vec3 cross = primary.cross(secondary);
  if (!(length_u > 0.0) || !(length_v > 0.0) || !(cross.norm() >= kLeastSine * length_u * length_v))
    return std::nullopt;
  const double s = (a + 1) % 3 == b ? 1.0 : -1.0;
  Mat3 R;
  const Vec3 e_a = primary / length_u;
  const Vec3 e_c = s * e_a.cross(secondary).normalized();
  R.col(a) = e_a;
  R.col(3 - a - b) = e_c;
  R.col(b) = s * e_c.cross(e_a);
  return Quat(R).normalized();
}

/// Turns names into places in a row.
class ArmFrames::Compiler {
 public:
  Compiler(const Rig& rig, SeenMarkers seen) : rig_(rig), out_(std::move(seen)) {}

  ArmFrames compile() {
    for (const RigFrame& frame : rig_.frames)
      std::visit([this](const auto& method) { add(method); }, frame.method);
    for (const std::string& marker : rig_.markers) static_cast<void>(named(marker));
    out_.last_.assign(out_.frames_.size(), missing_pose().q);
    out_.absent_.assign(absent_.begin(), absent_.end());
    return std::move(out_);
  }
  [[nodiscard]] bool found_any() const noexcept { return found_any_; }

 private:
  Named named(const std::string& name) {
    Named one;
    for (const RigLandmark& landmark : rig_.landmarks)
      if (landmark.name == name) {
        one.frame = rig_.frame(landmark.frame);
        one.p_F = landmark.position_m;
        return one;
      }
    const auto& markers = out_.seen_.names();
    const auto at = std::find(markers.begin(), markers.end(), name);
    if (at == markers.end()) {
      absent_.insert(name);
      return one;
    }
    one.marker = static_cast<std::size_t>(at - markers.begin());
    found_any_ = true;
    return one;
  }
  Mean mean(const RigPoint& point) {
    Mean all;
    for (const std::string& name : point) all.push_back(named(name));
    return all;
  }
  Axis axis(const RigAxis& axis) {
    return {axis.axis, axis.negative, mean(axis.from), mean(axis.to)};
  }

  void add(const ClusterFrame& frame) {
    out_.frames_.push_back(
        Cluster{RigidBody(frame.template_m, frame.max_residual_m.value_or(rig_.max_residual_m)),
                mean(frame.markers)});
  }
  void add(const PointsFrame& frame) {
    std::set<std::string> names;
    for (const RigPoint* point : {&frame.origin, &frame.primary.from, &frame.primary.to,
                                  &frame.secondary.from, &frame.secondary.to})
      names.insert(point->begin(), point->end());
    out_.frames_.push_back(Points{mean(frame.origin), axis(frame.primary), axis(frame.secondary),
                                  mean({names.begin(), names.end()})});
  }
  void add(const PointFrame& frame) {
    out_.frames_.push_back(Point{mean(frame.origin), *rig_.frame(frame.orientation)});
  }

  const Rig& rig_;
  ArmFrames out_;
  std::set<std::string> absent_;
  bool found_any_ = false;
};

/// One row; the frames before are solved already.
struct ArmFrames::Solver {
  std::span<const Vec3> p_W;
  std::span<const FramePose> before;

  [[nodiscard]] Vec3 position(const Named& one) const noexcept {
    if (one.marker) return p_W[*one.marker];
    if (!one.frame) return Vec3::Constant(kMissing);
    const Pose& X_WF = before[*one.frame].X_W;
    return X_WF.p + X_WF.q * one.p_F;
  }
  [[nodiscard]] Vec3 position(const Mean& mean) const noexcept {
    Vec3 sum = Vec3::Zero();
    for (const Named& one : mean) sum += position(one);
    return sum / static_cast<double>(mean.size());
  }
  [[nodiscard]] Vec3 direction(const Axis& axis) const noexcept {
    const Vec3 along = position(axis.to) - position(axis.from);
    return axis.negative ? Vec3(-along) : along;
  }

  FramePose operator()(const Cluster& cluster) const noexcept {
    std::array<Vec3, RigidBody::kMostMarkers> seen;
    for (std::size_t k = 0; k < cluster.markers.size(); ++k) seen[k] = position(cluster.markers[k]);
    const BodyFit fit = cluster.body.fit(std::span(seen).first(cluster.markers.size()));
    return {fit.state, fit.used, fit.rejected, fit.residual_m, fit.X_WB};
  }
  FramePose operator()(const Points& points) const noexcept {
    FramePose pose;
    for (const Named& one : points.distinct) pose.used += is_missing(position(one)) ? 0 : 1;
    if (pose.used < static_cast<int>(points.distinct.size())) return pose;
    const auto q = attitude_from_axes(direction(points.primary), points.primary.axis,
                                      direction(points.secondary), points.secondary.axis);
    pose.state = q ? FrameState::ok : FrameState::collinear;
    if (!q) return pose;
    pose.residual_m = 0.0;
    pose.X_W = {position(points.origin), *q};
    return pose;
  }
  FramePose operator()(const Point& point) const noexcept {
    FramePose pose;
    const Vec3 origin = position(point.origin);
    const FramePose& other = before[point.orientation];
    if (is_missing(origin) || !has_pose(other.state)) return pose;
    pose.state = FrameState::ok;
    pose.used = 1;
    pose.residual_m = 0.0;
    pose.X_W = {origin, other.X_W.q};
    return pose;
  }
};

Result<ArmFrames> ArmFrames::compile(const Rig& rig, std::span<const std::string> markers) {
  auto seen = SeenMarkers::compile(rig, markers);
  if (!seen) return seen.error();
  Compiler compiler(rig, *std::move(seen));
  ArmFrames frames = compiler.compile();
  if (!compiler.found_any())
    return refused("has none of the markers that the rig '%1' names"_text(rig.name),
                   "give the rig of this recording"_text);
  return frames;
}

void ArmFrames::solve(std::span<const Vec3> p_W, std::span<FramePose> frames) noexcept {
  const std::span<const Vec3> seen_W = seen_.see(p_W);
  for (std::size_t f = 0; f < frames_.size(); ++f) {
    frames[f] = std::visit(Solver{seen_W, frames.first(f)}, frames_[f]);
    if (!has_pose(frames[f].state)) continue;
    frames[f].X_W.q = continued(frames[f].X_W.q, last_[f]);
    last_[f] = frames[f].X_W.q;
  }
}

}  // namespace isograsp
