// SPDX-License-Identifier: GPL-3.0-or-later
// Hysteresis and friction clamp: golden table and the laws of the clamp.
#include "grasp_model/contact.hpp"

#include <cmath>
#include <random>

#include "tests/grasp_model/support.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::contact_test {
namespace {

using test::kEpsilon;

FrictionLimit limit_of(ContactModel model, double friction, double torsion_m = 0.0) {
  Contact contact;
  contact.model = model;
  contact.friction = friction;
  contact.torsion_m = torsion_m;
  return FrictionLimit(contact);
}

void expect_close(double value, double reference, const std::string& what) {
  EXPECT_LE(std::abs(value - reference), 4 * kEpsilon * std::abs(reference) + 1e-307) << what;
}

TEST(FrictionClamp, MatchesTheGoldenTable) {
  const auto rows = test::golden("friction_clamp.csv");
  ASSERT_GT(rows.size(), 40u);
  for (const auto& row : test::every(rows)) {
    Wrench measured;
    measured.force = row.vec3("fx_N", "fy_N", "fz_N");
    measured.torque.z() = row["tz_Nm"];
    const double mu = row["mu"];
    const double gamma = row["gamma_m"];
    const auto point = clamp_to_friction(limit_of(ContactModel::point, mu), measured);
    expect_close(point.fx, row["rad_x"], "rad_x");
    expect_close(point.fy, row["rad_y"], "rad_y");
    expect_close(point.fz, row["rad_z"], "rad_z");
    EXPECT_EQ(point.tz, 0.0);
    const FrictionLimit limit = limit_of(ContactModel::soft, mu, gamma);
    const auto soft = clamp_to_friction(limit, measured);
    expect_close(soft.fx, row["ell_x"], "ell_x");
    expect_close(soft.fy, row["ell_y"], "ell_y");
    expect_close(soft.fz, row["ell_z"], "ell_z");
    expect_close(soft.tz, row["ell_tz"], "ell_tz");
    // A subnormal limit has no digits left to divide by.
    const bool normal_limit = mu * measured.force.z() > 1e-300;
    if (gamma > 0.0 && normal_limit && std::isfinite(row["utilisation"]))
      expect_close(utilisation(limit, measured), row["utilisation"], "utilisation");
  }
}

TEST(FrictionClamp, IsIdempotentHomogeneousAndNeverMakesForce) {
  std::mt19937_64 random(5);
  const auto uniform = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53 * 2 - 1; };
  const FrictionLimit limit = limit_of(ContactModel::soft, 0.8, 0.004);
  int held = 0;
  for (int i = 0; i < 1000; ++i) {
    Wrench measured{{10 * uniform(), 10 * uniform(), 10 * std::abs(uniform())},
                    {0, 0, 0.1 * uniform()}};
    const ContactForce once = clamp_to_friction(limit, measured);
    const ContactForce twice =
        clamp_to_friction(limit, {{once.fx, once.fy, once.fz}, {0, 0, once.tz}});
    EXPECT_WITHIN(std::hypot(once.fx - twice.fx, once.fy - twice.fy), 0.0, 1e-14);
    EXPECT_WITHIN(once.tz, twice.tz, 1e-15);
    EXPECT_LE(std::hypot(once.fx, once.fy),
              (1.0 + 2.0 * kEpsilon) * measured.force.head<2>().norm());
    EXPECT_LE(std::abs(once.tz), std::abs(measured.torque.z()));
    const ContactForce quadruple =
        clamp_to_friction(limit, {4 * measured.force, 4 * measured.torque});
    EXPECT_EQ(quadruple.fx, 4 * once.fx);
    EXPECT_EQ(quadruple.tz, 4 * once.tz);
    EXPECT_EQ(once.slip, utilisation(limit, measured) > 1.0);
    held += once.slip ? 0 : 1;
  }
  EXPECT_GT(held, 20);
}

