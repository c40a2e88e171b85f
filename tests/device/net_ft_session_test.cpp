// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/protocol/net_ft_session.hpp"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "device/config/net_ft_sensor.hpp"
#include "device/emulator/emulated_net_ft.hpp"
#include "tests/device/conversation.hpp"
#include "tests/device/hex.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"

namespace isograsp::net_ft_session_test {
namespace {

using namespace std::chrono_literals;

/// Counts that number themselves: fx of finger f at sample n is n + 1000 f counts of a box.
Wrench counting(std::size_t finger, double play_s) {
  const double n = std::round(play_s * 100.0) + 1000.0 * static_cast<double>(finger);
  return {Vec3(n, -n, 2.0 * n) * 1e-6, Vec3(3.0, n, -n) * 1e-6};
}

struct Bench : test::Conversation {
  explicit Bench(double rate_Hz = 100.0, const NetFtBoxConfig& box = {}) {
    config.rate_Hz = rate_Hz;
    for (std::size_t f = 0; f < kFingerCount; ++f)
      add(std::make_unique<NetFtSession>(config, f, box), make_emulated_net_ft(f, config));
    wrench = counting;
  }
  [[nodiscard]] std::vector<Measurement> of(std::size_t finger) const {
    std::vector<Measurement> found;
    for (const auto& one : taken)
      if (one.finger == finger) found.push_back(one.measurement);
    return found;
  }
  [[nodiscard]] std::uint64_t sent_by(std::size_t finger) const {
    return static_cast<std::uint64_t>(std::count_if(
        sent.begin(), sent.end(), [&](const Sent& one) { return one.finger == finger; }));
  }

  DeviceConfig config = DeviceConfig::standard(kNetFtFamily);
};

TEST(NetFtSession, StopsAsksOnceAndStarts) {
  Bench bench;
  bench.begin();
  bench.run_for(60ms);
  std::vector<test::Bytes> to_thumb;
  for (const auto& frame : bench.asked)
    if (frame.id == 0) to_thumb.push_back(test::bytes_of(frame));
  EXPECT_EQ(to_thumb,
            (std::vector<test::Bytes>{test::hex("1234000000000000"), test::hex("1234000200000001"),
                                      test::hex("1234000200000000")}));
  for (const auto& session : test::every(bench.sessions)) EXPECT_TRUE(session->streaming());
  EXPECT_EQ(bench.sessions[0]->stop_frame(), encode_net_ft_request(0, {NetFtCommand::stop, 0}));
}

TEST(NetFtSession, EveryRecordArrivesWithItsValueOnceAndInOrder) {
  for (const double rate_Hz : {100.0, 500.0, 1000.0}) {
    Bench bench(rate_Hz);
    bench.wrench = [&](std::size_t f, double play_s) {
      return counting(f, std::round(play_s * rate_Hz) / 100.0);
    };
    bench.begin();
    bench.run_for(5s);
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      const auto samples = bench.of(f);
      ASSERT_GT(samples.size(), static_cast<std::size_t>(4.9 * rate_Hz));
      ASSERT_EQ(samples.size(), bench.sent_by(f));
      for (std::size_t n = 0; n < samples.size(); ++n) {
        const auto number = static_cast<std::int32_t>(n + 1000 * f);
        ASSERT_EQ(samples[n].raw_counts,
                  (RawCounts{number, -number, 2 * number, 3, number, -number}));
        ASSERT_TRUE(samples[n].valid);
        ASSERT_TRUE(samples[n].numbered);
        ASSERT_EQ(samples[n].wrench_S.force.x(), number / 1e6);
      }
      const auto counters = bench.sessions[f]->counters();
      EXPECT_EQ(
          counters.lost + counters.duplicate + counters.late + counters.foreign + counters.restarts,
          0u);
    }
  }
}

TEST(NetFtSession, CountsLossExactlyAlsoAtTheBeginning) {
  Bench bench;
  std::mt19937_64 random(1);
  std::array<std::uint64_t, kFingerCount> lost{};
  bench.lose = [&](const test::Conversation::Sent& sample) {
    const bool first = sample.number < 2;
    if (!first && random() % 20 != 0) return 0U;
    ++lost[sample.finger];
    return 1U;
  };
  bench.begin();
  bench.run_for(20s);
  bench.lose = [](const test::Conversation::Sent&) { return 0U; };
  bench.run_for(50ms);
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    EXPECT_GT(lost[f], 50u);
    EXPECT_EQ(bench.sessions[f]->counters().lost, lost[f]);
    EXPECT_EQ(bench.of(f).size() + lost[f], bench.sent_by(f));
  }
}

