// SPDX-License-Identifier: GPL-3.0-or-later
// The RFT driver and `isograsp emulate` against each other on a CAN bus of the kernel.
#include <algorithm>
#include <cstdio>
#include <utility>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/csv.hpp"
#include "core/finger_forces.hpp"
#include "device/can_bus.hpp"
#include "device/force_device.hpp"
#include "tests/device/counting_play.hpp"
#include "tests/support/command.hpp"
#include "tests/support/no_alloc.hpp"

namespace isograsp {
namespace {

using namespace std::chrono_literals;
using test::TemporaryFolder;

std::string interface() {
  const char* name = std::getenv("ISOGRASP_CAN_INTERFACE");
  return name == nullptr ? "vcan0" : name;
}
std::string uri(const std::string& more = "") {
  return "can://" + interface() + "?protocol=rft" + more;
}

/// The counting forces as a file.
std::string counting_file(const TemporaryFolder& folder) {
  constexpr std::size_t kRows = 2000;
  std::string text;
  for (const auto& name : finger_forces_columns()) text += (name == "t_s" ? "" : ",") + name;
  text += "\n";
  for (std::size_t k = 0; k < kRows; ++k) {
    FingerForcesRow row;
    row.t_s = static_cast<double>(k) / test::kPlayRate_Hz;
    row.present = {true, true, true};
    for (std::size_t f = 0; f < kFingerCount; ++f) row.wrench_C[f] = test::counting_wrench(k, f);
    append_finger_forces(text, row);
  }
  return folder.write("counting.csv", text);
}

/// `isograsp emulate` in a process of its own; finish() waits for its end and returns its counters.
class Emulator {
 public:
  Emulator(const std::string& play, double duration_s, const std::string& more = "") {
    // With one processor, the driver that the first frame of a sample wakes would hold up the
    // second.
    const std::string command =
        "$(chrt -f 20 true 2>/dev/null && echo chrt -f 20) \"" ISOGRASP_EXECUTABLE
        "\" emulate --protocol rft --json --on " +
        interface() + " --play " + play + " --duration " + std::to_string(duration_s) + " " + more;
    pipe_ = popen(command.c_str(), "r");
  }
  ~Emulator() {
    if (pipe_ != nullptr) pclose(pipe_);
  }
  Emulator(const Emulator&) = delete;
  Emulator& operator=(const Emulator&) = delete;

  nlohmann::json finish() {
    std::string text;
    char part[256];
    while (std::fgets(part, sizeof part, pipe_) != nullptr) text += part;
    EXPECT_EQ(pclose(std::exchange(pipe_, nullptr)), 0);
    return nlohmann::json::parse(text);
  }

