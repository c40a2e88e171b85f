// SPDX-License-Identifier: GPL-3.0-or-later
// A recording of markers as if it came from cameras.
#include <cmath>

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "device/cameras/marker_device.hpp"
#include "device/markers/marker_reader.hpp"
#include "tests/support/must.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/within.hpp"

namespace isograsp::marker_replay_test {
namespace {

using test::must;
using test::TemporaryFolder;

constexpr Timestamp kForever = std::chrono::hours{1};

std::unique_ptr<MarkerDevice> open(const std::string& path, const std::string& query = "") {
  return must(open_marker_device(must(Uri::parse("replay://" + path + query))));
}
std::string refusal(const std::string& uri) {
  const auto device = open_marker_device(must(Uri::parse(uri)));
  return device ? "accepted" : device.error().message();
}
struct Got {
  std::vector<std::int64_t> number;
  std::vector<Timestamp> stamp;
};
Got all_of(MarkerDevice& device) {
  Got got;
  MarkerSample sample;
  while (device.read(kForever, sample) == ReadStatus::sample) {
    got.number.push_back(sample.number);
    got.stamp.push_back(sample.stamp);
  }
  return got;
}
/// One marker at these times.
std::string file_at(const std::vector<double>& t_s) {
  std::string text = "t_s,A_x_m,A_y_m,A_z_m\n";
  for (const double t : t_s) text += format_number(t) + ",1,2,3\n";
  return text;
}

TEST(MarkerReplay, EveryPictureIsExactlyItsRowWhateverTheFormat) {
  const std::string folder = std::string(ISOGRASP_SOURCE_DIR) + "/tests/data/isotonic/";
  for (const std::string name : {"kabsch_prism.csv", "session_a_markers.csv"}) {
    auto device = open(folder + name, "?speed=0&rig=some.toml");
    auto reader = must(open_markers(folder + name));
    EXPECT_EQ(device->info().labels, reader->markers());
    EXPECT_TRUE(device->info().recorded);
    ManualClock clock;
    clock.wait_until(Timestamp{12345});
    must(device->start(clock));
    std::vector<Vec3> p_W(reader->markers().size());
    double t_s = 0.0, first_s = -1.0;
    std::uint64_t rows = 0;
    MarkerSample sample;
    while (device->read(kForever, sample) == ReadStatus::sample) {
      ASSERT_TRUE(must(reader->next(t_s, p_W)));
      if (first_s < 0.0) first_s = t_s;
      ++rows;
      EXPECT_EQ(sample.stamp, Timestamp{12345} + from_seconds(t_s - first_s));
      constexpr double kGrid = 0.51;  // half a step, and rounding
      EXPECT_WITHIN(static_cast<double>(sample.number), (t_s - first_s) / device->info().period_s,
                    kGrid);
      ASSERT_EQ(sample.p_W.size(), p_W.size());
      for (std::size_t k = 0; k < p_W.size(); ++k) {
        ASSERT_EQ(p_W[k].allFinite(), sample.p_W[k].allFinite());
        if (p_W[k].allFinite()) {
          EXPECT_EQ(sample.p_W[k], p_W[k]);
        } else {
          EXPECT_TRUE(sample.p_W[k].array().isNaN().all());
        }
      }
    }
    EXPECT_FALSE(must(reader->next(t_s, p_W)));
    EXPECT_GT(rows, 1U);
    EXPECT_EQ(device->health().counters.good, rows);
    EXPECT_EQ(device->health().state, DeviceState::finished);
  }
}

TEST(MarkerReplay, RowsThatAreNotThereAreGapsInTheNumbers) {
  const TemporaryFolder folder;
  auto device = open(folder.write("m.csv", file_at({5.0, 5.01, 5.02, 5.05, 5.06, 5.16})));
  EXPECT_EQ(device->info().period_s, 0.01);
  ManualClock clock;
  must(device->start(clock));
  const Got got = all_of(*device);
  EXPECT_EQ(got.number, (std::vector<std::int64_t>{0, 1, 2, 5, 6, 16}));
  EXPECT_EQ(device->health().counters.lost, 11U);
  EXPECT_EQ(clock.now(), std::chrono::milliseconds(160));
}

TEST(MarkerReplay, TimesWithFewDigitsDoNotDriftOffTheirGrid) {
  const TemporaryFolder folder;
  std::vector<double> t_s;
  for (int k = 0; k < 1200; ++k) t_s.push_back(std::floor(1000.0 * k / 120.0) / 1000.0);
  auto device = open(folder.write("m.csv", file_at(t_s)), "?speed=0");
  EXPECT_EQ(device->info().period_s, 1.0 / 120.0);
  ManualClock clock;
  must(device->start(clock));
  const Got got = all_of(*device);
  ASSERT_EQ(got.number.size(), 1200U);
  for (std::size_t k = 0; k < got.number.size(); ++k)
    EXPECT_EQ(got.number[k], static_cast<std::int64_t>(k));
}

TEST(MarkerReplay, NumbersIncreaseStrictlyHoweverCrookedTheTimes) {
  const TemporaryFolder folder;
  auto device = open(folder.write("m.csv", file_at({0, 0.01, 0.011, 0.012, 0.02, 0.03, 0.04})));
  ManualClock clock;
  must(device->start(clock));
  const Got got = all_of(*device);
  ASSERT_EQ(got.number.size(), 7U);
  for (std::size_t k = 1; k < 7; ++k) EXPECT_GT(got.number[k], got.number[k - 1]);
}

TEST(MarkerReplay, SpeedChangesTheWaitingButNotTheStamps) {
  const TemporaryFolder folder;
  std::vector<double> t_s;
  for (int k = 0; k <= 100; ++k) t_s.push_back(k / 100.0);
  const auto path = folder.write("m.csv", file_at(t_s));
  for (const double speed : {0.0, 0.25, 1.0, 4.0}) {
    auto device = open(path, "?speed=" + format_number(speed));
    ManualClock clock;
    must(device->start(clock));
    EXPECT_EQ(all_of(*device).stamp.back(), std::chrono::seconds(1));
    EXPECT_EQ(clock.now().count(), speed == 0.0 ? 0 : std::llround(1e9 / speed));
    EXPECT_EQ(device->now(clock), std::chrono::seconds(1));
  }
}

TEST(MarkerReplay, AGapOfMoreThanFiftyMillisecondsIsSilenceUntilTheNextPicture) {
  const TemporaryFolder folder;
  auto device = open(folder.write("m.csv", file_at({0, 0.01, 0.02, 0.1, 0.11})));
  ManualClock clock;
  must(device->start(clock));
  MarkerSample sample;
  for (int k = 0; k < 3; ++k) ASSERT_EQ(device->read(kForever, sample), ReadStatus::sample);
  EXPECT_EQ(device->read(std::chrono::milliseconds(70), sample), ReadStatus::timeout);
  EXPECT_EQ(device->health().state, DeviceState::streaming);
  EXPECT_EQ(device->read(std::chrono::milliseconds(71), sample), ReadStatus::timeout);
  EXPECT_EQ(device->health().fault, MarkerFault::silence);
  EXPECT_EQ(device->health().state, DeviceState::faulted);
  EXPECT_EQ(device->read(kForever, sample), ReadStatus::sample);
  EXPECT_EQ(device->health().state, DeviceState::degraded);
}

TEST(MarkerReplay, ReadingAllocatesNothing) {
  const TemporaryFolder folder;
  auto device = open(folder.write("m.csv", file_at({0, 0.01, 0.02, 0.05, 0.06})));
  ManualClock clock;
  must(device->start(clock));
  MarkerSample sample;
  const auto before = test::allocations();
  while (device->read(kForever, sample) == ReadStatus::sample) (void)device->health();
  EXPECT_EQ(test::allocations(), before);
}

TEST(MarkerReplay, WhatSoftwareMadeStaysSimulated) {
  const TemporaryFolder folder;
  EXPECT_FALSE(open(folder.write("a.csv", file_at({0, 1})))->info().simulated);
  EXPECT_TRUE(
      open(folder.write("b.csv", "# simulated: arm\n" + file_at({0, 1})))->info().simulated);
}

TEST(MarkerReplay, RefusesWhatCannotBeReplayed) {
  const TemporaryFolder folder;
  const auto good = "replay://" + folder.write("g.csv", file_at({0, 1}));
  EXPECT_NE(refusal("replay://" + folder.write("o.csv", file_at({0}))).find("fewer than two rows"),
            std::string::npos);
  EXPECT_NE(refusal("replay://").find("no file is named"), std::string::npos);
  EXPECT_NE(refusal("replay://" + folder.path("absent.csv")).find("absent.csv"), std::string::npos);
  EXPECT_NE(refusal(good + "?speed=-1").find("speed"), std::string::npos);
  EXPECT_NE(refusal(good + "?speed=0.001").find("is too slow"), std::string::npos);
  EXPECT_NE(refusal(good + "?protocol=rft").find("unknown parameter"), std::string::npos);
  EXPECT_NE(refusal("vrpn://host").find("no cameras are called vrpn://"), std::string::npos);
}

}  // namespace
}  // namespace isograsp::marker_replay_test
