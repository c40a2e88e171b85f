// SPDX-License-Identifier: GPL-3.0-or-later
// Points on a bed of springs: shares of the pressure and the friction of all of them together.
#include "grasp_model/patch/pressed_patch.hpp"

#include <cmath>
#include <fstream>
#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/random.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/within.hpp"

namespace isograsp::pressed_patch_test {
namespace {

using Json = nlohmann::json;

double number(const Json& text) {
  return std::stod(text.get<std::string>());
}

TEST(PressedPatch, IsThatOfTheGoldenCases) {
  std::ifstream in(std::string(ISOGRASP_SOURCE_DIR) + "/tests/data/bimanual/pad_points.json");
  constexpr double kRounding = 1e-12, kTwist = 1e-10, kMedian = 1e-9;
  for (const Json& one : test::every(Json::parse(in)["cases"])) {
    SCOPED_TRACE(one["id"].get<std::string>());
    std::vector<PatchPoint> points;
    double size_m = 1e-6;
    for (const Json& p : one["points"]) {
      points.push_back({{p[0].get<double>(), p[1].get<double>()}, p[2], p[3]});
      size_m = std::max(size_m, points.back().p_m.norm());
    }
    const double friction = one["friction"];
    const PressedPatch patch = test::must(press(points, friction));
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_WITHIN(patch.weights[i], number(one["weights"][i]),
                    kRounding * (1.0 + number(one["weights"][i])));
    EXPECT_EQ(patch.touching.size(), one["touching"].get<std::size_t>());
    EXPECT_WITHIN(patch.centroid_m.x(), number(one["centroid_m"][0]), kRounding * size_m);
    EXPECT_WITHIN(patch.centroid_m.y(), number(one["centroid_m"][1]), kRounding * size_m);
    EXPECT_WITHIN(patch.torsion_m, number(one["torsion_m"]), kRounding * size_m);
    EXPECT_WITHIN(patch.pure_torsion_limit_m, number(one["pure_torsion_limit_m"]),
                  kMedian * size_m);
    for (const Json& twist : one["twists"]) {
      const SlipFriction found = friction_of(
          patch, friction,
          {{twist["twist"][0].get<double>(), twist["twist"][1].get<double>()}, twist["twist"][2]});
      EXPECT_WITHIN(found.force.x(), number(twist["force"][0]), kTwist * friction);
      EXPECT_WITHIN(found.force.y(), number(twist["force"][1]), kTwist * friction);
      EXPECT_WITHIN(found.torque_m, number(twist["torque_m"]), kTwist * friction * size_m);
      EXPECT_WITHIN(found.dissipation, number(twist["dissipation"]),
                    kTwist * (1e-9 + number(twist["dissipation"])));
    }
  }
}

PressedPatch random_patch(Random& random, int count) {
  std::vector<PatchPoint> points;
  for (int i = 0; i < count; ++i)
    points.push_back({{0.01 * random.uniform(), 0.01 * random.uniform()},
                      1e-6 * (0.1 + random.uniform()),
                      1e-3 * (random.uniform() - 0.3)});
  points.front().penetration_m = 1e-3;
  return test::must(press(points, 0.8));
}

TEST(PressedPatch, FrictionDissipatesWhatItWorksAndNeverExceedsTheCone) {
  Random random(8, 2);
  for (int k = 0; k < 1000; ++k) {
    const PressedPatch patch = random_patch(random, 1 + k % 30);
    const SlipTwist slip{{random.uniform() - 0.5, random.uniform() - 0.5},
                         200.0 * (random.uniform() - 0.5)};
    const SlipFriction f = friction_of(patch, 0.8, slip);
    const double work = -(f.force.dot(slip.v_mps) + f.torque_m * slip.w_radps);
    EXPECT_WITHIN(work, f.dissipation, 1e-12 * (1.0 + f.dissipation));
    EXPECT_LE(f.force.norm(), 0.8 * (1.0 + 1e-12));
    EXPECT_LE(std::abs(f.torque_m), patch.torsion_m * (1.0 + 1e-12));
    EXPECT_LE(patch.pure_torsion_limit_m, patch.torsion_m * (1.0 + 1e-12));
  }
}

/// Least over a fine grid cannot be below the median's.
TEST(PressedPatch, TheMedianIsNoFartherThanAnyOtherPlace) {
  Random random(9, 2);
  for (int k = 0; k < 200; ++k) {
    const PressedPatch patch = random_patch(random, 1 + k % 12);
    for (int i = 0; i <= 20; ++i)
      for (int j = 0; j <= 20; ++j)
        EXPECT_LE(patch.pure_torsion_limit_m,
                  0.8 * mean_distance(patch.touching, {0.0005 * i, 0.0005 * j}) * (1.0 + 1e-12));
    for (const PressedPoint& point : patch.touching)
      EXPECT_LE(patch.pure_torsion_limit_m, 0.8 * mean_distance(patch.touching, point.p_m) + 1e-18);
  }
}

TEST(PressedPatch, APatchThatDoesNotTouchOrHasNoAreaIsRefused) {
  EXPECT_FALSE(press({}, 0.8));
  const PatchPoint away[] = {{{0, 0}, 1e-6, 0.0}};
  EXPECT_FALSE(press(away, 0.8));
  const PatchPoint flat[] = {{{0, 0}, 0.0, 1e-3}};
  EXPECT_FALSE(press(flat, 0.8));
  const PatchPoint nowhere[] = {{{std::nan(""), 0}, 1e-6, 1e-3}};
  EXPECT_FALSE(press(nowhere, 0.8));
}

}  // namespace
}  // namespace isograsp::pressed_patch_test
