// SPDX-License-Identifier: GPL-3.0-or-later
// v: speed of a marker, d: distance from face to glass, D: its least value while the glass is away
//   forward transport  first row of the stretch of v_glass >= 15 mm/s in which the glass comes
//                      further than 30 mm from where it stood
//   returning          first row with v_glass < 10 mm/s after the glass was last further than 30 mm
//                      from where it stands at the end
//   drinking           from the first to the last row between them with d <= 1.15 D
//   reaching, end      the same of the hand, with 2 % of its largest speed while it reaches and
//   while
//                      it returns
#include "kinematics/measures/drinking.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>

#include "kinematics/measures/smoothness.hpp"
#include "kinematics/measures/zero_phase.hpp"

namespace isograsp {

namespace {

constexpr double kGlassMoves_m_s = 0.015;
constexpr double kGlassRests_m_s = 0.010;
constexpr double kAway_m = 0.030;         // further than a glass is jogged and a hand shifts
constexpr double kHandMoves = 0.02;       // of its peak
constexpr double kNearestShare = 1.15;    // of the least distance
constexpr double kLongestUnseen_s = 0.1;  // about a boundary that is found by a distance

/// A row, or why it is not known.
struct FoundRow {
  std::size_t row = 0;
  Text reason;
};

constexpr Words kNoStart = "the start is not in the record"_text;
constexpr Words kNoEnd = "the end is not in the record"_text;
constexpr Words kNotInOrder = "the phases are not in their order"_text;

/// From `at` back to the first row of the stretch in which the speed is at least `least`.
FoundRow first_above(std::span<const double> speed, std::size_t at, double least) {
  for (std::size_t row = at;; --row) {
    if (std::isnan(speed[row])) return {row, "gap"_text};
    if (speed[row] < least) return {row + 1, {}};
    if (row == 0) return {0, kNoStart};
  }
}
/// From `at` on the first row in which the speed is below `least`.
FoundRow first_below(std::span<const double> speed, std::size_t at, double least) {
  for (std::size_t row = at; row < speed.size(); ++row) {
    if (std::isnan(speed[row])) return {row, "gap"_text};
    if (speed[row] < least) return {row, {}};
  }
  return {speed.size(), kNoEnd};
}

/// The first, the last row further away than 30 mm from where a marker is seen first, last.
/// Nothing: it never is.
std::optional<std::size_t> first_away(std::span<const Vec3> p) {
  std::optional<std::size_t> start;
  for (std::size_t row = 0; row < p.size(); ++row) {
    if (!start && !is_missing(p[row])) start = row;
    if (start && (p[row] - p[*start]).norm() > kAway_m) return row;
  }
  return std::nullopt;
}
std::optional<std::size_t> last_away(std::span<const Vec3> p) {
  std::optional<std::size_t> end;
  for (std::size_t row = p.size(); row-- > 0;) {
    if (!end && !is_missing(p[row])) end = row;
    if (end && (p[row] - p[*end]).norm() > kAway_m) return row;
  }
  return std::nullopt;
}

/// The row of the largest speed in [first, end); nothing seen: end.
std::size_t fastest_row(std::span<const double> speed, std::size_t first, std::size_t end) {
  std::size_t fastest = end;
  for (std::size_t row = first; row < end; ++row)
    if (!std::isnan(speed[row]) && (fastest == end || speed[row] > speed[fastest])) fastest = row;
  return fastest;
}

Measure drinking_measure(std::string name, std::string channel, const Valued& value,
                         std::string unit) {
  return movement_measure(0, std::move(name), std::move(channel), value, std::move(unit)).measure;
}

class Drinking {
 public:
  explicit Drinking(const DrinkingMarkers& markers)
      : t_s_(markers.t_s),
        hand_(filtered_part(markers.hand)),
        glass_(filtered_part(markers.glass)),
        face_(filtered_part(markers.face)),
        trunk_(filtered_part(markers.trunk)),
        shoulder_(filtered_part(markers.shoulder)),
        elbow_(filtered_part(markers.elbow)),
        wrist_(filtered_part(markers.wrist)),
        hand_speed_(lengths(velocities(t_s_, hand_))),
        glass_speed_(lengths(velocities(t_s_, glass_))) {
    for (std::size_t row = 0; row < t_s_.size(); ++row)
      distance_.push_back((face_[row] - glass_[row]).norm());
  }

  [[nodiscard]] DrinkingTask measured() {
    DrinkingTask task;
    task.reason = find_phases();
    if (task.reason.empty())
      for (std::size_t k = 0; k < rows_.size(); ++k) task.phase_s[k] = t_s_[rows_[k]];
    add_times(task);
    add_reach_and_units(task);
    add_trunk(task);
    add_elbow(task);
    return task;
  }

 private:
  [[nodiscard]] std::vector<Vec3> filtered_part(const std::vector<Vec3>& p) const {
    return p.empty() ? std::vector<Vec3>() : zero_phase(t_s_, std::span<const Vec3>(p));
  }

