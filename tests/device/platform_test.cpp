// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/config/platform.hpp"

#include <random>

#include <gtest/gtest.h>

#include "tests/support/within.hpp"

namespace isograsp::platform_test {
namespace {

constexpr double kRounding = 1e-14;  // a few products of numbers up to 10

TEST(NetWrench, IsZeroForFingersThatOnlySqueeze) {
  const Platform platform;
  FingerWrenches wrench_C{};
  wrench_C[0].force.z() = 8.0;
  wrench_C[1].force.z() = 4.0;
  wrench_C[2].force.z() = 4.0;
  const Wrench net = net_wrench(platform, wrench_C);
  EXPECT_LT(net.force.norm(), kRounding);
  EXPECT_LT(net.torque.norm(), kRounding);
}

TEST(NetWrench, OfAnArmThatPushesIsThePush) {
  // The same force at every pad, told in the axes of each contact.
  const Platform platform;
  const Vec3 push_P(1.0, -2.0, 3.0);
  FingerWrenches wrench_C{};
  for (std::size_t f = 0; f < kFingerCount; ++f)
    wrench_C[f].force = platform.supports[f].R_PC.transpose() * push_P;
  EXPECT_LT((net_wrench(platform, wrench_C).force - 3.0 * push_P).norm(), kRounding);
}

TEST(NetWrench, DoesTheWorkOfAllFingers) {
  std::mt19937_64 random(3);
  const auto number = [&] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1.0; };
  const auto vector = [&] { return Vec3(number(), number(), number()); };
  for (int i = 0; i < 1000; ++i) {
    Platform platform;
    FingerWrenches wrench_C{};
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      platform.supports[f].p_PC = vector();
      platform.supports[f].R_PC =
          Quat(number(), number(), number(), number()).normalized().toRotationMatrix();
      wrench_C[f] = {vector(), vector()};
    }
    // A rigid motion of the platform: velocity of the origin and angular velocity, in P.
    const Vec3 v = vector();
    const Vec3 w = vector();
    double power = 0.0;
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      const Support& s = platform.supports[f];
      power += wrench_C[f].force.dot(s.R_PC.transpose() * (v + w.cross(s.p_PC))) +
               wrench_C[f].torque.dot(s.R_PC.transpose() * w);
    }
    const Wrench net = net_wrench(platform, wrench_C);
    EXPECT_WITHIN(net.force.dot(v) + net.torque.dot(w), power, 100 * kRounding);
  }
}

TEST(CentreOfPressure, IsWhereASingleForceActs) {
  const Vec3 place(0.003, -0.002, 0.0);
  const Vec3 force(0.4, -0.3, 6.0);
  const auto found = centre_of_pressure({force, place.cross(force)});
  ASSERT_TRUE(found);
  EXPECT_WITHIN(found->x(), place.x(), 1e-16);
  EXPECT_WITHIN(found->y(), place.y(), 1e-16);
}

TEST(CentreOfPressure, IsNotToldForLightOrPullingFingers) {
  for (const double z_N : {-5.0, 0.0, 1.0, 2.0})
    EXPECT_FALSE(centre_of_pressure({Vec3(0, 0, z_N), Vec3::Zero()})) << z_N;
  EXPECT_TRUE(centre_of_pressure({Vec3(0, 0, 2.01), Vec3::Zero()}));
  EXPECT_FALSE(centre_of_pressure({Vec3::Constant(std::nan("")), Vec3::Zero()}));
}

}  // namespace
}  // namespace isograsp::platform_test
