// SPDX-License-Identifier: GPL-3.0-or-later
// Grasps of an object that a hand can reach, drawn at random, and what tells those that close from
// those that do not: limits of the criteria for an object of one's own (docs/virtual_hand.md,
// "Limits"). Not for the real-time path. The same seed gives the same grasps. SI units.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "virtual_hand/capsule.hpp"
#include "virtual_hand/grasp_criteria.hpp"

namespace isograsp::virtual_hand {

/// `count` grasps of two or three digits (`size`) whose tips reach the object with no link deep in
/// it: half of them with the digits on opposite sides, half anywhere. Fewer: the hand reaches no
/// more in a hundred times as many attempts.
[[nodiscard]] std::vector<GraspCriteria> reachable_grasps(const HandModel& hand,
                                                          const ObjectShape& shape,
                                                          std::size_t size, std::size_t count,
                                                          std::uint64_t seed);

/// How well one criterion tells grasps that close: the share of pairs, one that closes and one that
/// does not, of which the first has more (area under the ROC curve).
struct Separation {
  std::size_t closed = 0;
  std::size_t open = 0;
  double G_min = 0.0;
  double H_min = 0.0;
  double H_det = 0.0;
  double G_min_raw = 0.0;
};
/// NaN in the areas where all close or none does.
[[nodiscard]] Separation separation_of(std::span<const GraspCriteria> grasps);

/// Limits of one size of set. G_min: where the share of closed ones above it less that of open ones
/// is largest. H: what all but a twentieth of the closed ones exceed; they guard the posture alone.
struct FoundLimits {
  double G_min = 0.0;
  double H_min = 0.0;
  double H_det = 0.0;
};
/// Of no grasp that closes: nothing exceeds them (infinity).
[[nodiscard]] FoundLimits limits_from(std::span<const GraspCriteria> grasps);

}  // namespace isograsp::virtual_hand
