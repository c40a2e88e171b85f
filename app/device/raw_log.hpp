// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the raw frames of a device's bus to a log, on a thread of its own: candump lines of a CAN
// bus, lines of datagrams of a network.
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <string>
#include <thread>

#include "core/csv.hpp"
#include "core/result.hpp"
#include "device/bus/endpoint.hpp"
#include "device/bus/tapped_bus.hpp"
#include "hand/finger.hpp"

namespace isograsp::app {

class RawLog {
 public:
  /// `device` is the URI of what is recorded. Errors: no bus with a log format, or the file.
  [[nodiscard]] static Result<std::unique_ptr<RawLog>> open(const std::string& device,
                                                            const std::string& path);
  ~RawLog() { stop(); }

  /// What the device has to be opened with.
  [[nodiscard]] const std::shared_ptr<BusTap>& tap() const noexcept { return tap_; }
  void start();
  /// Writes what is left; fails if the file cannot be written or frames found no room.
  [[nodiscard]] Result<void> finish();

 private:
  RawLog(FileWriter file, std::string path) : file_(std::move(file)), path_(std::move(path)) {}
  void stop();
  void run();
  void write(const TappedFrame& frame);

  FileWriter file_;
  std::string path_;
  std::string interface_;                         ///< of CAN; empty: datagrams
  std::array<Endpoint, kFingerCount> sensors_{};  ///< of datagrams
  std::shared_ptr<BusTap> tap_;
  std::atomic<bool> running_{true};
  std::thread thread_;
};

}  // namespace isograsp::app
