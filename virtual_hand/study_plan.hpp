// SPDX-License-Identifier: GPL-3.0-or-later
// The study of grasp assistance: six objects, each placed with and without it (Delrieu et al.,
// task; what they leave open is decided in docs/virtual_hand.md, "The study"). Pure: the same seed
// gives the same plan. SI units; world X right, Y up from the table, Z to the viewer.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "virtual_hand/capsule.hpp"
#include "virtual_hand/grasp_criteria.hpp"

namespace isograsp::virtual_hand {

/// Objects of one size have the same targets and the same grasps.
enum class SizeClass : std::uint8_t { small, flat, slim };

/// An object that is placed. Main axis: z of the object.
struct StudyObject {
  std::string_view name;
  SizeClass size = SizeClass::small;
  ObjectShape shape;
  double mass_kg = 0.0;    ///< of a density of 1000 kg/m3
  double support_m = 0.0;  ///< height of the block that it lies on at first; 0: the table
  GraspLimits limits;      ///< as `isograsp hand thresholds` finds them
};
inline constexpr std::size_t kStudyObjects = 6;
/// Cuboid and cylinder of each size; small ones first.
[[nodiscard]] const std::array<StudyObject, kStudyObjects>& study_objects() noexcept;

/// Where an object is to be held: its centre, and its main axis, whose direction does not count.
struct StudyTarget {
  Vec3 p_W = Vec3::Zero();
  Vec3 axis_W = Vec3::UnitZ();  ///< unit vector
};
inline constexpr std::size_t kTargetsOfSize = 6;
/// Three on each side of the midline; the first three lie left, x < 0.
[[nodiscard]] const std::array<StudyTarget, kTargetsOfSize>& targets_of(SizeClass size) noexcept;

inline constexpr std::size_t kPlacements = 3;  ///< of a test
struct StudyTest {
  std::size_t object = 0;  ///< of study_objects()
  bool assistance = false;
  std::array<std::size_t, kPlacements> targets{};  ///< of targets_of() its size
};
/// Objects in an order drawn from the seed; of each the four tests in a row, two with assistance
/// and two without, in an order drawn for each object. Each of the four meets both sides, and with
/// and without assistance every target comes once.
[[nodiscard]] std::vector<StudyTest> study_plan(std::uint64_t seed);
/// So many tests of one object in one mode, as plans from this seed on order them.
[[nodiscard]] std::vector<StudyTest> tests_of(std::size_t object, bool assistance, int count,
                                              std::uint64_t seed);

}  // namespace isograsp::virtual_hand
