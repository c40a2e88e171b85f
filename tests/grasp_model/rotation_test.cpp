// SPDX-License-Identifier: GPL-3.0-or-later
// Attitudes and the geodesic spring: golden tables and laws.
#include "grasp_model/rotation.hpp"

#include <cmath>

#include "core/random.hpp"
#include "tests/grasp_model/support.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::so3::rotation_test {
namespace {

double largest(const Vec3& v) {
  return v.cwiseAbs().maxCoeff();
}

TEST(RotationVector, ExponentialAndJacobiansMatchTheGoldenTable) {
  const Vec3 u(0.3, -0.7, 0.2);
  const auto rows = test::golden("so3_exp_jac.csv");
  ASSERT_GT(rows.size(), 70u);
  for (const auto& row : test::every(rows)) {
    const Vec3 phi = row.vec3("phix_rad", "phiy_rad", "phiz_rad");
    const Quat q = exp(phi);
    EXPECT_WITHIN(q.w(), row["qw"], 1e-15);
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
  for (const auto& row : test::every(rows)) {
    const Vec3 phi = log(Quat(row["qw"], row["qx"], row["qy"], row["qz"]));
    const Vec3 reference = row.vec3("phix_rad", "phiy_rad", "phiz_rad");
    EXPECT_LE(largest(phi - reference),
              5e-16 * row["theta_rad"]);  // 3e-16 and the last printed digit
  }
}

TEST(RotationVector, TheShortestTurnTakesOneDirectionToTheOtherAboutAnAxisAcrossBoth) {
  // Rounding of two unit vectors and of the product with a unit quaternion.
  constexpr double kRounding = 2e-15;
  Random random(5);
  const auto direction = [&] {
    return Vec3(random.gaussian(), random.gaussian(), random.gaussian());
  };
  for (int k = 0; k < 20000; ++k) {
    const Vec3 from = direction();
    // Any angle, next to none, next to half a turn, and exactly these.
    const double near = k % 4 == 0 ? 1.0 : std::pow(10.0, -(k % 18)) * (k % 5 != 0);
    const Vec3 to =
        (k % 3 == 0 ? -1.0 : 1.0) * from * (k % 4 == 0 ? 0.0 : 1e3) + near * direction();
    const Quat q = shortest(from, to);
    EXPECT_WITHIN(q.norm(), 1.0, kRounding);
    EXPECT_GE(q.w(), 0.0);
    EXPECT_LE(largest(q * from.normalized() - to.normalized()), kRounding) << k;
    EXPECT_LE(std::abs(q.vec().dot(from.normalized())), kRounding) << k;
    EXPECT_LE(std::abs(q.vec().dot(to.normalized())), kRounding) << k;
  }
  EXPECT_EQ(shortest(Vec3::UnitY(), 3.0 * Vec3::UnitY()).coeffs(), Quat::Identity().coeffs());
  EXPECT_EQ(shortest(Vec3::UnitY(), -Vec3::UnitY()).w(), 0.0);
  EXPECT_WITHIN(shortest(1e-200 * Vec3::UnitX(), 1e200 * Vec3::UnitY()).w(), std::sqrt(0.5),
                kRounding);
}

TEST(RotationVector, JacobianAndItsInverseUndoEachOther) {
  const Vec3 u(0.3, -0.7, 0.2);
  for (const double angle : {0.0, 1e-9, 0.049, 0.051, 1.0, 3.0, 5.0}) {
    const Vec3 phi = angle * Vec3(2, -1, 2) / 3.0;
    EXPECT_LE(largest(jr_inverse(phi, jr(phi, u)) - u), 2e-14);
    const Vec3 v(-0.1, 0.4, 0.8);
    EXPECT_WITHIN(v.dot(jr_inverse(phi, u)), jr_inverse_transpose(phi, v).dot(u), 1e-14);
  }
}

TEST(TorsionSpring, MatchesTheGoldenTable) {
  const auto rows = test::golden("torsion_spring.csv");
  ASSERT_GE(rows.size(), 20u);
  for (const auto& row : test::every(rows)) {
    const Vec3 phi = row.vec3("phix_rad", "phiy_rad", "phiz_rad");
    const Vec3 k = row.vec3("Kx_Nmprad", "Ky_Nmprad", "Kz_Nmprad");
    const Vec3 reference = row.vec3("taux_Nm", "tauy_Nm", "tauz_Nm");
    if (phi.norm() > kSpringReach_rad) continue;
    const Vec3 torque = spring_torque(phi, k);
    EXPECT_LE((torque - reference).norm(), 1e-14 * reference.norm()) << phi.transpose();
    EXPECT_WITHIN(0.5 * phi.dot(k.cwiseProduct(phi)), row["U_J"], 1e-15 * (1.0 + row["U_J"]));
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
    EXPECT_WITHIN(spring_torque(phi, k)[i], -slope, 1e-10);
  }
}

}  // namespace
}  // namespace isograsp::so3::rotation_test
