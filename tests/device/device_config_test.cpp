// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/device_config.hpp"

#include <random>

#include <gtest/gtest.h>

namespace isograsp {
namespace {

constexpr const char* kMinimal = R"(format = "isograsp-device-1"
protocol = "rft"
[[sensor]]
finger = "thumb"
[[sensor]]
finger = "index"
[[sensor]]
finger = "middle"
)";

TEST(DeviceConfig, TheShippedExampleIsTheStandardMap) {
  const auto config =
      RftConfig::read(ISOGRASP_SOURCE_DIR "/library/devices/rft_three_fingers.toml");
  ASSERT_TRUE(config.ok()) << config.error().message();
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    EXPECT_EQ(config->sensors[f].ids.command, kRftIds[f].command);
    EXPECT_EQ(config->sensors[f].ids.first, kRftIds[f].first);
    EXPECT_EQ(config->sensors[f].ids.second, kRftIds[f].second);
    EXPECT_EQ(config->sensors[f].mounting.q_CS.coeffs(), Mounting().q_CS.coeffs());
  }
  EXPECT_EQ(config->filter_Hz, 30.0);
}

TEST(DeviceConfig, WhatIsLeftOutIsStandard) {
  const auto config = RftConfig::parse(kMinimal, "x.toml");
  ASSERT_TRUE(config.ok()) << config.error().message();
  EXPECT_EQ(config->sensors[1].divisors.force_per_N, 50.0);
  EXPECT_EQ(config->sensors[2].divisors.torque_per_Nm, 2000.0);
}

TEST(DeviceConfig, RefusesWhatCannotWork) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = kMinimal;
    text.replace(text.find(from), from.size(), to);
    return RftConfig::parse(text, "x.toml");
  };
  EXPECT_FALSE(with("\"index\"", "\"thumb\"").ok());                               // twice
  EXPECT_FALSE(with("\"index\"", "\"index\"\nfirst_id = 5").ok());                 // first > second
  EXPECT_FALSE(with("\"index\"", "\"index\"\nfirst_id = 1\nsecond_id = 9").ok());  // same as thumb
  EXPECT_FALSE(with("\"index\"", "\"index\"\ncommand_id = 256").ok());
  EXPECT_FALSE(with("\"index\"", "\"index\"\nforce_divisor = 0").ok());
  EXPECT_FALSE(with("\"index\"", "\"index\"\nquaternion_wxyz = [0, 0, 0, 0]").ok());
  EXPECT_FALSE(with("\"index\"", "\"index\"\nserial = 3").ok());  // unknown key
  EXPECT_FALSE(with("\"rft\"", "\"rft\"\nfilter_Hz = 31").ok());
  EXPECT_FALSE(with("[[sensor]]\nfinger = \"index\"\n", "").ok());  // missing
}

TEST(Mounting, PressingIsPositiveByDefault) {
  const Wrench pressing_S{Vec3(1.0, 2.0, -48.0), Vec3(0.1, 0.2, 0.3)};
  const Wrench wrench_C = Mounting().to_contact(pressing_S);
  EXPECT_EQ(wrench_C.force, Vec3(1.0, -2.0, 48.0));
  EXPECT_EQ(wrench_C.torque, Vec3(0.1, -0.2, -0.3));
}

TEST(Mounting, MovesTheTorqueToTheContactPoint) {
  Mounting mounting;
  mounting.q_CS = Quat::Identity();
  mounting.p_SC_S = Vec3(0.0, 0.0, 0.02);
  // A force through the contact point makes a torque about the sensor, none about the contact.
  const Vec3 force(3.0, -1.0, 5.0);
  const Wrench wrench_C = mounting.to_contact({force, mounting.p_SC_S.cross(force)});
  EXPECT_EQ(wrench_C.torque, Vec3::Zero());
}

TEST(Mounting, ConservesPowerAndComesBack) {
  constexpr double kRounding = 1e-13;  // a few dozen products of numbers up to 10
  std::mt19937_64 random(5);
  const auto number = [&] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1.0; };
  const auto vector = [&] { return Vec3(number(), number(), number()); };
  for (int i = 0; i < 1000; ++i) {
    Mounting mounting;
    mounting.q_CS = Quat(number(), number(), number(), number()).normalized();
    mounting.p_SC_S = vector();
    const Wrench wrench_S{10.0 * vector(), vector()};
    const Wrench wrench_C = mounting.to_contact(wrench_S);
    const Wrench back = mounting.to_sensor(wrench_C);
    EXPECT_LT((back.force - wrench_S.force).norm(), kRounding);
    EXPECT_LT((back.torque - wrench_S.torque).norm(), kRounding);
    // The same rigid motion, told at S and at C: v_C = R (v_S + w x p).
    const Vec3 v_S = vector();
    const Vec3 w_S = vector();
    const Vec3 v_C = mounting.q_CS * (v_S + w_S.cross(mounting.p_SC_S));
    const Vec3 w_C = mounting.q_CS * w_S;
    EXPECT_NEAR(wrench_C.force.dot(v_C) + wrench_C.torque.dot(w_C),
                wrench_S.force.dot(v_S) + wrench_S.torque.dot(w_S), kRounding);
  }
}

}  // namespace
}  // namespace isograsp
