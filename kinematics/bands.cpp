// SPDX-License-Identifier: GPL-3.0-or-later
// tau = (t - t10) / (matched - cue), t10 that of the sync link;  tau = k / 50, k = -25 .. 50
// X_RO = X_WR^-1 X_WO, its angles unwrapped, all six minus their values at the first row
#include "kinematics/bands.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace isograsp {

namespace {

constexpr int kFirstStep = -25;
constexpr int kLastStep = 50;
constexpr double kStepsInOne = 50.0;
constexpr std::array<const char*, 6> kPoseChannels{"x_m",      "y_m",       "z_m",
                                                   "roll_rad", "pitch_rad", "yaw_rad"};

/// One channel of one movement.
struct Curve {
  double t10_s = 0.0;  ///< on the clock of the record
  double length_s = 0.0;
  std::vector<double> t_s;
  std::vector<double> values;
};

/// The object in its reference over the rows of a movement, six curves.
std::array<std::vector<double>, 6> object_curves(std::span<const double> t_s,
                                                 std::span<const Pose> X_WO,
                                                 const PoseTarget& target,
                                                 std::vector<double>& rows_s) {
  std::array<std::vector<double>, 6> curves;
  Vec6 first = Vec6::Zero();
  Vec6 last = Vec6::Zero();
  for (std::size_t k = 0; k < t_s.size(); ++k) {
    if (t_s[k] < target.cue_s - kMarkerTimeSlack_s ||
        t_s[k] > *target.matched_s + kMarkerTimeSlack_s || is_missing(X_WO[k]))
      continue;
    const Pose X_RO = compose(inverse(target.X_WR), X_WO[k]);
    Vec6 now;
    now << X_RO.p, angles_of(X_RO.q, AngleSequence::rpy);
    if (rows_s.empty())
      first = now;
    else
      for (Eigen::Index a = 3; a < 6; ++a) now[a] = unwrapped(now[a], last[a]);
    rows_s.push_back(t_s[k]);
    for (std::size_t c = 0; c < curves.size(); ++c)
      curves[c].push_back(now[static_cast<Eigen::Index>(c)] - first[static_cast<Eigen::Index>(c)]);
    last = now;
  }
  return curves;
}

void add_band(std::vector<BandPoint>& band, const std::string& posture, const std::string& channel,
              const std::vector<Curve>& curves) {
  for (int step = kFirstStep; step <= kLastStep; ++step) {
    BandPoint point{posture, channel, step / kStepsInOne, 0, 0.0, std::nullopt};
    std::vector<double> values;
    for (const Curve& curve : curves) {
      const double when_s = curve.t10_s + point.tau * curve.length_s;
      if (when_s < curve.t_s.front() - kMarkerTimeSlack_s ||
          when_s > curve.t_s.back() + kMarkerTimeSlack_s)
        continue;
      values.push_back(curve_at(curve.t_s, curve.values, when_s));
    }
    if (values.empty()) continue;
    point.n = static_cast<int>(values.size());
    for (const double value : values) point.mean += value / point.n;
    if (point.n > 1) {
      double squares = 0.0;
      for (const double value : values) squares += (value - point.mean) * (value - point.mean);
      point.sd = std::sqrt(squares / (point.n - 1));
    }
    band.push_back(std::move(point));
  }
}

}  // namespace

Result<std::vector<BandPoint>> movement_bands(const Rig& rig, const PoseSeries& series,
                                              const MovementScores& scores) {
  const auto object = frame_of(series, rig.score->object);
  if (!object) return object.error();
  const std::size_t sync = *rig.link(rig.score->sync);
  std::vector<std::string> postures;
  for (const PoseTarget& target : scores.targets)
    if (std::find(postures.begin(), postures.end(), target.posture) == postures.end())
      postures.push_back(target.posture);
  std::vector<BandPoint> band;
  for (const std::string& posture : postures) {
    std::array<std::vector<Curve>, 6> of_object;
    std::vector<std::vector<Curve>> of_links(rig.links.size());
    for (std::size_t m = 0; m < scores.targets.size(); ++m) {
      const PoseTarget& target = scores.targets[m];
      const Valued& t10 = scores.links[m][sync].t10;
      if (target.posture != posture || !t10.value) continue;
      Curve curve;
      curve.t10_s = target.cue_s + *t10.value;
      curve.length_s = *target.matched_s - target.cue_s;
      auto curves = object_curves(series.t_s, series.X_W[*object], target, curve.t_s);
      if (!curve.t_s.empty())
        for (std::size_t c = 0; c < curves.size(); ++c) {
          curve.values = std::move(curves[c]);
          of_object[c].push_back(curve);
        }
      for (std::size_t l = 0; l < rig.links.size(); ++l) {
        const LinkMovement& link = scores.links[m][l];
        if (link.angle.empty()) continue;
        curve.t_s = link.t_s;
        curve.values = link.angle;
        of_links[l].push_back(curve);
      }
    }
    for (std::size_t c = 0; c < of_object.size(); ++c)
      add_band(band, posture, kPoseChannels[c], of_object[c]);
    for (std::size_t l = 0; l < rig.links.size(); ++l)
      add_band(band, posture, rig.links[l].name + "_r", of_links[l]);
  }
  return band;
}

}  // namespace isograsp
