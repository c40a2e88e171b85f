// SPDX-License-Identifier: GPL-3.0-or-later
// Three emulated sensors of each protocol on a CAN bus of the kernel: every sample that they put on
// the bus arrives, once, in order, with the same value. ISOGRASP_LONG=1: a minute each, on a busy
// processor.
#include <cmath>
#include <random>
#include <thread>

#include "device/bus/candump_log.hpp"
#include "device/bus/tapped_bus.hpp"
#include "device/config/family_facts.hpp"
#include "device/protocol/log_decoder.hpp"
#include "device/sensors/open_sensors.hpp"
#include "tests/can_guest/bus_bench.hpp"
#include "tests/can_guest/bus_load.hpp"
#include "tests/device/counting_play.hpp"
#include "tests/support/within.hpp"

namespace isograsp {
namespace {

using test::of_finger;
using test::Taken;
using test::TemporaryFolder;
using test::WireBits;

struct Stream {
  const char* protocol;
  int rate_Hz;
  bool pushes;  ///< the sensors measure by themselves, each row of the play once
  double bit_rate;
  std::vector<std::uint8_t> lengths;  ///< of the frames of one period: bytes
  std::size_t in_set_up;              ///< samples that the driver asks for before it starts
  double row_step;                    ///< counts of RFT from row to row, more than a rounding error
};

// Bytes on the wire in one period of all three sensors (RFT 2 x 8; ATI question, 8, 6; JR3 one
// synchronisation, then 8, 8 each).
const std::vector<std::uint8_t> kRft(6, 8);
const std::vector<std::uint8_t> kAti{0, 8, 6, 0, 8, 6, 0, 8, 6};
const std::vector<std::uint8_t> kJr3{0, 8, 8, 8, 8, 8, 8};
constexpr double kFast = 1e6;
constexpr double kSlow = 250e3;

// Until the driver notices that the sensors are gone, and a period of rounding.
constexpr double kQuestionsAtTheEnd = 40.0;
constexpr std::size_t kPeriodRows = 4000;  // the counts repeat after so many rows

class EverySample : public testing::TestWithParam<Stream> {
 protected:
  static bool is_long() { return std::getenv("ISOGRASP_LONG") != nullptr; }
  /// The emulated sensors need a moment to be there.
  static double duration_s() { return is_long() ? 61.0 : 5.0; }

