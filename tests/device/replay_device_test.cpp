// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/recording/replay_device.hpp"

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "device/sensors/frame_clock.hpp"
#include "hand/finger_forces.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/within.hpp"

namespace isograsp::replay_device_test {
namespace {

using test::TemporaryFolder;

constexpr Timestamp kForever = std::chrono::hours{1};

Result<std::unique_ptr<ForceDevice>> open(const std::string& path, const std::string& query = "") {
  const auto uri = Uri::parse("replay://" + path + query);
  EXPECT_TRUE(uri);
  return open_replay_device(*uri);
}

/// A file of three fingers whose forces are awkward decimals.
std::string regular_file(int rows, double rate_Hz) {
  std::string text = "# made by a test\n# second line\n";
  std::string line;
  for (const auto& name : finger_forces_columns()) text += (line = name) + ",";
  text.back() = '\n';
  FingerForcesRow row;
  row.present = {true, true, true};
  for (int k = 0; k < rows; ++k) {
    row.t_s = k / rate_Hz;
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      row.wrench_C[f].force = {0.1 * k, -1.0 / (k + 1), 3.3 + static_cast<double>(f)};
      row.wrench_C[f].torque = {1e-3 * k, 0.2, -0.3};
    }
    append_finger_forces(text, row);
  }
  return text;
}

TEST(ReplayDevice, AFrameOfARegularFileIsExactlyItsRow) {
  const TemporaryFolder folder;
  for (const double rate_Hz : {50.0, 100.0, 120.0, 1000.0}) {
    const auto path = folder.write("f.csv", regular_file(400, rate_Hz));
    auto device = open(path);
    ASSERT_TRUE(device) << device.error().message();
    const DeviceInfo& info = (*device)->info();
    EXPECT_TRUE(info.on_grid);
    EXPECT_EQ(info.frame_period_s, 1.0 / rate_Hz);
    ManualClock clock;
    clock.wait_until(Timestamp{987654321});
    ASSERT_TRUE((*device)->start(clock));
    FrameClock frames(info.frame_period_s, info.sample_period_s, info.on_grid, clock.now());
    auto reader = FingerForcesReader::open(path);
    ASSERT_TRUE(reader);
    FingerForcesRow row;
    FingerFrame frame;
    SensorSample sample;
    int compared = 0;
    while ((*device)->read(kForever, sample) == ReadStatus::sample) {
      frames.push(sample);
      while (frames.pop((*device)->now(clock), frame)) {
        ASSERT_TRUE(*reader->next(row));
        ++compared;
        EXPECT_EQ(frame.t_s, row.t_s);
        for (std::size_t f = 0; f < kFingerCount; ++f) {
          EXPECT_EQ(frame.flags[f], 0);
          EXPECT_EQ(frame.wrench_C[f].force, row.wrench_C[f].force);
          EXPECT_EQ(frame.wrench_C[f].torque, row.wrench_C[f].torque);
        }
      }
    }
    EXPECT_EQ(compared, 400);
    EXPECT_EQ((*device)->health().state, DeviceState::finished);
  }
}

TEST(ReplayDevice, SpeedChangesTheWaitingButNeitherStampsNorFrames) {
  const TemporaryFolder folder;
  const auto path = folder.write("f.csv", regular_file(101, 100.0));
  for (const double speed : {0.0, 0.25, 1.0, 4.0}) {
    auto device = open(path, "?speed=" + format_number(speed));
    ASSERT_TRUE(device) << device.error().message();
    ManualClock clock;
    ASSERT_TRUE((*device)->start(clock));
    FrameClock frames(0.01, 0.01, true, clock.now());
    SensorSample sample;
    FingerFrame frame;
    int whole = 0;
    while ((*device)->read(kForever, sample) == ReadStatus::sample) {
      frames.push(sample);
      while (frames.pop((*device)->now(clock), frame))
        if (!frame.any(SampleFlag::missing)) ++whole;
    }
    EXPECT_EQ(sample.stamp, std::chrono::seconds{1});
    EXPECT_EQ(whole, 101);
    EXPECT_EQ(clock.now().count(), speed == 0.0 ? 0 : std::llround(1e9 / speed));
  }
}

TEST(ReplayDevice, AnIrregularFileIsInterpolatedOnAHundredHertzGrid) {
  const TemporaryFolder folder;
  std::string text = "t_s,thumb_fx_N,thumb_fy_N,thumb_fz_N\n";
  double t_s = 5.0;
  for (int k = 0; k < 200; ++k) {
    text += format_number(t_s) + ",0,0," + format_number(10.0 * (t_s - 5.0)) + "\n";
    t_s += k % 2 == 0 ? 0.007 : 0.009;
  }
  auto device = open(folder.write("f.csv", text));
  ASSERT_TRUE(device) << device.error().message();
  const DeviceInfo& info = (*device)->info();
  EXPECT_FALSE(info.on_grid);
  EXPECT_EQ(info.frame_period_s, 0.01);
  ManualClock clock;
  ASSERT_TRUE((*device)->start(clock));
  FrameClock frames(info.frame_period_s, info.sample_period_s, info.on_grid, clock.now());
  SensorSample sample;
  FingerFrame frame;
  int compared = 0;
  while ((*device)->read(kForever, sample) == ReadStatus::sample) {
    frames.push(sample);
    while (frames.pop((*device)->now(clock), frame)) {
      ++compared;
      constexpr double kRounding = 1e-9;  // stamps are whole nanoseconds; 10 N/s
      EXPECT_WITHIN(frame.wrench_C[0].force.z(), 10.0 * frame.t_s, 10.0 * kRounding);
      EXPECT_EQ(frame.flags[0], 0);
      EXPECT_EQ(frame.flags[1], bit(SampleFlag::missing));  // the file has no index finger
    }
  }
  EXPECT_GT(compared, 150);
}

TEST(ReplayDevice, ARegularGridOutsideTheFrameRatesIsResampled) {
  const TemporaryFolder folder;
  for (const double rate_Hz : {10.0, 2000.0}) {
    auto device = open(folder.write("f.csv", regular_file(100, rate_Hz)));
    ASSERT_TRUE(device);
    EXPECT_FALSE((*device)->info().on_grid);
    EXPECT_EQ((*device)->info().frame_period_s, 0.01);
    EXPECT_WITHIN((*device)->info().sample_period_s, 1.0 / rate_Hz, 1e-12);
  }
}

TEST(ReplayDevice, EmptyFieldsAndAbsentFingersAreInvalidSamples) {
  const TemporaryFolder folder;
  auto device =
      open(folder.write("f.csv",
                        "t_s,thumb_fx_N,thumb_fy_N,thumb_fz_N,index_fx_N,index_fy_N,index_fz_N\n"
                        "0,1,2,3,4,5,6\n0.01,,,,4,5,6\n0.02,1,2,3,4,5,6\n"));
  ASSERT_TRUE(device) << device.error().message();
  ManualClock clock;
  ASSERT_TRUE((*device)->start(clock));
  std::vector<bool> valid;
  SensorSample sample;
  while ((*device)->read(kForever, sample) == ReadStatus::sample) valid.push_back(sample.valid);
  EXPECT_EQ(valid, (std::vector<bool>{true, true, false, false, true, false, true, true, false}));
  const auto health = (*device)->health();
  EXPECT_EQ(health.sensors[0].good, 2U);
  EXPECT_EQ(health.sensors[0].invalid, 1U);
  EXPECT_EQ(health.sensors[2].invalid, 3U);
}

TEST(ReplayDevice, CommentsBecomeProvenanceAndSimulatedForcesStaySimulated) {
  const TemporaryFolder folder;
  auto people = open(folder.write("p.csv", regular_file(5, 100.0)));
  ASSERT_TRUE(people);
  EXPECT_EQ((*people)->info().provenance,
            (std::vector<std::string>{"made by a test", "second line"}));
  EXPECT_TRUE((*people)->info().recorded);
  EXPECT_FALSE((*people)->info().simulated);
  auto software =
      open(folder.write("s.csv", "# simulated: sim://healthy?seed=7\n" + regular_file(5, 100.0)));
  ASSERT_TRUE(software);
  EXPECT_TRUE((*software)->info().simulated);
}

TEST(ReplayDevice, OpeningABadFileNamesThePlaceAndTheRemedy) {
  const TemporaryFolder folder;
  const std::string header = "t_s,thumb_fx_N,thumb_fy_N,thumb_fz_N\n";
  const auto refusal = [&](const std::string& text, const std::string& query = "") {
    const auto device = open(folder.write("f.csv", text), query);
    return device ? "accepted" : device.error().message();
  };
  const auto expect_part = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  expect_part(refusal("t_s,thumb_fx_N,thumb_fz_N\n0,1,2\n0.01,1,2\n"),
              "f.csv:1: thumb_fy_N: the column is missing");
  expect_part(refusal("time,thumb_fx_N\n0,1\n1,1\n"), "f.csv:1: t_s: the column is missing");
  expect_part(refusal(header + "0,1,2,3\n0.01,1,nan,3\n"),
              "f.csv:3: thumb_fy_N: 'nan' is not a finite number");
  expect_part(refusal(header + "0,1,2,3\n0.01,1,2,three\n"),
              "f.csv:3: thumb_fz_N: 'three' is not a finite number");
  expect_part(refusal(header + "0,1,2,3\n0.01,1,2,3\n0.005,1,2,3\n"),
              "f.csv:4: t_s: time does not increase");
  expect_part(refusal(header + "0,1,2,3\n"), "fewer than two rows");
  expect_part(refusal(header + "0,1,2,3\n0.01,1,2\n"), "f.csv:3: thumb_fz_N: the line ends");
  expect_part(refusal("t_s,other\n0,1\n0.01,2\n"), "holds no finger's forces");
  expect_part(refusal(header + "0,1,2,3\n0.01,1,2,3\n", "?speed=-1"), "speed:");
  expect_part(refusal(header + "0,1,2,3\n0.01,1,2,3\n", "?speed=1e-9"), "speed: is too slow");
  expect_part(refusal(header + "0,1,2,3\n0.01,1,2,3\n", "?sped=1"), "sped:");
  const auto absent = open(folder.path("absent.csv"));
  ASSERT_FALSE(absent);
  expect_part(absent.error().message(), "absent.csv: cannot be opened for reading");
}

TEST(ReplayOfRawLogs, PlaysTheForcesOfTheGoldenLogMountedAndInTime) {
  auto device = open_replay_device(*Uri::parse("replay://" ISOGRASP_SOURCE_DIR
                                               "/tests/data/golden_rft.log?protocol=rft&speed=0"));
  ASSERT_TRUE(device.ok()) << device.error().message();
  EXPECT_TRUE((*device)->info().recorded);
  ManualClock clock;
  ASSERT_TRUE((*device)->start(clock).ok());
  std::vector<SensorSample> samples;
  SensorSample sample;
  while ((*device)->read(std::chrono::seconds(1), sample) == ReadStatus::sample)
    samples.push_back(sample);
  ASSERT_EQ(samples.size(), 6u);
  // The numbers of docs: thumb (12.34, -5.5, -48.02) N in the sensor frame; the half turn about x
  // makes pressing +z.
  EXPECT_EQ(samples[0].finger, Finger::thumb);
  EXPECT_EQ(samples[0].wrench_C.force, Vec3(12.34, 5.5, 48.02));
  EXPECT_EQ(samples[0].raw_counts[0], 617);
  EXPECT_EQ(samples[5].flags, bit(SampleFlag::overload));
  EXPECT_EQ(samples[3].stamp - samples[0].stamp, std::chrono::microseconds(10393));
}

TEST(ReplayOfRawLogs, RefusesALogWithoutTheseSensors) {
  const auto device = open_replay_device(
      *Uri::parse("replay://" ISOGRASP_SOURCE_DIR "/tests/data/golden_rft.log?protocol=jr3-can"));
  ASSERT_FALSE(device.ok());
  EXPECT_NE(device.error().message().find("holds no sample of these sensors"), std::string::npos);
  EXPECT_FALSE(open_replay_device(*Uri::parse("replay://x.log?protocol=abc")).ok());
  EXPECT_FALSE(open_replay_device(*Uri::parse("replay://absent.log?protocol=rft")).ok());
}

}  // namespace
}  // namespace isograsp::replay_device_test
