// SPDX-License-Identifier: GPL-3.0-or-later
// Inside gui/trial_pages/ only: what stands in a row of a stored trial. Columns are looked up once:
// a trial has tens of thousands of rows. SI units.
#pragma once

#include <array>
#include <optional>

#include "core/signals.hpp"
#include "core/spatial.hpp"
#include "hand/columns.hpp"
#include "kinematics/attitude.hpp"
#include "virtual_hand/grasp_criteria.hpp"

namespace isograsp::gui {

/// A column of the signals; nothing: they have none of that name.
using Place = std::optional<std::size_t>;
struct PosePlaces {
  std::array<Place, 3> position;
  std::array<Place, 4> attitude;
};
[[nodiscard]] PosePlaces find_pose(const Signals& signals, const columns::OfAxes& position,
                                   const columns::OfComponents& attitude);

/// kMissing: there is no such column, or no value.
[[nodiscard]] double value_at(const Signals& signals, Place column, std::size_t row);
[[nodiscard]] Vec3 vector_at(const Signals& signals, const std::array<Place, 3>& places,
                             std::size_t row);
/// missing_pose() unless all of it is there.
[[nodiscard]] Pose pose_at(const Signals& signals, const PosePlaces& places, std::size_t row);

/// The best set of the digits of a tracked hand that touch, its criteria and their limits.
struct ChoicePlaces {
  Place digits, feasible;
  std::array<Place, 6> criteria;  ///< G_min, H_min, H_det; their limits
};
[[nodiscard]] ChoicePlaces find_choice(const Signals& signals);
[[nodiscard]] virtual_hand::GraspChoice choice_at(const Signals& signals,
                                                  const ChoicePlaces& places, std::size_t row);

}  // namespace isograsp::gui