  [[nodiscard]] Wrench wrench_of_row(std::size_t row, std::size_t finger) const {
    const auto step = static_cast<std::size_t>(GetParam().row_step);
    return test::counting_wrench(row * step % kPeriodRows, finger);
  }
  /// A sensor that measures by itself meets each row in its middle.
  [[nodiscard]] std::string play(const TemporaryFolder& folder) const {
    const auto rows = static_cast<std::size_t>(duration_s() * GetParam().rate_Hz) + 100;
    std::vector<double> t_s(rows);
    for (std::size_t k = 1; k < rows; ++k)
      t_s[k] = (static_cast<double>(k) - 0.5) / GetParam().rate_Hz;
    return test::forces_file(folder, t_s,
                             [&](std::size_t k, std::size_t f) { return wrench_of_row(k, f); });
  }
  [[nodiscard]] std::string uri() const {
    return "can://" + test::can_interface() + "?protocol=" + GetParam().protocol +
           "&rate=" + std::to_string(GetParam().rate_Hz);
  }
};

/// What an independent reading of the raw frames finds, in contact frames.
std::array<std::vector<Wrench>, kFingerCount> decode(const std::vector<TappedFrame>& frames,
                                                     const DeviceConfig& config) {
  std::array<std::vector<Wrench>, kFingerCount> samples;
  const auto decoder = config.family->make_log_decoder(config);
  Timestamp newest{0};  // the driver lets no stamp go back
  for (const auto& frame : frames) {
    if (!decoder->owns(frame.frame)) continue;
    if (!frame.sent) newest = std::max(newest, frame.stamp);
    if (const auto sample = decoder->push(frame.frame, frame.sent ? frame.stamp : newest);
        sample && sample->valid)
      samples[sample->finger].push_back(
          config.sensors[sample->finger].mounting.to_contact(sample->wrench_S));
  }
  decoder->finish();
  return samples;
}

bool same(const Wrench& a, const Wrench& b) {
  return a.force == b.force && a.torque == b.torque;
}

/// `rate_Hz`: of the samples.
void expect_load_as_computed(const Stream& stream, double rate_Hz,
                             const std::vector<TappedFrame>& frames, Timestamp begin,
                             Timestamp end) {
  WireBits measured;
  std::size_t number = 0;
  for (const auto& frame : frames) {
    if (frame.stamp < begin || frame.stamp >= end || !frame.frame.is_standard()) continue;
    measured += test::wire_bits(frame.frame);
    ++number;
  }
  WireBits period;
  for (const std::uint8_t length : stream.lengths) {
    BusFrame frame;
    frame.length = length;
    period += test::wire_bits(frame);
  }
  const double span_s = to_seconds(end - begin);
  const auto load = [&](double bits_per_s) { return 100.0 * bits_per_s / stream.bit_rate; };
  const double nominal = load(static_cast<double>(measured.nominal) / span_s);
  const double worst = load(static_cast<double>(measured.worst) / span_s);
  const double computed_nominal = load(static_cast<double>(period.nominal) * rate_Hz);
  const double computed_worst = load(static_cast<double>(period.worst) * rate_Hz);
  std::printf(
      "  load at %.0f kbit/s: %.2f %% real, %.2f %% nominal (computed %.2f), %.2f %% worst (%.2f); "
      "%.0f frames/s\n",
      stream.bit_rate / 1e3, load(static_cast<double>(measured.real) / span_s), nominal,
      computed_nominal, worst, computed_worst, static_cast<double>(number) / span_s);
  constexpr double kTolerance = 0.02;  // clocks, the ends of the span, a busy computer
  EXPECT_NEAR(nominal, computed_nominal, kTolerance * computed_nominal);
  EXPECT_NEAR(worst, computed_worst, kTolerance * computed_worst);
}

void print_latencies(const std::vector<Taken>& taken) {
  std::vector<double> us;
  for (const auto& t : taken) us.push_back(to_seconds(t.handed_over - t.sample.stamp) * 1e6);
  std::sort(us.begin(), us.end());
  std::printf("  kernel stamp to read(): median %.0f us, 99.9 %% %.0f us, largest %.0f us\n",
              us[us.size() / 2], us[us.size() * 999 / 1000], us.back());
}

TEST_P(EverySample, ArrivesOnceInOrderAndExactly) {
  const Stream& stream = GetParam();
  const TemporaryFolder folder;
  test::EmulateProcess emulator(stream.protocol, play(folder), duration_s());
  std::jthread load;
  if (is_long())
    load = std::jthread([](const std::stop_token& stop) {
      while (!stop.stop_requested()) {
      }
    });
  SteadyClock clock;
  const auto config = config_of(*Uri::parse(uri()));
  ASSERT_TRUE(config.ok());
  DeviceOptions options;
  options.tap = std::make_shared<BusTap>(static_cast<std::size_t>(
      (duration_s() + 1.0) * stream.rate_Hz * static_cast<double>(stream.lengths.size()) + 1000));
  const auto device = test::start_driver(uri(), clock, options);
  ASSERT_NE(device, nullptr);
  const auto taken = test::read_all(
      *device, clock, static_cast<std::size_t>(3 * (duration_s() + 1.0) * stream.rate_Hz));
  EXPECT_EQ(device->health().fault, DeviceFault::silence);  // the emulator has ended
  const auto sent = emulator.finish();
  const auto health = device->health();
  std::vector<TappedFrame> frames;
  for (TappedFrame frame; options.tap->ring.pop(frame);) frames.push_back(frame);
  EXPECT_EQ(options.tap->overrun, 0u);
  const auto decoded = decode(frames, *config);

  std::printf("%s, %d Hz:\n", stream.protocol, stream.rate_Hz);
  constexpr std::uint64_t kAtTheEnd = 1;  // when the emulator is gone, the driver begins anew
  // For so long that sensors had to be set up again, or the buffer was full: that is counted, too.
  const bool stood_still =
      health.bus.kernel_drops > 0 ||
      std::ranges::any_of(health.sensors, [](const auto& s) { return s.restarts > kAtTheEnd; });
  ASSERT_FALSE(taken.empty());
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const auto samples = of_finger(taken, f);
    const SensorCounters& counters = health.sensors[f];
    ASSERT_GT(samples.size(), 20u);
    EXPECT_EQ(counters.good, samples.size());
    // None lost, none invented: what was sent came, or it was refused and counted: two halves that
    // a busy computer pulled apart by more than 2 ms, an answer after its time. A sensor that the
    // driver had to set up again, because the computer stood still, was heard by nobody meanwhile.
    const auto number_sent = sent["sensors"][f]["samples"].get<std::size_t>();
    const std::size_t refused = counters.late + stream.in_set_up;
    if (!stood_still) {
      EXPECT_EQ(samples.size() + refused + counters.torn / 2, number_sent);
      EXPECT_EQ(samples.size() + refused, decoded[f].size());
    } else {
      EXPECT_LE(samples.size(), number_sent);
    }
    // The same values as somebody else finds in the raw frames.
    std::size_t next = 0;
    for (std::size_t k = 0; k < samples.size(); ++k, ++next) {
      while (next < decoded[f].size() && !same(samples[k].sample.wrench_C, decoded[f][next]))
        ++next;
      ASSERT_LT(next, decoded[f].size()) << k;
    }
    // And the same as the finger pressed.
    std::size_t row = 0;
    std::uint64_t plays = 1;  // each start of an RFT sensor begins the play again
    for (std::size_t k = 0; k < samples.size(); ++k) {
      const SensorSample& sample = samples[k].sample;
      ASSERT_TRUE(sample.valid);
      ASSERT_LE(sample.stamp, samples[k].handed_over);
      const auto rows = kPeriodRows / static_cast<std::size_t>(stream.row_step);
      const double counts = sample.wrench_C.force.z() * 50.0 - 1000.0 * static_cast<double>(f);
      const auto phase = static_cast<std::size_t>(std::llround(counts / stream.row_step)) % rows;
      const std::size_t on = (phase + rows - row % rows) % rows;
      if (k > 0) {
        ASSERT_GE(sample.stamp, samples[k - 1].sample.stamp);
        // A sensor that is asked may be asked twice in one row of the play.
        const bool goes_on = on < rows / 2 && (on > 0 || !stream.pushes);
        if (!goes_on) ++plays;
      }
      row += on;
      const Wrench expected = wrench_of_row(row, f);
      if (stream.pushes) {
        ASSERT_TRUE(same(sample.wrench_C, expected)) << k;
      } else {
        constexpr double kRounding_N = 0.08;  // six gages, half a count each
        constexpr double kRounding_Nm = 0.004;
        ASSERT_WITHIN((sample.wrench_C.force - expected.force).cwiseAbs().maxCoeff(), 0.0,
                      kRounding_N);
        ASSERT_WITHIN((sample.wrench_C.torque - expected.torque).cwiseAbs().maxCoeff(), 0.0,
                      kRounding_Nm);
      }
    }
    EXPECT_LE(plays, counters.restarts);
    const double span_s = to_seconds(samples.back().sample.stamp - samples.front().sample.stamp);
    if (stream.in_set_up == 0)
      EXPECT_EQ(counters.lost, test::lost_by_gaps(samples, stream.rate_Hz));
    else  // questions in time, and those that the driver could not ask
      EXPECT_NEAR(static_cast<double>(samples.size() + counters.lost),
                  span_s * stream.rate_Hz + 1.0, kQuestionsAtTheEnd);
    const double rate_Hz = static_cast<double>(samples.size() - 1) / span_s;
    std::printf("  %s: %zu samples, %.2f Hz, lost %llu, torn %llu, late %llu, restarts %llu\n",
                std::string(kFingerNames[f]).c_str(), samples.size(), rate_Hz,
                static_cast<unsigned long long>(counters.lost),
                static_cast<unsigned long long>(counters.torn),
                static_cast<unsigned long long>(counters.late),
                static_cast<unsigned long long>(counters.restarts));
  }
  EXPECT_EQ(health.foreign_frames, 0u);
  EXPECT_EQ(health.bus.unsent, 0u);
  print_latencies(taken);
  const bool late = std::ranges::any_of(health.sensors, [](const auto& s) { return s.late > 0; });
  if (stood_still || late) {
    std::printf("  the computer stood still: the load says nothing\n");
    return;
  }
  const Timestamp begin = taken.front().sample.stamp;
  const Timestamp end = taken.back().sample.stamp;
  // A driver that a busy computer holds up asks less often.
  const double asked_Hz =
      static_cast<double>(taken.size()) / (kFingerCount * to_seconds(end - begin));
  expect_load_as_computed(stream, stream.pushes ? stream.rate_Hz : asked_Hz, frames, begin, end);
}

INSTANTIATE_TEST_SUITE_P(OnABus, EverySample,
                         testing::Values(Stream{"rft", 100, true, kFast, kRft, 0, 1},
                                         Stream{"rft", 333, true, kFast, kRft, 0, 1},
                                         Stream{"rft", 500, true, kFast, kRft, 0, 1},
                                         Stream{"ati-netcanoem", 100, false, kSlow, kAti, 1, 10},
                                         Stream{"jr3-can", 100, false, kFast, kJr3, 0, 10}),
                         [](const auto& stream) {
                           std::string name =
                               stream.param.protocol + ("_" + std::to_string(stream.param.rate_Hz));
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(WireBits, StuffingLiesBetweenNoneAndTheWorst) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 20'000; ++k) {
    BusFrame frame;
    frame.id = static_cast<std::uint32_t>(random() & 0x7FFU);
    frame.length = static_cast<std::uint8_t>(random() % 9);
    for (std::size_t i = 0; i < frame.length; ++i)
      frame.data[i] = static_cast<std::uint8_t>(random() % 4 == 0 ? random() : 0);
    const WireBits bits = test::wire_bits(frame);
    EXPECT_EQ(bits.nominal, 47u + 8u * frame.length);
    EXPECT_GE(bits.real, bits.nominal);
    EXPECT_LE(bits.real, bits.worst);
  }
}

TEST(WireBits, OfTheGoldenLog) {
  auto log = CandumpReader::open(ISOGRASP_SOURCE_DIR "/tests/data/golden_rft.log");
  ASSERT_TRUE(log.ok());
  CandumpEntry entry;
  WireBits all;
  std::uint64_t number = 0;
  for (auto more = log->next(entry); more && *more; more = log->next(entry)) {
    if (entry.frame.data[0] == 0 || entry.frame.id > 6) continue;
    all += test::wire_bits(entry.frame);
    ++number;
  }
  ASSERT_GT(number, 10u);
  EXPECT_EQ(all.nominal, 111 * number);
  EXPECT_EQ(all.worst, 135 * number);
  std::printf("%.1f bits in the mean\n",
              static_cast<double>(all.real) / static_cast<double>(number));
}

}  // namespace
}  // namespace isograsp
