// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of the pose-target tasks. Time is task time: a device fault costs the patient nothing.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/csv.hpp"
#include "tasks/kinds/score_kinds.hpp"
#include "tasks/measures/smoothness.hpp"

namespace isograsp {

namespace {

/// What happened to one target.
struct Attempt {
  bool shown = false;
  bool reached = false;
  std::size_t first_row = 0;
  std::size_t last_row = 0;
  std::size_t hold_row = 0;  ///< reached: where the uninterrupted hold began
};

class PoseScore {
 public:
  PoseScore(const PoseTargetsSpec& spec, const Record& record)
      : spec_(spec), record_(record), signals_(record.signals()) {
    for (const char* name : {"phase", "target_index", "targets_reached"})
      if (!signals_.has(name) && absent_.empty())
        absent_ = "the column " + std::string(name) + " is missing";
    has_attitude_ = signals_.has("actual_qw") && signals_.has("actual_qx") &&
                    signals_.has("actual_qy") && signals_.has("actual_qz");
    attempts_.resize(spec.targets.size());
    if (absent_.empty()) find_attempts();
  }

  [[nodiscard]] std::vector<Measure> measures() const {
    std::vector<Measure> all;
    all.push_back(targets_reached());
    for (std::size_t i = 0; i < attempts_.size(); ++i) all.push_back(completion_time(i));
    add_hold_errors(all);
    all.push_back(tilt_in_transport());
    add_path(all);
    add_contact(all);
    all.push_back(smoothness());
    const Section force = record_.select(kWorking, {"actual_force_N"});
    all.push_back(make_measure("mean_grip", "grip", "N", force,
                               mean_over(force, signals_.column("actual_force_N"))));
    return all;
  }

 private:
  static constexpr std::initializer_list<Phase> kWorking = {Phase::transport, Phase::hold};

  void find_attempts() {
    const auto index = signals_.column("target_index");
    const auto reached = signals_.column("targets_reached");
    double reached_before = 0.0;
    for (std::size_t row = 0; row < record_.rows(); ++row) {
      const bool working =
          record_.phase(row) == Phase::transport || record_.phase(row) == Phase::hold;
      if (!working || !(index[row] >= 0.0) || index[row] >= static_cast<double>(attempts_.size()))
        continue;
      Attempt& attempt = attempts_[static_cast<std::size_t>(index[row])];
      if (!attempt.shown) attempt.first_row = row;
      attempt.shown = true;
      attempt.last_row = row;
      attempt.reached = attempt.reached || reached[row] > reached_before;
      reached_before = std::max(reached_before, reached[row]);
    }
    for (Attempt& attempt : attempts_) {
      if (!attempt.reached) continue;
      attempt.hold_row = attempt.last_row;
      for (std::size_t row = attempt.last_row; row > attempt.first_row;) {
        --row;
        if (record_.paused(row)) continue;
        if (record_.phase(row) != Phase::hold) break;
        attempt.hold_row = row;
      }
    }
  }

  [[nodiscard]] Section whole() const {
    Section section = record_.select(kWorking, {});
    if (!absent_.empty()) section.reason = absent_;
    return section;
  }

  [[nodiscard]] Measure targets_reached() const {
    const auto count = std::count_if(attempts_.begin(), attempts_.end(),
                                     [](const Attempt& attempt) { return attempt.reached; });
    return make_measure("targets_reached", "targets", "of " + std::to_string(attempts_.size()),
                        whole(), static_cast<double>(count));
  }

  [[nodiscard]] Measure completion_time(std::size_t i) const {
    const Attempt& attempt = attempts_[i];
    const std::string channel = "target_" + std::to_string(i + 1);
    Section section;
    if (!absent_.empty()) {
      section.reason = absent_;
    } else if (!attempt.shown) {
      section.reason = "the trial ended before this target";
    } else {
      section = record_.select(attempt.first_row, attempt.last_row + 1, kWorking, {});
    }
    return make_measure("completion_time", channel, "s", section, time_to_hold(attempt));
  }

  [[nodiscard]] Computed time_to_hold(const Attempt& attempt) const {
    if (!attempt.shown) return "the trial ended before this target";
    if (attempt.reached)
      return record_.task_time_s(attempt.hold_row) - record_.task_time_s(attempt.first_row);
    const double tried_s = record_.task_time_s(attempt.last_row) -
                           record_.task_time_s(attempt.first_row) +
                           record_.hold_s(attempt.last_row);
    constexpr double kRoundingSlack = 1e-6;
    if (tried_s >= spec_.time_limit_s * (1.0 - kRoundingSlack))
      return "not reached within " + format_number(spec_.time_limit_s) + " s";
    return "the trial ended before it was reached";
  }

