// SPDX-License-Identifier: GPL-3.0-or-later
// The buses that families share, and where the sensors are on them.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "core/result.hpp"
#include "device/bus/bus.hpp"
#include "device/config/device_config.hpp"
#include "device/config/family_facts.hpp"
#include "device/config/uri.hpp"

namespace isograsp {

/// Of all three sensors; none: they are not on CAN.
[[nodiscard]] CanIds can_ids(const DeviceConfig& config);
/// "HOST:PORT" of each sensor on a network; empty: not known.
[[nodiscard]] std::array<std::string, kFingerCount> udp_addresses(const DeviceConfig& config);

// For FamilyBus::open.

/// The interface that the configuration names, open for what these sensors send.
[[nodiscard]] Result<std::unique_ptr<Bus>> open_can_bus(const Uri& uri, const DeviceConfig& config);
/// Datagrams of these sensors. Errors: an address that is missing.
[[nodiscard]] Result<std::unique_ptr<Bus>> open_udp_bus(const Uri& uri, const DeviceConfig& config);
/// Fails if the address of a sensor is missing.
[[nodiscard]] Result<void> check_addresses(const Uri& uri,
                                           const std::array<std::string, kFingerCount>& addresses);

}  // namespace isograsp
