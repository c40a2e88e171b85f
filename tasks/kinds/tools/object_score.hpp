// SPDX-License-Identifier: GPL-3.0-or-later
// Inside tasks/ only: object, target and touch of a trial as the measures of all tasks with an
// object see them. SI units; positions and attitudes in the world.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/spatial.hpp"
#include "hand/columns.hpp"
#include "statistics/survival.hpp"
#include "tasks/record.hpp"

namespace isograsp::tasks {

/// Appends the rows of `part` to `sum`.
void append(Section& sum, const Section& part);

/// Two measures of the same movement.
struct Smoothness {
  statistics::Computed sparc;
  statistics::Computed ldlj;
};

class ObjectRecord {
 public:
  /// Refers to `record`, which must outlive it.
  explicit ObjectRecord(const Record& record);

  [[nodiscard]] const Record& record() const noexcept { return record_; }

  /// Rows in [first, last) in which object and target have a position: x and y, z if recorded.
  [[nodiscard]] Section select_positions(std::size_t first, std::size_t last,
                                         std::initializer_list<Phase> phases) const;
  /// Rows in which both have an attitude: whole quaternions, or the angle about z where there are
  /// none.
  [[nodiscard]] Section select_attitudes(std::size_t first, std::size_t last,
                                         std::initializer_list<Phase> phases) const;

  [[nodiscard]] Vec3 position(std::size_t row) const { return position_of_axes(actual_m_, row); }
  [[nodiscard]] Vec3 target(std::size_t row) const { return position_of_axes(target_m_, row); }
  [[nodiscard]] Quat attitude(std::size_t row) const {
    return attitude_of(actual_q_, actual_angle_, row);
  }
  [[nodiscard]] Quat target_attitude(std::size_t row) const {
    return attitude_of(target_q_, target_angle_, row);
  }
  /// From the object to its target [m].
  [[nodiscard]] double distance(std::size_t row) const {
    return (position(row) - target(row)).norm();
  }
  /// Geodesic angle between object and target [rad, 0 … pi].
  [[nodiscard]] double angle(std::size_t row) const {
    return angle_between(target_attitude(row), attitude(row));
  }
  [[nodiscard]] bool touched(std::size_t row) const { return any(contact_, row); }
  /// Whether each finger of the scene touches or not is known in this row.
  [[nodiscard]] bool touch_known(std::size_t row) const;
  [[nodiscard]] bool slips(std::size_t row) const { return any(slip_, row); }
  /// What touched() reads. A finger that the scene lacks has an empty column, or none.
  [[nodiscard]] const std::vector<std::string>& contact_columns() const { return contact_.names; }

  /// Hold errors of position, attitude and, of an object that leans out of the plane of the screen,
  /// its main axis, over sections of select_positions() and select_attitudes().
  void add_hold_errors(std::vector<Measure>& all, const Section& position,
                       const Section& attitude) const;
  /// Root mean square of the angle over a section of select_attitudes() [rad].
  [[nodiscard]] statistics::Computed tilt(const Section& section) const;

  /// Share of the time of contact in which a finger slips, in %; and the mean of the grip [N].
  [[nodiscard]] Measure slip(std::initializer_list<Phase> phases) const;
  [[nodiscard]] Measure mean_grip(std::initializer_list<Phase> phases) const;
  /// Of the object's speed, and of |dF/dt| of the grip, over a section: the speed of the virtual
  /// object is also that of its springs, the force is the hand's alone.
  [[nodiscard]] Smoothness smoothness_of_motion(const Section& section) const;
  [[nodiscard]] Smoothness smoothness_of_grip(const Section& section) const;

  [[nodiscard]] Text no_contact_columns() const { return contact_.absent; }

 private:
  using Axes = std::array<std::span<const double>, 3>;
  using Components = std::array<std::span<const double>, 4>;  ///< w x y z; empty: angle instead
  struct Flags {
    std::vector<std::string> names;
    std::vector<std::span<const double>> columns;
    Text absent;  ///< why there are none
  };

