// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/sensors/force_device.hpp"

#include "device/config/uri.hpp"

namespace isograsp {

std::string_view name_of(DeviceState state) noexcept {
  constexpr std::array<std::string_view, 7> kNames{
      "absent", "identified", "configured", "streaming", "degraded", "faulted", "finished"};
  return kNames[static_cast<std::size_t>(state)];
}

std::string_view name_of(DeviceFault fault) noexcept {
  constexpr std::array<std::string_view, kDeviceFaultCount> kNames{
      "none",         "interface_gone", "interface_down", "bus_off",  "silence",
      "wrong_sensor", "frozen",         "status",         "overload", "restarted",
      "bus_overflow", "bus_warning",    "damaged_samples"};
  return kNames[static_cast<std::size_t>(fault)];
}

namespace {

/// For a sensor whose finger is not known, then for thumb, index and middle.
using Sentences = std::array<std::string, 1 + kFingerCount>;

Sentences about_sensor(const std::string& end) {
  return {"A sensor " + end, "The thumb's sensor " + end, "The index finger's sensor " + end,
          "The middle finger's sensor " + end};
}
Sentences about_bus(const std::string& text) {
  return {text, text, text, text};
}

// Made when the program starts, so that describing allocates nothing. In the order of DeviceFault.
const std::array<Sentences, kDeviceFaultCount> kSentences{
    about_bus("The device works."),
    about_bus("The bus adapter was unplugged: plug it in again."),
    about_bus("The bus interface is down: switch it on."),
    about_bus("The bus is switched off after errors: check cable and termination."),
    about_sensor("is silent: check its cable and power."),
    about_sensor("is not the one that belongs here: do not measure with it."),
    about_sensor("repeats one value: switch it off and on, then zero again."),
    about_sensor("reports that it is broken: do not measure with it."),
    about_sensor("is overloaded: take the hand out."),
    about_sensor("started anew: take the hand out and zero again."),
    about_bus("The bus adapter or this computer loses frames: close other programs."),
    about_bus("The bus counts many errors: check cable and termination."),
    about_sensor("loses samples on the way: check the bus wiring.")};

}  // namespace

const char* describe(DeviceFault fault, std::optional<Finger> finger) noexcept {
  return kSentences[static_cast<std::size_t>(fault)][finger ? 1 + index_of(*finger) : 0].c_str();
}

}  // namespace isograsp
