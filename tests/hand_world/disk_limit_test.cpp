// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand_world/disk_limit.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "grasp_model/limit_surface.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::disk_limit_test {
namespace {

using namespace isograsp::test;
using namespace isograsp::hand_world;

constexpr double kTorsion = 2.0 / 3.0;
/// Of the root of a function that is flat to half the digits at the tips of the set.
constexpr double kRoot = 1e-7;

DiskLoad on_the_edge(const DiskLimit& limit, double slip) {
  const DiskFriction share = disk_friction(Pressure::uniform, slip);
  return {limit.most_N * share.force, limit.most_N * limit.radius_m * share.torque};
}
DiskLoad scaled(const DiskLoad& load, double by) {
  return {by * load.force, by * load.torque};
}

TEST(DiskLimit, BearsWhatIsWithinTheExactSetAndNothingBeyondIt) {
  constexpr double kJust = 1e-9;
  const DiskLimit limit{2.5, 0.005};
  for (int k = 0; k <= 100; ++k) {
    const DiskLoad edge = on_the_edge(limit, std::tan(0.0155 * k));
    EXPECT_TRUE(limit.bears(scaled(edge, 1.0 - kJust))) << k;
    EXPECT_FALSE(limit.bears(scaled(edge, 1.0 + kJust))) << k;
  }
  EXPECT_TRUE(limit.bears({}));
  EXPECT_FALSE((DiskLimit{0.0, 0.005}.bears({1e-12, 0.0})));
  EXPECT_FALSE((DiskLimit{1.0, 0.0}.bears({0.5, 1e-12}))) << "a point bears no torque";
}

TEST(DiskLimit, ALoadOfTheSetDissipatesAtLeastAsMuchAsAnyOtherLoadOfIt) {
  Random random(7);
  AtLeast seen(1000);
  for (int k = 0; k < 2000; ++k) {
    const DiskLimit limit{0.1 + 5.0 * random.uniform(), 0.001 + 0.04 * random.uniform()};
    const DiskLoad trial{3.0 * limit.most_N * random.uniform(),
                         3.0 * limit.most_N * limit.radius_m * random.uniform()};
    if (limit.bears(trial)) continue;
    ++seen;
    const double per_force = 1.0 + 100.0 * random.uniform();
    const double per_torque = per_force / (limit.radius_m * limit.radius_m) *
                              std::pow(10.0, 4.0 * random.uniform() - 2.0);
    double angle = 1.5 * random.uniform();
    const DiskLoad kept = limit.nearest(trial, per_force, per_torque, angle);
    const double v = per_force * (trial.force - kept.force);
    const double w = per_torque * (trial.torque - kept.torque);
    EXPECT_GE(v, -kRoot * per_force * limit.most_N);
    EXPECT_GE(w, -kRoot * per_torque * limit.most_N * limit.radius_m);
    const double dissipates = v * kept.force + w * kept.torque;
    const double scale = std::hypot(v, w * limit.radius_m) * limit.most_N;
    for (int s = 0; s <= 40; ++s) {
      const DiskLoad other = on_the_edge(limit, std::tan(s * std::numbers::pi / 81.0));
      EXPECT_GE(dissipates, v * other.force + w * other.torque - kRoot * scale) << k;
    }
  }
}

TEST(DiskLimit, PureSlidingAndPureTurningEndAtTheTips) {
  const DiskLimit limit{2.0, 0.01};
  double angle = 0.3;
  const DiskLoad slides = limit.nearest({5.0, 0.0}, 1.0, 1e4, angle);
  EXPECT_EQ(slides.force, 2.0);
  EXPECT_EQ(slides.torque, 0.0);
  constexpr double kRounding = 1e-15;
  const DiskLoad turns = limit.nearest({0.0, 5.0}, 1.0, 1e4, angle);
  EXPECT_EQ(turns.force, 0.0);
  EXPECT_WITHIN(turns.torque, 2.0 * 0.01 * kTorsion, kRounding);
}

TEST(DiskLimit, TheGuessChangesNothingButRounding) {
  constexpr double kGuess = 1e-11;
  const DiskLimit limit{1.0, 0.005};
  double angle = 0.7;
  const DiskLoad from_middle = limit.nearest({1.2, 0.004}, 30.0, 5e5, angle);
  for (const double guess : {0.0, 0.1, angle, 1.5, std::numbers::pi / 2}) {
    double other = guess;
    const DiskLoad load = limit.nearest({1.2, 0.004}, 30.0, 5e5, other);
    EXPECT_WITHIN(load.force, from_middle.force, kGuess);
    EXPECT_WITHIN(load.torque, from_middle.torque, kGuess * limit.radius_m);
  }
}

}  // namespace
}  // namespace isograsp::disk_limit_test
