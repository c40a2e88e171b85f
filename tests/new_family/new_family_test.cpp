// SPDX-License-Identifier: GPL-3.0-or-later
// Adding a family of sensors takes new files and one row of the table: triax.patch does it, and
// this program is built with what it makes (see CMakeLists.txt). The contract of all devices,
// compiled into it too, then holds for the new family unasked.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "core/files.hpp"
#include "device/bus/candump_log.hpp"
#include "device/codec/triax_codec.hpp"
#include "device/config/triax_sensor.hpp"
#include "device/family/buses.hpp"
#include "device/recording/log_samples.hpp"
#include "device/sensors/open_sensors.hpp"
#include "tests/device/sensor_bench.hpp"
#include "tests/support/every.hpp"
#include "tests/support/patch_changes.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::new_family_test {
namespace {

using namespace std::chrono_literals;

TEST(NewFamily, IsNewFilesAndOneRow) {
  test::expect_new_files_and_one_row(
      {ISOGRASP_SOURCE_DIR "/tests/new_family/triax.patch",
       "device/family/families.cpp",
       {"#include \"device/config/triax_sensor.hpp\"", "    &kTriaxFamily,"},
       "device/CMakeLists.txt",
       9},
      ISOGRASP_PATCHED_TREE);
}

TEST(NewFamily, IsKnownByItsName) {
  EXPECT_EQ(all_families().size(), 6U);
  EXPECT_EQ(family_named("triax"), &kTriaxFamily);
  EXPECT_EQ(family_names(), "rft, ati-netcanoem, jr3-can, net-ft or triax");
}

Result<DeviceConfig> with(const std::string& index) {
  return DeviceConfig::parse(
      "format = \"isograsp-device-1\"\nprotocol = \"triax\"\n[[sensor]]\nfinger = \"thumb\"\n"
      "[[sensor]]\nfinger = \"middle\"\n[[sensor]]\nfinger = \"index\"\n" +
          index,
      "x.toml");
}

TEST(NewFamily, HasItsOwnKeys) {
  const auto config = with("node = 9\n");
  ASSERT_TRUE(config.ok()) << config.error().message();
  EXPECT_EQ(config->family, &kTriaxFamily);
  EXPECT_EQ(config->sensors[1].as<TriaxSensor>().node, 9);
  EXPECT_EQ(config->sensors[2].as<TriaxSensor>().node, 3) << "as it is standard";
  EXPECT_EQ(can_ids(*config).heard, (std::vector<std::uint32_t>{0x281, 0x289, 0x283}));
  EXPECT_FALSE(with("node = 128\n").ok());
  EXPECT_FALSE(with("node = 3\n").ok()) << "the middle finger has it";
  EXPECT_FALSE(with("first_id = 3\n").ok()) << "a key of another family";
}

TEST(NewFamily, IsReachedByItsAddress) {
  const auto config = config_of(*Uri::parse("can://can0?protocol=triax&rate=250"));
  ASSERT_TRUE(config.ok()) << config.error().message();
  EXPECT_EQ(config->rate_Hz, 250.0);
  const auto elsewhere = config_of(*Uri::parse("udp://1.1.1.1,1.1.1.2,1.1.1.3?protocol=triax"));
  ASSERT_FALSE(elsewhere.ok());
  EXPECT_EQ(english(elsewhere.error().what), "Triax sensors do not speak over udp://");
}

TEST(NewFamily, WhatItsEmulatedSensorsFeelArrives) {
  EmulatorOptions options;
  options.config = DeviceConfig::standard(kTriaxFamily);
  options.noise_counts = 3;  // a value that never changes is that of a frozen sensor
  constexpr double kNoise_N = 0.06;
  FingerPlay play;
  play.t_s = {0.0};
  FingerWrenches wrenches{};
  for (std::size_t f = 0; f < kFingerCount; ++f)
    wrenches[f].force = Vec3(1.25, -2.0, 10.0 + static_cast<double>(f));
  play.wrench_C = {wrenches};
  test::SensorBench bench(options, options.config, play);
  ASSERT_TRUE(bench.device->start(bench.clock).ok());
  EXPECT_EQ(english(bench.device->info().description), "Triax on test");
  const auto samples = bench.read_for(1s);
  EXPECT_NEAR(static_cast<double>(samples.size()), 300.0, 3.0);
  for (const auto& sample : test::every(samples)) {
    EXPECT_TRUE(sample.valid);
    EXPECT_LT((sample.wrench_C.force - wrenches[index_of(sample.finger)].force).norm(), kNoise_N);
  }
}

TEST(NewFamily, ItsLogsAreRead) {
  const test::TemporaryFolder folder;
  std::string log;
  for (std::uint8_t node = 1; node <= 3; ++node)
    log +=
        format_candump_line(1s, "can0", triax_sample_frame(node, {1, {0, 0, 100 * node}})) + "\n";
  const auto config = DeviceConfig::standard(kTriaxFamily);
  std::vector<double> force_N;
  const auto report = read_log(folder.write("frames.log", log), config, false,
                               [&](const std::string&, Timestamp, const DecodedSample& sample) {
                                 force_N.push_back(sample.wrench_S.force.z());
                               });
  ASSERT_TRUE(report.ok()) << report.error().message();
  EXPECT_EQ(force_N, (std::vector<double>{1.0, 2.0, 3.0}));
}

}  // namespace
}  // namespace isograsp::new_family_test