 private:
  FILE* pipe_;
};

/// Starts the driver as soon as the emulated sensors are there.
std::unique_ptr<ForceDevice> start_driver(SteadyClock& clock) {
  auto device = open_device(uri());
  if (!device) {
    ADD_FAILURE() << device.error().message();
    return nullptr;
  }
  for (int i = 0; i < 30; ++i) {
    const auto started = (*device)->start(clock);
    if (started) return *std::move(device);
    if (i == 29) ADD_FAILURE() << started.error().message();
  }
  return nullptr;
}

struct Taken {
  SensorSample sample;
  Timestamp handed_over;  ///< when read() returned
};

/// Everything until no sample has come for a second.
std::vector<Taken> read_all(ForceDevice& device, const SteadyClock& clock) {
  std::vector<Taken> taken;
  taken.reserve(20'000);
  Timestamp newest = clock.now();
  const auto before = test::allocations();
  while (clock.now() < newest + 1s) {
    Taken next;
    if (device.read(clock.now() + 10ms, next.sample) != ReadStatus::sample) continue;
    next.handed_over = newest = clock.now();
    taken.push_back(next);
  }
  EXPECT_EQ(test::allocations(), before) << "reading must not allocate";
  return taken;
}

std::vector<Taken> of_finger(const std::vector<Taken>& all, std::size_t finger) {
  std::vector<Taken> some;
  std::copy_if(all.begin(), all.end(), std::back_inserter(some),
               [&](const Taken& t) { return index_of(t.sample.finger) == finger; });
  return some;
}

/// The rule of docs/devices.md, applied to the stamps of the samples.
std::uint64_t lost_by_gaps(const std::vector<Taken>& samples) {
  std::uint64_t lost = 0;
  for (std::size_t k = 1; k < samples.size(); ++k) {
    const double periods =
        to_seconds(samples[k].sample.stamp - samples[k - 1].sample.stamp) * test::kPlayRate_Hz;
    if (periods > 1.5) lost += static_cast<std::uint64_t>(std::llround(periods)) - 1;
  }
  return lost;
}

/// Whether every sample came within a third of a period of its time: a computer that is busy with
/// other work holds the emulator up, and then gaps are no losses.
bool came_in_time(const std::vector<Taken>& samples, std::size_t finger) {
  for (std::size_t k = 1; k < samples.size(); ++k) {
    const auto rows = static_cast<double>(test::row_of(samples[k].sample.wrench_C, finger) -
                                          test::row_of(samples[k - 1].sample.wrench_C, finger));
    const double periods =
        to_seconds(samples[k].sample.stamp - samples[k - 1].sample.stamp) * test::kPlayRate_Hz;
    if (std::abs(periods - rows) > 1.0 / 3.0) return false;
  }
  return true;
}

void expect_exact_rows(const std::vector<Taken>& samples, std::size_t finger) {
  for (const auto& [sample, handed_over] : samples) {
    const Wrench expected = test::counting_wrench(test::row_of(sample.wrench_C, finger), finger);
    ASSERT_EQ(sample.wrench_C.force, expected.force);
    ASSERT_EQ(sample.wrench_C.torque, expected.torque);
    ASSERT_TRUE(sample.valid);
  }
}

TEST(RealBus, EverySampleArrivesOnceAndExactly) {
  const TemporaryFolder folder;
  Emulator emulator(counting_file(folder), 6.0);
  SteadyClock clock;
  const auto device = start_driver(clock);
  ASSERT_NE(device, nullptr);
  const auto taken = read_all(*device, clock);
  EXPECT_EQ(device->health().fault, DeviceFault::silence);  // the emulator has ended
  const auto sent = emulator.finish();
  const auto health = device->health();
  std::vector<double> latencies_us;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const auto samples = of_finger(taken, f);
    ASSERT_GT(samples.size(), 300u);
    // None lost, none invented: each row once, in order. A pair that a busy computer pulled apart
    // by more than 2 ms is refused and counted as two halves.
    EXPECT_EQ(samples.size() + health.sensors[f].torn / 2,
              sent["sensors"][f]["samples"].get<std::size_t>());
    for (std::size_t k = 0; k < samples.size(); ++k) {
      if (k > 0) {
        ASSERT_GE(samples[k].sample.stamp, samples[k - 1].sample.stamp);
        ASSERT_GT(test::row_of(samples[k].sample.wrench_C, f),
                  test::row_of(samples[k - 1].sample.wrench_C, f));
      }
      ASSERT_LE(samples[k].sample.stamp, samples[k].handed_over);
      latencies_us.push_back(to_seconds(samples[k].handed_over - samples[k].sample.stamp) * 1e6);
    }
    expect_exact_rows(samples, f);
    EXPECT_EQ(health.sensors[f].good, samples.size());
    const std::size_t rows = test::row_of(samples.back().sample.wrench_C, f) -
                             test::row_of(samples.front().sample.wrench_C, f) + 1;
    EXPECT_EQ(health.sensors[f].lost,
              came_in_time(samples, f) ? rows - samples.size() : lost_by_gaps(samples));
    const double span_s = to_seconds(samples.back().sample.stamp - samples.front().sample.stamp);
    const double rate_Hz = static_cast<double>(rows - 1) / span_s;
    // 200 ppm of clock error, and first and last stamp may be late by tens of milliseconds.
    EXPECT_NEAR(rate_Hz, 100.0, 1.0);
    std::printf("%s: %zu samples, %.3f Hz, lost %llu, torn %llu\n",
                std::string(kFingerNames[f]).c_str(), samples.size(), rate_Hz,
                static_cast<unsigned long long>(health.sensors[f].lost),
                static_cast<unsigned long long>(health.sensors[f].torn));
  }
  EXPECT_EQ(health.foreign_frames, 0u);
  EXPECT_EQ(health.kernel_drops, 0u);
  std::sort(latencies_us.begin(), latencies_us.end());
  std::printf("from kernel stamp to read(): median %.0f us, 99 %% %.0f us, largest %.0f us\n",
              latencies_us[latencies_us.size() / 2], latencies_us[latencies_us.size() * 99 / 100],
              latencies_us.back());
}

TEST(RealBus, CountersEqualWhatTheBusLost) {
  const TemporaryFolder folder;
  Emulator emulator(counting_file(folder), 4.0,
                    "--seed 3 --fault lose=index:tx1:0.2 --fault lose=middle:tx2:0.2");
  SteadyClock clock;
  const auto device = start_driver(clock);
  ASSERT_NE(device, nullptr);
  const auto taken = read_all(*device, clock);
  const auto sent = emulator.finish()["sensors"];
  const auto health = device->health();
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const auto samples = of_finger(taken, f);
    const auto number = [&](const char* key) { return sent[f][key].get<std::uint64_t>(); };
    ASSERT_GT(samples.size(), 100u);
    expect_exact_rows(samples, f);
    // Pairs that a busy computer pulled apart.
    const std::uint64_t apart = number("samples") - number("lost_samples") - samples.size();
    const std::uint64_t halves = number("lost_tx1") + number("lost_tx2");
    const std::uint64_t waiting = halves + 2 * apart - health.sensors[f].torn;
    EXPECT_LE(waiting, 1u);  // a first half may still wait for its second one
    const std::size_t first = test::row_of(samples.front().sample.wrench_C, f);
    const std::size_t last = test::row_of(samples.back().sample.wrench_C, f);
    EXPECT_EQ(health.sensors[f].lost,
              came_in_time(samples, f) ? last - first + 1 - samples.size() : lost_by_gaps(samples));
    if (f > 0) {
      EXPECT_GT(number("lost_samples"), 20u);
    }
    std::printf("%s: %zu samples, lost %llu of %llu dropped, torn %llu\n",
                std::string(kFingerNames[f]).c_str(), samples.size(),
                static_cast<unsigned long long>(health.sensors[f].lost),
                static_cast<unsigned long long>(number("lost_samples")),
                static_cast<unsigned long long>(health.sensors[f].torn));
  }
}

TEST(RealBus, TheRawLogDecodesToWhatWasSent) {
  const TemporaryFolder folder;
  Emulator emulator(counting_file(folder), 6.0);
  const std::string out = folder.path("forces.csv");
  const std::string raw = folder.path("frames.log");
  const std::string decoded = folder.path("samples.csv");
  test::CommandResult recorded;
  for (int i = 0; i < 10 && recorded.status != 0; ++i)  // until the emulator is there
    recorded = test::isograsp("record --device '" + uri() + "' --out " + out + " --raw " + raw +
                              " --duration 2");
  ASSERT_EQ(recorded.status, 0) << recorded.err;
  const auto result = test::isograsp("decode --protocol rft --json " + raw + " --out " + decoded);
  ASSERT_EQ(result.status, 0) << result.err;
  (void)emulator.finish();
  const auto counts = nlohmann::json::parse(result.out);
  EXPECT_EQ(counts["duplicate"], 0);
  EXPECT_EQ(counts["foreign"], 0);

  std::ifstream in(decoded);
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "t_s,sensor,fx_N,fy_N,fz_N,tx_Nm,ty_Nm,tz_Nm,valid,flags");
  std::array<std::size_t, kFingerCount> next{};
  std::size_t missing = 0;
  while (std::getline(in, line)) {
    std::vector<std::string> fields;
    std::istringstream words(line);
    for (std::string field; std::getline(words, field, ',');) fields.push_back(field);
    ASSERT_GE(fields.size(), 9u);
    const std::size_t f = index_of(*finger_from_name(fields[1]));
    const auto row = static_cast<std::size_t>(std::lround(-std::stod(fields[4]) * 50.0)) - 1000 * f;
    ASSERT_GE(row, next[f]);
    missing += row - next[f];
    next[f] = row + 1;
    const Wrench wrench_S = Mounting().to_sensor(test::counting_wrench(row, f));
    for (int axis = 0; axis < 3; ++axis) {
      const auto column = static_cast<std::size_t>(axis);
      EXPECT_EQ(std::stod(fields[2 + column]), wrench_S.force[axis]);
      EXPECT_EQ(std::stod(fields[5 + column]), wrench_S.torque[axis]);
    }
    EXPECT_EQ(fields[8], "1");
  }
  for (const std::size_t rows : next) EXPECT_GE(rows, 190u);
  // Every row from the first one on is there, or its two halves came too far apart; the log may
  // also end within a pair.
  const auto torn = counts["torn"].get<std::size_t>();
  EXPECT_GE(torn, 2 * missing);
  EXPECT_LE(torn, 2 * missing + 2 * kFingerCount);