TEST(NetFtSession, DropsDuplicatesAndLateRecordsAndCountsThem) {
  Bench bench;
  bench.begin();
  bench.run_for(1s);
  const auto record_of = [&](std::size_t back) {
    std::size_t k = bench.sent.size();
    for (std::size_t n = 0; n <= back;)
      if (bench.sent[--k].finger == 1) ++n;
    return bench.sent[k].frames.front();
  };
  const auto before = bench.of(1).size();
  bench.to_host(record_of(0));
  bench.to_host(record_of(5));
  EXPECT_EQ(bench.of(1).size(), before);
  EXPECT_EQ(bench.sessions[1]->counters().duplicate, 2u);

  // One is held back until the next two have come.
  BusFrame held;
  bench.lose = [&](const test::Conversation::Sent& sample) {
    if (sample.finger != 1 || held.length != 0) return 0U;
    held = sample.frames.front();
    return 1U;
  };
  bench.run_for(30ms);
  bench.to_host(held);
  EXPECT_EQ(bench.sessions[1]->counters().lost, 1u);
  EXPECT_EQ(bench.sessions[1]->counters().late, 1u);
  std::int32_t last = INT32_MIN;
  for (const auto& sample : test::every(bench.of(1))) {
    EXPECT_GT(sample.raw_counts[0], last) << "never backwards";
    last = sample.raw_counts[0];
  }
}

TEST(NetFtSession, ForgedRecordsAreCountedAsForeignAndTheStreamGoesOn) {
  Bench bench;
  bench.begin();
  bench.run_for(1s);
  const auto newest_of = [&](std::size_t finger) {
    std::size_t k = bench.sent.size();
    while (bench.sent[--k].finger != finger) continue;
    return *decode_net_ft_record(bench.sent[k].frames.front().bytes());
  };
  const auto before = bench.of(1).size();
  for (const std::uint32_t jump : {1'000'000U, 500U, 100U}) {
    NetFtRecord forged = newest_of(1);
    forged.rdt_sequence += jump;
    forged.ft_sequence += 10;
    bench.to_host(encode_net_ft_record(1, forged));
    bench.run_for(1s);
  }
  const auto counters = bench.sessions[1]->counters();
  EXPECT_EQ(counters.foreign, 3u);
  EXPECT_EQ(counters.lost + counters.late + counters.duplicate + counters.restarts, 0u);
  EXPECT_EQ(bench.of(1).size(), before + 300);
}

TEST(NetFtSession, CountsExactlyOnANetworkThatReorders) {
  Bench bench;
  std::mt19937_64 random(5);
  bench.leave = [&](Timestamp when) { return when + random() % 4 * 9ms; };
  std::uint64_t lost = 0;
  bench.lose = [&](const test::Conversation::Sent& sample) {
    const bool loses = sample.finger == 0 && random() % 10 == 0;
    lost += loses ? 1 : 0;
    return loses ? 1U : 0U;
  };
  bench.begin();
  bench.run_for(30s);
  bench.lose = [](const test::Conversation::Sent&) { return 0U; };
  bench.leave = [](Timestamp when) { return when + 36ms; };
  bench.run_for(100ms);
  const auto counters = bench.sessions[0]->counters();
  EXPECT_GT(counters.late, 100u);
  EXPECT_EQ(counters.lost - counters.late, lost);
  EXPECT_EQ(counters.duplicate, 0u);
  EXPECT_EQ(counters.restarts, 0u);
}

