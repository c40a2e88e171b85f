// SPDX-License-Identifier: GPL-3.0-or-later
// What every live system of cameras keeps, against an emulator on a real port of this computer.
#include <functional>

#include "device/cameras/picture_watch.hpp"
#include "tests/device/cameras/marker_servers.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"

namespace isograsp::marker_contract_test {
namespace {

using namespace std::chrono_literals;
using namespace isograsp::test;

constexpr Timestamp kPatience = 10s;
constexpr double kRate_Hz = 200.0;

struct Wire {
  const char* name;
  const char* scheme;
  NatNetVersion version;
  const char* fault = "";  ///< that no client may notice
};
std::string name_of_wire(const testing::TestParamInfo<Wire>& info) {
  return info.param.name;
}

class LiveCameras : public testing::TestWithParam<Wire> {
 protected:
  [[nodiscard]] std::unique_ptr<RunningServer> serve(MarkerPlay play,
                                                     std::vector<std::string> faults = {}) const {
    if (*GetParam().fault != '\0') faults.emplace_back(GetParam().fault);
    if (is_qtm()) return qtm_server(std::move(play), faults);
    return natnet_server(std::move(play), faults, GetParam().version);
  }
  [[nodiscard]] bool is_qtm() const { return std::string(GetParam().scheme) == "qtm"; }
  /// The number that leaves the device for one that was put on the wire.
  [[nodiscard]] double of_wire(double value) const {
    if (!is_qtm()) return static_cast<double>(static_cast<float>(value));
    return 1e-3 * static_cast<double>(static_cast<float>(1e3 * value));
  }
  [[nodiscard]] std::unique_ptr<MarkerDevice> started(const RunningServer& server) {
    auto device = open_cameras(uri_of(GetParam().scheme, server));
    must(device->start(clock_));
    return device;
  }
  /// Reads until `done` or patience is over; true: it was.
  bool read_until(MarkerDevice& device,
                  const std::function<bool(ReadStatus, MarkerSample&)>& done) {
    const Timestamp end = clock_.now() + kPatience;
    MarkerSample sample;
    while (clock_.now() < end) {
      const ReadStatus status = device.read(clock_.now() + 5ms, sample);
      if (done(status, sample)) return true;
    }
    return false;
  }
  SteadyClock clock_;
};

/// Which row of the play a picture shows.
std::size_t row_of(const MarkerSample& sample) {
  return static_cast<std::size_t>(std::lround(1e3 * sample.p_W[0].x()));
}

TEST_P(LiveCameras, EveryPictureArrivesInItsPlaceToTheLastBit) {
  const MarkerPlay play = marker_play(150, kRate_Hz);
  const auto server = serve(play);
  const auto device = started(*server);
  EXPECT_EQ(device->info().labels, play.labels);
  EXPECT_EQ(device->info().period_s, 1.0 / kRate_Hz);
  EXPECT_FALSE(device->info().simulated);
  std::size_t first = 0, last = 0, read = 0;
  std::int64_t first_number = 0;
  std::uint64_t allocated = 0;
  const Timestamp end = clock_.now() + kPatience;
  MarkerSample sample;
  while (last + 1 < play.t_s.size() && clock_.now() < end) {
    const auto before = allocations();
    const ReadStatus status = device->read(clock_.now() + 20ms, sample);
    allocated += allocations() - before;
    if (status != ReadStatus::sample) continue;
    const std::size_t row = row_of(sample);
    if (read++ == 0) {
      first = row;
      first_number = sample.number;
    } else {
      EXPECT_GT(row, last);
    }
    last = row;
    ASSERT_EQ(static_cast<std::size_t>(sample.number - first_number), row - first);
    ASSERT_EQ(sample.p_W.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& sent = play.p_W[3 * row + k];
      if (sent.allFinite()) {
        EXPECT_EQ(sample.p_W[k], Vec3(of_wire(sent.x()), of_wire(sent.y()), of_wire(sent.z())));
      } else {
        EXPECT_TRUE(sample.p_W[k].array().isNaN().all());
      }
    }
  }
  EXPECT_EQ(last + 1, play.t_s.size());
  EXPECT_EQ(read, last + 1 - first) << "none is lost on the way";
  EXPECT_EQ(allocated, 0U);
  EXPECT_EQ(device->health().counters.good, read);
  EXPECT_EQ(device->health().counters.lost, 0U);
  EXPECT_EQ(device->health().counters.damaged, 0U);
  EXPECT_TRUE(device->health().jitter_s);
}

INSTANTIATE_TEST_SUITE_P(
    Wires, LiveCameras,
    testing::Values(Wire{"qtm", "qtm", {}}, Wire{"qtm_byte_by_byte", "qtm", {}, "split"},
                    Wire{"qtm_three_at_once", "qtm", {}, "merge=3"},
                    Wire{"natnet_2_5", "natnet", {2, 5}}, Wire{"natnet_2_6", "natnet", {2, 6}},
                    Wire{"natnet_2_9", "natnet", {2, 9}}, Wire{"natnet_2_11", "natnet", {2, 11}},
                    Wire{"natnet_3_0", "natnet", {3, 0}}, Wire{"natnet_4_0", "natnet", {4, 0}},
                    Wire{"natnet_4_1", "natnet", {4, 1}}),
    name_of_wire);

class LiveCamerasInTrouble : public LiveCameras {};

TEST_P(LiveCamerasInTrouble, SilenceIsAFaultUntilPicturesComeAgain) {
  const auto server = serve(marker_play(400, kRate_Hz), {"silence=400ms@300ms"});
  const auto device = started(*server);
  bool silent = false;
  std::int64_t before = -1, after = -1;
  std::uint64_t lost = 0;
  ASSERT_TRUE(read_until(*device, [&](ReadStatus status, MarkerSample& sample) {
    const MarkerHealth health = device->health();
    if (status != ReadStatus::sample) {
      silent = silent || health.fault == MarkerFault::silence;
      if (health.fault == MarkerFault::silence) {
        EXPECT_EQ(health.state, DeviceState::faulted);
      }
      return false;
    }
    if (!silent) before = sample.number;
    after = sample.number;
    lost = health.counters.lost;
    // Told for a second behind the silence.
    return silent && health.fault == MarkerFault::damaged_samples &&
           health.state == DeviceState::degraded;
  }));
  EXPECT_EQ(after - before - 1, static_cast<std::int64_t>(lost));
  EXPECT_GE(lost, 60U) << "0.4 s at 200 Hz, less what a busy computer may shift";
  EXPECT_EQ(device->health().counters.restarts, 0U);
}

TEST_P(LiveCamerasInTrouble, LostPicturesAreGapsInTheNumbers) {
  const auto server = serve(marker_play(200, kRate_Hz), {"drop=0.2"});
  const auto device = started(*server);
  std::int64_t first = -1, last = -1;
  std::size_t first_row = 0;
  ASSERT_TRUE(read_until(*device, [&](ReadStatus status, MarkerSample& sample) {
    if (status != ReadStatus::sample) return false;
    if (first < 0) {
      first = sample.number;
      first_row = row_of(sample);
    }
    last = sample.number;
    EXPECT_EQ(static_cast<std::size_t>(last - first), row_of(sample) - first_row);
    return row_of(sample) > 150;
  }));
  const MarkerCounters counters = device->health().counters;
  EXPECT_EQ(counters.good + counters.lost, static_cast<std::uint64_t>(last + 1));
  EXPECT_GT(counters.lost, 5U);
}

TEST_P(LiveCamerasInTrouble, TheGridGoesOnWhereTheCamerasBeginToCountAnew) {
  const auto server = serve(marker_play(300, kRate_Hz), {"restart@400ms"});
  const auto device = started(*server);
  std::int64_t last = -1;
  ASSERT_TRUE(read_until(*device, [&](ReadStatus status, MarkerSample& sample) {
    if (status != ReadStatus::sample) return false;
    EXPECT_GT(sample.number, last);
    last = sample.number;
    return row_of(sample) > 200;
  }));
  EXPECT_LT(last, 600) << "no jump but that of a busy computer";
}

TEST_P(LiveCamerasInTrouble, StartsAgainAfterStop) {
  const auto server = serve(marker_play(2000, kRate_Hz));
  const auto device = started(*server);
  MarkerSample sample;
  ASSERT_TRUE(read_until(
      *device, [](ReadStatus status, MarkerSample&) { return status == ReadStatus::sample; }));
  device->stop();
  EXPECT_EQ(device->health().state, DeviceState::configured);
  EXPECT_EQ(device->read(clock_.now() + 1s, sample), ReadStatus::finished);
  must(device->start(clock_));
  EXPECT_TRUE(read_until(*device, [](ReadStatus status, MarkerSample& again) {
    return status == ReadStatus::sample && again.number == 0;
  }));
}

TEST_P(LiveCamerasInTrouble, ReadingEndsAtItsDeadline) {
  const auto server = serve(marker_play(2000, kRate_Hz), {"silence@200ms"});
  const auto device = started(*server);
  MarkerSample sample;
  ASSERT_TRUE(read_until(*device, [&](ReadStatus, MarkerSample&) {
    return device->health().fault == MarkerFault::silence;
  }));
  for (int k = 0; k < 5; ++k) {
    const Timestamp deadline = clock_.now() + 10ms;
    EXPECT_EQ(device->read(deadline, sample), ReadStatus::timeout);
    EXPECT_GE(clock_.now(), deadline);
  }
}

TEST_P(LiveCamerasInTrouble, DoNotRunInVirtualTime) {
  const auto server = serve(marker_play(20, kRate_Hz));
  auto device = open_cameras(uri_of(GetParam().scheme, *server));
  ManualClock clock;
  const auto begun = device->start(clock);
  ASSERT_FALSE(begun);
  EXPECT_NE(begun.error().message().find("virtual time"), std::string::npos);
  EXPECT_EQ(device->health().state, DeviceState::absent);
}

INSTANTIATE_TEST_SUITE_P(Wires, LiveCamerasInTrouble,
                         testing::Values(Wire{"qtm", "qtm", {}}, Wire{"natnet", "natnet", {4, 1}}),
                         name_of_wire);

}  // namespace
}  // namespace isograsp::marker_contract_test
