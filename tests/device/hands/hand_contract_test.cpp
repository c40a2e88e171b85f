// SPDX-License-Identifier: GPL-3.0-or-later
// What every live tracker of hands keeps, against an emulator on a real port of this computer.
#include <functional>

#include "tests/device/hands/hand_trackers.hpp"
#include "tests/support/no_alloc.hpp"

namespace isograsp::hand_contract_test {
namespace {

using namespace std::chrono_literals;
using namespace isograsp::test;

constexpr Timestamp kPatience = 10s;
constexpr double kRate_Hz = 120.0;

struct Wire {
  const char* name;
  bool leap;
  const char* fault = "";  ///< that no client may notice
};
std::string name_of_wire(const testing::TestParamInfo<Wire>& info) {
  return info.param.name;
}

/// Every counter, in the order of HandCounters.
std::vector<std::uint64_t> all_of(const HandCounters& c) {
  return {c.frames, c.rows,      c.untracked, c.incomplete,  c.other_side, c.lost,
          c.late,   c.malformed, c.foreign,   c.clock_steps, c.restarts,   c.overrun};
}

class LiveHands : public testing::TestWithParam<Wire> {
 protected:
  /// A tracker that plays, and a device that hears it.
  std::unique_ptr<HandDevice> heard(HandPlay play, std::vector<std::string> faults = {},
                                    std::optional<Hand> side = Hand::right) {
    if (*GetParam().fault != '\0') faults.emplace_back(GetParam().fault);
    std::string uri;
    if (GetParam().leap) {
      tracker_ = leap_tracker(std::move(play), faults);
      uri = "leap://" + tracker_->address().text();
    } else {
      const std::uint16_t port = free_udp_port();
      tracker_ = hand_script(std::move(play), port, faults);
      uri = "udp-hand://127.0.0.1:" + std::to_string(port);
    }
    auto device = open_hands(uri, side);
    must(device->start(clock_));
    return device;
  }
  /// The number that leaves the device for one that was put on the wire.
  [[nodiscard]] double of_wire(double value) const {
    return GetParam().leap ? 1e-3 * (1e3 * value) : value;
  }
  /// Reads until `done` or patience is over; true: it was. Counters never decrease meanwhile.
  bool read_until(HandDevice& device, const std::function<bool(ReadStatus, HandSample&)>& done) {
    const Timestamp end = clock_.now() + kPatience;
    HandSample sample;
    auto before = all_of(device.health().counters);
    while (clock_.now() < end) {
      const ReadStatus status = device.read(clock_.now() + 5ms, sample);
      const auto now = all_of(device.health().counters);
      for (std::size_t k = 0; k < now.size(); ++k) EXPECT_GE(now[k], before[k]) << k;
      before = now;
      if (done(status, sample)) return true;
    }
    return false;
  }
  SteadyClock clock_;
  std::unique_ptr<RunningTracker> tracker_;
};

/// Which row of the play a sample shows.
std::size_t row_of(const HandSample& sample) {
  return static_cast<std::size_t>(std::lround(1e3 * sample.frame.joints[kWristJoint].x()));
}

TEST_P(LiveHands, EveryRowArrivesInItsPlaceToTheLastBitWithoutAnAllocation) {
  const HandPlay play = hand_play(150, kRate_Hz);
  const auto device = heard(play);
  EXPECT_NEAR(device->info().period_s, 1.0 / kRate_Hz, 1e-4) << "ten frames, whole microseconds";
  std::size_t read = 0, first = 0, last = 0;
  std::int64_t number = -1;
  Timestamp stamp{0};
  std::uint64_t allocated = 0;
  const Timestamp end = clock_.now() + kPatience;
  HandSample sample;
  while (last + 1 < play.hands.size() && clock_.now() < end) {
    const auto before = allocations();
    const ReadStatus status = device->read(clock_.now() + 20ms, sample);
    allocated += allocations() - before;
    if (status != ReadStatus::sample) continue;
    const std::size_t row = row_of(sample);
    if (read++ == 0)
      first = row;
    else
      ASSERT_EQ(row, last + 1);
    last = row;
    ASSERT_LT(row, play.hands.size());
    const HandFrame& sent = play.hands[row];
    EXPECT_GT(sample.number, number);
    EXPECT_GT(sample.stamp, stamp);
    EXPECT_LE(sample.stamp, clock_.now());
    number = sample.number;
    stamp = sample.stamp;
    EXPECT_TRUE(sample.frame.tracked);
    EXPECT_EQ(sample.frame.confidence, sent.confidence);
    for (std::size_t j = 0; j < kHandJointCount; ++j)
      for (Eigen::Index a = 0; a < 3; ++a)
        ASSERT_EQ(sample.frame.joints[j][a], of_wire(sent.joints[j][a])) << j;
  }
  EXPECT_EQ(last + 1, play.hands.size());
  EXPECT_EQ(read, last + 1 - first) << "none is lost on the way";
  EXPECT_EQ(allocated, 0U);
  const HandHealth health = device->health();
  EXPECT_EQ(health.counters.rows, read);
  EXPECT_EQ(health.counters.lost, 0U);
  EXPECT_EQ(health.counters.malformed, 0U);
  EXPECT_EQ(health.counters.overrun, 0U);
  EXPECT_TRUE(health.jitter_s);
}

INSTANTIATE_TEST_SUITE_P(Wires, LiveHands,
                         testing::Values(Wire{"leap", true},
                                         Wire{"leap_in_fragments", true, "split"},
                                         Wire{"udp", false}),
                         name_of_wire);

class LiveHandsInTrouble : public LiveHands {};

TEST_P(LiveHandsInTrouble, SilenceIsAFaultUntilHandsComeAgain) {
  const auto device = heard(hand_play(300, kRate_Hz), {"silence=600ms@400ms"});
  bool silent = false;
  std::uint64_t lost = 0;
  ASSERT_TRUE(read_until(*device, [&](ReadStatus status, HandSample&) {
    const HandHealth health = device->health();
    if (status != ReadStatus::sample) {
      if (health.fault == HandFault::silence) {
        silent = true;
        EXPECT_EQ(health.state, DeviceState::faulted);
      }
      return false;
    }
    lost = health.counters.lost;
    return silent && health.fault == HandFault::damaged_samples &&
           health.state == DeviceState::degraded;
  }));
  EXPECT_GE(lost, 60U) << "0.6 s at 120 Hz, less what a busy computer may shift";
  EXPECT_EQ(device->health().counters.restarts, 0U);
}

TEST_P(LiveHandsInTrouble, AHandThatIsNotSeenIsARowAndNoFault) {
  const auto device = heard(hand_play(300, kRate_Hz), {"lose=400ms@400ms"});
  int unseen = 0;
  ASSERT_TRUE(read_until(*device, [&](ReadStatus status, HandSample& sample) {
    if (status == ReadStatus::sample && !sample.frame.tracked) {
      ++unseen;
      EXPECT_FALSE(sample.frame.joints[kWristJoint].allFinite());
      EXPECT_NE(device->health().fault, HandFault::silence);
    }
    return unseen > 30 && sample.frame.tracked;
  }));
  EXPECT_EQ(device->health().counters.untracked, static_cast<std::uint64_t>(unseen));
}

TEST_P(LiveHandsInTrouble, RowsOfTheOtherHandAreCountedSaidAndNeverGiven) {
  const auto device = heard(hand_play(300, kRate_Hz), {"flip=600ms@400ms"});
  bool said = false, again = false;
  ASSERT_TRUE(read_until(*device, [&](ReadStatus status, HandSample& sample) {
    if (status == ReadStatus::sample) {
      EXPECT_EQ(sample.frame.side, Hand::right);
    }
    if (device->health().fault == HandFault::other_hand) {
      said = true;
      EXPECT_EQ(device->health().state, DeviceState::degraded);
    }
    again = said && status == ReadStatus::sample && sample.frame.tracked;
    return again && device->health().fault != HandFault::other_hand;
  }));
  EXPECT_GE(device->health().counters.other_side, 60U);
}

TEST_P(LiveHandsInTrouble, BothHandsAreGivenWhereNoneIsChosen) {
  const auto device = heard(hand_play(100, kRate_Hz, true), {}, std::nullopt);
  std::array<int, 2> rows{};
  ASSERT_TRUE(read_until(*device, [&](ReadStatus status, HandSample& sample) {
    if (status == ReadStatus::sample) ++rows[static_cast<std::size_t>(sample.frame.side)];
    return rows[0] > 50 && rows[1] > 50;
  }));
  EXPECT_EQ(device->health().counters.other_side, 0U);
}

TEST_P(LiveHandsInTrouble, APictureThatNeverChangesIsAFault) {
  const auto device = heard(hand_play(300, kRate_Hz), {"freeze=700ms@400ms"});
  bool frozen = false;
  ASSERT_TRUE(read_until(*device, [&](ReadStatus, HandSample&) {
    const HandHealth health = device->health();
    if (health.fault == HandFault::frozen) {
      frozen = true;
      EXPECT_EQ(health.state, DeviceState::faulted);
    }
    return frozen && health.fault == HandFault::none;
  }));
}

TEST_P(LiveHandsInTrouble, AHandWithAJointThatIsNoNumberIsNotTracked) {
  const auto device = heard(hand_play(300, kRate_Hz), {"nan=300ms@400ms"});
  int unseen = 0;
  ASSERT_TRUE(read_until(*device, [&](ReadStatus status, HandSample& sample) {
    if (status != ReadStatus::sample) return false;
    if (!sample.frame.joints[joint_of(Digit::index, 3)].allFinite()) {
      EXPECT_FALSE(sample.frame.tracked);
      ++unseen;
    }
    return unseen > 20 && sample.frame.tracked;
  }));
  EXPECT_EQ(device->health().counters.incomplete, static_cast<std::uint64_t>(unseen));
}

TEST_P(LiveHandsInTrouble, DamageIsCountedAndTheRestGoesOn) {
  const auto device = heard(hand_play(300, kRate_Hz), {"malformed=0.2", "drop=0.2"});
  std::size_t last = 0;
  ASSERT_TRUE(read_until(*device, [&](ReadStatus status, HandSample& sample) {
    if (status != ReadStatus::sample) return false;
    EXPECT_GT(row_of(sample) + 1, last);
    last = row_of(sample);
    return last > 250;
  }));
  const HandCounters counters = device->health().counters;
  EXPECT_GT(counters.malformed, 10U);
  EXPECT_GT(counters.lost, 40U) << "both leave gaps in time";
  EXPECT_EQ(counters.restarts, 0U);
}

TEST_P(LiveHandsInTrouble, TimeGoesOnWhereTheTrackersClockJumps) {
  for (const char* jump : {"clock=-3s@500ms", "clock=2s@500ms"}) {
    const auto device = heard(hand_play(300, kRate_Hz), {jump});
    double last_s = -1.0;
    Timestamp stamp{0};
    ASSERT_TRUE(read_until(*device, [&](ReadStatus status, HandSample& sample) {
      if (status != ReadStatus::sample) return false;
      EXPECT_GT(sample.frame.t_s, last_s);
      EXPECT_GT(sample.stamp, stamp);
      EXPECT_LT(clock_.now() - sample.stamp, 1s) << jump;
      last_s = sample.frame.t_s;
      stamp = sample.stamp;
      return row_of(sample) > 150;
    })) << jump;
    EXPECT_EQ(device->health().counters.clock_steps, 1U) << jump;
    EXPECT_LT(last_s, 2.2) << jump << ": 1.3 s of play, and no jump but that of a busy computer";
  }
}

TEST_P(LiveHandsInTrouble, StartsAgainAfterStop) {
  const auto device = heard(hand_play(2000, kRate_Hz));
  HandSample sample;
  ASSERT_TRUE(read_until(
      *device, [](ReadStatus status, HandSample&) { return status == ReadStatus::sample; }));
  device->stop();
  EXPECT_EQ(device->health().state, DeviceState::configured);
  EXPECT_EQ(device->read(clock_.now() + 1s, sample), ReadStatus::finished);
  must(device->start(clock_));
  EXPECT_TRUE(read_until(*device, [](ReadStatus status, HandSample& again) {
    return status == ReadStatus::sample && again.number == 0 && again.frame.t_s == 0.0;
  }));
}

TEST_P(LiveHandsInTrouble, ReadingEndsAtItsDeadline) {
  const auto device = heard(hand_play(2000, kRate_Hz), {"silence@300ms"});
  HandSample sample;
  ASSERT_TRUE(read_until(*device, [&](ReadStatus, HandSample&) {
    return device->health().fault == HandFault::silence;
  }));
  for (int k = 0; k < 5; ++k) {
    const Timestamp deadline = clock_.now() + 10ms;
    EXPECT_EQ(device->read(deadline, sample), ReadStatus::timeout);
    EXPECT_GE(clock_.now(), deadline);
  }
}

TEST_P(LiveHandsInTrouble, DoNotRunInVirtualTime) {
  auto device = open_hands(GetParam().leap ? "leap://127.0.0.1" : "udp-hand://127.0.0.1");
  ManualClock clock;
  const auto begun = device->start(clock);
  ASSERT_FALSE(begun);
  EXPECT_NE(begun.error().message().find("virtual time"), std::string::npos);
  EXPECT_EQ(device->health().state, DeviceState::absent);
}

INSTANTIATE_TEST_SUITE_P(Wires, LiveHandsInTrouble,
                         testing::Values(Wire{"leap", true}, Wire{"udp", false}), name_of_wire);

}  // namespace
}  // namespace isograsp::hand_contract_test
