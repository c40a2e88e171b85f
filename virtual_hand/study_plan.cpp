// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_hand/study_plan.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/random.hpp"

namespace isograsp::virtual_hand {

namespace {

constexpr double kDensity_kg_m3 = 1000.0;
constexpr std::size_t kTestsOfObject = 4;

struct Size {
  double width_m = 0.0;   ///< edges of the cuboid across its main axis, diameter of the cylinder
  double length_m = 0.0;  ///< along it
  double support_m = 0.0;
  GraspLimits limits;
};
constexpr Size size_of(SizeClass size) noexcept {
  switch (size) {
    // G_min and H_min of pairs as `isograsp hand thresholds` finds them for the cuboid: 0.38 and
    // 0.024 refuse many pinches that close, and exact force closure is asked for anyway.
    case SizeClass::small: return {0.01, 0.02, 0.02, {0.35, 0.014, 9e-5, 0.58, 8e-4}};
    case SizeClass::flat: return {0.08, 0.01, 0.0, {0.093, 0.028, 3.5e-4, 0.15, 1.8e-3}};
    case SizeClass::slim: break;
  }
  return {0.02, 0.15, 0.0, {0.45, 0.030, 1.3e-4, 0.33, 1.1e-3}};
}

StudyObject made(std::string_view name, SizeClass size, ObjectShape::Kind kind) noexcept {
  const Size of = size_of(size);
  const double half_m = 0.5 * of.width_m;
  const double base_m2 =
      kind == ObjectShape::Kind::box ? of.width_m * of.width_m : std::numbers::pi * half_m * half_m;
  return {name,
          size,
          {kind, Vec3(half_m, half_m, 0.5 * of.length_m)},
          kDensity_kg_m3 * base_m2 * of.length_m,
          of.support_m,
          of.limits};
}

/// Seeded order of `all` (Fisher, Yates).
template <class Values>
void shuffle(Values& all, Random& random) {
  for (std::size_t left = all.size(); left > 1; --left)
    std::swap(all[left - 1],
              all[static_cast<std::size_t>(random.uniform() * static_cast<double>(left))]);
}

/// An axis that lies level is turned by this about the vertical, one that stands leans by it.
StudyTarget target(double x_m, double y_m, double z_m, double turn_deg, bool stands) noexcept {
  const double turn = turn_deg * std::numbers::pi / 180.0;
  return {{x_m, y_m, z_m},
          stands ? Vec3(std::sin(turn), std::cos(turn), 0.0)
                 : Vec3(std::cos(turn), 0.0, -std::sin(turn))};
}

/// Left ones, then their reflections.
std::array<StudyTarget, kTargetsOfSize> on_both_sides(bool stands) noexcept {
  return {target(-0.06, 0.12, 0.00, 0.0, stands),   target(-0.10, 0.18, -0.04, 20.0, stands),
          target(-0.14, 0.14, 0.04, -20.0, stands), target(0.06, 0.12, 0.00, 0.0, stands),
          target(0.10, 0.18, -0.04, -20.0, stands), target(0.14, 0.14, 0.04, 20.0, stands)};
}

}  // namespace

const std::array<StudyObject, kStudyObjects>& study_objects() noexcept {
  using Kind = ObjectShape::Kind;
  static const std::array<StudyObject, kStudyObjects> kObjects{
      made("small_cuboid", SizeClass::small, Kind::box),
      made("small_cylinder", SizeClass::small, Kind::cylinder),
      made("flat_cuboid", SizeClass::flat, Kind::box),
      made("flat_cylinder", SizeClass::flat, Kind::cylinder),
      made("slim_cuboid", SizeClass::slim, Kind::box),
      made("slim_cylinder", SizeClass::slim, Kind::cylinder)};
  return kObjects;
}

const std::array<StudyTarget, kTargetsOfSize>& targets_of(SizeClass size) noexcept {
  static const auto kStanding = on_both_sides(true);
  static const auto kLying = on_both_sides(false);
  return size == SizeClass::slim ? kLying : kStanding;
}

std::vector<StudyTest> study_plan(std::uint64_t seed) {
  constexpr std::uint64_t kStream = 300;
  Random random(seed, kStream);
  std::array<std::size_t, kStudyObjects> order{};
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  shuffle(order, random);
  std::vector<StudyTest> plan;
  for (const std::size_t object : order) {
    std::array<bool, kTestsOfObject> assisted{true, true, false, false};
    shuffle(assisted, random);
    // Of each mode the first test has two targets of one side and one of the other, the second the
    // rest.
    std::array<std::vector<StudyTest>, 2> of_mode;
    for (auto& tests : of_mode) {
      std::array<std::size_t, kPlacements> left{0, 1, 2}, right{3, 4, 5};
      shuffle(left, random);
      shuffle(right, random);
      std::array<std::size_t, kPlacements> first{left[0], left[1], right[0]};
      std::array<std::size_t, kPlacements> second{left[2], right[1], right[2]};
      if (random.uniform() < 0.5) std::swap(first, second);
      shuffle(first, random);
      shuffle(second, random);
      tests = {{object, false, second}, {object, false, first}};
    }
    for (const bool assistance : assisted) {
      auto& tests = of_mode[assistance ? 1 : 0];
      plan.push_back(tests.back());
      plan.back().assistance = assistance;
      tests.pop_back();
    }
  }
  return plan;
}

std::vector<StudyTest> tests_of(std::size_t object, bool assistance, int count,
                                std::uint64_t seed) {
  std::vector<StudyTest> tests;
  for (std::uint64_t plan = seed; tests.size() < static_cast<std::size_t>(count); ++plan)
    for (const StudyTest& test : study_plan(plan))
      if (test.object == object && test.assistance == assistance &&
          tests.size() < static_cast<std::size_t>(count))
        tests.push_back(test);
  return tests;
}

}  // namespace isograsp::virtual_hand
