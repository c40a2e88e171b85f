// SPDX-License-Identifier: GPL-3.0-or-later
// Cameras in software that look at an arm in software.
#include <cmath>

#include <gtest/gtest.h>

#include "device/cameras/marker_device.hpp"
#include "tests/support/must.hpp"
#include "tests/support/no_alloc.hpp"

namespace isograsp::simulated_markers_test {
namespace {

using test::must;

/// Two markers; the first one tells the time at which it was asked, the second is never seen.
class Teller final : public MarkerSource {
 public:
  [[nodiscard]] std::span<const std::string> labels() const noexcept override { return labels_; }
  void see(const Stimulus&) noexcept override {}
  void markers(double t_s, std::span<Vec3> p_W) noexcept override {
    increasing = increasing && t_s > last_s;
    last_s = t_s;
    ++asked;
    p_W[0] = {t_s, 0.0, 1.0};
    p_W[1] = Vec3::Constant(std::nan(""));
  }
  double last_s = -1.0;
  int asked = 0;
  bool increasing = true;

 private:
  std::vector<std::string> labels_{"A", "B"};
};

std::unique_ptr<MarkerDevice> open(const std::string& query, Teller& teller) {
  return must(open_marker_device(must(Uri::parse("sim://arm" + query)), &teller));
}
constexpr Timestamp kTenSeconds = std::chrono::seconds(10);

TEST(SimulatedMarkers, PicturesLieExactlyOnTheGridOfTheRate) {
  for (const int rate : {50, 100, 120, 500}) {
    Teller teller;
    auto device = open("?rate=" + std::to_string(rate) + "&rig=r.toml&hand=left", teller);
    EXPECT_EQ(device->info().period_s, 1.0 / rate);
    EXPECT_EQ(device->info().labels, (std::vector<std::string>{"A", "B"}));
    EXPECT_TRUE(device->info().simulated);
    ManualClock clock;
    clock.wait_until(Timestamp{777});
    must(device->start(clock));
    MarkerSample sample;
    for (int k = 0; k < 1000; ++k) {
      ASSERT_EQ(device->read(Timestamp{777} + std::chrono::hours(1), sample), ReadStatus::sample);
      EXPECT_EQ(sample.number, k);
      EXPECT_EQ(sample.stamp, Timestamp{777} + from_seconds(static_cast<double>(k) / rate));
      EXPECT_EQ(sample.p_W[0].x(), static_cast<double>(k) / rate);
      EXPECT_TRUE(sample.p_W[1].array().isNaN().all());
      EXPECT_EQ(teller.asked, k + 1) << "nobody is asked ahead of what he sees";
    }
  }
}

TEST(SimulatedMarkers, LostPicturesAreCountedAndTheArmMovesOn) {
  Teller teller;
  auto device = open("?drop=0.2&seed=5", teller);
  ManualClock clock;
  must(device->start(clock));
  MarkerSample sample;
  std::vector<std::int64_t> first;
  while (device->read(kTenSeconds, sample) == ReadStatus::sample) first.push_back(sample.number);
  const auto counters = device->health().counters;
  EXPECT_EQ(counters.good, first.size());
  EXPECT_EQ(counters.good + counters.lost, static_cast<std::uint64_t>(first.back() + 1));
  EXPECT_EQ(teller.asked, 1001);
  EXPECT_TRUE(teller.increasing);
  EXPECT_GT(counters.lost, 120U);
  EXPECT_LT(counters.lost, 280U);

  device->stop();
  EXPECT_EQ(device->read(kTenSeconds, sample), ReadStatus::finished);
  ManualClock again;
  must(device->start(again));
  std::vector<std::int64_t> second;
  while (device->read(kTenSeconds, sample) == ReadStatus::sample) second.push_back(sample.number);
  EXPECT_EQ(first, second) << "the same seed loses the same pictures";
}

TEST(SimulatedMarkers, WithoutPicturesTheCamerasAreSilent) {
  Teller teller;
  auto device = open("?drop=1", teller);
  ManualClock clock;
  must(device->start(clock));
  MarkerSample sample;
  EXPECT_EQ(device->read(std::chrono::milliseconds(50), sample), ReadStatus::timeout);
  EXPECT_EQ(device->health().fault, MarkerFault::none);
  EXPECT_EQ(device->read(std::chrono::milliseconds(60), sample), ReadStatus::timeout);
  EXPECT_EQ(device->health().fault, MarkerFault::silence);
}

TEST(SimulatedMarkers, ReadingAllocatesNothing) {
  Teller teller;
  auto device = open("?drop=0.3", teller);
  ManualClock clock;
  must(device->start(clock));
  MarkerSample sample;
  const auto before = test::allocations();
  while (device->read(kTenSeconds, sample) == ReadStatus::sample) (void)device->health();
  EXPECT_EQ(test::allocations(), before);
}

TEST(SimulatedMarkers, RefusesWhatItCannotShow) {
  Teller teller;
  const auto refusal = [&](const std::string& uri, MarkerSource* source) {
    const auto device = open_marker_device(must(Uri::parse(uri)), source);
    return device ? "accepted" : device.error().message();
  };
  const auto expect_part = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  expect_part(refusal("sim://arm", nullptr), "nobody moves the simulated arm");
  expect_part(refusal("sim://healthy", &teller), "'healthy' is nothing that cameras could see");
  expect_part(refusal("sim://arm?rate=40", &teller), "rate");
  expect_part(refusal("sim://arm?rate=501", &teller), "rate");
  expect_part(refusal("sim://arm?seed=1.5", &teller), "seed");
  expect_part(refusal("sim://arm?hand=both", &teller), "hand");
  expect_part(refusal("sim://arm?drop=2", &teller), "drop");
  expect_part(refusal("sim://arm?speed=2", &teller), "unknown parameter");
}

}  // namespace
}  // namespace isograsp::simulated_markers_test
