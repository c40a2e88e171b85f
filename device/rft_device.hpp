// SPDX-License-Identifier: GPL-3.0-or-later
// Three Robotous RFT sensors on one CAN bus as a ForceDevice. The bus is handed in, so that the
// whole device also runs without a kernel bus and in virtual time.
#pragma once

#include <memory>
#include <string>

#include "device/can_bus.hpp"
#include "device/device_config.hpp"
#include "device/force_device.hpp"
#include "device/rft_session.hpp"

namespace isograsp {

class RftDevice final : public ForceDevice {
 public:
  /// `place` names the bus to people ("can0"). @pre rft_rate_code(rate_Hz) and
  /// rft_filter_code(config.filter_Hz) exist
  RftDevice(std::unique_ptr<CanBus> bus, const RftConfig& config, double rate_Hz, std::string uri,
            std::string place);

  [[nodiscard]] const DeviceInfo& info() const noexcept override { return info_; }
  [[nodiscard]] DeviceHealth health() const noexcept override;
  /// Stops, identifies, configures and starts the sensors; about 30 ms if they answer, at most
  /// 0.4 s. Fills the serial numbers of info().
  [[nodiscard]] Result<void> start(Clock& clock) override;
  [[nodiscard]] ReadStatus read(Timestamp deadline, SensorSample& out) noexcept override;
  void stop() noexcept override;

 private:
  /// When a conversation wants to be served next.
  [[nodiscard]] Timestamp due() const noexcept;
  /// Sends what is due.
  void serve(Timestamp now) noexcept;
  [[nodiscard]] bool take(const ReceivedFrame& in, SensorSample& out) noexcept;
  void fill(std::size_t finger, const RftCounts& counts, Timestamp stamp,
            SensorSample& out) noexcept;
  [[nodiscard]] std::uint64_t trouble() const noexcept;

  std::unique_ptr<CanBus> bus_;
  RftConfig config_;
  std::string place_;
  DeviceInfo info_;
  std::array<RftSession, kFingerCount> sessions_;
  std::array<SensorCounters, kFingerCount> counters_{};
  Clock* clock_ = nullptr;
  bool started_ = false;
  bool stopped_ = false;
  DeviceFault bus_fault_ = DeviceFault::none;
  Timestamp newest_{0};  ///< stamps never decrease
  std::uint64_t known_trouble_ = 0;
  Timestamp last_trouble_ = Timestamp::min();
  Timestamp last_overload_ = Timestamp::min();
};

}  // namespace isograsp
