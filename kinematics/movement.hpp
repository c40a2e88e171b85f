// SPDX-License-Identifier: GPL-3.0-or-later
// One movement, from the cue to the entry into the tolerance: how far each link turned, how soon,
// and which share it had. Times in s, angles in rad. Formulas and sources: docs/markers.md.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/measure.hpp"
#include "core/result.hpp"
#include "kinematics/pose_series.hpp"

namespace isograsp {

/// What a record was asked for: one target (the events of a trial).
struct PoseTarget {
  std::string posture;
  double cue_s = 0.0;
  std::optional<double> matched_s;  ///< the entry; nothing: not reached
  Pose X_WR;
};

/// A number, or the reason why there is none.
struct Valued {
  std::optional<double> value;
  Text reason;
};

[[nodiscard]] inline Valued no_value(Text reason) {
  return {std::nullopt, std::move(reason)};
}

/// The rows from the cue to the match of which `valid` says that they have a value, and why they
/// cannot be measured (empty: they can): the target was not reached, the first is more than 50 ms
/// behind the cue or the last before the match, or more than 0.1 s lie between two.
struct MovementRows {
  std::vector<std::size_t> rows;
  Text reason;
};
[[nodiscard]] MovementRows movement_rows(std::span<const double> t_s,
                                         const std::function<bool(std::size_t)>& valid,
                                         const PoseTarget& target);

/// One link in one movement: what its rows give, and the curves that bands are made of.
struct LinkMovement {
  Text reason;                ///< why there are no rows to measure; empty: there are
  std::vector<double> t_s;    ///< valid rows
  std::vector<double> angle;  ///< r_angle, 0 at the first row and 1 at the last; empty: undefined
  std::vector<double> rpy;    ///< r_rpy
  std::vector<double> axis;   ///< r_axis
  Valued rotation;            ///< theta(T)
  Valued rotation_rpy;        ///< n(T) - n(0)
  Valued t10, t63;            ///< of r_angle, from the cue
  Valued t10_rpy, t63_rpy;    ///< of r_rpy
};

/// `X_L`: one pose of the link for each time, missing ones missing_pose().
[[nodiscard]] LinkMovement measure_link(std::span<const double> t_s, std::span<const Pose> X_L,
                                        const RigLink& link, const PoseTarget& target);

/// Value of a curve at a time, linear between rows and held beyond them. @pre not empty
[[nodiscard]] double curve_at(std::span<const double> t_s, std::span<const double> curve,
                              double when_s) noexcept;

/// All links of a rig in all movements.
struct MovementScores {
  std::vector<PoseTarget> targets;
  std::vector<std::vector<LinkMovement>> links;  ///< [movement][link of the rig]
};
/// What a rig says is scored; an error if it has no [score].
[[nodiscard]] Result<RigScore> score_of(const Rig& rig);
/// Errors: the rig has no [score], or frames of its links are not in the series.
[[nodiscard]] Result<MovementScores> score_movements(const Rig& rig, const PoseSeries& series,
                                                     std::vector<PoseTarget> targets);

struct MovementMeasure {
  std::size_t movement = 0;
  Measure measure;
};
[[nodiscard]] MovementMeasure movement_measure(std::size_t movement, std::string name,
                                               std::string channel, const Valued& valued,
                                               std::string unit);
/// duration, rotation, rotation_rpy, t10, t63, t10_rpy, t63_rpy, share_angle, share_rpy, share_axis
/// of every movement; the channel is the link, that of the duration is "task".
/// @pre scores are of this rig
[[nodiscard]] std::vector<MovementMeasure> movement_measures(const Rig& rig,
                                                             const MovementScores& scores);

}  // namespace isograsp