  [[nodiscard]] static Vec3 position_of_axes(const Axes& axes, std::size_t row) {
    return {axes[0][row], axes[1][row], axes[2].empty() ? 0.0 : axes[2][row]};
  }
  [[nodiscard]] static Quat attitude_of(const Components& q, std::span<const double> angle,
                                        std::size_t row) {
    if (q[0].empty()) return Quat(Eigen::AngleAxisd(angle[row], Vec3::UnitZ()));
    return {q[0][row], q[1][row], q[2][row], q[3][row]};
  }
  [[nodiscard]] static bool any(const Flags& flags, std::size_t row);
  [[nodiscard]] std::vector<Quat> attitudes(const Section& section) const;
  [[nodiscard]] std::vector<Quat> target_attitudes(const Section& section) const;
  [[nodiscard]] Components components(const columns::OfComponents& attitude) const;
  [[nodiscard]] Flags flags(const columns::OfFingers& of, Words absent) const;

  const Record& record_;
  Axes actual_m_, target_m_;
  Components actual_q_, target_q_;
  std::span<const double> actual_angle_, target_angle_;
  Flags contact_, slip_;
};

/// How the grip suits the load of the virtual object: correlation, lag and slope over the longest
/// uninterrupted grasp; safety margin over all grasps; friction used over all touch.
void add_grasp(std::vector<Measure>& measures, const Record& record,
               std::initializer_list<Phase> phases);

/// What happened to one of several targets, or objects to be placed.
struct Attempt {
  bool shown = false;
  bool reached = false;
  std::size_t first_row = 0;
  std::size_t last_row = 0;
  std::size_t hold_row = 0;  ///< reached: where the uninterrupted hold began
};

/// All attempts of a trial, in the order of the task.
struct Attempts {
  std::vector<Attempt> all;
  Text absent;  ///< the column without which nothing is known
};
[[nodiscard]] Attempts attempts_of(const Record& record, std::size_t count);

/// From the appearance of the target to `end`, or how long it was tried without success, up to the
/// limit.
/// Time is task time: a device fault costs the patient nothing. @pre attempt.shown
[[nodiscard]] statistics::Completion completion_of(const Record& record, const Attempt& attempt,
                                                   std::size_t end_row, double limit_s);

/// How long one of several targets was tried.
struct TargetTime {
  Section rows;                                      ///< in which it was tried
  std::optional<statistics::Completion> completion;  ///< nothing: it was never shown
};
/// "k of n", the time of each, and over all that were shown the Kaplan-Meier median and the
/// restricted mean time. `whole`: the rows of all, or the reason why nothing is known.
void add_target_times(std::vector<Measure>& measures, const Section& whole,
                      const std::vector<TargetTime>& targets, double limit_s);

/// "k of n", the time of each up to the `end_row` of a reached attempt, and over all that were
/// shown the Kaplan-Meier median and the restricted mean time: a time-out is a time longer than the
/// limit, not a failure left out.
void add_completions(std::vector<Measure>& measures, const Record& record, const Attempts& attempts,
                     double limit_s, std::size_t Attempt::*end_row);

/// How often the object was dropped.
[[nodiscard]] Measure drops_measure(const Record& record);
/// Of the paths that ended at their targets, each from where the object appeared last.
[[nodiscard]] Measure path_efficiency_measure(const Record& record, const Attempts& attempts);

/// Only the rows of which `keeps(value)` is true; `values`: one for each row.
template <class Keeps>
void keep_rows(Section& section, const std::vector<double>& values, Keeps keeps) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < section.rows.size(); ++k) {
    if (!keeps(values[k])) continue;
    section.rows[kept] = section.rows[k];
    section.t_s[kept] = section.t_s[k];
    section.weight_s[kept] = section.weight_s[k];
    ++kept;
  }
  section.rows.resize(kept);
  section.t_s.resize(kept);
  section.weight_s.resize(kept);
}

/// The phases in which an object is moved.
inline constexpr std::initializer_list<Phase> kMoving = {Phase::transport, Phase::hold};

}  // namespace isograsp::tasks