  /// Appends the rows of `part` to `sum`.
  static void append(Section& sum, const Section& part) {
    if (sum.reason.empty()) sum.reason = part.reason;
    sum.rows.insert(sum.rows.end(), part.rows.begin(), part.rows.end());
    sum.t_s.insert(sum.t_s.end(), part.t_s.begin(), part.t_s.end());
    sum.weight_s.insert(sum.weight_s.end(), part.weight_s.begin(), part.weight_s.end());
    sum.excluded += part.excluded;
  }

  /// Mean of f(row) or its root mean square.
  template <class Function>
  static Computed mean_of(const Section& section, bool square, Function&& f) {
    double sum = 0.0;
    double total_s = 0.0;
    for (std::size_t i = 0; i < section.rows.size(); ++i) {
      const double value = f(section.rows[i]);
      sum += section.weight_s[i] * (square ? value * value : value);
      total_s += section.weight_s[i];
    }
    if (!(total_s > 0.0)) return "no samples";
    return square ? std::sqrt(sum / total_s) : sum / total_s;
  }

  [[nodiscard]] double distance_to_target(std::size_t row) const {
    double squares = 0.0;
    for (const char* axis : {"x_m", "y_m", "z_m"}) {
      const auto actual = signals_.column("actual_" + std::string(axis));
      const auto target = signals_.column("target_" + std::string(axis));
      if (actual.empty() || target.empty()) continue;
      squares += (actual[row] - target[row]) * (actual[row] - target[row]);
    }
    return std::sqrt(squares);
  }

  /// Geodesic angle between the attitudes [rad, 0 … pi].
  [[nodiscard]] double angle_to_target(std::size_t row) const {
    const double target = signals_.column("target_angle_rad")[row];
    if (!has_attitude_)
      return std::abs(std::remainder(signals_.column("actual_angle_rad")[row] - target,
                                     2.0 * std::numbers::pi));
    const Quat q_WO(signals_.column("actual_qw")[row], signals_.column("actual_qx")[row],
                    signals_.column("actual_qy")[row], signals_.column("actual_qz")[row]);
    return angle_between(Quat(Eigen::AngleAxisd(target, Vec3::UnitZ())), q_WO);
  }

  [[nodiscard]] Section select_error(std::size_t first, std::size_t last,
                                     std::initializer_list<Phase> phases) const {
    if (signals_.has("actual_z_m") && signals_.has("target_z_m"))
      return record_.select(
          first, last, phases,
          {"actual_x_m", "actual_y_m", "actual_z_m", "target_x_m", "target_y_m", "target_z_m"});
    return record_.select(first, last, phases,
                          {"actual_x_m", "actual_y_m", "target_x_m", "target_y_m"});
  }
  [[nodiscard]] Section select_angle(std::size_t first, std::size_t last,
                                     std::initializer_list<Phase> phases) const {
    if (has_attitude_)
      return record_.select(
          first, last, phases,
          {"actual_qw", "actual_qx", "actual_qy", "actual_qz", "target_angle_rad"});
    return record_.select(first, last, phases, {"actual_angle_rad", "target_angle_rad"});
  }

  /// Over the holds that reached their target: from entering for exactly hold_s.
  void add_hold_errors(std::vector<Measure>& all) const {
    Section position;
    Section angle;
    position.reason = angle.reason = absent_;
    for (std::size_t i = 0; i < attempts_.size(); ++i) {
      const Attempt& attempt = attempts_[i];
      if (!attempt.reached || !(spec_.targets[i].hold_s > 0.0)) continue;
      append(position, select_error(attempt.hold_row, attempt.last_row, {Phase::hold}));
      append(angle, select_angle(attempt.hold_row, attempt.last_row, {Phase::hold}));
    }
    if (position.reason.empty() && position.rows.empty())
      position.reason = angle.reason = "no target was held";
    all.push_back(make_measure(
        "hold_error_position", "position", "m", position,
        mean_of(position, false, [&](std::size_t row) { return distance_to_target(row); })));
    all.push_back(
        make_measure("hold_error_angle", "angle", "rad", angle,
                     mean_of(angle, false, [&](std::size_t row) { return angle_to_target(row); })));
  }

  [[nodiscard]] Measure tilt_in_transport() const {
    Section level;
    level.reason = absent_;
    for (std::size_t i = 0; i < attempts_.size(); ++i)
      if (spec_.targets[i].level && attempts_[i].shown)
        append(level,
               select_angle(attempts_[i].first_row, attempts_[i].last_row + 1, {Phase::transport}));
    if (level.reason.empty() && level.rows.empty()) level.reason = "there was no level transport";
    return make_measure(
        "tilt_in_transport", "angle", "rad", level,
        mean_of(level, true, [&](std::size_t row) { return angle_to_target(row); }));
  }

