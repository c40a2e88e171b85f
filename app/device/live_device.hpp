// SPDX-License-Identifier: GPL-3.0-or-later
// A device at the command line: opened by URI, with a person who presses if it is a simulated one,
// read frame by frame on the strict grid until time is up or Ctrl-C.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/result.hpp"
#include "device/config/device_config.hpp"
#include "device/sensors/force_device.hpp"
#include "hand/finger.hpp"
#include "hand/stimulus.hpp"
#include "session/acquisition/realtime.hpp"
#include "session/acquisition/timing.hpp"
#include "virtual_patient/virtual_patient.hpp"

namespace isograsp::app {

/// What somebody who presses, holds and releases every ten seconds sees on the screen: relax for
/// 2 s, follow 12 N for 5 s, relax. `grip_N` is the force that the screen shows.
[[nodiscard]] Stimulus press_hold_release(double t_s, double grip_N);

/// The device file for --protocol and --config of decode and emulate: the family's standard if no
/// file is given. Errors name the option or the file.
[[nodiscard]] Result<DeviceConfig> family_config(const std::string& protocol,
                                                 const std::string& file);

class LiveDevice {
 public:
  /// `tap` gets the raw frames of a device on a bus.
  [[nodiscard]] static Result<LiveDevice> open(const std::string& uri,
                                               const std::shared_ptr<BusTap>& tap = nullptr);

  [[nodiscard]] ForceDevice& device() noexcept { return *device_; }
  /// This thread, which run() works on, asks for real time and notes on standard error what it got.
  [[nodiscard]] static Result<void> ask_for(session::Realtime wish);
  /// Starts the device and hands every frame on until `duration_s` is over (0: no end), the
  /// recording ends, Ctrl-C is pressed or `on_frame` returns false; then stops it.
  [[nodiscard]] Result<void> run(double duration_s,
                                 const std::function<bool(const FingerFrame&)>& on_frame);
  /// Of the frames of run(); the work is that of `on_frame`.
  [[nodiscard]] const session::Timing& timing() const noexcept { return timing_; }

 private:
  LiveDevice() = default;
  std::unique_ptr<virtual_patient::VirtualPatient> person_;
  std::unique_ptr<ForceDevice> device_;
  session::Timing timing_;
};

/// From now on Ctrl-C and SIGTERM set a flag instead of ending the program.
void watch_for_interrupt();
[[nodiscard]] bool interrupted() noexcept;

}  // namespace isograsp::app