  /// Rows at which the phases begin, and the end; or why they are not known.
  Text find_phases() {
    if (Text objection = objection_to_rate(t_s_); !objection.empty()) return objection;
    if (Text reason = find_glass(); !reason.empty()) return reason;
    if (Text reason = find_drinking(); !reason.empty()) return reason;
    if (Text reason = find_hand(); !reason.empty()) return reason;
    if (!std::is_sorted(rows_.begin(), rows_.end()) || rows_[0] > peak_) return kNotInOrder;
    return {};
  }

  Text find_glass() {
    const auto is_seen = [](const Vec3& p) { return !is_missing(p); };
    if (std::none_of(glass_.begin(), glass_.end(), is_seen)) return "the glass was not seen"_text;
    const auto lifted = first_away(glass_);
    const auto set_down = last_away(glass_);
    if (!lifted || !set_down) return "the glass was not lifted"_text;
    const FoundRow lift = first_above(glass_speed_, *lifted, kGlassMoves_m_s);
    if (!lift.reason.empty()) return lift.reason;
    const FoundRow rest = first_below(glass_speed_, *set_down, kGlassRests_m_s);
    if (!rest.reason.empty()) return rest.reason;
    rows_[1] = lift.row;
    rows_[4] = rest.row;
    if (rows_[1] >= rows_[4]) return kNotInOrder;
    return {};
  }

  Text find_drinking() {
    double least = kMissing;
    for (std::size_t row = rows_[1]; row <= rows_[4]; ++row)
      if (!std::isnan(distance_[row]) && !(distance_[row] >= least)) least = distance_[row];
    if (std::isnan(least)) return "the face was not seen"_text;
    const auto near = [&](std::size_t row) { return distance_[row] <= kNearestShare * least; };
    std::size_t first = rows_[1];
    while (!near(first)) ++first;
    std::size_t last = rows_[4];
    while (!near(last)) --last;
    // The distance must be known on the other side of both, too.
    if (!seen_beside(first, -1) || !seen_beside(last, 1)) return "gap"_text;
    rows_[2] = first;
    rows_[3] = last;
    return {};
  }
  [[nodiscard]] bool seen_beside(std::size_t row, int step) const {
    for (auto at = static_cast<std::ptrdiff_t>(row) + step;
         at >= 0 && at < static_cast<std::ptrdiff_t>(t_s_.size()); at += step) {
      const auto beside = static_cast<std::size_t>(at);
      if (std::abs(t_s_[beside] - t_s_[row]) > kLongestUnseen_s + kMarkerTimeSlack_s) return false;
      if (!std::isnan(distance_[beside])) return true;
    }
    return false;
  }

  Text find_hand() {
    const auto left = first_away(hand_);
    const auto back = last_away(hand_);
    peak_ = fastest_row(hand_speed_, 0, rows_[1]);
    const std::size_t last_peak = fastest_row(hand_speed_, rows_[4], t_s_.size());
    if (!left || !back || peak_ == rows_[1] || last_peak == t_s_.size())
      return "the hand did not move"_text;
    const FoundRow start = first_above(hand_speed_, *left, kHandMoves * hand_speed_[peak_]);
    if (!start.reason.empty()) return start.reason;
    const FoundRow end = first_below(hand_speed_, *back, kHandMoves * hand_speed_[last_peak]);
    if (!end.reason.empty()) return end.reason;
    rows_[0] = start.row;
    rows_[5] = end.row;
    return {};
  }

  /// The rows of [first, last] in which all of `parts` are seen, by the rules of a movement.
  [[nodiscard]] MovementRows seen_in(std::size_t first, std::size_t last,
                                     std::initializer_list<const std::vector<Vec3>*> parts) const {
    const auto seen = [&parts](std::size_t row) {
      return std::none_of(parts.begin(), parts.end(),
                          [row](const auto* p) { return is_missing((*p)[row]); });
    };
    return movement_rows(t_s_, seen, {"", t_s_[first], t_s_[last], Pose()});
  }

  void add_times(DrinkingTask& task) const {
    const auto between = [&](std::size_t from, std::size_t to) -> Valued {
      if (!task.reason.empty()) return no_value(task.reason);
      return {task.phase_s[to] - task.phase_s[from], {}};
    };
    task.measures.push_back(
        drinking_measure("total_movement_time", "task", between(0, kDrinkingPhases.size()), "s"));
    for (std::size_t phase = 0; phase < kDrinkingPhases.size(); ++phase)
      task.measures.push_back(drinking_measure("phase_time", std::string(kDrinkingPhases[phase]),
                                               between(phase, phase + 1), "s"));
  }

  /// Movement units of the hand between two rows.
  [[nodiscard]] Valued units_between(std::size_t first, std::size_t last) const {
    const auto speed = std::span(hand_speed_).subspan(first, last - first + 1);
    const auto times = std::span(t_s_).subspan(first, last - first + 1);
    const double usual_s = *usual_step_s(t_s_);
    for (std::size_t k = 0; k < speed.size(); ++k)
      if (std::isnan(speed[k]) || (k > 0 && times[k] - times[k - 1] > kLongestMotionStep * usual_s))
        return no_value("gap"_text);
    return {static_cast<double>(movement_units(times, speed).size()), {}};
  }