TEST(NetFtSession, ABoxThatRebootedIsStartedAgain) {
  Bench bench;
  bench.begin();
  bench.run_for(2s);
  bench.sensors[1]->power_dip(bench.now, bench);
  const auto before = bench.of(1).size();
  bench.run_for(1s);
  EXPECT_EQ(bench.sessions[1]->counters().restarts, 1u);
  EXPECT_TRUE(bench.sessions[1]->streaming());
  EXPECT_GT(bench.of(1).size(), before + 80) << "back within 200 ms";
  EXPECT_EQ(bench.sessions[0]->counters().restarts, 0u);
  EXPECT_EQ(bench.sessions[2]->counters().restarts, 0u);
}

TEST(NetFtSession, AStreamThatBeginsAnewByItselfIsARestart) {
  Bench bench;
  bench.begin();
  bench.run_for(2s);
  for (std::uint32_t rdt = 1; rdt <= 2; ++rdt)
    bench.to_host(encode_net_ft_record(0, {rdt, 70 * rdt, 0, {}}));
  EXPECT_EQ(bench.sessions[0]->counters().restarts, 1u);
  EXPECT_FALSE(bench.sessions[0]->streaming());
  bench.run_for(500ms);
  EXPECT_TRUE(bench.sessions[0]->streaming());
}

TEST(NetFtSession, RecordsOfTheStreamBeforeAreNotTaken) {
  Bench bench;
  // Somebody else has started the boxes; they stop only when they are told to.
  for (std::uint32_t f = 0; f < kFingerCount; ++f)
    bench.put_on_bus(encode_net_ft_request(f, {NetFtCommand::start, 0}));
  bench.run_for(2s);
  EXPECT_TRUE(bench.taken.empty());
  const auto old_stream = bench.sent.back();
  bench.begin();
  bench.run_for(40ms);
  ASSERT_TRUE(bench.sessions[old_stream.finger]->streaming());
  const auto before = bench.taken.size();
  bench.to_host(old_stream.frames.front());  // was under way for a long time
  EXPECT_EQ(bench.taken.size(), before);
  bench.run_for(1s);
  EXPECT_EQ(bench.sessions[old_stream.finger]->counters().lost, 0u);
}

TEST(NetFtSession, ABoxThatDoesNotAnswerIsToldAfterThreeTries) {
  Bench bench;
  bench.mute = true;
  bench.begin();
  bench.run_for(500ms);
  for (const auto& session : test::every(bench.sessions)) {
    EXPECT_EQ(session->failure(), SensorSession::Failure::no_answer);
    EXPECT_NE(session->error("thumb", "udp").message().find("192.168.1."), std::string::npos);
  }
  EXPECT_EQ(std::count_if(bench.asked.begin(), bench.asked.end(),
                          [](const BusFrame& frame) {
                            return frame.id == 0 && decode_net_ft_request(frame.bytes()) ==
                                                        NetFtRequest{NetFtCommand::start, 1};
                          }),
            3);
  bench.mute = false;
  bench.run_for(2s);
  for (const auto& session : test::every(bench.sessions)) EXPECT_TRUE(session->streaming());
}

TEST(NetFtSession, AValueThatTheBoxCallsWrongIsNotValid) {
  NetFtBoxConfig axia;
  axia.product = NetFtProduct::axia;
  for (const auto& [box, status, valid, saturated, overload] :
       {std::tuple(NetFtBoxConfig{}, 0x80010000U, true, false, false),
        std::tuple(NetFtBoxConfig{}, 0x80020000U, false, true, false),
        std::tuple(NetFtBoxConfig{}, 0x88000000U, false, false, false),
        std::tuple(axia, 0x88000000U, false, true, false),
        std::tuple(axia, 0xC0000000U, false, false, true)}) {
    Bench bench(100.0, box);
    bench.begin();
    bench.run_for(1s);
    auto record = *decode_net_ft_record(bench.sent.back().frames.front().bytes());
    const std::size_t finger = bench.sent.back().finger;
    record.rdt_sequence += 1;
    record.ft_sequence += 70;
    record.status = status;
    bench.to_host(encode_net_ft_record(static_cast<std::uint32_t>(finger), record));
    const Measurement& last = bench.taken.back().measurement;
    EXPECT_EQ(last.status, status);
    EXPECT_EQ(last.valid, valid);
    EXPECT_EQ(last.status_error, !valid);
    EXPECT_EQ(last.saturated, saturated);
    EXPECT_EQ(last.overload, overload);
  }
}

