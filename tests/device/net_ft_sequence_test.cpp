// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/codec/net_ft_sequence.hpp"

#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/every.hpp"

namespace isograsp::net_ft_sequence_test {
namespace {

using namespace std::chrono_literals;
using Place = NetFtSequence::Place;

constexpr std::uint32_t kStep = 7;  // measurements inside per record: 1000 of 7000 Hz
constexpr std::uint32_t kOn = 1'000'000;

NetFtRecord numbered(std::uint32_t rdt, std::uint32_t ft) {
  NetFtRecord record;
  record.rdt_sequence = rdt;
  record.ft_sequence = ft;
  return record;
}
NetFtRecord numbered(std::uint32_t rdt) {
  return numbered(rdt, kOn + kStep * rdt);
}

Place push(NetFtSequence& sequence, const NetFtRecord& record) {
  return sequence.push(record, 1s);
}

TEST(NetFtSequence, FollowsTheRulesOfTheDifferences) {
  NetFtSequence sequence;
  EXPECT_EQ(push(sequence, numbered(5)), Place::in_order);  // a log may begin anywhere
  EXPECT_EQ(push(sequence, numbered(6)), Place::in_order);
  EXPECT_EQ(push(sequence, numbered(6)), Place::duplicate);
  EXPECT_EQ(push(sequence, numbered(10)), Place::in_order);
  EXPECT_EQ(sequence.lost(), 3u);
  EXPECT_EQ(push(sequence, numbered(8)), Place::late);
  EXPECT_EQ(push(sequence, numbered(8)), Place::duplicate);
  EXPECT_EQ(push(sequence, numbered(11)), Place::in_order);
  EXPECT_EQ(sequence.lost(), 3u);
  EXPECT_EQ(sequence.late(), 1u);
  EXPECT_EQ(sequence.duplicate(), 2u);
}

TEST(NetFtSequence, BothCountersMayWrap) {
  for (std::uint32_t i = 0; i < 200; ++i) {
    NetFtSequence sequence;
    const std::uint32_t rdt = UINT32_MAX - i;
    const std::uint32_t ft = UINT32_MAX - 3 * i;
    std::uint64_t lost = 0;
    std::uint32_t before = 0;
    EXPECT_EQ(push(sequence, numbered(rdt, ft)), Place::in_order);
    for (std::uint32_t k = 1; k < 400; k += 1 + k % 3) {
      EXPECT_EQ(push(sequence, numbered(rdt + k, ft + kStep * k)), Place::in_order);
      EXPECT_EQ(push(sequence, numbered(rdt + k, ft + kStep * k)), Place::duplicate);
      lost += k - before - 1;
      before = k;
    }
    EXPECT_EQ(sequence.lost(), lost);
    EXPECT_GT(lost, 0u);
    EXPECT_EQ(sequence.late(), 0u);
    EXPECT_EQ(sequence.restarts(), 0u);
  }
}

TEST(NetFtSequence, AnUnchangedInnerCounterIsAStalledSensor) {
  NetFtSequence sequence;
  (void)push(sequence, numbered(1, kOn));
  EXPECT_EQ(push(sequence, numbered(2, kOn)), Place::stalled);
  EXPECT_EQ(push(sequence, numbered(3, kOn)), Place::stalled);
  EXPECT_EQ(push(sequence, numbered(4, kOn + 1)), Place::in_order);
  EXPECT_EQ(sequence.stalled(), 2u);
  EXPECT_EQ(sequence.lost(), 0u);
}

/// Every way in which a short stream may arrive: each record lost, once or twice, in every order.
TEST(NetFtSequence, CountsExactlyUnderEveryPatternOfLossRepetitionAndOrder) {
  constexpr int kRecords = 5;
  int patterns = 0;
  for (int fates = 0; fates < 243; ++fates) {  // 3^5
    std::vector<std::uint32_t> arrivals;
    std::uint64_t lost = 0;
    std::uint64_t twice = 0;
    for (int k = 0, rest = fates; k < kRecords; ++k, rest /= 3) {
      const int copies = rest % 3;
      lost += copies == 0 ? 1 : 0;
      twice += copies == 2 ? 1 : 0;
      for (int copy = 0; copy < copies; ++copy)
        arrivals.push_back(static_cast<std::uint32_t>(10 + k));
    }
    std::sort(arrivals.begin(), arrivals.end());
    do {
      NetFtSequence sequence;
      // The stream is known before and goes on after.
      (void)push(sequence, numbered(9));
      std::set<std::uint32_t> used;
      std::uint32_t newest = 9;
      for (const auto number : arrivals) {
        const Place place = push(sequence, numbered(number));
        const bool fresh = used.insert(number).second;
        ASSERT_EQ(place, !fresh            ? Place::duplicate
                         : number > newest ? Place::in_order
                                           : Place::late);
        newest = std::max(newest, number);
      }
      ASSERT_EQ(push(sequence, numbered(15)), Place::in_order);
      ASSERT_EQ(sequence.lost() - sequence.late(), lost);
      ASSERT_EQ(sequence.duplicate(), twice);
      ASSERT_EQ(sequence.restarts() + sequence.stalled(), 0u);
      ++patterns;
    } while (std::next_permutation(arrivals.begin(), arrivals.end()));
  }
  EXPECT_GT(patterns, 100'000);
}

TEST(NetFtSequence, CountsExactlyInLongRandomStreams) {
  std::mt19937_64 random(3);
  for (int round = 0; round < 200; ++round) {
    struct Arrival {
      std::uint64_t when;
      NetFtRecord record;
    };
    std::vector<Arrival> arrivals;
    std::uint64_t lost = 0;
    std::uint64_t twice = 0;
    const auto first = static_cast<std::uint32_t>(random());
    const auto ft = static_cast<std::uint32_t>(random());
    constexpr std::uint32_t kRecords = 2000;
    for (std::uint32_t k = 0; k <= kRecords; ++k) {
      const bool end = k == 0 || k == kRecords;  // both ends of the stream are seen
      const auto fate = end ? 99 : random() % 100;
      lost += fate < 10 ? 1 : 0;
      twice += fate >= 10 && fate < 20 ? 1 : 0;
      for (int copy = 0; copy < (fate < 10 ? 0 : fate < 20 ? 2 : 1); ++copy) {
        const std::uint64_t delay = end || random() % 4 != 0 ? 0 : random() % 50;
        arrivals.push_back({4 * (k + delay), numbered(first + k, ft + kStep * k)});
      }
    }
    std::stable_sort(arrivals.begin(), arrivals.end(),
                     [](const Arrival& a, const Arrival& b) { return a.when < b.when; });
    NetFtSequence sequence;
    std::uint64_t used = 0;
    std::uint32_t newest = 0;
    for (const auto& arrival : test::every(arrivals)) {
      const Place place = push(sequence, arrival.record);
      const std::uint32_t k = arrival.record.rdt_sequence - first;
      if (place == Place::in_order) {
        ASSERT_TRUE(k == 0 || k > newest) << "never backwards";
        newest = k;
      }
      used += place == Place::in_order || place == Place::late ? 1 : 0;
    }
    EXPECT_EQ(sequence.lost() - sequence.late(), lost);
    EXPECT_EQ(sequence.duplicate(), twice);
    EXPECT_EQ(used, kRecords + 1 - lost);
    EXPECT_EQ(sequence.restarts(), 0u);
  }
}

TEST(NetFtSequence, AfterAStartOnlyTheNewStreamCounts) {
  NetFtSequence sequence;
  sequence.start(10s);
  EXPECT_EQ(sequence.push(numbered(5000), 10s + 100us), Place::stale);
  EXPECT_EQ(sequence.push(numbered(5001), 10s + 200us), Place::stale);
  EXPECT_EQ(sequence.push(numbered(1), 10s + 1ms), Place::in_order);
  EXPECT_EQ(sequence.push(numbered(5002), 10s + 1ms), Place::impossible);
  EXPECT_EQ(sequence.lost(), 0u);
}

constexpr double kRate_Hz = 100.0;

/// A box that sends at 100 Hz, started at 10 s, and has sent this many records.
struct Stream {
  explicit Stream(std::uint32_t count) {
    sequence.start(start);
    for (std::uint32_t k = 1; k <= count; ++k)
      EXPECT_EQ(sequence.push(numbered(k), when(k)), Place::in_order);
  }
  [[nodiscard]] Timestamp when(std::uint32_t k) const { return start + 10ms * (k - 1); }

  Timestamp start = 10s;
  NetFtSequence sequence{kRate_Hz};
};

TEST(NetFtSequence, ANumberThatCannotHaveBeenSentYetIsCountedAndChangesNothing) {
  for (const std::uint32_t length : {1U, 50U, 1000U, 100'000U})
    for (const std::uint32_t jump : {1U, 2U, 10U, 64U, 5000U, 1'000'000U, 0x7FFFFFFFU}) {
      Stream stream(length);
      const auto early = stream.when(length) + 3ms;
      const auto far = numbered(length + jump, kOn + kStep * (length + 1));
      EXPECT_EQ(stream.sequence.push(far, early), Place::impossible) << length << " " << jump;
      EXPECT_EQ(stream.sequence.push(numbered(length + 1), stream.when(length + 1)),
                Place::in_order);
      EXPECT_EQ(stream.sequence.lost(), 0u);
      EXPECT_EQ(stream.sequence.late(), 0u);
      EXPECT_EQ(stream.sequence.impossible(), 1u);
      EXPECT_EQ(stream.sequence.restarts(), 0u);
    }
}

TEST(NetFtSequence, ASecondRecordThreeMillisecondsAfterTheFirstIsNoneAtAHundredHertz) {
  Stream stream(1);
  EXPECT_EQ(stream.sequence.push(numbered(2), stream.when(1) + 3ms), Place::impossible);
  EXPECT_EQ(stream.sequence.push(numbered(2), stream.when(2)), Place::in_order)
      << "the box's own comes at its time";
  EXPECT_EQ(stream.sequence.impossible(), 1u);
  EXPECT_EQ(stream.sequence.duplicate(), 0u);
}

/// A stream whose box has a clock that is fast (or slow: negative) by this part.
Timestamp sent_at(std::uint32_t k, double rate_Hz, double fast) {
  return 10s + std::chrono::duration_cast<Timestamp>(
                   std::chrono::duration<double>((k - 1) / (rate_Hz * (1.0 + fast))));
}

TEST(NetFtSequence, ARecordBeforeItsTimeIsImpossibleHoweverLongTheStreamAndWhateverTheClock) {
  int asked = 0;
  for (const double fast : {-0.019, -0.005, -1e-4, 0.0, 1e-4, 0.005, 0.019}) {
    NetFtSequence sequence(kRate_Hz);
    sequence.start(10s);
    for (std::uint32_t k = 1; k < 400'000; ++k) {
      ASSERT_EQ(sequence.push(numbered(k), sent_at(k, kRate_Hz, fast)), Place::in_order)
          << fast << " " << k;
      if (k > 50 && k % 997 != 0) continue;
      NetFtSequence forged = sequence;
      ASSERT_EQ(forged.push(numbered(k + 1), sent_at(k, kRate_Hz, fast) + 3ms), Place::impossible)
          << fast << " " << k;
      ASSERT_EQ(forged.push(numbered(k + 1), sent_at(k + 1, kRate_Hz, fast)), Place::in_order)
          << "the box's own comes at its time";
      ++asked;
    }
    EXPECT_EQ(sequence.impossible() + sequence.restarts(), 0u);
  }
  EXPECT_GT(asked, 7 * 400);
}

/// Delays of each record that a network really has; no record overtakes another.
struct Delay {
  const char* name;
  Timestamp most;
  Timestamp bunched;     ///< records come at whole multiples of this only; 0: at any time
  double stall_every_s;  ///< one record in this time waits for 0.3 s; 0: none
};

TEST(NetFtSequence, DelaysOfARealNetworkAreNoForgery) {
  int streams = 0;
  for (const Delay& delay : {Delay{"quiet", 100us, 0us, 0.0}, Delay{"jitter", 1ms, 0us, 0.0},
                             Delay{"bunches", 100us, 4ms, 0.0}, Delay{"stalls", 200us, 0us, 5.0}})
    for (const double rate_Hz : {10.0, 100.0, 1000.0, 7000.0})
      for (const double fast : {-0.019, -1e-4, 0.0, 1e-4, 0.009}) {
        std::mt19937_64 random(5);
        NetFtSequence sequence(rate_Hz);
        sequence.start(10s);
        Timestamp before = 10s;
        for (std::uint32_t k = 1; k <= 60'000; ++k) {
          Timestamp stamp = sent_at(k, rate_Hz, fast) +
                            Timestamp(random() % static_cast<std::uint64_t>(delay.most.count()));
          if (delay.stall_every_s > 0.0 &&
              random() % static_cast<std::uint64_t>(delay.stall_every_s * rate_Hz) == 0)
            stamp += 300ms;
          if (delay.bunched.count() > 0)
            stamp += delay.bunched - Timestamp(stamp.count() % delay.bunched.count());
          before = std::max(before, stamp);
          ASSERT_EQ(sequence.push(numbered(k), before), Place::in_order)
              << delay.name << " " << rate_Hz << " Hz, fast by " << fast << ", record " << k;
        }
        ++streams;
      }
  EXPECT_EQ(streams, 4 * 4 * 5);
}

TEST(NetFtSequence, WhenALongDelayEndsTheStreamGoesOnAndNothingBeganAnew) {
  for (const Timestamp held : {50ms, 200ms, 500ms})
    for (const std::uint32_t lasted : {10U, 100U, 1000U, 10'000U}) {
      Stream stream(1000);
      Timestamp before = stream.when(1000);
      std::uint32_t refused = 0;
      for (std::uint32_t k = 1001; k < 13'000; ++k) {
        before = std::max(before, stream.when(k) + (k <= 1000 + lasted ? held : 0ms));
        const auto place = stream.sequence.push(numbered(k), before);
        ASSERT_TRUE(place == Place::in_order || place == Place::impossible) << k;
        refused += place == Place::impossible ? 1 : 0;
      }
      // No more than came at once when the delay ended, and one; a short delay costs none.
      EXPECT_LE(refused, lasted == 10 ? 0 : held / 10ms + 1) << held.count() << " " << lasted;
      EXPECT_EQ(stream.sequence.lost(), refused);
      EXPECT_EQ(stream.sequence.restarts(), 0u);
    }
}

TEST(NetFtSequence, AnInnerCounterThatJumpsIsImpossible) {
  Stream stream(100);
  EXPECT_EQ(stream.sequence.push(numbered(101, kOn + 1'000'000), stream.when(101)),
            Place::impossible);
  EXPECT_EQ(stream.sequence.push(numbered(101), stream.when(101)), Place::in_order);
  EXPECT_EQ(stream.sequence.restarts(), 0u);
}

TEST(NetFtSequence, WhatTheNetworkKeptComesAtOnceAndIsGood) {
  for (const std::uint32_t kept : {1U, 5U, 30U, 99U}) {
    Stream stream(200);
    for (std::uint32_t k = 201; k <= 200 + kept; ++k)
      EXPECT_EQ(stream.sequence.push(numbered(k), stream.when(200 + kept)), Place::in_order);
    EXPECT_EQ(stream.sequence.push(numbered(201 + kept), stream.when(201 + kept)), Place::in_order);
    EXPECT_EQ(stream.sequence.impossible(), 0u);
    EXPECT_EQ(stream.sequence.lost(), 0u);
  }
}

TEST(NetFtSequence, AfterASilenceOfAnyLengthTheLostOnesAreCounted) {
  for (const std::uint32_t silence : {1U, 30U, 1000U, 1'000'000U}) {
    Stream stream(200);
    const std::uint32_t next = 201 + silence;
    EXPECT_EQ(stream.sequence.push(numbered(next), stream.when(next)), Place::in_order);
    EXPECT_EQ(stream.sequence.lost(), silence);
  }
}

TEST(NetFtSequence, ABoxWhoseClockIsOnePercentFastStaysGoodForAnHour) {
  NetFtSequence sequence(kRate_Hz);
  sequence.start(10s);
  for (std::uint32_t k = 1; k <= 360'000; ++k)
    ASSERT_EQ(sequence.push(numbered(k), 10s + 9900us * (k - 1)), Place::in_order);
}

TEST(NetFtSequence, WhoeverForgesRecordsLostAgreesWithTheTime) {
  std::mt19937_64 random(11);
  for (int round = 0; round < 100; ++round) {
    Stream stream(1);
    const auto records = static_cast<std::uint32_t>(10 + random() % 500);
    for (std::uint32_t k = 2; k <= records; ++k) {
      const auto stamp = stream.when(k) + (random() % 9) * 1ms;
      const auto ahead = static_cast<std::uint32_t>(random() >> (32 + random() % 32));
      if (random() % 3 == 0) (void)stream.sequence.push(numbered(k + ahead), stamp);
      (void)stream.sequence.push(numbered(k), stamp);
    }
    constexpr double kLeastSlack = 8.0;  // 50 ms of jitter, and roundings
    EXPECT_LE(static_cast<double>(stream.sequence.lost()), 1.02 * records + kLeastSlack);
  }
}

TEST(NetFtSequence, TheFirstRecordsOfAStreamMayBeLost) {
  for (std::uint32_t first = 1; first < 100; ++first) {
    NetFtSequence sequence;
    sequence.start(10s);
    const auto stamp = 10s + first * 10ms;
    EXPECT_EQ(sequence.push(numbered(first), stamp), Place::in_order);
    EXPECT_EQ(sequence.lost(), first - 1);
  }
  NetFtSequence early;
  early.start(10s);
  EXPECT_EQ(early.push(numbered(1), 9s), Place::stale) << "before the start";
  EXPECT_EQ(early.push(numbered(0), 11s), Place::stale) << "streams begin with 1";
}

TEST(NetFtSequence, ARebootIsBelievedWithItsSecondRecord) {
  NetFtSequence sequence;
  for (std::uint32_t k = 1; k <= 500; ++k) (void)push(sequence, numbered(k));
  EXPECT_EQ(push(sequence, numbered(1, 70)), Place::unplaced);
  EXPECT_EQ(push(sequence, numbered(2, 77)), Place::restarted);
  EXPECT_EQ(push(sequence, numbered(3, 84)), Place::in_order);
  EXPECT_EQ(sequence.restarts(), 1u);
  EXPECT_EQ(sequence.lost(), 0u);
}

TEST(NetFtSequence, ARebootIsSeenAlsoInsideTheMemoryOfTheStream) {
  NetFtSequence sequence;
  for (std::uint32_t k = 1; k <= 5; ++k) (void)push(sequence, numbered(k));
  EXPECT_EQ(push(sequence, numbered(1, 70)), Place::unplaced);
  EXPECT_EQ(push(sequence, numbered(2, 77)), Place::restarted);
}

TEST(NetFtSequence, AStreamThatSomebodyElseBeganAnewIsSeen) {
  NetFtSequence sequence;
  for (std::uint32_t k = 1; k <= 500; ++k) (void)push(sequence, numbered(k));
  const std::uint32_t ft = kOn + kStep * 500;
  EXPECT_EQ(push(sequence, numbered(1, ft + 7)), Place::unplaced);
  EXPECT_EQ(push(sequence, numbered(3, ft + 21)), Place::restarted);
  EXPECT_EQ(sequence.lost(), 1u);
}

TEST(NetFtSequence, OneStrayRecordChangesNothing) {
  NetFtSequence sequence;
  for (std::uint32_t k = 1; k <= 500; ++k) {
    EXPECT_EQ(push(sequence, numbered(k)), Place::in_order);
    if (k == 300) {
      EXPECT_EQ(push(sequence, numbered(1, 70)), Place::unplaced);
    }
    if (k == 400) {
      EXPECT_EQ(push(sequence, numbered(7, 90)), Place::unplaced);
    }
  }
  EXPECT_EQ(sequence.restarts(), 0u);
  EXPECT_EQ(sequence.lost(), 0u);
  EXPECT_EQ(sequence.late(), 2u);
}

TEST(NetFtSequence, CountersBeginAnewAndThePlaceStays) {
  NetFtSequence sequence;
  (void)push(sequence, numbered(1));
  (void)push(sequence, numbered(4));
  sequence.reset_counters();
  EXPECT_EQ(push(sequence, numbered(6)), Place::in_order);
  EXPECT_EQ(sequence.lost(), 1u);
}

}  // namespace
}  // namespace isograsp::net_ft_sequence_test
