// SPDX-License-Identifier: GPL-3.0-or-later
// Attitudes and the integrator of three rotations: golden tables, conservation, order.
#include "grasp_model/rotation.hpp"

#include <cmath>

#include "tests/grasp_model/support.hpp"

namespace isograsp::so3 {
namespace {

double largest(const Vec3& v) {
  return v.cwiseAbs().maxCoeff();
}

TEST(RotationVector, ExponentialAndJacobiansMatchTheGoldenTable) {
  const Vec3 u(0.3, -0.7, 0.2);
  const auto rows = test::golden("so3_exp_jac.csv");
  ASSERT_GT(rows.size(), 70u);
  for (const auto& row : rows) {
    const Vec3 phi = row.vec3("phix_rad", "phiy_rad", "phiz_rad");
    const Quat q = exp(phi);
    EXPECT_NEAR(q.w(), row["qw"], 1e-15);
    EXPECT_LE(largest(q.vec() - row.vec3("qx", "qy", "qz")), 1e-15);
    const Mat3 R = q.toRotationMatrix();
    Mat3 reference;
    reference << row["R00"], row["R01"], row["R02"], row["R10"], row["R11"], row["R12"], row["R20"],
        row["R21"], row["R22"];
    EXPECT_LE((R - reference).cwiseAbs().maxCoeff(), 1e-15);
    EXPECT_LE(largest(jr(phi, u) - row.vec3("Jru_x", "Jru_y", "Jru_z")), 1e-15);
    // The inverse has a pole at 2 pi: the rounding of |phi| grows with the square of its nearness.
    const double gap = 2.0 * 3.14159265358979323846 - phi.norm();
    const double tolerance = std::min(2e-13, 2e-15 * (1.0 + 2.0 / (gap * gap)));
    EXPECT_LE(largest(jr_inverse(phi, u) - row.vec3("Jrinvu_x", "Jrinvu_y", "Jrinvu_z")), tolerance)
        << phi.norm();
  }
}

TEST(RotationVector, LogarithmMatchesTheGoldenTable) {
  const auto rows = test::golden("so3_log.csv");
  ASSERT_GT(rows.size(), 70u);
  for (const auto& row : rows) {
    const Vec3 phi = log(Quat(row["qw"], row["qx"], row["qy"], row["qz"]));
    const Vec3 reference = row.vec3("phix_rad", "phiy_rad", "phiz_rad");
    EXPECT_LE(largest(phi - reference),
              5e-16 * row["theta_rad"]);  // 3e-16 and the last printed digit
  }
}

TEST(RotationVector, JacobianAndItsInverseUndoEachOther) {
  const Vec3 u(0.3, -0.7, 0.2);
  for (const double angle : {0.0, 1e-9, 0.049, 0.051, 1.0, 3.0, 5.0}) {
    const Vec3 phi = angle * Vec3(2, -1, 2) / 3.0;
    EXPECT_LE(largest(jr_inverse(phi, jr(phi, u)) - u), 2e-14);
    const Vec3 v(-0.1, 0.4, 0.8);
    EXPECT_NEAR(v.dot(jr_inverse(phi, u)), jr_inverse_transpose(phi, v).dot(u), 1e-14);
  }
}

TEST(TorsionSpring, MatchesTheGoldenTable) {
  const auto rows = test::golden("torsion_spring.csv");
  ASSERT_GE(rows.size(), 20u);
  for (const auto& row : rows) {
    const Vec3 phi = row.vec3("phix_rad", "phiy_rad", "phiz_rad");
    const Vec3 k = row.vec3("Kx_Nmprad", "Ky_Nmprad", "Kz_Nmprad");
    const Vec3 reference = row.vec3("taux_Nm", "tauy_Nm", "tauz_Nm");
    if (phi.norm() > kSpringReach_rad) continue;
    const Vec3 torque = spring_torque(phi, k);
    EXPECT_LE((torque - reference).norm(), 1e-14 * reference.norm()) << phi.transpose();
    EXPECT_NEAR(0.5 * phi.dot(k.cwiseProduct(phi)), row["U_J"], 1e-15 * (1.0 + row["U_J"]));
  }
}

TEST(TorsionSpring, IsTheGradientOfItsEnergy) {
  const Vec3 k(0.05, 0.1, 0.3);
  const Vec3 phi(0.5, -1.2, 0.8);
  const auto energy = [&k](const Quat& q) {
    const Vec3 at = log(q);
    return 0.5 * at.dot(k.cwiseProduct(at));
  };
  for (Eigen::Index i = 0; i < 3; ++i) {
    constexpr double kStep = 1e-5;
    const Vec3 d = kStep * Vec3::Unit(i);
    const double slope = (energy(exp(phi) * exp(d)) - energy(exp(phi) * exp(-d))) / (2 * kStep);
    EXPECT_NEAR(spring_torque(phi, k)[i], -slope, 1e-10);
  }
}

/// As the plan does it: holds of `hold_s`, each divided by its own rate.
bool turn(const Body& body, const Torques& torques, double time_s, double hold_s, Spin& spin) {
  bool exceeded = false;
  const int holds = static_cast<int>(std::lround(time_s / hold_s));
  for (int i = 0; i < holds; ++i) {
    const Division division = divide(fastest_rate(body, torques, spin, hold_s), hold_s);
    exceeded = exceeded || division.tolerance_exceeded;
    for (int j = 0; j < division.substeps; ++j)
      (division.implicit ? implicit_step : rkmk4)(body, torques, hold_s / division.substeps, spin);
    spin.q_WO.normalize();
  }
  return exceeded;
}

TEST(ThreeRotations, MatchTheGoldenMotions) {
  for (const auto& row : test::golden("rotation_dynamics.csv")) {
    const Body body{row.vec3("Ix_kgm2", "Iy", "Iz"), row.vec3("Cx_Nmsprad", "Cy", "Cz"),
                    row.vec3("Kx_Nmprad", "Ky", "Kz")};
    const Torques torques{row.vec3("tauwx_Nm", "tauwy", "tauwz"),
                          row.vec3("taubx_Nm", "tauby", "taubz")};
    Spin spin{exp(row.vec3("phi0x_rad", "phi0y", "phi0z")), row.vec3("w0x_radps", "w0y", "w0z")};
    EXPECT_FALSE(turn(body, torques, row["T_s"], 0.01, spin)) << row.text("case");
    const Vec3 w = row.vec3("wx_radps", "wy", "wz");
    // A hundredth of what one LSB of the sensor does in one frame (3e-4 rad).
    constexpr double kAngle_rad = 3e-6;
    const Quat q(row["qw"], row["qx"], row["qy"], row["qz"]);
    EXPECT_LE((spin.q_WO.coeffs() - q.coeffs()).norm(), kAngle_rad) << row.text("case");
    EXPECT_LE((spin.w_O - w).norm(),
              1e-5 * (w.norm() + row.vec3("w0x_radps", "w0y", "w0z").norm() + 1.0))
        << row.text("case");
  }
}

const Body kUneven{Vec3(1e-4, 2e-4, 3e-4), Vec3::Zero(), Vec3(0.02, 0.05, 0.1)};
const Spin kTumbling{exp(Vec3(1.2, 0.8, -1.0)), Vec3(1.0, -2.0, 0.5)};

TEST(ThreeRotations, TheIntegratorIsOfOrderFour) {
  const auto after = [](int steps) {
    Spin spin = kTumbling;
    for (int i = 0; i < steps; ++i) rkmk4(kUneven, {}, 0.2 / steps, spin);
    return spin;
  };
  const Spin exact = after(4096);
  const auto error = [&](int steps) {
    const Spin spin = after(steps);
    return (spin.q_WO.coeffs() - exact.q_WO.coeffs()).norm() + 1e-2 * (spin.w_O - exact.w_O).norm();
  };
  for (const int steps : {32, 64, 128}) {
    const double order = std::log2(error(steps) / error(2 * steps));
    EXPECT_GT(order, 3.7);
    EXPECT_LT(order, 4.3);
  }
}

TEST(ThreeRotations, WithoutTorqueEnergyAndMomentumStay) {
  const Body body{Vec3(1e-4, 2e-4, 3e-4), Vec3::Zero(), Vec3::Zero()};
  Spin spin{Quat::Identity(), Vec3(0.01, 10.0, 0.0)};
  const auto energy = [&] { return 0.5 * spin.w_O.dot(body.inertia_kg_m2.cwiseProduct(spin.w_O)); };
  const auto momentum = [&]() -> Vec3 {
    return spin.q_WO * body.inertia_kg_m2.cwiseProduct(spin.w_O);
  };
  const double energy_before = energy();
  const Vec3 momentum_before = momentum();
  turn(body, {}, 60.0, 0.01, spin);
  EXPECT_NEAR(energy() / energy_before, 1.0, 1e-7);
  EXPECT_LE((momentum() - momentum_before).norm(), 1e-7 * momentum_before.norm());
}

TEST(ThreeRotations, ASpringKeepsItsEnergyAndADamperTakesIt) {
  const auto energy = [](const Body& body, const Spin& spin) {
    const Vec3 phi = log(spin.q_WO);
    return 0.5 * spin.w_O.dot(body.inertia_kg_m2.cwiseProduct(spin.w_O)) +
           0.5 * phi.dot(body.stiffness.cwiseProduct(phi));
  };
  Spin spin = kTumbling;
  const double before = energy(kUneven, spin);
  turn(kUneven, {}, 60.0, 0.01, spin);
  EXPECT_NEAR(energy(kUneven, spin) / before, 1.0,
              1e-4);  // the fastest mode turns 2,000 rad in 60 s

  Body damped = kUneven;
  damped.damping = Vec3(1e-4, 2e-4, 3e-4);
  spin = kTumbling;
  double last = before;
  for (int i = 0; i < 500; ++i) {
    turn(damped, {}, 0.01, 0.01, spin);
    const double now = energy(damped, spin);
    EXPECT_LE(now, last * (1.0 + 1e-9));
    last = now;
  }
}

TEST(ThreeRotations, TurningTheWorldTurnsTheMotion) {
  const Quat g = exp(Vec3(0.4, 1.1, -0.3));
  Body body{Vec3(1e-4, 2e-4, 3e-4), Vec3::Constant(1e-3), Vec3::Zero()};
  Spin plain = kTumbling;
  Spin turned{g * kTumbling.q_WO, kTumbling.w_O};
  const Vec3 torque(0.01, -0.02, 0.005);
  turn(body, {torque, Vec3::Zero()}, 0.5, 0.01, plain);
  turn(body, {g * torque, Vec3::Zero()}, 0.5, 0.01, turned);
  EXPECT_LE(((g * plain.q_WO).coeffs() - turned.q_WO.coeffs()).norm(), 1e-12);
  EXPECT_LE((plain.w_O - turned.w_O).norm(), 1e-11);
}

TEST(ThreeRotations, HowEverStiffNothingDivergesAndTheFlagTells) {
  for (const double rate : {1e3, 1e4, 1e5, 1e7, 1e10}) {
    for (const bool spring : {false, true}) {
      const double I = 1e-4;
      const Vec3 damping = Vec3::Constant(spring ? 0.0 : rate * I);
      const Vec3 stiffness = Vec3(1, 2, 3) * (spring ? rate * rate * I : 0.0);
      const Body body{Vec3(1, 2, 3) * I, damping, stiffness};
      Spin spin{exp(Vec3(0.01, 0.02, -0.01)), Vec3(1.0, -2.0, 0.5)};
      const double energy = 0.5 * spin.w_O.dot(body.inertia_kg_m2.cwiseProduct(spin.w_O)) +
                            0.5 * 6e-4 * stiffness.maxCoeff();
      const bool exceeded = turn(body, {}, 1.0, 0.01, spin);
      EXPECT_TRUE(spin.w_O.allFinite());
      EXPECT_LE(0.5 * spin.w_O.dot(body.inertia_kg_m2.cwiseProduct(spin.w_O)), energy * 1.01);
      EXPECT_EQ(exceeded, rate * 0.01 > kSubstep_rad * kMostSubsteps) << rate << spring;
    }
  }
}

TEST(ThreeRotations, WithoutInertiaTheDamperFollowsTheTorqueAtOnce) {
  const Body massless{Vec3::Zero(), Vec3(1e-3, 2e-3, 3e-3), Vec3(0.01, 0.02, 0.01)};
  Body light = massless;
  light.inertia_kg_m2 = Vec3::Constant(1e-8);
  const Torques torques{Vec3(0.002, 0, 0.001), Vec3::Zero()};
  Spin a;
  Spin b;
  turn(massless, torques, 0.2, 0.01, a);
  for (int i = 0; i < 400000; ++i) rkmk4(light, torques, 0.2 / 400000, b);
  EXPECT_LE((a.q_WO.coeffs() - b.q_WO.coeffs()).norm(), 1e-5);
}

}  // namespace
}  // namespace isograsp::so3
