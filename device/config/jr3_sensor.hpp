// SPDX-License-Identifier: GPL-3.0-or-later
// How a JR3 sensor behind the open CAN adaptor is reached (SensorConfig::connection).
#pragma once

#include <cstdint>

namespace isograsp {

struct FamilyFacts;

struct Jr3Sensor {
  std::uint8_t node = 1;  ///< 1 … 127
};

extern const FamilyFacts kJr3Family;

}  // namespace isograsp
