// SPDX-License-Identifier: GPL-3.0-or-later
// Emulated cameras on real ports of this computer, served by a thread of their own.
#pragma once

#include <atomic>
#include <cmath>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "device/cameras/marker_device.hpp"
#include "device/emulator/marker_server.hpp"
#include "tests/support/must.hpp"

namespace isograsp::test {

inline constexpr std::uint32_t kThisComputer = 0x7F000001;

/// Three markers at 100 Hz whose numbers are awkward; the second one is lost now and then. x of the
/// first tells the row.
inline MarkerPlay marker_play(std::size_t rows, double rate_Hz = 100.0) {
  MarkerPlay play;
  play.labels = {"A", "B", "C"};
  play.period_s = 1.0 / rate_Hz;
  for (std::size_t k = 0; k < rows; ++k) {
    const auto t = static_cast<double>(k);
    play.t_s.push_back(t / rate_Hz);
    play.p_W.emplace_back(1e-3 * t, 0.1 + t / 3.0 * 1e-3, -1.0 / (t + 1.0));
    play.p_W.push_back(k % 7 == 3 ? Vec3(Vec3::Constant(std::nan("")))
                                  : Vec3(0.3, 1e-3 * t * t / 7.0, 0.2));
    play.p_W.emplace_back(std::sin(t), std::cos(t), 1.0 / 3.0);
  }
  return play;
}

class RunningServer {
 public:
  explicit RunningServer(std::unique_ptr<MarkerServer> server)
      : server_(std::move(server)), thread_([this] { run(); }) {}
  ~RunningServer() { end(); }
  RunningServer(const RunningServer&) = delete;
  RunningServer& operator=(const RunningServer&) = delete;

  void end() {
    ended_ = true;
    if (thread_.joinable()) thread_.join();
  }
  [[nodiscard]] Endpoint address() const { return server_->address(); }
  /// After end().
  [[nodiscard]] const MarkerServer& server() const { return *server_; }

 private:
  void run() {
    constexpr Timestamp kLook = std::chrono::milliseconds(5);
    SteadyClock clock;
    while (!ended_) server_->serve(clock, clock.now() + kLook);
  }
  std::unique_ptr<MarkerServer> server_;
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

inline MarkerScene scene(MarkerPlay play, const std::vector<std::string>& faults = {}) {
  std::vector<EmulatedMarkerFault> parsed;
  for (const std::string& fault : faults) parsed.push_back(must(EmulatedMarkerFault::parse(fault)));
  return must(MarkerScene::make(std::move(play), std::move(parsed), 1));
}
inline std::unique_ptr<RunningServer> qtm_server(MarkerPlay play,
                                                 const std::vector<std::string>& faults = {},
                                                 std::uint16_t port = 0) {
  return std::make_unique<RunningServer>(
      must(open_qtm_server({kThisComputer, port}, scene(std::move(play), faults))));
}
inline std::unique_ptr<RunningServer> natnet_server(MarkerPlay play,
                                                    const std::vector<std::string>& faults = {},
                                                    NatNetVersion version = {4, 1}) {
  EmulatedNatNetOptions options;
  options.version = version;
  return std::make_unique<RunningServer>(
      must(open_natnet_server({kThisComputer, 0}, scene(std::move(play), faults), options)));
}

inline std::unique_ptr<MarkerDevice> open_cameras(const std::string& uri) {
  return must(open_marker_device(must(Uri::parse(uri))));
}
inline std::string uri_of(const std::string& scheme, const RunningServer& server) {
  return scheme + "://" + server.address().text() + "?rig=some.toml";
}

}  // namespace isograsp::test