TEST(NetFtSession, AStalledSensorGivesNoValidValues) {
  Bench bench;
  bench.begin();
  bench.run_for(1s);
  auto record = *decode_net_ft_record(bench.sent.back().frames.front().bytes());
  const auto finger = static_cast<std::uint32_t>(bench.sent.back().finger);
  record.rdt_sequence += 1;
  const auto before = bench.taken.size();
  bench.to_host(encode_net_ft_record(finger, record));
  ASSERT_EQ(bench.taken.size(), before + 1);
  EXPECT_FALSE(bench.taken.back().measurement.valid);
  EXPECT_FALSE(bench.taken.back().measurement.numbered);
  EXPECT_FALSE(bench.taken.back().measurement.status_error);
}

TEST(NetFtSession, AnEmulatedBoxPressedBeyondItsRangeSaysSo) {
  Bench bench;
  bench.wrench = [&](std::size_t f, double) {
    return Wrench{Vec3(0, 0, f == 2 ? -1.3 * bench.config.sensors[2].range[2] : 0), Vec3::Zero()};
  };
  bench.begin();
  bench.run_for(1s);
  for (const auto& one : test::every(bench.taken)) {
    EXPECT_EQ(one.measurement.valid, one.finger != 2);
    EXPECT_EQ(one.measurement.saturated, one.finger == 2);
    EXPECT_EQ(one.measurement.status, one.finger == 2 ? 0x80020000u : 0u);
  }
}

TEST(NetFtSession, CountsWhatIsNoRecord) {
  Bench bench;
  bench.begin();
  bench.run_for(1s);
  BusFrame cut = bench.sent.back().frames.front();
  cut.id = 0;
  cut.length = 35;
  bench.to_host(cut);
  cut.length = 72;  // of a longer datagram: two records
  bench.to_host(cut);
  BusFrame strange = bench.sent.back().frames.front();
  strange.id = 0;
  strange.remote = true;
  bench.to_host(strange);
  EXPECT_EQ(bench.sessions[0]->counters().foreign, 3u);
  bench.sessions[0]->reset_counters();
  EXPECT_EQ(bench.sessions[0]->counters().foreign, 0u);
  bench.run_for(100ms);
  EXPECT_EQ(bench.sessions[0]->counters().lost, 0u);
}

TEST(NetFtSession, TellsScaleDelayAndSerialNumber) {
  NetFtBoxConfig box;
  box.serial_number = "FT27462";
  box.filter_Hz = 73.0;
  box.scale.counts_per_unit_force = 1000.0;
  const Bench bench(100.0, box);
  EXPECT_EQ(bench.sessions[0]->serial_number(), "FT27462");
  EXPECT_DOUBLE_EQ(bench.sessions[0]->units_per_count()[0], 0.001);
  EXPECT_DOUBLE_EQ(bench.sessions[0]->units_per_count()[5], 1e-6);
  EXPECT_NEAR(bench.sessions[0]->sensor_delay_s(), 0.00218, 1e-5);
  EXPECT_EQ(Bench().sessions[0]->sensor_delay_s(), 0.0);
}

TEST(NetFtSession, DoesNotAllocateWhileItStreams) {
  Bench bench;
  bench.begin();
  bench.run_for(1s);
  const auto finger = static_cast<std::uint32_t>(bench.sent.back().finger);
  auto record = *decode_net_ft_record(bench.sent.back().frames.front().bytes());
  Measurement out;
  const auto before = test::allocations();
  for (std::uint32_t n = 1; n < 100; ++n) {
    record.rdt_sequence += n % 7 == 0 ? 2 : 1;
    record.ft_sequence += 70;
    (void)bench.sessions[finger]->take(encode_net_ft_record(finger, record), bench.now, out);
    (void)bench.sessions[finger]->poll(bench.now);
  }
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace isograsp::net_ft_session_test
