// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/config/device_config.hpp"

#include <filesystem>
#include <random>

#include <gtest/gtest.h>

#include "device/config/ati_sensor.hpp"
#include "device/config/jr3_sensor.hpp"
#include "device/config/net_ft_sensor.hpp"
#include "device/config/rft_sensor.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/within.hpp"

namespace isograsp::device_config_test {
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
      DeviceConfig::read(ISOGRASP_SOURCE_DIR "/library/devices/rft_three_fingers.toml");
  ASSERT_TRUE(config.ok()) << config.error().message();
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const RftIds& ids = config->sensors[f].as<RftSensor>().ids;
    EXPECT_EQ(ids.command, kRftIds[f].command);
    EXPECT_EQ(ids.first, kRftIds[f].first);
    EXPECT_EQ(ids.second, kRftIds[f].second);
    EXPECT_EQ(config->sensors[f].mounting.q_CS.coeffs(), Mounting().q_CS.coeffs());
  }
  EXPECT_EQ(config->filter_Hz, 30.0);
}

TEST(DeviceConfig, WhatIsLeftOutIsStandard) {
  const auto config = DeviceConfig::parse(kMinimal, "x.toml");
  ASSERT_TRUE(config.ok()) << config.error().message();
  EXPECT_EQ(config->sensors[1].as<RftSensor>().divisors.force_per_N, 50.0);
  EXPECT_EQ(config->sensors[2].as<RftSensor>().divisors.torque_per_Nm, 2000.0);
}

TEST(DeviceConfig, RefusesWhatCannotWork) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = kMinimal;
    text.replace(text.find(from), from.size(), to);
    return DeviceConfig::parse(text, "x.toml");
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

TEST(DeviceConfig, EveryShippedFileIsGood) {
  int files = 0;
  for (const auto& entry :
       test::every(std::filesystem::directory_iterator(ISOGRASP_SOURCE_DIR "/library/devices"))) {
    if (entry.path().extension() != ".toml") continue;
    const auto config = DeviceConfig::read(entry.path().string());
    EXPECT_TRUE(config.ok()) << config.error().message();
    ++files;
  }
  EXPECT_GE(files, 5);
}

/// A device file of this protocol with these lines at the top and in the index finger's sensor.
Result<DeviceConfig> with(const std::string& protocol, const std::string& top,
                          const std::string& index, const std::string& file = "x.toml") {
  return DeviceConfig::parse("format = \"isograsp-device-1\"\nprotocol = \"" + protocol + "\"\n" +
                                 top + "\n[[sensor]]\nfinger = \"thumb\"\n[[sensor]]\n" +
                                 "finger = \"index\"\n" + index +
                                 "\n[[sensor]]\nfinger = \"middle\"\n",
                             file);
}

TEST(DeviceConfig, EveryProtocolHasItsOwnKeys) {
  const auto ati = with("ati-netcanoem", "hand = \"left\"", "base_id = 0x30\ncalibration_slot = 3");
  ASSERT_TRUE(ati.ok()) << ati.error().message();
  EXPECT_EQ(ati->hand, Hand::left);
  EXPECT_EQ(ati->sensors[1].as<AtiSensor>().base, 0x30);
  EXPECT_EQ(ati->sensors[1].as<AtiSensor>().calibration, 3);
  const auto jr3 = with("jr3-can", "filter_Hz = 125", "node = 9");
  ASSERT_TRUE(jr3.ok()) << jr3.error().message();
  EXPECT_EQ(jr3->filter_Hz, 125.0);
  EXPECT_EQ(jr3->sensors[1].as<Jr3Sensor>().node, 9);
  const auto box = with("net-ft", "rate_Hz = 500\nfir_taps = 33", "address = \"10.0.0.7\"");
  ASSERT_TRUE(box.ok()) << box.error().message();
  EXPECT_EQ(box->fir_taps, 33);
  EXPECT_EQ(box->sensors[1].as<NetFtSensor>().host, "10.0.0.7");
  const auto mounted = with("rft", "", "sign = -1\nsupport_position_m = [0.03, 0, 0]");
  ASSERT_TRUE(mounted.ok()) << mounted.error().message();
  EXPECT_EQ(mounted->sensors[1].mounting.sign, -1.0);
  EXPECT_EQ(mounted->platform.supports[1].p_PC, Vec3(0.03, 0, 0));

  EXPECT_FALSE(with("rft", "", "node = 9").ok()) << "a key of another protocol";
  EXPECT_FALSE(with("ati-netcanoem", "", "base_id = 0x20").ok()) << "the thumb has it";
  EXPECT_FALSE(with("ati-netcanoem", "", "calibration_slot = 16").ok());
  EXPECT_FALSE(with("ati-netcanoem", "filter_Hz = 30", "").ok()) << "the board has none";
  EXPECT_FALSE(with("jr3-can", "", "node = 128").ok());
  EXPECT_FALSE(with("jr3-can", "filter_Hz = 700", "").ok());
  EXPECT_FALSE(with("jr3-can", "", "serial_number = \"1\"").ok()) << "the adaptor tells none";
  EXPECT_FALSE(with("net-ft", "", "address = \"box.clinic\"").ok()) << "names are refused";
  EXPECT_FALSE(with("rft", "rate_Hz = 120", "").ok());
  EXPECT_FALSE(with("rft", "rate_Hz = 500\nfir_taps = 32", "").ok()) << "even";
  EXPECT_FALSE(with("rft", "rate_Hz = 100\nfir_taps = 33\nfir_cutoff_Hz = 60", "").ok());
  EXPECT_FALSE(with("rft", "hand = \"middle\"", "").ok());
  EXPECT_FALSE(with("rft", "", "sign = 0").ok());
  EXPECT_FALSE(with("rft", "", "support_normal = [1, 0, 0]\nsupport_tangent = [2, 0, 0]").ok());
}

