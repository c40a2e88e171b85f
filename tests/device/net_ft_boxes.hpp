// SPDX-License-Identifier: GPL-3.0-or-later
// Three emulated Net F/T boxes on real sockets of this computer, on a thread of their own, and the
// whole driver for them.
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "device/config/net_ft_sensor.hpp"
#include "device/emulator/emulator.hpp"
#include "device/emulator/net_ft_server.hpp"
#include "device/protocol/net_ft_session.hpp"
#include "device/sensors/sensor_device.hpp"
#include "tests/device/counting_play.hpp"

namespace isograsp::test {

inline constexpr std::uint32_t kLoopback = 0x7F000001;

class Boxes {
 public:
  explicit Boxes(EmulatorOptions options) : Boxes(std::move(options), counting_play(100'000)) {}
  Boxes(EmulatorOptions options, FingerPlay play)
      : emulator_rate_Hz_(options.config.rate_Hz), emulator_(std::move(options), std::move(play)) {
    NetFtServerOptions server;
    for (std::uint32_t f = 0; f < kFingerCount; ++f) {
      server.boxes[f].records = {kLoopback + f, 0};
      server.boxes[f].pages = {kLoopback + f, 0};
    }
    server.set_rate = [rate_Hz = emulator_rate_Hz_](std::size_t, double wanted_Hz) {
      return wanted_Hz == rate_Hz;
    };
    server_ = NetFtServer::open(server).value();
    EXPECT_TRUE(server_->start(clock_));
    thread_ = std::thread([this] { run(); });
  }
  ~Boxes() { end(); }
  void end() {
    ended_ = true;
    if (thread_.joinable()) thread_.join();
  }
  /// Nothing is measured any more; what was sent stays to be read.
  void finish() {
    finishing_ = true;
    while (finishing_) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  [[nodiscard]] std::string address(std::size_t finger) const {
    return server_->records(finger).text();
  }
  /// As a device file writes it: with the port of its pages.
  [[nodiscard]] std::string full_address(std::size_t finger) const {
    return address(finger) + ":" + std::to_string(server_->pages(finger).port);
  }
  /// @pre finished or ended
  [[nodiscard]] const EmulatorCounters& counters(std::size_t finger) const {
    return emulator_.counters()[finger];
  }

 private:
  void run() {
    ReceivedFrame in;
    BusFrame out;
    while (!ended_) {
      if (finishing_) {
        emulator_.finish(clock_.now());
        while (emulator_.take(Timestamp::max(), out)) server_->send(out);
        finishing_ = false;
      }
      const Timestamp next =
          std::min(emulator_.next(), clock_.now() + std::chrono::milliseconds(2));
      if (server_->receive(next, in) == BusEvent::frame) emulator_.receive(in.frame, in.stamp);
      while (emulator_.take(clock_.now(), out)) server_->send(out);
    }
  }
  double emulator_rate_Hz_;
  Emulator emulator_;
  SteadyClock clock_;
  std::unique_ptr<NetFtServer> server_;
  std::atomic<bool> ended_{false};
  std::atomic<bool> finishing_{false};
  std::thread thread_;
};

inline std::unique_ptr<SensorDevice> open_boxes(const Boxes& boxes, DeviceConfig config) {
  SensorSessions sessions;
  std::array<std::string, kFingerCount> addresses;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    addresses[f] = boxes.address(f);
    config.sensors[f].connection = NetFtSensor{addresses[f]};
    sessions[f] = std::make_unique<NetFtSession>(config, f, NetFtBoxConfig{});
  }
  auto bus = open_udp(addresses);
  EXPECT_TRUE(bus) << bus.error().message();
  return std::make_unique<SensorDevice>(*std::move(bus), std::move(sessions), config,
                                        std::vector<double>{}, "udp://test", "udp");
}

}  // namespace isograsp::test
