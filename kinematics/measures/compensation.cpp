// SPDX-License-Identifier: GPL-3.0-or-later
// p_BE = R_WB^T (p_WE - p_WB);  path = sum |p_BE(k) - p_BE(k - 1)|,  displacement = max |p(k) -
// p(0)| lean = max angle between R(k) R(0)^T u and u, u up;  rotation = max |log(R(0)^T R(k))|
#include "kinematics/measures/compensation.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "kinematics/measures/zero_phase.hpp"

namespace isograsp {

namespace {

/// A frame over the record, filtered; or why it is not known.
struct BodyPart {
  Text reason;
  std::vector<Pose> X;
};

Result<BodyPart> body_part(const PoseSeries& series, const std::string& parent,
                           const std::optional<std::string>& frame, const Text& if_unnamed) {
  if (!frame) return BodyPart{if_unnamed, {}};
  const auto poses = link_poses(series, parent, *frame);
  if (!poses) return poses.error();
  return BodyPart{objection_to_rate(series.t_s), zero_phase(series.t_s, std::span(*poses))};
}

/// The largest of what `distance` says of two poses, `from` and each row.
template <class Distance>
double largest_from(const BodyPart& part, const std::vector<std::size_t>& rows, const Pose& from,
                    const Distance& distance) {
  double largest = 0.0;
  for (const std::size_t row : rows) largest = std::max(largest, distance(from, part.X[row]));
  return largest;
}

double moved_by(const Pose& from, const Pose& to) {
  return (to.p - from.p).norm();
}
double turned_by(const Pose& from, const Pose& to) {
  return angle_between(from.q, to.q);
}

/// The rows of a movement in which a part has a pose, or why it has none.
MovementRows rows_of(const BodyPart& part, std::span<const double> t_s, const PoseTarget& target) {
  if (!part.reason.empty()) return {{}, part.reason};
  return movement_rows(
      t_s, [&part](std::size_t row) { return !is_missing(part.X[row]); }, target);
}

/// The camera axis that points up, as a direction.
Vec3 up_axis(const Rig& rig) {
  const std::string up = rig.view.value_or(RigView()).up;
  Vec3 axis = Vec3::Zero();
  axis[up.back() - 'x'] = up.front() == '-' ? -1.0 : 1.0;
  return axis;
}

class Compensations {
 public:
  Compensations(const Rig& rig, std::span<const double> t_s, BodyPart elbow, BodyPart trunk,
                BodyPart brace)
      : t_s_(t_s), elbow_(std::move(elbow)), trunk_(std::move(trunk)), brace_(std::move(brace)) {
    const RigScore& score = *rig.score;
    up_W_ = up_axis(rig);
    trunk_has_attitude_ = score.trunk && !std::holds_alternative<PointFrame>(
                                             rig.frames[*rig.frame(*score.trunk)].method);
    const auto seen = std::find_if(brace_.X.begin(), brace_.X.end(),
                                   [](const Pose& pose) { return !is_missing(pose); });
    if (seen != brace_.X.end()) first_brace_ = *seen;
    trunk_named_ = score.trunk.has_value();
  }

  [[nodiscard]] MovementCompensation of(const PoseTarget& target) const {
    MovementCompensation all;
    measure_elbow(all, target);
    measure_trunk(all, target);
    measure_brace(all, target);
    return all;
  }

 private:
  void measure_elbow(MovementCompensation& all, const PoseTarget& target) const {
    const MovementRows valid = rows_of(elbow_, t_s_, target);
    if (!valid.reason.empty()) {
      all.elbow_path = all.elbow_displacement = no_value(valid.reason);
      return;
    }
    double path_m = 0.0;
    for (std::size_t k = 1; k < valid.rows.size(); ++k)
      path_m += moved_by(elbow_.X[valid.rows[k - 1]], elbow_.X[valid.rows[k]]);
    all.elbow_path.value = path_m;
    all.elbow_displacement.value =
        largest_from(elbow_, valid.rows, elbow_.X[valid.rows.front()], moved_by);
    if (*all.elbow_displacement.value > kUpperArmMoved_m)
      all.notes.push_back("upper arm moved"_text);
  }

