// SPDX-License-Identifier: GPL-3.0-or-later
// The study of grasp assistance (docs/virtual_hand.md, "The simulated study"): placements of
// people, with assistance and without, of three sizes of objects, as values of a study: mode times
// size within people. SI units.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/study/study_data.hpp"

namespace isograsp::reports {

/// One placement. What an unfinished one has not is nothing.
struct GraspPlacement {
  std::string group;       ///< kind of person: "healthy"
  std::uint64_t seed = 0;  ///< of the person
  std::string object;
  std::string size;  ///< of kGraspSizes
  bool assistance = false;
  std::size_t target = 0;
  bool completed = false;
  int fails = 0;
  std::optional<double> manipulation_s;
  std::optional<double> hold_distance_m;
  std::optional<double> hold_axis_angle_rad;
  std::optional<double> hold_geodesic_rad;
  std::optional<double> release_s;
  bool helped = false;
  double held_open_s = 0.0;  ///< still held while the hand was open
  double lost_share = 0.0;   ///< of its frames, without the hand
};
inline constexpr std::array<std::string_view, 3> kGraspSizes{"small", "flat", "slim"};

/// What is compared, each in a report of its own.
enum class GraspMeasure : std::uint8_t { fails, time, distance, angle, release };
inline constexpr std::array<GraspMeasure, 5> kGraspMeasures{
    GraspMeasure::fails, GraspMeasure::time, GraspMeasure::distance, GraspMeasure::angle,
    GraspMeasure::release};
/// As measures are called: "placement_fails".
[[nodiscard]] std::string_view name_of(GraspMeasure measure) noexcept;

/// Factors and analyses: size within mode, two-way, follow-ups of the sizes in each mode.
[[nodiscard]] Study grasp_study(GraspMeasure measure);
/// A cell is the mean over the placements of a person in one mode with one size. Time: one that is
/// not completed counts with `longest_s`. Distance, angle and release have values only where a
/// placement was completed: how many were is said.
[[nodiscard]] StudyData grasp_study_data(const std::vector<GraspPlacement>& placements,
                                         GraspMeasure measure, double longest_s);

/// One row for each placement.
[[nodiscard]] std::string grasp_study_csv(const std::vector<GraspPlacement>& placements);

/// What all placements of one kind of person, mode and size came to.
struct GraspTally {
  std::string group;
  std::string size;
  bool assistance = false;
  int placements = 0;
  int completed = 0;
  int fails = 0;
  int helped = 0;
  double longest_held_open_s = 0.0;
};
[[nodiscard]] std::vector<GraspTally> tally_of(const std::vector<GraspPlacement>& placements);

}  // namespace isograsp::reports