  void add_path(std::vector<Measure>& all) const {
    const Section motion = record_.select_position(0, record_.rows(), kWorking);
    all.push_back(make_measure("path_length", "position", "m", motion,
                               motion.rows.empty() ? 0.0 : path_length_of(motion, signals_)));
    Section transports;
    transports.reason = absent_.empty() ? motion.reason : absent_;
    double straight_m = 0.0;
    double path_m = 0.0;
    for (const Attempt& attempt : attempts_) {
      if (!attempt.reached) continue;
      const Section way = select_error(attempt.first_row, attempt.hold_row + 1, kWorking);
      if (way.rows.size() < 2 || distance_to_target(way.rows.front()) <= spec_.position_tolerance_m)
        continue;
      Section ends;
      ends.rows = {way.rows.front(), way.rows.back()};
      straight_m += path_length_of(ends, signals_);
      path_m += path_length_of(way, signals_);
      append(transports, way);
    }
    all.push_back(make_measure(
        "path_efficiency", "position", "%", transports,
        path_m > 0.0 ? Computed(100.0 * straight_m / path_m) : Computed("nothing moved")));
  }

  [[nodiscard]] bool any(std::string_view prefix, std::size_t row) const {
    return std::any_of(kFingers.begin(), kFingers.end(), [&](Finger finger) {
      const auto column = signals_.column(std::string(prefix) + std::string(name_of(finger)));
      return !column.empty() && column[row] > 0.5;
    });
  }
  [[nodiscard]] std::string absent_columns(std::string_view prefix) const {
    for (const Finger finger : kFingers)
      if (signals_.has(std::string(prefix) + std::string(name_of(finger)))) return "";
    return "the columns " + std::string(prefix) + "* are missing";
  }

  void add_contact(std::vector<Measure>& all) const {
    Section touched = whole();
    if (touched.reason.empty()) touched.reason = absent_columns("contact_");
    int drops = 0;
    bool held_before = false;
    double contact_s = 0.0;
    double slip_s = 0.0;
    for (std::size_t row = 0; row < record_.rows(); ++row) {
      const Phase phase = record_.phase(row);
      if (phase != Phase::transport && phase != Phase::hold) {
        held_before = false;  // across a pause nothing is the patient's doing
        continue;
      }
      if (record_.missing(row)) {
        held_before = false;
        continue;
      }
      const bool held = any("contact_", row);
      if (held_before && !held && phase == Phase::transport) ++drops;
      held_before = held;
      if (!held || !record_.counts(row)) continue;
      contact_s += record_.hold_s(row);
      if (any("slip_", row)) slip_s += record_.hold_s(row);
    }
    all.push_back(make_measure("drops", "contact", "", touched, static_cast<double>(drops)));
    if (touched.reason.empty()) touched.reason = absent_columns("slip_");
    all.push_back(make_measure(
        "slip", "contact", "%", touched,
        contact_s > 0.0 ? Computed(100.0 * slip_s / contact_s) : Computed("there was no contact")));
  }

  /// Mean of the spectral arc lengths of the single level transports (of all ways, if none is
  /// level).
  [[nodiscard]] Measure smoothness() const {
    const bool has_level = std::any_of(spec_.targets.begin(), spec_.targets.end(),
                                       [](const PoseTarget& target) { return target.level; });
    Section all;
    all.reason = absent_;
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < attempts_.size(); ++i) {
      const Attempt& attempt = attempts_[i];
      if (!attempt.reached || (has_level && !spec_.targets[i].level)) continue;
      const Section way =
          record_.select_position(attempt.first_row, attempt.hold_row + 1, kWorking);
      append(all, way);
      if (way.rows.size() < 2) continue;
      const Computed arc = sparc(speed_of(position_of(way, signals_)));
      if (!arc.value) continue;
      sum += *arc.value;
      ++count;
    }
    return make_measure(
        "sparc", "transport", "", all,
        count > 0 ? Computed(sum / count) : Computed("no transport reached its target"));
  }

  const PoseTargetsSpec& spec_;
  const Record& record_;
  const Signals& signals_;
  bool has_attitude_ = false;  ///< the angle alone is enough where one rotation is free
  std::string absent_;
  std::vector<Attempt> attempts_;
};

}  // namespace

std::vector<Measure> measures_of(const PoseTargetsSpec& spec, const Record& record) {
  return PoseScore(spec, record).measures();
}

}  // namespace isograsp