  // The forces rise by one count per sample, so the frames between them must rise too. A slot
  // without a value stays empty.
  const auto forces = read_signals(out);
  ASSERT_TRUE(forces.ok()) << forces.error().message();
  EXPECT_GE(forces->rows(), 199u);
  for (const char* name : {"thumb_fz_N", "index_fz_N", "middle_fz_N"}) {
    double before = -1.0;
    std::size_t present = 0;
    for (const double value : forces->column(name)) {
      if (std::isnan(value)) continue;
      EXPECT_GT(value, before) << name;
      before = value;
      ++present;
    }
    EXPECT_GT(present, 0u);
    std::printf("%s: %zu of %zu frames have a value\n", name, present, forces->rows());
  }
}

TEST(RealBus, AnInterfaceThatGoesAndComesBackIsToldAndTakenUpAgain) {
  const TemporaryFolder folder;
  Emulator emulator(counting_file(folder), 5.0);
  SteadyClock clock;
  const auto device = start_driver(clock);
  ASSERT_NE(device, nullptr);
  const auto run = [](const std::string& arguments) {
    return std::system(("ip link " + arguments).c_str());
  };
  SensorSample sample;
  const auto read_until = [&](auto reached) {
    for (const Timestamp end = clock.now() + 3s; clock.now() < end && !reached();)
      (void)device->read(clock.now() + 10ms, sample);
    return reached();
  };
  ASSERT_EQ(run("set " + interface() + " down"), 0);
  EXPECT_TRUE(read_until([&] { return device->health().fault == DeviceFault::interface_down; }));
  ASSERT_EQ(run("set " + interface() + " up"), 0);
  EXPECT_TRUE(read_until([&] { return device->health().state != DeviceState::faulted; }));
  ASSERT_EQ(run("delete dev " + interface()), 0);
  EXPECT_TRUE(read_until([&] { return device->health().fault == DeviceFault::interface_gone; }));
  ASSERT_EQ(run("add dev " + interface() + " type vcan"), 0);
  ASSERT_EQ(run("set " + interface() + " up"), 0);
  EXPECT_TRUE(read_until([&] { return device->health().state != DeviceState::faulted; }));
  device->stop();
  (void)emulator.finish();
}

