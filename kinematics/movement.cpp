// SPDX-License-Identifier: GPL-3.0-or-later
// R(t) attitude of a link, 0 the first and T the last valid row of the movement:
//   phi(t) = log(R_0^T R_t),   theta = |phi|
//   r_angle = theta(t) / theta(T),   r_axis = phi(t) . phi(T) / theta(T)^2
//   n = |(roll, pitch, yaw)| of R R_zero^-1, roll and yaw unwrapped from row to row
//   r_rpy = (n(t) - n(0)) / (n(T) - n(0))     (Kurillo et al., eq. 6)
//   t10, t63: first k with r_k < L <= r_k+1, linear in between; L = 0.1, 1 - 1/e; minus the cue
//   share of a link = its r where the forearm passes 63 %
// Below 5 degrees a movement has no r: 0.5 degrees of noise are then a tenth of it.
#include "kinematics/movement.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace isograsp {

namespace {

constexpr double kLeastRotation_rad = 5.0 * std::numbers::pi / 180.0;
constexpr double kLeastPitchCosine = 0.0175;  // nearer to +-90 degrees roll and yaw are not known
constexpr double kLongestGap_s = 0.1;
constexpr double kTenth = 0.1;
constexpr double k63 = 1.0 - 1.0 / std::numbers::e;

/// Why the rows cannot be measured; empty: they can.
Text objection_to(std::span<const double> t_s, const std::vector<std::size_t>& rows,
                  const PoseTarget& target) {
  if (rows.empty() || t_s[rows.front()] - target.cue_s > kLongestStandIn_s + kMarkerTimeSlack_s)
    return "no valid sample at the cue"_text;
  if (*target.matched_s - t_s[rows.back()] > kLongestStandIn_s + kMarkerTimeSlack_s)
    return "no valid sample at the match"_text;
  for (std::size_t k = 1; k < rows.size(); ++k)
    if (t_s[rows[k]] - t_s[rows[k - 1]] > kLongestGap_s + kMarkerTimeSlack_s) return "gap"_text;
  return {};
}

Valued crossing(std::span<const double> t_s, const std::vector<double>& curve, double level,
                double cue_s) {
  for (std::size_t k = 0; k + 1 < curve.size(); ++k)
    if (curve[k] < level && level <= curve[k + 1])
      return {
          t_s[k] + (t_s[k + 1] - t_s[k]) * (level - curve[k]) / (curve[k + 1] - curve[k]) - cue_s,
          {}};
  return no_value("not crossed"_text);
}

/// |(roll, pitch, yaw)| of each row; empty: pitch comes too near to 90 degrees.
std::vector<double> angle_norms(const std::vector<Quat>& attitudes, const RigLink& link) {
  std::vector<double> norms;
  Vec3 last = Vec3::Zero();
  for (const Quat& q : attitudes) {
    Vec3 angles = angles_of(from_zero(q, link.zero), AngleSequence::rpy);
    if (std::cos(angles.y()) < kLeastPitchCosine) return {};
    if (!norms.empty()) {
      angles.x() = unwrapped(angles.x(), last.x());
      angles.z() = unwrapped(angles.z(), last.z());
    }
    norms.push_back(angles.norm());
    last = angles;
  }
  return norms;
}

void measure_angle(LinkMovement& movement, const std::vector<Quat>& q, double cue_s) {
  std::vector<Vec3> phi;
  for (const Quat& at : q) phi.push_back(rotation_vector(q.front().conjugate() * at));
  const Vec3 whole = phi.back();
  const double theta = whole.norm();
  movement.rotation.value = theta;
  if (theta < kLeastRotation_rad) {
    movement.t10 = movement.t63 = no_value("too little rotation"_text);
    return;
  }
  for (const Vec3& part : phi) {
    movement.angle.push_back(part.norm() / theta);
    movement.axis.push_back(part.dot(whole) / (theta * theta));
  }
  movement.t10 = crossing(movement.t_s, movement.angle, kTenth, cue_s);
  movement.t63 = crossing(movement.t_s, movement.angle, k63, cue_s);
}

void measure_rpy(LinkMovement& movement, const std::vector<Quat>& q, const RigLink& link,
                 double cue_s) {
  const auto norms = angle_norms(q, link);
  if (norms.empty()) {
    movement.rotation_rpy = movement.t10_rpy = movement.t63_rpy = no_value("gimbal lock"_text);
    return;
  }
  const double change = norms.back() - norms.front();
  movement.rotation_rpy.value = change;
  if (std::abs(change) < kLeastRotation_rad) {
    movement.t10_rpy = movement.t63_rpy = no_value("too little rotation"_text);
    return;
  }
  for (const double n : norms) movement.rpy.push_back((n - norms.front()) / change);
  movement.t10_rpy = crossing(movement.t_s, movement.rpy, kTenth, cue_s);
  movement.t63_rpy = crossing(movement.t_s, movement.rpy, k63, cue_s);
}

/// Of a link, its curve where the forearm passes 63 %.
Valued share(const LinkMovement& link, const std::vector<double>& curve, const Valued& undefined,
             const Valued& forearm_t63, double cue_s) {
  if (!forearm_t63.value) return no_value(forearm_t63.reason);
  if (curve.empty()) return no_value(undefined.reason);
  return {curve_at(link.t_s, curve, cue_s + *forearm_t63.value), {}};
}

}  // namespace

