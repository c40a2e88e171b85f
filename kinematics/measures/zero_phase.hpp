// SPDX-License-Identifier: GPL-3.0-or-later
// Motion without its noise: a Butterworth low-pass forward and backward, so without delay, for
// positions [m] and attitudes (unit quaternions) of a series of rows, and the velocities of what is
// left. Missing values are NaN. A whole recording at a time, not for the real-time path.
// Derivation: docs/markers.md.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/text.hpp"
#include "kinematics/attitude.hpp"

namespace isograsp {

/// Where the gain of both passes together is 1/sqrt 2 (-3 dB).
inline constexpr double kMotionCutoff_Hz = 6.0;
/// Rates that are filtered, with 1 % of slack for cameras that do not keep theirs.
inline constexpr double kLeastMotionRate_Hz = 50.0;
inline constexpr double kMostMotionRate_Hz = 500.0;

/// The usual step [s]: mean of those that are at most one and a half times their median; nothing
/// for fewer than two rows. @pre times increase strictly
[[nodiscard]] std::optional<double> usual_step_s(std::span<const double> t_s);
/// Why a series with these times is not filtered; empty: it is.
[[nodiscard]] Text objection_to_rate(std::span<const double> t_s);

/// Rows follow each other if at most so many usual steps lie between them.
inline constexpr double kLongestMotionStep = 1.5;

/// Rows [first, end) without a hole: a missing value, or a longer step, ends a run.
struct MotionRun {
  std::size_t first = 0;
  std::size_t end = 0;
};
[[nodiscard]] std::vector<MotionRun> motion_runs(std::span<const double> t_s,
                                                 std::span<const Vec3> p);
[[nodiscard]] std::vector<MotionRun> motion_runs(std::span<const double> t_s,
                                                 std::span<const Quat> q);

/// Each run on its own, as if its rows were as far from each other as its mean step. Beyond its
/// ends a run is continued by point reflection, 2 p_0 - p_k and q_0 q_k^-1 q_0, again and again, so
/// that even motion and even turning stay what they are; the first and the last row of a run keep
/// their value and with it their noise. Missing rows stay missing; all are if the rate is not one
/// that is filtered. Signs of quaternions do not count, those of the result are continuous.
/// @pre times increase strictly, equal sizes, cutoff_Hz > 0
[[nodiscard]] std::vector<Vec3> zero_phase(std::span<const double> t_s, std::span<const Vec3> p,
                                           double cutoff_Hz = kMotionCutoff_Hz);
[[nodiscard]] std::vector<Quat> zero_phase(std::span<const double> t_s, std::span<const Quat> q,
                                           double cutoff_Hz = kMotionCutoff_Hz);
[[nodiscard]] std::vector<Pose> zero_phase(std::span<const double> t_s, std::span<const Pose> X,
                                           double cutoff_Hz = kMotionCutoff_Hz);

/// dp/dt [m/s] by central differences, one-sided at the ends of runs; missing in runs of one row.
[[nodiscard]] std::vector<Vec3> velocities(std::span<const double> t_s, std::span<const Vec3> p);
/// Angular velocity [rad/s] in the frame that q leads to (w_AB_A of q_AB), from the turn between
/// the row before and the row behind: below half a turn.
[[nodiscard]] std::vector<Vec3> angular_velocities(std::span<const double> t_s,
                                                   std::span<const Quat> q);
/// Lengths; missing ones NaN.
[[nodiscard]] std::vector<double> lengths(std::span<const Vec3> v);

}  // namespace isograsp