TEST(RealBus, BusOffIsToldAtOnce) {
  auto listener = open_socketcan(interface(), std::array<std::uint32_t, 1>{0x01});
  auto sender = open_socketcan(interface(), {});
  ASSERT_TRUE(listener.ok() && sender.ok());
  SteadyClock clock;
  ASSERT_TRUE((*listener)->start(clock).ok() && (*sender)->start(clock).ok());
  CanFrame bus_off;
  bus_off.error = true;
  bus_off.id = 0x40;
  bus_off.length = 8;
  CanFrame foreign;  // not let in by the filter: extended, remote, another number
  foreign.length = 8;
  foreign.id = 0x01;
  foreign.extended = true;
  (*sender)->send(foreign);
  foreign.extended = false;
  foreign.remote = true;
  (*sender)->send(foreign);
  foreign.remote = false;
  foreign.id = 0x02;
  (*sender)->send(foreign);
  (*sender)->send(bus_off);
  ReceivedFrame in;
  EXPECT_EQ((*listener)->receive(clock.now() + 1s, in), BusEvent::bus_off);
  foreign.id = 0x01;
  (*sender)->send(foreign);
  EXPECT_EQ((*listener)->receive(clock.now() + 1s, in), BusEvent::frame);
  EXPECT_EQ(in.frame, foreign);
  EXPECT_EQ((*listener)->receive(clock.now() + 5ms, in), BusEvent::timeout);
}

TEST(RealBus, WithoutSensorsTheDriverSaysWhoDoesNotAnswer) {
  const auto result = test::isograsp("monitor --device '" + uri() + "' --duration 1");
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("the thumb's sensor (identifier 0x64) does not answer"),
            std::string::npos)
      << result.err;
}

TEST(RealBus, AVirtualClockIsRefused) {
  auto device = open_device(uri());
  ASSERT_TRUE(device.ok());
  ManualClock clock;
  EXPECT_FALSE((*device)->start(clock).ok());
}

}  // namespace
}  // namespace isograsp