  void measure_trunk(MovementCompensation& all, const PoseTarget& target) const {
    const MovementRows valid = rows_of(trunk_, t_s_, target);
    if (!trunk_named_) all.notes.push_back("trunk not measured"_text);
    if (!valid.reason.empty()) {
      all.trunk_displacement = all.trunk_lean = all.trunk_rotation = no_value(valid.reason);
      return;
    }
    const Pose& first = trunk_.X[valid.rows.front()];
    all.trunk_displacement.value = largest_from(trunk_, valid.rows, first, moved_by);
    if (!trunk_has_attitude_) {
      all.trunk_lean = all.trunk_rotation = no_value("one marker shows no attitude"_text);
      return;
    }
    all.trunk_rotation.value = largest_from(trunk_, valid.rows, first, turned_by);
    all.trunk_lean.value =
        largest_from(trunk_, valid.rows, first, [this](const Pose& from, const Pose& to) {
          const Vec3 leaning = to.q * (from.q.conjugate() * up_W_);
          return std::atan2(leaning.cross(up_W_).norm(), leaning.dot(up_W_));
        });
  }

  void measure_brace(MovementCompensation& all, const PoseTarget& target) const {
    const MovementRows valid = rows_of(brace_, t_s_, target);
    if (!valid.reason.empty()) {
      all.brace_displacement = all.brace_rotation = no_value(valid.reason);
      return;
    }
    all.brace_displacement.value = largest_from(brace_, valid.rows, first_brace_, moved_by);
    all.brace_rotation.value = largest_from(brace_, valid.rows, first_brace_, turned_by);
    if (*all.brace_displacement.value > kDeviceMoved_m ||
        *all.brace_rotation.value > kDeviceMoved_rad)
      all.notes.push_back("device moved"_text);
  }

  std::span<const double> t_s_;
  BodyPart elbow_;
  BodyPart trunk_;
  BodyPart brace_;
  Vec3 up_W_ = Vec3::Zero();
  bool trunk_named_ = false;
  bool trunk_has_attitude_ = false;
  Pose first_brace_ = missing_pose();
};

}  // namespace

Result<std::vector<MovementCompensation>> movement_compensation(
    const Rig& rig, const PoseSeries& series, std::span<const PoseTarget> targets) {
  const auto score = score_of(rig);
  if (!score) return score.error();
  auto elbow = body_part(series, score->brace.value_or(std::string(kWorld)), score->elbow,
                         "elbow not measured"_text);
  if (!elbow) return elbow.error();
  auto trunk = body_part(series, std::string(kWorld), score->trunk, "trunk not measured"_text);
  if (!trunk) return trunk.error();
  auto brace = body_part(series, std::string(kWorld), score->brace, "brace not measured"_text);
  if (!brace) return brace.error();
  const Compensations compensations(rig, series.t_s, *std::move(elbow), *std::move(trunk),
                                    *std::move(brace));
  std::vector<MovementCompensation> all;
  for (const PoseTarget& target : targets) all.push_back(compensations.of(target));
  return all;
}

std::vector<MovementMeasure> compensation_measures(
    std::span<const MovementCompensation> movements) {
  std::vector<MovementMeasure> measures;
  for (std::size_t m = 0; m < movements.size(); ++m) {
    const MovementCompensation& of = movements[m];
    const auto add = [&](const char* name, const char* channel, const Valued& value,
                         const char* unit) {
      measures.push_back(movement_measure(m, name, channel, value, unit));
    };
    add("elbow_path", "elbow", of.elbow_path, "m");
    add("elbow_displacement", "elbow", of.elbow_displacement, "m");
    add("trunk_displacement", "trunk", of.trunk_displacement, "m");
    add("trunk_lean", "trunk", of.trunk_lean, "rad");
    add("trunk_rotation", "trunk", of.trunk_rotation, "rad");
    add("brace_displacement", "brace", of.brace_displacement, "m");
    add("brace_rotation", "brace", of.brace_rotation, "rad");
  }
  return measures;
}

}  // namespace isograsp
