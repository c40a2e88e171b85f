// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/device/raw_log.hpp"

#include <chrono>

#include "device/bus/candump_log.hpp"
#include "device/bus/datagram_log.hpp"
#include "device/family/buses.hpp"
#include "device/sensors/open_sensors.hpp"

namespace isograsp::app {

Result<std::unique_ptr<RawLog>> RawLog::open(const std::string& device, const std::string& path) {
  const auto uri = Uri::parse(device);
  if (!uri) return uri.error();
  if (uri->scheme != "can" && uri->scheme != "udp")
    return refused("only devices on a CAN bus or a network have raw frames"_text,
                   "leave it out, or record a can:// or udp:// device"_text)
        .about("--raw");
  const auto config = config_of(*uri);
  if (!config) return config.error();
  std::string interface;
  std::array<Endpoint, kFingerCount> sensors{};
  if (uri->scheme == "can") {
    interface = config->interface;
  } else {
    const auto addresses = udp_addresses(*config);
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      const auto endpoint = parse_endpoint(addresses[f]);
      if (!endpoint)
        return refused("'%1' is no address in numbers"_text(addresses[f]),
                       "give addresses like 192.168.1.1"_text)
            .at(uri->text);
      sensors[f] = *endpoint;
    }
  }
  auto file = FileWriter::create(path);
  if (!file) return file.error();
  auto log = std::unique_ptr<RawLog>(new RawLog(*std::move(file), path));
  log->interface_ = interface;
  log->sensors_ = sensors;
  constexpr std::size_t kRoom = 1 << 15;  // seconds of the fastest sensors
  log->tap_ = std::make_shared<BusTap>(kRoom);
  return log;
}

void RawLog::start() {
  thread_ = std::thread([this] { run(); });
}

void RawLog::stop() {
  running_ = false;
  if (thread_.joinable()) thread_.join();
}

void RawLog::run() {
  constexpr auto kLook = std::chrono::milliseconds(20);
  TappedFrame frame;
  while (true) {
    const bool last_look = !running_;
    while (tap_->ring.pop(frame)) write(frame);
    if (last_look) return;
    std::this_thread::sleep_for(kLook);
  }
}

void RawLog::write(const TappedFrame& frame) {
  if (!interface_.empty())
    file_.write(format_candump_line(frame.wall_time, interface_, frame.frame) + "\n");
  else if (frame.frame.id < kFingerCount)
    file_.write(
        format_datagram_line(frame.wall_time, sensors_[frame.frame.id], frame.frame.bytes()) +
        "\n");
}

Result<void> RawLog::finish() {
  stop();
  if (auto written = file_.commit(); !written) return written;
  if (const auto overrun = tap_->overrun.load(); overrun > 0)
    return failed("%1 frames are missing: this computer was too slow"_text(overrun),
                  "close other programs and record again"_text)
        .at(path_);
  return {};
}

}  // namespace isograsp::app
