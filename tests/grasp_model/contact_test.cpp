// SPDX-License-Identifier: GPL-3.0-or-later
// Hysteresis and friction clamp: golden table and the laws of the clamp.
#include "grasp_model/contact.hpp"

#include <cmath>
#include <random>

#include "tests/grasp_model/support.hpp"

namespace isograsp {
namespace {

using test::kEpsilon;

Contact contact_with(ContactModel model, double friction, double torsion_m = 0.0) {
  Contact contact;
  contact.model = model;
  contact.friction = friction;
  contact.torsion_m = torsion_m;
  return contact;
}

void expect_close(double value, double reference, const std::string& what) {
  EXPECT_LE(std::abs(value - reference), 4 * kEpsilon * std::abs(reference) + 1e-307) << what;
}

TEST(FrictionClamp, MatchesTheGoldenTable) {
  const auto rows = test::golden("friction_clamp.csv");
  ASSERT_GT(rows.size(), 40u);
  for (const auto& row : rows) {
    Wrench measured;
    measured.force = row.vec3("fx_N", "fy_N", "fz_N");
    measured.torque.z() = row["tz_Nm"];
    const double mu = row["mu"];
    const double gamma = row["gamma_m"];
    const auto point = transmit(contact_with(ContactModel::point, mu), measured).F_C;
    expect_close(point.force.x(), row["rad_x"], "rad_x");
    expect_close(point.force.y(), row["rad_y"], "rad_y");
    expect_close(point.force.z(), row["rad_z"], "rad_z");
    EXPECT_EQ(point.torque.z(), 0.0);
    const auto soft = transmit(contact_with(ContactModel::soft, mu, gamma), measured);
    expect_close(soft.F_C.force.x(), row["ell_x"], "ell_x");
    expect_close(soft.F_C.force.y(), row["ell_y"], "ell_y");
    expect_close(soft.F_C.force.z(), row["ell_z"], "ell_z");
    expect_close(soft.F_C.torque.z(), row["ell_tz"], "ell_tz");
    // A subnormal limit has no digits left to divide by.
    const bool normal_limit = mu * measured.force.z() > 1e-300;
    if (gamma > 0.0 && normal_limit && std::isfinite(row["utilisation"]))
      expect_close(soft.utilisation, row["utilisation"], "utilisation");
  }
}

TEST(FrictionClamp, IsIdempotentHomogeneousAndNeverMakesForce) {
  std::mt19937_64 random(5);
  const auto uniform = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53 * 2 - 1; };
  const Contact contact = contact_with(ContactModel::soft, 0.8, 0.004);
  for (int i = 0; i < 1000; ++i) {
    Wrench measured{{10 * uniform(), 10 * uniform(), 10 * std::abs(uniform())},
                    {0, 0, 0.1 * uniform()}};
    const Wrench once = transmit(contact, measured).F_C;
    const Wrench twice = transmit(contact, once).F_C;
    EXPECT_NEAR((once.force - twice.force).norm(), 0.0, 1e-14);
    EXPECT_NEAR(once.torque.z(), twice.torque.z(), 1e-15);
    EXPECT_LE(once.force.norm(), measured.force.norm());
    EXPECT_LE(std::abs(once.torque.z()), std::abs(measured.torque.z()));
    const Wrench doubled = transmit(contact, {4 * measured.force, 4 * measured.torque}).F_C;
    EXPECT_EQ(doubled.force, 4 * once.force);
    EXPECT_EQ(doubled.torque.z(), 4 * once.torque.z());
  }
}

TEST(FrictionClamp, PullingSidewaysWithoutPressingIsNotAGrip) {
  const auto passed = transmit(contact_with(ContactModel::point, 0.5), {{5, 0, 0}, {0, 0, 0}});
  EXPECT_EQ(passed.F_C.force, Vec3::Zero());
}

TEST(FrictionClamp, EachModelPassesItsOwnColumnsOnly) {
  const Wrench measured{{0.1, 0.2, 5}, {0.01, 0.02, 0.003}};
  const auto frictionless = transmit(contact_with(ContactModel::frictionless, 0.8, 0.01), measured);
  EXPECT_EQ(frictionless.F_C.force, Vec3(0, 0, 5));
  EXPECT_EQ(frictionless.F_C.torque, Vec3::Zero());
  EXPECT_FALSE(frictionless.slip());
  const auto point = transmit(contact_with(ContactModel::point, 0.8, 0.01), measured);
  EXPECT_EQ(point.F_C.force, measured.force);
  EXPECT_EQ(point.F_C.torque, Vec3::Zero());
  const auto soft = transmit(contact_with(ContactModel::soft, 0.8, 0.01), measured);
  EXPECT_EQ(soft.F_C.torque, Vec3(0, 0, 0.003));
  EXPECT_LT(soft.utilisation, 1.0);
  const auto rigid = transmit(contact_with(ContactModel::soft, 0.8, 0.0), measured);
  EXPECT_EQ(rigid.F_C.torque, Vec3::Zero());
  EXPECT_EQ(rigid.F_C.force, measured.force);
}

TEST(ContactHysteresis, NeedsTheThresholdToTouchAndHalfOfItToLetGo) {
  EXPECT_FALSE(in_contact(false, 0.5, 0.5));
  EXPECT_TRUE(in_contact(false, 0.5000001, 0.5));
  EXPECT_TRUE(in_contact(true, 0.2500001, 0.5));
  EXPECT_FALSE(in_contact(true, 0.25, 0.5));
  EXPECT_FALSE(in_contact(false, 0.0, 0.0));
  EXPECT_TRUE(in_contact(false, 1e-300, 0.0));
  EXPECT_FALSE(in_contact(true, 0.0, 0.0));
}

TEST(ContactHysteresis, NoiseBelowHalfTheThresholdDoesNotFlicker) {
  bool on = false;
  int changes = 0;
  for (int i = 0; i < 1000; ++i) {
    const bool now = in_contact(on, 0.5 + (i % 2 == 0 ? 0.08 : -0.08), 0.5);
    changes += now != on ? 1 : 0;
    on = now;
  }
  EXPECT_EQ(changes, 1);
}

}  // namespace
}  // namespace isograsp
