// SPDX-License-Identifier: GPL-3.0-or-later
// can://IFACE?protocol=…, udp://HOST,HOST,HOST?protocol=…, serial://PORT,PORT,PORT?protocol=…:
// three sensors on a bus.
#pragma once

#include <memory>

#include "core/result.hpp"
#include "device/config/device_config.hpp"
#include "device/config/uri.hpp"
#include "device/sensors/force_device.hpp"

namespace isograsp {

/// Opens the bus and reads the configuration (docs/devices.md). Errors name the interface, the
/// protocol or the parameter. The sensors stay untouched until start().
[[nodiscard]] Result<std::unique_ptr<ForceDevice>> open_sensors(const Uri& uri,
                                                                const DeviceOptions& options);

/// The configuration of a device URI: the configuration file or the protocol's standard, in which
/// interface or addresses, rate and fir of the URI replace what stands there.
[[nodiscard]] Result<DeviceConfig> config_of(const Uri& uri);

}  // namespace isograsp
