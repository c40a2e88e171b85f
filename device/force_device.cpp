// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/force_device.hpp"

#include "device/uri.hpp"

namespace isograsp {

std::string_view name_of(DeviceState state) noexcept {
  constexpr std::array<std::string_view, 7> kNames{
      "absent", "identified", "configured", "streaming", "degraded", "faulted", "finished"};
  return kNames[static_cast<std::size_t>(state)];
}

std::string_view describe(DeviceFault fault) noexcept {
  switch (fault) {
    case DeviceFault::none: return "The device works.";
    case DeviceFault::silence: return "A sensor is silent: check its cable and power.";
    case DeviceFault::torn_samples: return "Samples arrive damaged: check the bus wiring.";
    case DeviceFault::bus_off:
      return "The bus is switched off after errors: check cable and termination.";
    case DeviceFault::interface_down: return "The bus interface is down: switch it on.";
    case DeviceFault::interface_gone: return "The bus adapter was unplugged: plug it in again.";
    case DeviceFault::overload: return "A sensor is overloaded: take the hand out.";
  }
  return "";
}

}  // namespace isograsp
