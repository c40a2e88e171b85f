// SPDX-License-Identifier: GPL-3.0-or-later
// Friction of a disk that slides and turns: golden table, laws, the ellipsoid around it.
#include "grasp_model/limit_surface.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/grasp_model/support.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::limit_surface_test {
namespace {

using test::kEpsilon;

constexpr std::array kPressures{Pressure::uniform, Pressure::hertz};
/// The dissipation at s, M = torque + s force.
double dissipation(Pressure pressure, double s) {
  const auto [force, torque] = disk_friction(pressure, s);
  return torque + s * force;
}

TEST(LimitSurface, AgreesWithTheGoldenDisks) {
  constexpr double kForce = 4e-16;   // what the stable forms reach, of the largest force, 1
  constexpr double kTorque = 1e-15;  // relative, for every slip (asked for: 7e-15 up to 10)
  const auto rows = test::golden("contensou_disk.csv");
  ASSERT_GE(rows.size(), 12u);
  for (const auto& row : test::every(rows)) {
    const double s = row["s_v_over_omegaR"];
    for (const auto pressure : kPressures) {
      const std::string kind = pressure == Pressure::uniform ? "u" : "h";
      const auto [force, torque] = disk_friction(pressure, s);
      EXPECT_WITHIN(force, row["f" + kind + "_over_muN"], kForce) << s << kind;
      const double reference = row["tau" + kind + "_over_muNR"];
      EXPECT_WITHIN(torque, reference, kTorque * reference) << s << kind;
    }
  }
}

TEST(LimitSurface, TurnsOnlyOrSlidesOnlyAtTheEnds) {
  for (const auto pressure : kPressures) {
    const double torsion = disk_torsion_m(pressure, 1.0, 1.0);
    EXPECT_EQ(disk_friction(pressure, 0.0).force, 0.0);
    EXPECT_WITHIN(disk_friction(pressure, 0.0).torque, torsion, kEpsilon);
    const auto slides = disk_friction(pressure, std::numeric_limits<double>::infinity());
    EXPECT_EQ(slides.force, 1.0);
    EXPECT_EQ(slides.torque, 0.0);
    // Slow slip: in proportion; fast slip: torque in inverse proportion. No digit is lost.
    for (const double s : {1e-300, 1e-100, 1e-12}) {
      const double slope = disk_friction(pressure, s).force / s;
      EXPECT_WITHIN(slope, pressure == Pressure::uniform ? 1.0 : 3.0 * std::numbers::pi / 8.0,
                    4.0 * kEpsilon);
      EXPECT_WITHIN(disk_friction(pressure, s).torque, torsion, kEpsilon);
      EXPECT_EQ(disk_friction(pressure, 1.0 / s).force, 1.0);
      // Mean square distance from the middle, 1/2 or 2/5, over 2 s.
      const double mean_square = pressure == Pressure::uniform ? 0.5 : 0.4;
      EXPECT_WITHIN(disk_friction(pressure, 1.0 / s).torque / s, 0.5 * mean_square, 4.0 * kEpsilon);
    }
  }
}

TEST(LimitSurface, ForceIsTheSlopeOfTheDissipation) {
  // Five-point slope: error of the order of h^4 f''''; the curvature of the uniform disk grows as
  // 1/(s - 1)^3 near 1, where half the contact reverses.
  constexpr double kStep = 1e-3;
  constexpr double kSlope = 1e-9;
  for (const auto pressure : kPressures)
    for (const double s : {0.05, 0.3, 0.8, 1.2, 1.9, 2.1, 5.0, 50.0}) {
      const auto M = [&](double at) { return dissipation(pressure, at); };
      const double slope =
          (8.0 * (M(s + kStep) - M(s - kStep)) - (M(s + 2.0 * kStep) - M(s - 2.0 * kStep))) /
          (12.0 * kStep);
      EXPECT_WITHIN(disk_friction(pressure, s).force, slope, kSlope) << s;
    }
}

TEST(LimitSurface, MoreSlipMeansMoreForceAndLessTorque) {
  for (const auto pressure : kPressures) {
    auto before = disk_friction(pressure, 0.0);
    for (double s = 1e-6; s < 1e6; s *= 1.01) {
      const auto now = disk_friction(pressure, s);
      EXPECT_GE(now.force, before.force) << s;
      EXPECT_LE(now.torque, before.torque) << s;
      before = now;
    }
  }
}

TEST(LimitSurface, BranchesMeetWithoutAStep) {
  // Closed form | series at 2, turning | sliding at 1: within rounding and the slope over one step.
  constexpr double kJoint = 16.0 * kEpsilon;
  for (const auto pressure : kPressures)
    for (const double s : {1.0, 2.0}) {
      const auto below = disk_friction(pressure, std::nextafter(s, 0.0));
      const auto at = disk_friction(pressure, s);
      const auto above = disk_friction(pressure, std::nextafter(s, 3.0));
      for (const auto& side : {below, above}) {
        EXPECT_WITHIN(side.force, at.force, kJoint) << s;
        EXPECT_WITHIN(side.torque, at.torque, kJoint) << s;
      }
    }
}

TEST(LimitSurface, LiesJustInsideTheEllipsoid) {
  for (const auto pressure : kPressures) {
    const double torsion = disk_torsion_m(pressure, 1.0, 1.0);
    double deepest = 1.0;
    for (double s = 1e-4; s < 1e4; s *= 1.001) {
      const auto [force, torque] = disk_friction(pressure, s);
      const double rho = std::hypot(force, torque / torsion);
      EXPECT_LE(rho, 1.0 + 4.0 * kEpsilon) << s;
      deepest = std::min(deepest, rho);
    }
    EXPECT_WITHIN(1.0 - deepest, pressure == Pressure::uniform ? 0.066 : 0.060, 0.0005);
  }
}

TEST(LimitSurface, IsThePrincipleOfGreatestDissipation) {
  // No friction on the surface dissipates more at a given slip than the one that acts: convexity.
  for (const auto pressure : kPressures)
    for (double s = 1e-3; s < 1e3; s *= 1.7)
      for (double other = 1e-3; other < 1e3; other *= 1.3) {
        const auto [force, torque] = disk_friction(pressure, other);
        EXPECT_LE(torque + s * force, dissipation(pressure, s) * (1.0 + 8.0 * kEpsilon));
      }
}

TEST(PatchTorsion, OfAFineDiskIsThatOfTheDisk) {
  constexpr double kRadius_m = 0.0075;
  constexpr double kFriction = 0.8;
  constexpr int kRings = 2000;
  // Rings at their middle radius: the error is of the order of 1 / rings^2; the root at the rim of
  // the Hertz pressure leaves 1 / rings^1.5.
  constexpr double kQuadrature = 2e-5;
  for (const auto pressure : kPressures) {
    std::vector<PressedPoint> points;
    double pressed = 0.0;
    for (int i = 0; i < kRings; ++i) {
      const double r = (i + 0.5) / kRings;
      points.push_back({{r * kRadius_m, 0.0},
                        r * (pressure == Pressure::uniform ? 3.0 : std::sqrt(1.0 - r * r))});
      pressed += points.back().share;
    }
    const double disk = disk_torsion_m(pressure, kFriction, kRadius_m);
    EXPECT_WITHIN(kFriction * mean_distance(points, Vec2::Zero()) / pressed, disk,
                  kQuadrature * disk);
  }
  EXPECT_WITHIN(disk_torsion_m(Pressure::uniform, kFriction, kRadius_m), 0.004, 1e-18);
}

}  // namespace
}  // namespace isograsp::limit_surface_test
