// SPDX-License-Identifier: GPL-3.0-or-later
// x: r_angle of the forearm, y: that of the link to the object, in the rows that both have:
//   slope = Sxy / Sxx,   R^2 = Sxy^2 / (Sxx Syy),   Sxy = sum (x - mean x) (y - mean y)
// margin = min over the own ranges of a link of (angle - min, max - angle); below 0: beyond it
#include "kinematics/measures/coupling.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp {

namespace {

constexpr std::size_t kLeastRows = 3;  // through two points every line fits

/// The values of two curves where both have a row.
struct CommonRows {
  std::vector<double> x;
  std::vector<double> y;
};
CommonRows common_rows(const LinkMovement& a, const LinkMovement& b) {
  CommonRows rows;
  for (std::size_t i = 0, j = 0; i < a.t_s.size() && j < b.t_s.size();) {
    if (a.t_s[i] == b.t_s[j]) {
      rows.x.push_back(a.angle[i++]);
      rows.y.push_back(b.angle[j++]);
    } else if (a.t_s[i] < b.t_s[j]) {
      ++i;
    } else {
      ++j;
    }
  }
  return rows;
}

void measure_line(MovementCoupling& coupling, const CommonRows& rows) {
  if (rows.x.size() < kLeastRows) {
    coupling.slope = coupling.r_squared = no_value("fewer than three samples"_text);
    return;
  }
  const auto count = static_cast<double>(rows.x.size());
  double mean_x = 0.0, mean_y = 0.0;
  for (std::size_t k = 0; k < rows.x.size(); ++k) {
    mean_x += rows.x[k] / count;
    mean_y += rows.y[k] / count;
  }
  double sxx = 0.0, sxy = 0.0, syy = 0.0;
  for (std::size_t k = 0; k < rows.x.size(); ++k) {
    const double dx = rows.x[k] - mean_x;
    const double dy = rows.y[k] - mean_y;
    sxx += dx * dx;
    sxy += dx * dy;
    syy += dy * dy;
  }
  // Both go from 0 to 1, so neither is constant.
  coupling.slope.value = sxy / sxx;
  coupling.r_squared.value = sxy * sxy / (sxx * syy);
}

/// Why there is no r_angle of a link; empty: there is one.
Text without_share(const LinkMovement& link) {
  return link.angle.empty() ? link.t10.reason : Text();
}

void measure_pair(MovementCoupling& coupling, const LinkMovement& forearm,
                  const LinkMovement& hand) {
  Text objection = without_share(forearm);
  if (objection.empty()) objection = without_share(hand);
  if (!objection.empty())
    coupling.slope = coupling.r_squared = no_value(objection);
  else
    measure_line(coupling, common_rows(forearm, hand));
  if (!forearm.t10.value || !hand.t10.value)
    coupling.lead = no_value(forearm.t10.value ? hand.t10.reason : forearm.t10.reason);
  else
    coupling.lead.value = *forearm.t10.value - *hand.t10.value;
}

/// To the nearest limit of a link in the first row of a movement.
Valued margin_of(std::span<const double> t_s, std::span<const Pose> X_L, const RigLink& link,
                 std::span<const OwnRange> ranges, const PoseTarget& target) {
  const MovementRows valid = movement_rows(
      t_s, [&X_L](std::size_t row) { return !is_missing(X_L[row]); }, target);
  if (!valid.reason.empty()) return no_value(valid.reason);
  const Vec3 angles = link_angles(X_L[valid.rows.front()].q, link);
  Valued margin = no_value("own range not measured"_text);
  for (const OwnRange& range : ranges) {
    if (range.link != link.name) continue;
    const double own =
        std::min(angles[range.angle] - range.min_rad, range.max_rad - angles[range.angle]);
    margin = {std::min(own, margin.value.value_or(own)), {}};
  }
  return margin;
}

void measure_times(MovementCoupling& coupling, const LinkMovement& object,
                   const PoseTarget& target) {
  coupling.recognition_time = coupling.movement_time = object.t10;
  if (object.t10.value)
    coupling.movement_time.value = *target.matched_s - target.cue_s - *object.t10.value;
}

}  // namespace

std::optional<std::size_t> link_to_object(const Rig& rig) {
  for (std::size_t l = 0; l < rig.links.size(); ++l)
    if (rig.links[l].child == rig.score->object && rig.links[l].parent != kWorld) return l;
  return std::nullopt;
}

Result<std::vector<MovementCoupling>> movement_coupling(const Rig& rig, const PoseSeries& series,
                                                        const MovementScores& scores,
                                                        std::span<const OwnRange> ranges) {
  for (const OwnRange& range : ranges)
    if (!rig.link(range.link))
      return refused("'%1' is no link"_text(range.link), "name a link of the rig"_text);
  const std::size_t forearm = *rig.link(rig.score->forearm);
  const std::size_t sync = *rig.link(rig.score->sync);
  const auto hand = link_to_object(rig);
  std::vector<MovementCoupling> all(scores.targets.size());
  for (std::size_t m = 0; m < all.size(); ++m) {
    const auto& links = scores.links[m];
    if (hand)
      measure_pair(all[m], links[forearm], links[*hand]);
    else
      all[m].slope = all[m].r_squared = all[m].lead = no_value("no link from hand to object"_text);
    measure_times(all[m], links[sync], scores.targets[m]);
  }
  for (const RigLink& link : rig.links) {
    const auto poses = link_poses(series, link.parent, link.child);
    if (!poses) return poses.error();
    for (std::size_t m = 0; m < all.size(); ++m)
      all[m].range_margin.push_back(margin_of(series.t_s, *poses, link, ranges, scores.targets[m]));
  }
  return all;
}

std::vector<MovementMeasure> coupling_measures(const Rig& rig,
                                               std::span<const MovementCoupling> movements) {
  const auto hand = link_to_object(rig);
  const std::string channel = hand ? rig.links[*hand].name : "object";
  std::vector<MovementMeasure> measures;
  for (std::size_t m = 0; m < movements.size(); ++m) {
    const MovementCoupling& of = movements[m];
    const auto add = [&](const char* name, const std::string& of_channel, const Valued& value,
                         const char* unit) {
      measures.push_back(movement_measure(m, name, of_channel, value, unit));
    };
    add("coupling_slope", channel, of.slope, "");
    add("coupling_r_squared", channel, of.r_squared, "");
    add("lead", channel, of.lead, "s");
    for (std::size_t l = 0; l < of.range_margin.size(); ++l)
      add("range_margin", rig.links[l].name, of.range_margin[l], "rad");
    add("recognition_time", "task", of.recognition_time, "s");
    add("movement_time", "task", of.movement_time, "s");
  }
  return measures;
}

}  // namespace isograsp
