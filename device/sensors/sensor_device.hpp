// SPDX-License-Identifier: GPL-3.0-or-later
// Three real sensors behind one bus: their conversations, calibration, mounting and health. The bus
// and the protocol come from outside, so the same code runs on a kernel's bus and in virtual time.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "device/bus/bus.hpp"
#include "device/config/device_config.hpp"
#include "device/config/fir.hpp"
#include "device/protocol/make_sessions.hpp"
#include "device/sensors/force_device.hpp"

namespace isograsp {

class SensorDevice final : public ForceDevice {
 public:
  /// `fir` is empty, or designed for config.rate_Hz. `place` names the bus to people ("can0").
  SensorDevice(std::unique_ptr<Bus> bus, SensorSessions sessions, const DeviceConfig& config,
               const std::vector<double>& fir, std::string uri, std::string place);

  [[nodiscard]] const DeviceInfo& info() const noexcept override { return info_; }
  [[nodiscard]] DeviceHealth health() const noexcept override;
  /// Identifies, configures and starts the sensors; some ten milliseconds if they answer, at most
  /// about a second. Fills serial numbers, units and delay of info().
  [[nodiscard]] Result<void> start(Clock& clock) override;
  [[nodiscard]] ReadStatus read(Timestamp deadline, SensorSample& out) noexcept override;
  void stop() noexcept override;

 private:
  /// What is remembered of one sensor besides its conversation.
  struct Track {
    SensorCounters counters;
    FirFilter filter;
    Vec6 last_input = Vec6::Zero();  ///< of the filter
    bool has_input = false;
    std::uint64_t lost_before = 0;  ///< by the conversation, at the last sample
    RawCounts repeated{};
    Timestamp repeated_since = Timestamp::min();
    int repeats = 0;  ///< of that value, up to what is too many
    Timestamp last_overload = Timestamp::min();
    Timestamp last_status_error = Timestamp::min();
    Timestamp last_damage = Timestamp::min();
    Timestamp last_restart = Timestamp::min();
    bool frozen = false;
  };
  /// When a conversation wants to be served next.
  [[nodiscard]] Timestamp due() const noexcept;
  /// Sends what is due.
  void serve(Timestamp now) noexcept;
  void note(BusEvent event) noexcept;
  [[nodiscard]] bool take(const ReceivedFrame& in, SensorSample& out) noexcept;
  void fill(std::size_t finger, const Measurement& measurement, SensorSample& out) noexcept;
  [[nodiscard]] bool repeats_too_long(Track& track, const Measurement& measurement) const noexcept;
  /// False: the filter has no value yet.
  [[nodiscard]] bool smooth(Track& track, std::uint64_t lost, Wrench& wrench_S) noexcept;
  void watch_counters(Timestamp now) noexcept;
  [[nodiscard]] DeviceFault fault_of(std::size_t finger, Timestamp now) const noexcept;

  std::unique_ptr<Bus> bus_;
  SensorSessions sessions_;
  DeviceConfig config_;
  std::string place_;
  DeviceInfo info_;
  double fir_delay_s_;
  std::array<Track, kFingerCount> tracks_;
  Clock* clock_ = nullptr;
  bool started_ = false;
  bool stopped_ = false;
  DeviceFault bus_fault_ = DeviceFault::none;    ///< the bus does not work
  DeviceFault bus_trouble_ = DeviceFault::none;  ///< it works with errors
  Timestamp last_overflow_ = Timestamp::min();
  std::uint64_t known_drops_ = 0;
  Timestamp newest_{0};  ///< stamps never decrease
};

}  // namespace isograsp
