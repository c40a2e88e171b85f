// SPDX-License-Identifier: GPL-3.0-or-later
// can://IFACE?protocol=…&config=…&rate=…: three sensors on one CAN bus.
#pragma once

#include <memory>

#include "core/result.hpp"
#include "device/force_device.hpp"
#include "device/uri.hpp"

namespace isograsp {

/// Opens the interface and reads the configuration (docs/devices.md). Errors name the interface,
/// the protocol or the parameter. The bus stays untouched until start().
[[nodiscard]] Result<std::unique_ptr<ForceDevice>> open_can_device(const Uri& uri);

}  // namespace isograsp