MovementRows movement_rows(std::span<const double> t_s,
                           const std::function<bool(std::size_t)>& valid,
                           const PoseTarget& target) {
  MovementRows all;
  if (!target.matched_s) {
    all.reason = "not reached"_text;
    return all;
  }
  const auto first = std::lower_bound(t_s.begin(), t_s.end(), target.cue_s - kMarkerTimeSlack_s);
  for (auto k = static_cast<std::size_t>(first - t_s.begin());
       k < t_s.size() && t_s[k] <= *target.matched_s + kMarkerTimeSlack_s; ++k)
    if (valid(k)) all.rows.push_back(k);
  all.reason = objection_to(t_s, all.rows, target);
  return all;
}

LinkMovement measure_link(std::span<const double> t_s, std::span<const Pose> X_L,
                          const RigLink& link, const PoseTarget& target) {
  LinkMovement movement;
  const MovementRows valid = movement_rows(
      t_s, [&X_L](std::size_t row) { return !is_missing(X_L[row]); }, target);
  movement.reason = valid.reason;
  if (!movement.reason.empty()) {
    for (Valued* value : {&movement.rotation, &movement.rotation_rpy, &movement.t10, &movement.t63,
                          &movement.t10_rpy, &movement.t63_rpy})
      *value = no_value(movement.reason);
    return movement;
  }
  std::vector<Quat> q;
  for (const std::size_t row : valid.rows) {
    movement.t_s.push_back(t_s[row]);
    q.push_back(X_L[row].q);
  }
  measure_angle(movement, q, target.cue_s);
  measure_rpy(movement, q, link, target.cue_s);
  return movement;
}

double curve_at(std::span<const double> t_s, std::span<const double> curve,
                double when_s) noexcept {
  const auto above = std::upper_bound(t_s.begin(), t_s.end(), when_s);
  if (above == t_s.begin()) return curve.front();
  if (above == t_s.end()) return curve.back();
  const auto k = static_cast<std::size_t>(above - t_s.begin());
  return curve[k - 1] + (curve[k] - curve[k - 1]) * (when_s - t_s[k - 1]) / (t_s[k] - t_s[k - 1]);
}

Result<RigScore> score_of(const Rig& rig) {
  if (!rig.score)
    return refused("does not say what is scored"_text,
                   "add [score] with forearm, sync and object"_text)
        .about("score");
  return *rig.score;
}

Result<MovementScores> score_movements(const Rig& rig, const PoseSeries& series,
                                       std::vector<PoseTarget> targets) {
  if (const auto score = score_of(rig); !score) return score.error();
  MovementScores scores;
  scores.links.resize(targets.size());
  for (const RigLink& link : rig.links) {
    const auto poses = link_poses(series, link.parent, link.child);
    if (!poses) return poses.error();
    for (std::size_t m = 0; m < targets.size(); ++m)
      scores.links[m].push_back(measure_link(series.t_s, *poses, link, targets[m]));
  }
  scores.targets = std::move(targets);
  return scores;
}

MovementMeasure movement_measure(std::size_t movement, std::string name, std::string channel,
                                 const Valued& valued, std::string unit) {
  Measure measure;
  measure.name = std::move(name);
  measure.channel = std::move(channel);
  measure.value = valued.value;
  measure.unit = std::move(unit);
  measure.reason = english(valued.reason);
  return {movement, std::move(measure)};
}

std::vector<MovementMeasure> movement_measures(const Rig& rig, const MovementScores& scores) {
  std::vector<MovementMeasure> measures;
  for (std::size_t m = 0; m < scores.targets.size(); ++m) {
    const PoseTarget& target = scores.targets[m];
    const auto add = [&measures, m](const char* name, const std::string& channel,
                                    const Valued& valued, const char* unit) {
      measures.push_back(movement_measure(m, name, channel, valued, unit));
    };
    add("duration", "task",
        target.matched_s ? Valued{*target.matched_s - target.cue_s, {}}
                         : no_value("not reached"_text),
        "s");
    const LinkMovement& forearm = scores.links[m][*rig.link(rig.score->forearm)];
    for (std::size_t l = 0; l < rig.links.size(); ++l) {
      const LinkMovement& link = scores.links[m][l];
      const std::string& name = rig.links[l].name;
      add("rotation", name, link.rotation, "rad");
      add("rotation_rpy", name, link.rotation_rpy, "rad");
      add("t10", name, link.t10, "s");
      add("t63", name, link.t63, "s");
      add("t10_rpy", name, link.t10_rpy, "s");
      add("t63_rpy", name, link.t63_rpy, "s");
      add("share_angle", name, share(link, link.angle, link.t63, forearm.t63, target.cue_s), "");
      add("share_rpy", name, share(link, link.rpy, link.t63_rpy, forearm.t63_rpy, target.cue_s),
          "");
      add("share_axis", name, share(link, link.axis, link.t63, forearm.t63, target.cue_s), "");
    }
  }
  return measures;
}

}  // namespace isograsp
