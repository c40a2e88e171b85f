// SPDX-License-Identifier: GPL-3.0-or-later
// The driver and `isograsp emulate` against each other on a CAN bus of the kernel: lost frames, raw
// logs, an interface that goes and comes back.
#include "core/csv.hpp"
#include "device/bus/bus.hpp"
#include "tests/can_guest/bus_bench.hpp"
#include "tests/device/counting_play.hpp"
#include "tests/support/every.hpp"

namespace isograsp {
namespace {

using namespace std::chrono_literals;
using test::can_interface;
using test::EmulateProcess;
using test::lost_by_gaps;
using test::of_finger;
using test::read_all;
using test::start_driver;
using test::Taken;
using test::TemporaryFolder;

std::string uri() {
  return "can://" + can_interface() + "?protocol=rft";
}

/// The counting forces as a file.
std::string counting_file(const TemporaryFolder& folder) {
  std::vector<double> t_s(1000);
  for (std::size_t k = 0; k < t_s.size(); ++k) t_s[k] = static_cast<double>(k) / test::kPlayRate_Hz;
  return test::forces_file(folder, t_s, test::counting_wrench);
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
  for (const auto& [sample, handed_over] : test::every(samples)) {
    const Wrench expected = test::counting_wrench(test::row_of(sample.wrench_C, finger), finger);
    ASSERT_EQ(sample.wrench_C.force, expected.force);
    ASSERT_EQ(sample.wrench_C.torque, expected.torque);
    ASSERT_TRUE(sample.valid);
  }
}

TEST(RealBus, CountersEqualWhatTheBusLost) {
  const TemporaryFolder folder;
  EmulateProcess emulator("rft", counting_file(folder), 3.0,
                          "--seed 3 --fault lose=index:tx1:0.2 --fault lose=middle:tx2:0.2");
  SteadyClock clock;
  const auto device = start_driver(uri(), clock);
  ASSERT_NE(device, nullptr);
  const auto taken = read_all(*device, clock, 10'000);
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
    EXPECT_EQ(health.sensors[f].lost, came_in_time(samples, f)
                                          ? last - first + 1 - samples.size()
                                          : lost_by_gaps(samples, test::kPlayRate_Hz));
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
  EmulateProcess emulator("rft", counting_file(folder), 5.0);
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
  bool stood_still = false;
  while (std::getline(in, line)) {
    std::vector<std::string> fields;
    std::istringstream words(line);
    for (std::string field; std::getline(words, field, ',');) fields.push_back(field);
    ASSERT_GE(fields.size(), 9u);
    const std::size_t f = index_of(*finger_from_name(fields[1]));
    const auto row = static_cast<std::size_t>(std::lround(-std::stod(fields[4]) * 50.0)) - 1000 * f;
    // After a silence that a busy computer made, the driver starts the sensor anew.
    constexpr std::size_t kFirstRows = 10;
    if (row < kFirstRows && next[f] > kFirstRows) {
      stood_still = true;
      next[f] = row;
    }
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
  if (stood_still) {
    std::printf("the computer stood still: nothing to say about what is missing\n");
    return;
  }
  for (const std::size_t rows : next) EXPECT_GE(rows, 150u);
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
    for (const double value : test::every(forces->column(name))) {
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
  EmulateProcess emulator("rft", counting_file(folder), 6.0);
  SteadyClock clock;
  const auto device = start_driver(uri(), clock);
  ASSERT_NE(device, nullptr);
  const auto run = [](const std::string& arguments) {
    return std::system(("ip link " + arguments).c_str());
  };
  SensorSample sample;
  const auto read_until = [&](auto reached) {
    constexpr int kLeastLooks = 400;  // a computer that stands still proves nothing
    const Timestamp end = clock.now() + 3s;
    for (int looks = 0; (clock.now() < end || looks < kLeastLooks) && !reached(); ++looks)
      (void)device->read(clock.now() + 10ms, sample);
    return reached();
  };
  ASSERT_EQ(run("set " + can_interface() + " down"), 0);
  EXPECT_TRUE(read_until([&] { return device->health().fault == DeviceFault::interface_down; }));
  ASSERT_EQ(run("set " + can_interface() + " up"), 0);
  EXPECT_TRUE(read_until([&] { return device->health().state != DeviceState::faulted; }));
  ASSERT_EQ(run("delete dev " + can_interface()), 0);
  EXPECT_TRUE(read_until([&] { return device->health().fault == DeviceFault::interface_gone; }))
      << name_of(device->health().fault);
  ASSERT_EQ(run("add dev " + can_interface() + " type vcan"), 0);
  ASSERT_EQ(run("set " + can_interface() + " up"), 0);
  EXPECT_TRUE(read_until([&] { return device->health().state != DeviceState::faulted; }));
  device->stop();
  (void)emulator.finish();
}

TEST(RealBus, BusOffIsToldAtOnce) {
  auto listener = open_socketcan(can_interface(), std::array<std::uint32_t, 1>{0x01});
  auto sender = open_socketcan(can_interface(), {});
  ASSERT_TRUE(listener.ok() && sender.ok());
  SteadyClock clock;
  ASSERT_TRUE((*listener)->start(clock).ok() && (*sender)->start(clock).ok());
  BusFrame bus_off;
  bus_off.error = true;
  bus_off.id = 0x40;
  bus_off.length = 8;
  BusFrame foreign;  // not let in by the filter: extended, remote, another number
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
