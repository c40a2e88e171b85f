// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_hand/capsule.hpp"

#include <gtest/gtest.h>

#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/within.hpp"
#include "tests/virtual_hand/support.hpp"

namespace isograsp::capsule_test {
namespace {

using namespace isograsp::test;
using namespace isograsp::virtual_hand;

ObjectShape shape_in(const Fields& row) {
  if (row.at("shape") == "box") return {ObjectShape::Kind::box, 0.5 * three_in(row, "s", "_m")};
  const double radius_m = 0.5 * number_in(row, "sx_m");
  return {ObjectShape::Kind::cylinder, {radius_m, radius_m, 0.5 * number_in(row, "sy_m")}};
}

TEST(Capsule, DistancesNormalsAndPointsAreThoseOfTheIndependentOracle) {
  constexpr double kDistance_m = 1e-12;  // the table is good to this …
  constexpr double kDeep_m = 1e-9;       // … and where the segment is inside a cylinder to this
  constexpr double kPoint_m = 1e-9;      // a nearest point moves more than its distance
  constexpr double kNormal = 1e-8;
  for (const Fields& row : every(golden_table(hand_data("capsule.csv")))) {
    const Capsule capsule{three_in(row, "a", "_m"), three_in(row, "b", "_m"),
                          number_in(row, "r_m")};
    const CapsuleContact contact = capsule_contact(capsule, shape_in(row));
    const std::string where = row.at("id") + " " + row.at("kind");
    EXPECT_EQ(contact.deep, row.at("deep") == "1") << where;
    EXPECT_WITHIN(contact.distance_m, number_in(row, "distance_m"),
                  contact.deep ? kDeep_m : kDistance_m)
        << where;
    if (contact.deep) continue;
    EXPECT_WITHIN((contact.point - three_in(row, "p", "_m")).norm(), 0.0, kPoint_m) << where;
    if (row.at("normal_unique") == "1") {
      EXPECT_WITHIN((contact.normal - three_in(row, "n")).norm(), 0.0, kNormal) << where;
    }
  }
}

/// Of differences of lengths below 0.2 m.
constexpr double kRounding_m = 1e-15;
/// The depth in a cylinder is the least of a function of one angle: flat there, to half the digits.
constexpr double kDepth_m = 1e-9;

/// A segment anywhere near an object of hand size.
Capsule random_capsule(Random& random) {
  return {random_vector(random, 0.08), random_vector(random, 0.08),
          0.005 + 0.005 * random.uniform()};
}
ObjectShape random_shape(Random& random) {
  const Vec3 half =
      0.003 * Vec3::Ones() + 0.04 * Vec3(random.uniform(), random.uniform(), random.uniform());
  if (random.uniform() < 0.5) return {ObjectShape::Kind::box, half};
  return {ObjectShape::Kind::cylinder, {half.x(), half.x(), half.z()}};
}

TEST(Capsule, NoPointOfTheSegmentIsNearerThanTheDistanceSays) {
  Random random(30);
  AtLeast seen(500);
  for (int k = 0; k < 2000; ++k) {
    const Capsule capsule = random_capsule(random);
    const ObjectShape shape = random_shape(random);
    const CapsuleContact contact = capsule_contact(capsule, shape);
    if (contact.deep) continue;
    ++seen;
    double least_m = 1.0;
    for (int s = 0; s <= 200; ++s) {
      const Vec3 p = capsule.a + s / 200.0 * (capsule.b - capsule.a);
      least_m = std::min(least_m, capsule_contact({p, p, capsule.radius_m}, shape).distance_m);
    }
    // Half a step of samples along at most 0.28 m: the distance changes no faster than the place.
    constexpr double kHalfStep_m = 0.28 / 400.0;
    EXPECT_GE(least_m, contact.distance_m - kRounding_m) << k;
    EXPECT_LE(least_m, contact.distance_m + kHalfStep_m) << k;
  }
}

TEST(Capsule, AfterTheLeastTranslationTheSegmentJustTouches) {
  Random random(31);
  AtLeast seen(100);
  for (int k = 0; k < 4000; ++k) {
    Capsule capsule = random_capsule(random);
    capsule.a *= 0.3;
    const ObjectShape shape = random_shape(random);
    const CapsuleContact contact = capsule_contact(capsule, shape);
    if (!contact.deep) continue;
    ++seen;
    const Vec3 way = (contact.distance_m + capsule.radius_m) * contact.normal;
    const CapsuleContact moved = capsule_contact({capsule.a + way, capsule.b + way, 0.0}, shape);
    EXPECT_NEAR(moved.deep ? 0.0 : moved.distance_m, 0.0, kDepth_m) << k;
  }
}

TEST(Capsule, TheEndsOfASegmentMayChangePlacesAndItsFrameMayTurnAboutTheCylinder) {
  constexpr double kSame_m = 10.0 * kRounding_m;  // turned about the axis
  Random random(32);
  for (int k = 0; k < 1000; ++k) {
    const Capsule capsule = random_capsule(random);
    const ObjectShape shape = random_shape(random);
    const double distance_m = capsule_contact(capsule, shape).distance_m;
    const bool deep = capsule_contact(capsule, shape).deep;
    EXPECT_NEAR(capsule_contact({capsule.b, capsule.a, capsule.radius_m}, shape).distance_m,
                distance_m, deep ? kDepth_m : kSame_m);
    if (shape.kind != ObjectShape::Kind::cylinder) continue;
    const Eigen::AngleAxisd turn(6.3 * random.uniform(), Vec3::UnitZ());
    EXPECT_NEAR(
        capsule_contact({turn * capsule.a, turn * capsule.b, capsule.radius_m}, shape).distance_m,
        distance_m, deep ? kDepth_m : kSame_m);
  }
}

TEST(Capsule, AParallelSegmentTouchesInItsMiddleAndNothingIsAllocated) {
  const ObjectShape box{ObjectShape::Kind::box, {0.04, 0.04, 0.005}};
  const auto before = allocations();
  const CapsuleContact contact =
      capsule_contact({{-0.01, 0.0, 0.02}, {0.03, 0.0, 0.02}, 0.008}, box);
  EXPECT_EQ(allocations(), before);
  constexpr double kMiddle_m = 1e-11;  // slopes below a share of the largest are rounding
  EXPECT_WITHIN(contact.point.x(), 0.01, kMiddle_m);
  EXPECT_WITHIN(contact.distance_m, 0.007, kRounding_m);
}

TEST(Capsule, ASegmentWithoutLengthOnTheAxisOfACylinderHasADepth) {
  const ObjectShape rod{ObjectShape::Kind::cylinder, {0.01, 0.01, 0.05}};
  const CapsuleContact contact = capsule_contact({Vec3::Zero(), Vec3::Zero(), 0.005}, rod);
  EXPECT_TRUE(contact.deep);
  EXPECT_WITHIN(contact.distance_m, -0.015, kRounding_m);
}

}  // namespace
}  // namespace isograsp::capsule_test
