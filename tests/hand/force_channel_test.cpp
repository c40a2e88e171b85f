// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand/force_channel.hpp"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::force_channel_test {
namespace {

std::vector<ForceChannel> all_channels() {
  std::vector<ForceChannel> channels;
  for (int digits = 0; digits <= static_cast<int>(Digits::middle); ++digits)
    for (std::size_t direction = 0; direction < kDirectionCount; ++direction)
      channels.push_back({static_cast<Digits>(digits), static_cast<Direction>(direction)});
  return channels;
}

FingerWrenches random_forces(std::uint64_t seed) {
  Random random(seed, 1);
  FingerWrenches wrench_C;
  for (Wrench& w : wrench_C) {
    w.torque = Vec3::Zero();
    w.force = Vec3(random.gaussian(), random.gaussian(), random.gaussian());
  }
  return wrench_C;
}

FingerWrenches scaled(FingerWrenches wrench_C, double factor) {
  for (Wrench& w : wrench_C) w.force *= factor;
  return wrench_C;
}

TEST(ForceChannel, NamesAreUniqueAndReadBackToTheSameChannel) {
  std::set<std::string> names;
  for (const ForceChannel channel : test::every(all_channels())) {
    names.insert(name_of(channel));
    EXPECT_EQ(force_channel_from_name(name_of(channel)), channel) << name_of(channel);
  }
  EXPECT_EQ(names.size(), all_channels().size());
  EXPECT_FALSE(force_channel_from_name("ring"));
  EXPECT_EQ(name_of({Digits::grip, Direction::minus_z}), "opening");
  EXPECT_EQ(name_of({Digits::thumb, Direction::minus_x}), "thumb_-x");
}

TEST(ForceChannel, TheForceGrowsInProportionToTheForcesOfTheDigits) {
  constexpr double kRounding = 1e-12;
  for (const ForceChannel channel : test::every(all_channels())) {
    const FingerWrenches forces = random_forces(7);
    EXPECT_WITHIN(force_of(scaled(forces, 2.5), channel), 2.5 * force_of(forces, channel),
                  kRounding);
  }
}

TEST(ForceChannel, AGripIsTheWeakerSideWhetherItClosesOrOpens) {
  FingerWrenches wrench_C = scaled(random_forces(1), 0.0);
  wrench_C[0].force.z() = 5.0;
  wrench_C[1].force.z() = 2.0;
  wrench_C[2].force.z() = 1.5;
  EXPECT_DOUBLE_EQ(force_of(wrench_C, {}), 3.5);
  EXPECT_DOUBLE_EQ(force_of(wrench_C, {Digits::grip_mean}), 4.25);
  EXPECT_DOUBLE_EQ(force_of(wrench_C, {Digits::pinch}), 2.0);
  EXPECT_DOUBLE_EQ(force_of(wrench_C, {Digits::sum}), 8.5);
  EXPECT_DOUBLE_EQ(force_of(scaled(wrench_C, -1.0), {Digits::grip, Direction::minus_z}), 3.5);
  EXPECT_LT(force_of(wrench_C, {Digits::grip, Direction::minus_z}), 0.0) << "closing opens nothing";
}

TEST(ForceChannel, ASingleDigitIsItsForceAlongTheAxis) {
  const FingerWrenches forces = random_forces(3);
  for (const Finger finger : kFingers)
    for (std::size_t d = 0; d < kDirectionCount; ++d) {
      const ForceChannel channel = channel_of(finger, static_cast<Direction>(d));
      EXPECT_EQ(single_digit(channel), finger);
      EXPECT_DOUBLE_EQ(force_of(forces, channel),
                       forces[index_of(finger)].force.dot(axis_of(channel.direction)));
    }
  EXPECT_FALSE(single_digit({Digits::pinch}));
}

TEST(ForceChannel, TheNoiseOfASumIsThatOfIndependentParts) {
  const std::array<Vec3, kFingerCount> sd_N{Vec3::Constant(0.1), Vec3::Constant(0.3),
                                            Vec3::Constant(0.4)};
  EXPECT_DOUBLE_EQ(noise_of(sd_N, {Digits::grip}), 0.5);
  EXPECT_DOUBLE_EQ(noise_of(sd_N, {Digits::pinch}), 0.3);
  EXPECT_DOUBLE_EQ(noise_of(sd_N, {Digits::middle, Direction::minus_x}), 0.4);
  EXPECT_DOUBLE_EQ(noise_of(sd_N, {Digits::sum}), std::sqrt(0.01 + 0.09 + 0.16));
}

}  // namespace
}  // namespace isograsp::force_channel_test