TEST(FrictionClamp, MeetsForcesWhoseSquaresAreNoNumbers) {
  const FrictionLimit limit = limit_of(ContactModel::point, 0.5);
  for (const double size : {1e-300, 1e-200, 1e-100, 1e100, 1e200}) {
    const ContactForce inside =
        clamp_to_friction(limit, {{0.3 * size, 0.3 * size, size}, {0, 0, 0}});
    EXPECT_FALSE(inside.slip) << size;
    EXPECT_EQ(inside.fx, 0.3 * size);
    const ContactForce outside =
        clamp_to_friction(limit, {{3.0 * size, 4.0 * size, size}, {0, 0, 0}});
    EXPECT_TRUE(outside.slip) << size;
    EXPECT_WITHIN(outside.fx / size, 0.3, 1e-15);
    EXPECT_WITHIN(outside.fy / size, 0.4, 1e-15);
  }
}

TEST(FrictionClamp, PullingSidewaysWithoutPressingIsNotAGrip) {
  const auto passed = clamp_to_friction(limit_of(ContactModel::point, 0.5), {{5, 0, 0}, {0, 0, 0}});
  EXPECT_EQ(passed.fx, 0.0);
  EXPECT_EQ(passed.fz, 0.0);
}

TEST(FrictionClamp, WithoutFrictionOnlyTheNormalForcePasses) {
  const FrictionLimit none = limit_of(ContactModel::point, 0.0);
  const ContactForce slides = clamp_to_friction(none, {{0.1, 0, 5}, {0, 0, 0}});
  EXPECT_EQ(slides.fx, 0.0);
  EXPECT_EQ(slides.fz, 5.0);
  EXPECT_TRUE(slides.slip);
  EXPECT_EQ(utilisation(none, {{0.1, 0, 5}, {0, 0, 0}}), HUGE_VAL);
  EXPECT_FALSE(clamp_to_friction(none, {{0, 0, 5}, {0, 0, 0}}).slip);
}

TEST(FrictionClamp, EachModelPassesItsOwnColumnsOnly) {
  const Wrench measured{{0.1, 0.2, 5}, {0.01, 0.02, 0.003}};
  const auto passed = [&](ContactModel model, double torsion_m) {
    const ContactForce f = clamp_to_friction(limit_of(model, 0.8, torsion_m), measured);
    EXPECT_FALSE(f.slip);
    return Eigen::Vector4d(f.fx, f.fy, f.fz, f.tz);
  };
  EXPECT_EQ(passed(ContactModel::frictionless, 0.01), Eigen::Vector4d(0, 0, 5, 0));
  EXPECT_EQ(passed(ContactModel::point, 0.01), Eigen::Vector4d(0.1, 0.2, 5, 0));
  EXPECT_EQ(passed(ContactModel::soft, 0.01), Eigen::Vector4d(0.1, 0.2, 5, 0.003));
  EXPECT_EQ(passed(ContactModel::soft, 0.0), Eigen::Vector4d(0.1, 0.2, 5, 0));
}

TEST(ContactHysteresis, NeedsTheThresholdToTouchAndHalfOfItToLetGo) {
  EXPECT_FALSE(TouchRule(0.5).touches(false, 0.5));
  EXPECT_TRUE(TouchRule(0.5).touches(false, 0.5000001));
  EXPECT_TRUE(TouchRule(0.5).touches(true, 0.2500001));
  EXPECT_FALSE(TouchRule(0.5).touches(true, 0.25));
  EXPECT_FALSE(TouchRule(0.0).touches(false, 0.0));
  EXPECT_TRUE(TouchRule(0.0).touches(false, 1e-300));
  EXPECT_FALSE(TouchRule(0.0).touches(true, 0.0));
}

TEST(ContactHysteresis, NoiseBelowHalfTheThresholdDoesNotFlicker) {
  bool on = false;
  int changes = 0;
  for (int i = 0; i < 1000; ++i) {
    const bool now = TouchRule(0.5).touches(on, 0.5 + (i % 2 == 0 ? 0.08 : -0.08));
    changes += now != on ? 1 : 0;
    on = now;
  }
  EXPECT_EQ(changes, 1);
}

}  // namespace
}  // namespace isograsp::contact_test
