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
using Sentences = std::array<Words, 1 + kFingerCount>;

constexpr Sentences about_bus(Words text) {
  return {text, text, text, text};
}

// In the order of DeviceFault.
constexpr std::array<Sentences, kDeviceFaultCount> kSentences{
    about_bus("The device works."_text),
    about_bus("The bus adapter was unplugged: plug it in again."_text),
    about_bus("The bus interface is down: switch it on."_text),
    about_bus("The bus is switched off after errors: check cable and termination."_text),
    Sentences{"A sensor is silent: check its cable and power."_text,
              "The thumb's sensor is silent: check its cable and power."_text,
              "The index finger's sensor is silent: check its cable and power."_text,
              "The middle finger's sensor is silent: check its cable and power."_text},
    Sentences{
        "A sensor is not the one that belongs here: do not measure with it."_text,
        "The thumb's sensor is not the one that belongs here: do not measure with it."_text,
        "The index finger's sensor is not the one that belongs here: do not measure with it."_text,
        "The middle finger's sensor is not the one that belongs here: do not measure with it."_text},
    Sentences{
        "A sensor repeats one value: switch it off and on, then zero again."_text,
        "The thumb's sensor repeats one value: switch it off and on, then zero again."_text,
        "The index finger's sensor repeats one value: switch it off and on, then zero again."_text,
        "The middle finger's sensor repeats one value: switch it off and on, then zero again."_text},
    Sentences{"A sensor reports that it is broken: do not measure with it."_text,
              "The thumb's sensor reports that it is broken: do not measure with it."_text,
              "The index finger's sensor reports that it is broken: do not measure with it."_text,
              "The middle finger's sensor reports that it is broken: do not measure with it."_text},
    Sentences{"A sensor is overloaded: take the hand out."_text,
              "The thumb's sensor is overloaded: take the hand out."_text,
              "The index finger's sensor is overloaded: take the hand out."_text,
              "The middle finger's sensor is overloaded: take the hand out."_text},
    Sentences{"A sensor started anew: take the hand out and zero again."_text,
              "The thumb's sensor started anew: take the hand out and zero again."_text,
              "The index finger's sensor started anew: take the hand out and zero again."_text,
              "The middle finger's sensor started anew: take the hand out and zero again."_text},
    about_bus("The bus adapter or this computer loses frames: close other programs."_text),
    about_bus("The bus counts many errors: check cable and termination."_text),
    Sentences{"A sensor loses samples on the way: check the bus wiring."_text,
              "The thumb's sensor loses samples on the way: check the bus wiring."_text,
              "The index finger's sensor loses samples on the way: check the bus wiring."_text,
              "The middle finger's sensor loses samples on the way: check the bus wiring."_text}};

}  // namespace

Words words_of(DeviceFault fault, std::optional<Finger> finger) noexcept {
  return kSentences[static_cast<std::size_t>(fault)][finger ? 1 + index_of(*finger) : 0];
}

}  // namespace isograsp
