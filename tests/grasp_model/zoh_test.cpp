// SPDX-License-Identifier: GPL-3.0-or-later
// The exact step of one degree of freedom: golden table and the laws of a linear system.
#include "grasp_model/zoh.hpp"

#include <cmath>

#include "grasp_model/travel.hpp"
#include "tests/grasp_model/support.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::zoh_test {
namespace {

using test::kEpsilon;

TEST(LinearStep, MatchesTheGoldenTableToRounding) {
  const auto rows = test::golden("zoh_1dof.csv");
  ASSERT_GT(rows.size(), 300u);
  for (const auto& row : test::every(rows)) {
    const Oscillator o{row["m_kg"], row["c_Nspm"], row["k_Npm"]};
    const double h = row["h_s"];
    const Motion start{row["x0_m"], row["v0_mps"]};
    const double force = row["F_N"];
    const Motion end = LinearStep(o, h).advance(start, force);
    const Response step = response(o, h);

    const double w = std::sqrt(o.k / o.m);
    const double decay = o.c * h / (2.0 * o.m);
    const bool underdamped = o.c * o.c < 4.0 * o.m * o.k;
    // Two roundings times the condition of the problem: the phase w h is only known to eps w h.
    const double condition = 1.0 + (underdamped ? w * h * std::exp(-decay) : 0.0);
    const double reach = std::min({h * h, o.m / o.k, h * o.m / o.c});
    const double scale = std::max({std::abs(start.x), std::abs(start.v) * std::min(h, 1.0 / w),
                                   std::abs(force / o.m) * reach, std::abs(row["x1_m"])});
    EXPECT_LE(std::abs(end.x - row["x1_m"]), 2.0 * kEpsilon * condition * scale)
        << row.text("case");
    const double rate = std::max(w, o.c / o.m);
    EXPECT_LE(std::abs(end.v - row["v1_mps"]),
              8.0 * kEpsilon * condition *
                  std::max(std::abs(row["v1_mps"]), scale * std::max(rate, 1.0 / h)))
        << row.text("case");
    EXPECT_LE(std::abs(step.P - row["P_s2"]), 3.0 * kEpsilon * condition * std::abs(row["P_s2"]))
        << row.text("case");
    // Relative to the envelope of the oscillation; exp(-x) itself is only good to eps x.
    const double ringing = std::sqrt(std::max(0.0, w * w - 0.25 * o.c * o.c / (o.m * o.m)));
    const double envelope_S =
        underdamped ? std::exp(-decay) * std::min(h, 1.0 / ringing) : std::abs(row["S_s"]);
    const double envelope_Q = std::max(std::abs(row["Q"]), std::exp(-decay) * (1.0 + decay));
    const double exponent = 1.0 + std::min(decay, 750.0);
    EXPECT_LE(std::abs(step.S - row["S_s"]),
              (3.0 * condition + exponent) * kEpsilon * envelope_S + 1e-307)
        << row.text("case");
    EXPECT_LE(std::abs(step.Q - row["Q"]),
              (3.0 * condition + exponent) * kEpsilon * envelope_Q + 1e-307)
        << row.text("case");
  }
}

const std::vector<Oscillator> kOscillators{{0.3, 3, 15},   {0.3, 0, 30},     {0.3, 1, 0},
                                           {0.3, 0, 0},    {0.3, 6, 30},     {3e-4, 6e-3, 0.04},
                                           {0.3, 30, 3e5}, {0.3, 300, 0.01}, {1e-6, 1, 1e3},
                                           {0.0, 2, 30},   {0.0, 3, 0}};

TEST(LinearStep, TwoHalvesMakeAWhole) {
  for (const auto& o : kOscillators) {
    const double h = 0.01;
    const LinearStep half(o, h / 2);
    const LinearStep whole(o, h);
    const Motion once = whole.advance({0.02, -0.1}, 1.5);
    const Motion twice = half.advance(half.advance({0.02, -0.1}, 1.5), 1.5);
    EXPECT_WITHIN(twice.x, once.x, 1e-14 * (1 + std::abs(once.x)));  // a few roundings
    EXPECT_WITHIN(twice.v, once.v, 2e-13 * (1 + std::abs(once.v)));  // times w = 1e3
  }
}

TEST(LinearStep, VolumeOfPhaseSpaceShrinksByTheDamping) {
  for (const auto& o : kOscillators) {
    if (o.m == 0.0) continue;
    const Response step = response(o, 0.01);
    const double determinant = step.R * step.Q + o.k / o.m * step.S * step.S;
    EXPECT_WITHIN(determinant, std::exp(-o.c / o.m * 0.01), 1e-13);
  }
}

TEST(LinearStep, RestUnderAConstantForceStaysAtRest) {
  for (const auto& o : kOscillators) {
    if (o.k == 0.0) continue;
    const double rest = 1.5 / o.k;
    const Motion end = LinearStep(o, 0.01).advance({rest, 0.0}, 1.5);
    EXPECT_WITHIN(end.x, rest, 2 * kEpsilon * rest);
    EXPECT_WITHIN(end.v, 0.0, 1e-12);
  }
}

TEST(LinearStep, EnergyNeverGrowsWithoutForce) {
  for (const auto& o : kOscillators) {
    const auto energy = [&o](const Motion& at) {
      return 0.5 * (o.m * at.v * at.v + o.k * at.x * at.x);
    };
    for (const double h : {1e-6, 1e-3, 0.01, 0.1, 1.0, 100.0}) {
      const Motion start{0.02, o.m == 0.0 ? 0.0 : -0.3};
      const Motion end = LinearStep(o, h).advance(start, 0.0);
      EXPECT_LE(energy(end), energy(start) * (1.0 + 1e-9))
          << o.m << ' ' << o.c << ' ' << o.k << ' ' << h;
    }
  }
}

TEST(LinearStep, ScalingByPowersOfTwoIsExact) {
  for (const auto& o : kOscillators) {
    const Oscillator scaled{8 * o.m, 8 * o.c, 8 * o.k};
    const Motion plain = LinearStep(o, 0.01).advance({0.02, -0.1}, 1.5);
    const Motion same = LinearStep(scaled, 0.01).advance({0.02, -0.1}, 12.0);
    const Motion doubled = LinearStep(o, 0.01).advance({0.04, -0.2}, 3.0);
    EXPECT_EQ(plain.x, same.x);
    EXPECT_EQ(plain.v, same.v);
    EXPECT_EQ(2 * plain.x, doubled.x);
    EXPECT_EQ(2 * plain.v, doubled.v);
  }
}

TEST(LinearStep, WithoutMassTheDamperFollowsTheForceAtOnce) {
  const Oscillator massless{0.0, 2.0, 30.0};
  const Oscillator nearly{1e-9, 2.0, 30.0};
  const Motion a = LinearStep(massless, 0.01).advance({0.02, 0.0}, 1.5);
  const Motion b = LinearStep(nearly, 0.01).advance({0.02, 0.0}, 1.5);
  EXPECT_WITHIN(a.x, b.x, 1e-9);
  EXPECT_WITHIN(a.v, b.v, 1e-6);
}

TEST(LinearStep, AgreesWithTheBenchmarksOfAnotherProgram) {
  // Drake (BSD-3), multibody/benchmarks/mass_damper_spring: closed forms, and for the overdamped
  // case numbers that its authors made with MotionGenesis.
  const double w = 3.0;
  const double wd = w * std::sqrt(1.0 - 0.04);
  const double period_s = 2.0 * 3.14159265358979323846 / wd;
  const Motion undamped = LinearStep({1, 0, 9}, 4.25).advance({3, 0}, 0.0);
  EXPECT_WITHIN(undamped.x, 3.0 * std::cos(3.0 * 4.25), 2e-14);
  const Motion underdamped = LinearStep({1, 1.2, 9}, period_s).advance({3, 0}, 0.0);
  EXPECT_WITHIN(underdamped.x, 3.0 * std::exp(-0.2 * w * period_s), 1e-14);
  EXPECT_WITHIN(underdamped.v, 0.0, 1e-14);
  const Motion critical = LinearStep({1, 6, 9}, 0.25).advance({0, 3}, 0.0);
  EXPECT_WITHIN(critical.x, 3.0 * 0.25 * std::exp(-0.75), 1e-15);
  EXPECT_WITHIN(critical.v, 3.0 * 0.25 * std::exp(-0.75), 1e-15);
  const Motion overdamped = LinearStep({1, 9, 9}, 0.25).advance({0, 3}, 0.0);
  EXPECT_WITHIN(overdamped.x, 0.2730433627750083, 1e-14 * 0.28);
  EXPECT_WITHIN(overdamped.v, 0.1082082477370706, 1e-14 * 0.28);
}

TEST(LinearStep, IsANumberAndStableForEveryMassSpringAndDamper) {
  // omega h in [0, 1e6], zeta in [0, 1e6], m in [1e-6, 1e3].
  const double h = 0.01;
  int cases = 0;
  for (const double m : {1e-6, 1e-3, 0.3, 1e3})
    for (const double turn : {0.0, 1e-9, 1e-4, 0.3, 0.999, 1.0, 1.001, 3.0, 50.0, 1e3, 1e6})
      for (const double zeta :
           {0.0, 1e-12, 0.05, 1.0 - 1e-12, 1.0, 1.0 + 1e-12, 1.5, 30.0, 1e3, 1e6}) {
        const double w = turn / h;
        const Oscillator o{m, 2.0 * zeta * m * (w == 0.0 ? 1.0 / h : w), m * w * w};
        const Motion end = LinearStep(o, h).advance({0.02, -0.3}, 1.5);
        EXPECT_TRUE(std::isfinite(end.x) && std::isfinite(end.v))
            << m << ' ' << turn << ' ' << zeta;
        const Motion free = LinearStep(o, h).advance({0.02, -0.3}, 0.0);
        const auto energy = [&o](const Motion& at) {
          return 0.5 * (o.m * at.v * at.v + o.k * at.x * at.x);
        };
        // The phase is known to eps omega h, and so is what the spring holds.
        EXPECT_LE(energy(free), energy({0.02, -0.3}) * (1.0 + 8 * kEpsilon * (1.0 + turn)));
        ++cases;
      }
  EXPECT_EQ(cases, 4 * 11 * 10);
}

TEST(LinearStep, WithoutDamperTheMotionRunsBackwardsToItsStart) {
  for (const double k : {0.0, 30.0, 3e5, 1e7}) {
    const Oscillator o{0.3, 0.0, k};
    const LinearStep step(o, 0.01);
    const Motion there = step.advance({0.02, -0.1}, 1.5);
    const Motion back = step.advance({there.x, -there.v}, 1.5);
    const double turn = 0.01 * std::sqrt(k / 0.3);
    EXPECT_WITHIN(back.x, 0.02, 8 * kEpsilon * (1.0 + turn) * (0.03 + 1.5 / std::max(k, 50.0)));
  }
}

TEST(AdvanceWithin, FarFromTheStopsItIsTheSameStep) {
  for (const auto& o : kOscillators) {
    const LinearStep step(o, 0.01);
    const Motion free = step.advance({0.02, -0.1}, 1.5);
    const Motion bounded = advance_within(o, step, {-1e6, 1e6}, 0.01, {0.02, -0.1}, 1.5);
    EXPECT_EQ(free.x, bounded.x);
    EXPECT_EQ(free.v, bounded.v);
  }
}

TEST(AdvanceWithin, StopsAtTheCrossingAndRests) {
  for (const auto& o : kOscillators) {
    const Motion end =
        advance_within(o, LinearStep(o, 0.1), {-0.05, 0.05}, 0.1, {0.0499, 0.5}, 1e6);
    EXPECT_EQ(end.x, 0.05);
    EXPECT_EQ(end.v, 0.0);
  }
}

TEST(AdvanceWithin, LeavesTheStopInTheTimeThatIsLeft) {
  // Free mass at 1 m/s, 1 mm before the stop, pushed back by 1 N: stopped after it has come there,
  // then 1 m/s^2 for the rest of the hold.
  const Oscillator o{1.0, 0.0, 0.0};
  const double h = 0.01;
  const double crossing_s = (1.0 - std::sqrt(1.0 - 2.0 * 0.001)) / 1.0;
  const Motion end = advance_within(o, LinearStep(o, h), {-1.0, 1.0}, h, {0.999, 1.0}, -1.0);
  EXPECT_WITHIN(end.x, 1.0 - 0.5 * (h - crossing_s) * (h - crossing_s), 1e-15);
  EXPECT_WITHIN(end.v, -(h - crossing_s), 1e-15);
}

TEST(AdvanceWithin, SeesAnExcursionThatReturnsInsideTheHold) {
  // Ten periods a hold: both ends of the hold are inside, the peak of 1 is not.
  const double h = 1.0;
  const double w = 20.0 * 3.14159265358979323846;
  const Oscillator o{1.0, 0.0, w * w};
  const Motion free = LinearStep(o, h).advance({0.0, w}, 0.0);
  ASSERT_WITHIN(free.x, 0.0, 1e-10);
  const Motion stopped = advance_within(o, LinearStep(o, h), {-10.0, 0.5}, h, {0.0, w}, 0.0);
  const double energy = 0.5 * (stopped.v * stopped.v + w * w * stopped.x * stopped.x);
  // It swings on from rest at 0.5: a quarter of the energy is left.
  EXPECT_WITHIN(energy, 0.25 * 0.5 * w * w, 1e-8 * w * w);
}

TEST(AdvanceWithin, EnergyNeverGrowsAndNothingLeavesTheTravel) {
  for (const auto& o : kOscillators) {
    Motion at{0.03, o.m == 0.0 ? 0.0 : 0.7};
    double before = 0.5 * (o.m * at.v * at.v + o.k * at.x * at.x);
    for (int i = 0; i < 200; ++i) {
      at = advance_within(o, LinearStep(o, 0.007), {-0.01, 0.04}, 0.007, at, 0.0);
      const double energy = 0.5 * (o.m * at.v * at.v + o.k * at.x * at.x);
      EXPECT_LE(energy, before * (1.0 + 1e-9) + 1e-30);
      EXPECT_LE(at.x, 0.04);
      EXPECT_GE(at.x, -0.01);
      before = energy;
    }
  }
}

}  // namespace
}  // namespace isograsp::zoh_test
