// SPDX-License-Identifier: GPL-3.0-or-later
// Template: q_k = mean X_WF^-1 x_k, F the frame of the recipe. Landmark: p_FL = mean X_WF^-1 p_tip.
#include "kinematics/calibration.hpp"

#include <cmath>
#include <utility>

#include "kinematics/arm_frames.hpp"

namespace isograsp {

namespace {

/// The frames before the one at `index`, then its recipe as a frame of points.
Rig with_recipe(const Rig& rig, std::size_t index, const PointsFrame& recipe) {
  Rig partial = rig;
  partial.frames.resize(index);
  partial.frames.push_back({rig.frames[index].name, recipe});
  return partial;
}

Result<std::vector<Vec3>> measured_template(const Rig& rig, std::size_t index,
                                            const MarkerRows& rows) {
  const auto& cluster = std::get<ClusterFrame>(rig.frames[index].method);
  const auto poses = poses_of(with_recipe(rig, index, *cluster.calibration), rows, Hand::right);
  if (!poses) return poses.error();
  const auto names = aliased(rig, rows.markers);
  if (!names) return names.error();
  std::vector<std::size_t> columns;
  for (const std::string& marker : cluster.markers)
    for (std::size_t c = 0; c < names->size(); ++c)
      if ((*names)[c] == marker) columns.push_back(c);
  std::vector<Vec3> sums(columns.size(), Vec3::Zero());
  int count = 0;
  for (std::size_t row = 0; row < rows.p_W.size(); ++row) {
    const Pose& X_WF = (*poses)[index][row];
    bool complete = !is_missing(X_WF) && columns.size() == cluster.markers.size();
    for (const std::size_t c : columns) complete = complete && !is_missing(rows.p_W[row][c]);
    if (!complete) continue;
    ++count;
    const Pose X_FW = inverse(X_WF);
    for (std::size_t k = 0; k < columns.size(); ++k)
      sums[k] += X_FW.p + X_FW.q * rows.p_W[row][columns[k]];
  }
  if (count == 0)
    return refused(
        "no row shows all markers of frame '%1' and of its recipe"_text(rig.frames[index].name),
        "record again with all of them in view"_text);
  for (Vec3& sum : sums) sum /= count;
  return sums;
}

}  // namespace

Result<std::vector<std::vector<Pose>>> poses_of(const Rig& rig, const MarkerRows& rows, Hand hand) {
  const bool left = hand == Hand::left;
  auto frames = ArmFrames::compile(left ? mirrored(rig) : rig, rows.markers);
  if (!frames) return frames.error();
  std::vector<std::vector<Pose>> poses(frames->frames());
  std::vector<FramePose> solved(frames->frames());
  for (std::vector<Vec3> p_W : rows.p_W) {
    if (left)
      for (Vec3& p : p_W) p = mirrored(p);
    frames->solve(p_W, solved);
    for (std::size_t f = 0; f < solved.size(); ++f) poses[f].push_back(solved[f].X_W);
  }
  return poses;
}

Result<Rig> calibrated(const Rig& rig, const MarkerRows& still, Hand hand) {
  Rig result = rig;
  for (std::size_t f = 0; f < result.frames.size(); ++f) {
    auto* cluster = std::get_if<ClusterFrame>(&result.frames[f].method);
    if (cluster == nullptr || !cluster->calibration) continue;
    auto measured = measured_template(result, f, still);
    if (!measured) return measured.error();
    cluster->template_m = std::move(*measured);
  }
  const auto poses = poses_of(result, still, hand);
  if (!poses) return poses.error();
  for (RigLink& link : result.links) {
    if (!link.zero) continue;
    const auto parent = result.frame(link.parent);
    const std::size_t child = *result.frame(link.child);
    MeanAttitude mean;
    int count = 0;
    for (std::size_t row = 0; row < still.p_W.size(); ++row) {
      const Pose& X_WC = (*poses)[child][row];
      const Pose X_WP = parent ? (*poses)[*parent][row] : Pose();
      if (is_missing(X_WC) || is_missing(X_WP)) continue;
      mean.add(X_WP.q.conjugate() * X_WC.q);
      ++count;
    }
    if (count == 0)
      return refused("no row shows link '%1'"_text(link.name),
                     "record again with its markers in view"_text);
    link.zero = mean.mean();
  }
  return result;
}

Result<MeasuredLandmark> measure_landmark(const Rig& rig, const MarkerRows& rows,
                                          const std::string& probe, const std::string& frame) {
  for (const auto& [option, name] : {std::pair("--probe", probe), {"--frame", frame}})
    if (!rig.frame(name))
      return refused("'%1' is no frame of the rig"_text(name), "name one of its frames"_text)
          .about(option);
  const auto poses = poses_of(rig, rows, Hand::right);
  if (!poses) return poses.error();
  const auto& tip = (*poses)[*rig.frame(probe)];
  const auto& base = (*poses)[*rig.frame(frame)];
  std::vector<Vec3> seen;
  for (std::size_t row = 0; row < tip.size(); ++row) {
    if (is_missing(tip[row]) || is_missing(base[row])) continue;
    const Pose X_FW = inverse(base[row]);
    seen.push_back(X_FW.p + X_FW.q * tip[row].p);
  }
  if (seen.size() < 2)
    return refused("%1 rows show '%2' and '%3' together"_text(seen.size(), probe, frame),
                   "hold the pointer where the cameras see both"_text);
  MeasuredLandmark landmark;
  landmark.rows = seen.size();
  const auto n = static_cast<double>(seen.size());
  for (const Vec3& p : seen) landmark.position_m += p / n;
  for (const Vec3& p : seen) landmark.sd_m += (p - landmark.position_m).cwiseAbs2() / (n - 1.0);
  landmark.sd_m = landmark.sd_m.cwiseSqrt();
  return landmark;
}

}  // namespace isograsp
