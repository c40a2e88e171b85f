// SPDX-License-Identifier: GPL-3.0-or-later
// M: spectrum of the speed v divided by its first line; from the first to the last line of at most
// 10 Hz with M >= 0.05 are n steps:
//   SPARC = -sum sqrt(1 / n^2 + (M_(k + 1) - M_k)^2)
//   jerk_k = (v_(k + 1) - 2 v_k + v_(k - 1)) / dt^2
//   LDLJ = -ln(duration^3 / (largest v)^2 * sum jerk^2 dt)
// Of movements:
// Speeds are those of the whole record, so that the ends of a movement are not ends of the filter.
// sparc and ldlj begin at the first row of the stretch of at least 5 % of the largest speed in
// which a tenth of the largest distance (angle) from the first row is passed: what trembles before
// does not count.
#include "kinematics/measures/smoothness.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "core/fourier.hpp"
#include "kinematics/measures/zero_phase.hpp"

namespace isograsp {

namespace {

constexpr double kLeastRise_m_s = 0.02;
constexpr double kLeastApart_s = 0.15;
constexpr double kOnsetShare = 0.05;  // of the largest speed
constexpr double kOnsetWay = 0.1;     // of the largest distance
// Less is not told from noise.
constexpr double kLeastTurn_rad = 5.0 * std::numbers::pi / 180.0;
constexpr double kLeastWay_m = 0.010;

/// What moves, over the record: a link that turns, or the object on its way.
struct Mover {
  std::string channel;
  bool turns = false;
  std::vector<Pose> X;        ///< filtered
  std::vector<double> speed;  ///< rad/s or m/s
  [[nodiscard]] double distance(std::size_t from, std::size_t to) const {
    return turns ? angle_between(X[from].q, X[to].q) : (X[to].p - X[from].p).norm();
  }
};

Mover mover(std::span<const double> t_s, std::string channel, std::span<const Pose> X, bool turns) {
  Mover of{std::move(channel), turns, zero_phase(t_s, X), {}};
  std::vector<Vec3> p;
  std::vector<Quat> q;
  for (const Pose& pose : of.X) {
    p.push_back(pose.p);
    q.push_back(pose.q);
  }
  of.speed = lengths(turns ? angular_velocities(t_s, q) : velocities(t_s, p));
  return of;
}

/// The times of a record, and what is asked of them once.
struct RecordTimes {
  explicit RecordTimes(const std::vector<double>& times)
      : t_s(times),
        objection(objection_to_rate(times)),
        usual_s(usual_step_s(times).value_or(0.0)) {}
  std::span<const double> t_s;
  Text objection;
  double usual_s;
};

/// The speeds of a movement, one step from each other.
struct SpeedRows {
  Text reason;  ///< why there are none
  std::vector<double> t_s;
  std::vector<double> speed;
  std::vector<double> distance;  ///< from the first row
  double step_s = 0.0;
};

SpeedRows speeds_in(const RecordTimes& times, const Mover& of, const PoseTarget& target) {
  SpeedRows out;
  const MovementRows valid = movement_rows(
      times.t_s, [&of](std::size_t row) { return !std::isnan(of.speed[row]); }, target);
  out.reason = target.matched_s && !times.objection.empty() ? times.objection : valid.reason;
  if (!out.reason.empty()) return out;
  if (valid.rows.size() < 2) {
    out.reason = "fewer than two samples"_text;
    return out;
  }
  for (const std::size_t row : valid.rows) {
    out.t_s.push_back(times.t_s[row]);
    out.speed.push_back(of.speed[row]);
    out.distance.push_back(of.distance(valid.rows.front(), row));
  }
  for (std::size_t k = 1; k < out.t_s.size(); ++k)
    if (out.t_s[k] - out.t_s[k - 1] > kLongestMotionStep * times.usual_s) out.reason = "gap"_text;
  out.step_s = (out.t_s.back() - out.t_s.front()) / static_cast<double>(out.t_s.size() - 1);
  return out;
}

/// From its onset on.
std::span<const double> moving_part(const SpeedRows& rows) {
  const double fastest = *std::max_element(rows.speed.begin(), rows.speed.end());
  const double furthest = *std::max_element(rows.distance.begin(), rows.distance.end());
  const auto away = std::find_if(rows.distance.begin(), rows.distance.end(),
                                 [&](double distance) { return distance >= kOnsetWay * furthest; });
  auto onset = static_cast<std::size_t>(away - rows.distance.begin());
  while (onset > 0 && rows.speed[onset - 1] >= kOnsetShare * fastest) --onset;
  return std::span(rows.speed).subspan(onset);
}

/// Why a movement is too small for its shape to be told; empty: it is not.
Text too_little(const Mover& of, const SpeedRows& rows) {
  const double furthest = *std::max_element(rows.distance.begin(), rows.distance.end());
  if (of.turns && furthest < kLeastTurn_rad) return "too little rotation"_text;
  if (!of.turns && furthest < kLeastWay_m) return "too short a way"_text;
  return {};
}

void add_smoothness(std::vector<MovementMeasure>& measures, std::size_t movement, const Mover& of,
                    const SpeedRows& rows) {
  const Text reason = rows.reason.empty() ? too_little(of, rows) : rows.reason;
  Valued arc = no_value(reason);
  Valued jerk = no_value(reason);
  if (reason.empty()) {
    arc = spectral_arc_length(moving_part(rows), rows.step_s);
    jerk = log_dimensionless_jerk(moving_part(rows), rows.step_s);
  }
  measures.push_back(movement_measure(movement, "sparc", of.channel, arc, ""));
  measures.back().measure.version = 2;  // docs/measures.md
  measures.push_back(movement_measure(movement, "ldlj", of.channel, jerk, ""));
}

void add_units(std::vector<MovementMeasure>& measures, std::size_t movement, const Mover& of,
               const SpeedRows& rows) {
  Valued units = no_value(rows.reason);
  Valued fastest = no_value(rows.reason);
  if (rows.reason.empty()) {
    units = {static_cast<double>(movement_units(rows.t_s, rows.speed).size()), {}};
    fastest = {*std::max_element(rows.speed.begin(), rows.speed.end()), {}};
  }
  measures.push_back(movement_measure(movement, "movement_units", of.channel, units, ""));
  measures.push_back(movement_measure(movement, "peak_speed", of.channel, fastest, "m/s"));
}

}  // namespace

Valued spectral_arc_length(std::span<const double> speed, double step_s) {
  constexpr unsigned kPadding = 4;
  constexpr double kHighest_Hz = 10.0;
  constexpr double kLeastAmplitude = 0.05;
  const std::size_t n = speed.size();
  if (n < 2) return no_value("fewer than two samples"_text);
  const std::size_t length = std::bit_ceil(n) << kPadding;
  const double line_Hz = 1.0 / (step_s * static_cast<double>(length));
  constexpr double kRoundingSlack = 1e-9;  // a line at 10 Hz belongs to the range
  const double highest_Hz = kHighest_Hz * (1.0 + kRoundingSlack);
  const double lines = std::min(highest_Hz / line_Hz + 1.0, 0.5 * static_cast<double>(length));
  std::vector<double> magnitude = low_magnitudes(speed, length, static_cast<std::size_t>(lines));
  const double largest = magnitude.front();  // of a signal that is never negative
  if (!(largest > 0.0)) return no_value("nothing moved"_text);
  std::size_t first = magnitude.size();
  std::size_t last = 0;
  for (std::size_t k = 0; k < magnitude.size(); ++k) {
    magnitude[k] /= largest;
    if (static_cast<double>(k) * line_Hz > highest_Hz || magnitude[k] < kLeastAmplitude) continue;
    first = std::min(first, k);
    last = k;
  }
  if (first >= last) return no_value("the spectrum has no range"_text);
  const double scaled_line = 1.0 / static_cast<double>(last - first);
  double length_of_arc = 0.0;
  for (std::size_t k = first; k < last; ++k) {
    const double rise = magnitude[k + 1] - magnitude[k];
    length_of_arc += std::sqrt(scaled_line * scaled_line + rise * rise);
  }
  return {-length_of_arc, {}};
}

Valued log_dimensionless_jerk(std::span<const double> speed, double step_s) {
  if (speed.size() < 3) return no_value("fewer than three samples"_text);
  double fastest = 0.0;
  for (const double value : speed) fastest = std::max(fastest, std::abs(value));
  if (!(fastest > 0.0)) return no_value("nothing moved"_text);
  double squares = 0.0;
  for (std::size_t k = 1; k + 1 < speed.size(); ++k) {
    const double jerk = (speed[k + 1] - 2.0 * speed[k] + speed[k - 1]) / (step_s * step_s);
    squares += jerk * jerk;
  }
  if (!(squares > 0.0)) return no_value("the speed never changes its slope"_text);
  const double duration = static_cast<double>(speed.size()) * step_s;
  return {-std::log(duration * duration * duration / (fastest * fastest) * squares * step_s), {}};
}

std::vector<std::size_t> movement_units(std::span<const double> t_s,
                                        std::span<const double> speed) {
  std::vector<std::size_t> units;
  std::size_t k = 0;
  while (k + 1 < speed.size()) {
    while (k + 1 < speed.size() && speed[k + 1] <= speed[k]) ++k;
    const double low = speed[k];
    std::size_t top = k;
    while (k + 1 < speed.size() && speed[k + 1] >= speed[k]) {
      ++k;
      if (speed[k] > speed[top]) top = k;
    }
    if (k + 1 == speed.size()) break;  // it falls no more, or still rises
    const bool apart =
        units.empty() || t_s[top] - t_s[units.back()] >= kLeastApart_s - kMarkerTimeSlack_s;
    if (speed[top] - low >= kLeastRise_m_s && apart) units.push_back(top);
  }
  return units;
}

Result<std::vector<MovementMeasure>> movement_smoothness(const Rig& rig, const PoseSeries& series,
                                                         std::span<const PoseTarget> targets) {
  const auto score = score_of(rig);
  if (!score) return score.error();
  std::vector<Mover> movers;
  for (const RigLink& link : rig.links) {
    const auto poses = link_poses(series, link.parent, link.child);
    if (!poses) return poses.error();
    movers.push_back(mover(series.t_s, link.name, *poses, true));
  }
  const auto object = frame_of(series, score->object);
  if (!object) return object.error();
  movers.push_back(mover(series.t_s, "position", series.X_W[*object], false));

  const RecordTimes times(series.t_s);
  std::vector<MovementMeasure> measures;
  for (std::size_t m = 0; m < targets.size(); ++m)
    for (const Mover& of : movers) {
      const SpeedRows rows = speeds_in(times, of, targets[m]);
      add_smoothness(measures, m, of, rows);
      if (!of.turns) add_units(measures, m, of, rows);
    }
  return measures;
}

}  // namespace isograsp