  void add_reach_and_units(DrinkingTask& task) const {
    Valued fastest = no_value(task.reason);
    Valued when = fastest;
    Valued forward = fastest;
    Valued back = fastest;
    Valued total = fastest;
    if (task.reason.empty()) {
      fastest = {hand_speed_[peak_], {}};
      when = {100.0 * (t_s_[peak_] - task.phase_s[0]) / (task.phase_s[1] - task.phase_s[0]), {}};
      forward = units_between(rows_[0], rows_[2]);
      back = units_between(rows_[3], rows_[5]);
      total = forward.value ? back : forward;
      if (total.value) total.value = *forward.value + *back.value;
    }
    task.measures.push_back(drinking_measure("peak_velocity", "reaching", fastest, "m/s"));
    task.measures.push_back(drinking_measure("time_to_peak_velocity", "reaching", when, "%"));
    task.measures.push_back(drinking_measure("movement_units", "reaching_forward", forward, ""));
    task.measures.push_back(drinking_measure("movement_units", "back_returning", back, ""));
    task.measures.push_back(drinking_measure("movement_units", "total", total, ""));
  }

  void add_trunk(DrinkingTask& task) const {
    Valued moved = no_value(trunk_.empty() ? Text("trunk not measured"_text) : task.reason);
    Valued reach = moved;
    if (moved.reason.empty()) {
      const MovementRows whole = seen_in(rows_[0], rows_[5], {&trunk_});
      moved = no_value(whole.reason);
      if (whole.reason.empty()) {
        moved.value = 0.0;
        for (const std::size_t row : whole.rows)
          moved.value = std::max(*moved.value, (trunk_[row] - trunk_[whole.rows.front()]).norm());
      }
      const MovementRows reaching = seen_in(rows_[0], rows_[1], {&trunk_, &hand_});
      reach = no_value(reaching.reason);
      if (reaching.reason.empty()) {
        reach.value = 0.0;
        for (const std::size_t row : reaching.rows)
          reach.value = std::max(*reach.value, (hand_[row] - trunk_[row]).norm());
      }
    }
    task.measures.push_back(drinking_measure("trunk_displacement", "trunk", moved, "m"));
    task.measures.push_back(drinking_measure("reach", "trunk", reach, "m"));
  }

  void add_elbow(DrinkingTask& task) const {
    const bool complete = !shoulder_.empty() && !elbow_.empty() && !wrist_.empty();
    Valued angle =
        no_value(complete ? task.reason : Text("shoulder, elbow and wrist are needed"_text));
    Valued rate = angle;
    if (angle.reason.empty()) {
      const MovementRows reaching = seen_in(rows_[0], rows_[1], {&shoulder_, &elbow_, &wrist_});
      angle = rate = no_value(reaching.reason);
      if (reaching.reason.empty()) {
        std::vector<double> angles;
        for (const std::size_t row : reaching.rows) angles.push_back(elbow_angle(row));
        angle.value = *std::max_element(angles.begin(), angles.end());
        rate = fastest_rise(reaching.rows, angles);
      }
    }
    task.measures.push_back(drinking_measure("elbow_extension", "reaching", angle, "rad"));
    task.measures.push_back(drinking_measure("elbow_extension_rate", "reaching", rate, "rad/s"));
  }
  /// Between upper arm and forearm; a straight arm has pi.
  [[nodiscard]] double elbow_angle(std::size_t row) const {
    const Vec3 up = shoulder_[row] - elbow_[row];
    const Vec3 down = wrist_[row] - elbow_[row];
    return std::atan2(up.cross(down).norm(), up.dot(down));
  }
  [[nodiscard]] Valued fastest_rise(const std::vector<std::size_t>& rows,
                                    const std::vector<double>& angles) const {
    if (rows.size() < 3) return no_value("fewer than three samples"_text);
    double fastest = 0.0;
    for (std::size_t k = 1; k + 1 < rows.size(); ++k)
      fastest = std::max(fastest,
                         (angles[k + 1] - angles[k - 1]) / (t_s_[rows[k + 1]] - t_s_[rows[k - 1]]));
    return {fastest, {}};
  }

  std::vector<double> t_s_;
  std::vector<Vec3> hand_, glass_, face_, trunk_, shoulder_, elbow_, wrist_;
  std::vector<double> hand_speed_, glass_speed_;
  std::vector<double> distance_;  ///< from face to glass
  /// The first row of each phase, and of what follows.
  std::array<std::size_t, kDrinkingPhases.size() + 1> rows_{};
  std::size_t peak_ = 0;  ///< of the hand's speed while it reaches
};

}  // namespace

DrinkingTask drinking_task(const DrinkingMarkers& markers) {
  return Drinking(markers).measured();
}

}  // namespace isograsp