constexpr const char* kCalibration = R"(format = "isograsp-calibration-1"
serial_number = "A-17"
date = "2026-03-05"
fx = [1.01, 0, 0, 0, 0, 0]
fy = [0, 0.99, 0, 0, 0, 0]
fz = [0.02, 0, 1.0, 0, 0, 0]
tx = [0, 0, 0, 1, 0, 0]
ty = [0, 0, 0, 0, 1, 0]
tz = [0, 0, 0, 0, 0, 1]
)";

TEST(DeviceConfig, ACalibrationBelongsToOneSensor) {
  const test::TemporaryFolder folder;
  folder.write("a17.toml", kCalibration);
  const auto file = folder.path("device.toml");
  const auto right =
      with("rft", "", "serial_number = \"A-17\"\ncalibration_file = \"a17.toml\"", file);
  ASSERT_TRUE(right.ok()) << right.error().message();
  EXPECT_EQ(right->sensors[1].calibration->matrix(2, 0), 0.02);
  const auto other =
      with("rft", "", "serial_number = \"A-18\"\ncalibration_file = \"a17.toml\"", file);
  ASSERT_FALSE(other.ok());
  EXPECT_NE(other.error().message().find("was made with sensor A-17, but this one is A-18"),
            std::string::npos);
  EXPECT_FALSE(with("rft", "", "calibration_file = \"a17.toml\"", file).ok());
  EXPECT_FALSE(
      with("rft", "", "serial_number = \"A-17\"\ncalibration_file = \"absent.toml\"", file).ok());
}

TEST(DeviceConfig, AMatrixThatIsNoCorrectionIsRefused) {
  const test::TemporaryFolder folder;
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"[1.01,", "[50,"},
                                 {"[1.01,", "[-1.01,"},
                                 {"[1.01, 0, 0, 0, 0, 0]", "[1.01, 0]"},
                                 {"date", "day"}}) {
    std::string text = kCalibration;
    text.replace(text.find(from), from.size(), to);
    EXPECT_FALSE(ClinicCalibration::read(folder.write("bad.toml", text)).ok()) << to;
  }
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
    mounting.sign = i % 2 == 0 ? 1.0 : -1.0;
    const Wrench wrench_S{10.0 * vector(), vector()};
    const Wrench wrench_C = mounting.to_contact(wrench_S);
    const Wrench back = mounting.to_sensor(wrench_C);
    EXPECT_LT((back.force - wrench_S.force).norm(), kRounding);
    EXPECT_LT((back.torque - wrench_S.torque).norm(), kRounding);
    // The same rigid motion, told at S and at C: v_C = R (v_S + w x p).
    const Vec3 v_S = vector();
    const Vec3 w_S = vector();
    const Vec3 v_C = mounting.sign * (mounting.q_CS * (v_S + w_S.cross(mounting.p_SC_S)));
    const Vec3 w_C = mounting.sign * (mounting.q_CS * w_S);
    EXPECT_WITHIN(wrench_C.force.dot(v_C) + wrench_C.torque.dot(w_C),
                  wrench_S.force.dot(v_S) + wrench_S.torque.dot(w_S), kRounding);
  }
}

}  // namespace
}  // namespace isograsp::device_config_test
