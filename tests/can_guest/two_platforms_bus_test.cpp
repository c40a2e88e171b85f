// SPDX-License-Identifier: GPL-3.0-or-later
// Two platforms on one CAN bus of the kernel: their sensors have other identifiers, each driver
// takes its own and nothing of the other one.
#include <cmath>
#include <numbers>

#include "tests/can_guest/bus_bench.hpp"
#include "tests/device/counting_play.hpp"
#include "tests/support/every.hpp"

namespace isograsp {
namespace {

using test::can_interface;
using test::EmulateProcess;
using test::of_finger;
using test::read_all;
using test::start_driver;
using test::TemporaryFolder;

/// Three RFT sensors with identifiers from these on.
std::string sensors_from(const TemporaryFolder& folder, const std::string& hand, int command_id,
                         int first_id) {
  std::string text = "format = \"isograsp-device-1\"\nname = \"" + hand +
                     "\"\nprotocol = \"rft\"\nhand = \"" + hand + "\"\nfilter_Hz = 0\n";
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const int place = static_cast<int>(f);
    text += "[[sensor]]\nfinger = \"" + std::string(kFingerNames[f]) +
            "\"\ncommand_id = " + std::to_string(command_id + place) +
            "\nfirst_id = " + std::to_string(first_id + 2 * place) +
            "\nsecond_id = " + std::to_string(first_id + 2 * place + 1) + "\n";
  }
  return folder.write(hand + ".toml", text);
}

/// A force that goes up and down by this, twice a second.
std::string swinging_file(const TemporaryFolder& folder, double swing_N) {
  std::vector<double> t_s(1000);
  for (std::size_t k = 0; k < t_s.size(); ++k) t_s[k] = static_cast<double>(k) / test::kPlayRate_Hz;
  return test::forces_file(folder, t_s, [&](std::size_t row, std::size_t) {
    const double way = std::sin(4.0 * std::numbers::pi * t_s[row]);
    return Wrench{Vec3(0.0, 0.0, 50.0 + 0.5 * swing_N * way), Vec3::Zero()};
  });
}

TEST(TwoPlatformsOnOneBus, EachDriverTakesItsOwnSensorsAndNothingOfTheOther) {
  const TemporaryFolder left_folder, right_folder;
  const std::string left = sensors_from(left_folder, "left", 0x64, 0x01);
  const std::string right = sensors_from(right_folder, "right", 0x74, 0x11);
  constexpr double kLeft_N = 6.0, kRight_N = 40.0;
  EmulateProcess left_sensors("rft", swinging_file(left_folder, kLeft_N), 4.0, "--config " + left);
  EmulateProcess right_sensors("rft", swinging_file(right_folder, kRight_N), 4.0,
                               "--config " + right);
  SteadyClock clock;
  const auto uri = [](const std::string& config) {
    return "can://" + can_interface() + "?protocol=rft&config=" + config;
  };
  const auto left_device = start_driver(uri(left), clock);
  const auto right_device = start_driver(uri(right), clock);
  ASSERT_NE(left_device, nullptr);
  ASSERT_NE(right_device, nullptr);
  // One after the other: what comes for the second waits in its socket.
  constexpr std::size_t kSome = 300;
  const auto of_left = read_all(*left_device, clock, kSome);
  const auto of_right = read_all(*right_device, clock, kSome);
  for (const auto& [taken, force_N] :
       {std::pair{&of_left, kLeft_N}, std::pair{&of_right, kRight_N}})
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      const auto samples = of_finger(*taken, f);
      ASSERT_GT(samples.size(), 50u);
      double least_N = 1e9, most_N = -1e9;
      for (const auto& [sample, handed_over] : test::every(samples)) {
        least_N = std::min(least_N, sample.wrench_C.force.z());
        most_N = std::max(most_N, sample.wrench_C.force.z());
      }
      constexpr double kSampled = 0.05;  // samples miss the peaks of the swing by this at most
      EXPECT_NEAR(most_N - least_N, force_N, kSampled * force_N);
    }
  static_cast<void>(left_sensors.finish());
  static_cast<void>(right_sensors.finish());
}

}  // namespace
}  // namespace isograsp
