// SPDX-License-Identifier: GPL-3.0-or-later
// Emulated trackers of hands on real ports of this computer, served by a thread of their own.
#pragma once

#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "device/bus/udp_port.hpp"
#include "device/hand/hand_device.hpp"
#include "device/hand/hand_server.hpp"
#include "tests/support/must.hpp"

namespace isograsp::test {

inline constexpr std::uint32_t kHandComputer = 0x7F000001;

/// A hand whose numbers are awkward; x of its wrist tells the row.
inline HandFrame made_hand(Hand side, std::size_t row, double t_s) {
  HandFrame hand;
  hand.t_s = t_s;
  hand.side = side;
  hand.tracked = true;
  hand.confidence = 1.0 / (1.0 + static_cast<double>(row % 3));
  for (std::size_t j = 0; j < kHandJointCount; ++j) {
    const double k = static_cast<double>(j) + static_cast<double>(row) / 7.0;
    hand.joints[j] = Vec3(0.1 + k / 300.0, std::sin(k) / 3.0, -1.0 / (k + 1.0));
  }
  hand.joints[kWristJoint].x() = 1e-3 * static_cast<double>(row);
  return hand;
}
inline HandFrame unseen_hand(Hand side, double t_s) {
  HandFrame hand;
  hand.t_s = t_s;
  hand.side = side;
  hand.confidence = 0.0;
  hand.joints.fill(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  return hand;
}
/// The right hand in each row, the left one too where `both`.
inline HandPlay hand_play(std::size_t rows, double rate_Hz, bool both = false) {
  std::vector<HandFrame> hands;
  for (std::size_t k = 0; k < rows; ++k) {
    const double t_s = static_cast<double>(k) / rate_Hz;
    hands.push_back(made_hand(Hand::right, k, t_s));
    if (both) hands.push_back(made_hand(Hand::left, k, t_s));
  }
  return HandPlay::of(std::move(hands));
}
inline HandScene hand_scene(HandPlay play, const std::vector<std::string>& faults = {}) {
  std::vector<EmulatedHandFault> parsed;
  for (const std::string& fault : faults) parsed.push_back(must(EmulatedHandFault::parse(fault)));
  return {std::move(play), std::move(parsed), 1};
}

/// A UDP port of this computer that nobody has.
inline std::uint16_t free_udp_port() {
  UdpPort port;
  must(port.open({kHandComputer, 0}, false));
  return port.local().port;
}

class RunningTracker {
 public:
  explicit RunningTracker(std::unique_ptr<HandServer> server)
      : server_(std::move(server)), thread_([this] { run(); }) {}
  ~RunningTracker() { end(); }
  RunningTracker(const RunningTracker&) = delete;
  RunningTracker& operator=(const RunningTracker&) = delete;

  void end() {
    ended_ = true;
    if (thread_.joinable()) thread_.join();
  }
  [[nodiscard]] Endpoint address() const { return server_->address(); }
  /// After end().
  [[nodiscard]] const HandServer& server() const { return *server_; }

 private:
  void run() {
    constexpr Timestamp kLook = std::chrono::milliseconds(5);
    SteadyClock clock;
    while (!ended_) {
      const Timestamp until = clock.now() + kLook;
      server_->serve(clock, until);
      clock.wait_until(until);
    }
  }
  std::unique_ptr<HandServer> server_;
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

inline std::unique_ptr<RunningTracker> leap_tracker(HandPlay play,
                                                    const std::vector<std::string>& faults = {},
                                                    std::uint16_t port = 0) {
  return std::make_unique<RunningTracker>(
      must(open_leap_server({kHandComputer, port}, hand_scene(std::move(play), faults))));
}
inline std::unique_ptr<RunningTracker> hand_script(HandPlay play, std::uint16_t to,
                                                   const std::vector<std::string>& faults = {}) {
  return std::make_unique<RunningTracker>(
      must(open_hand_sender({kHandComputer, to}, hand_scene(std::move(play), faults))));
}
inline std::unique_ptr<HandDevice> open_hands(const std::string& uri,
                                              std::optional<Hand> side = Hand::right) {
  return must(open_hand_device(must(Uri::parse(uri)), side));
}

}  // namespace isograsp::test
