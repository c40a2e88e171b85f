// SPDX-License-Identifier: GPL-3.0-or-later
// How a sensor with an ATI NETCANOEM board is reached and set (SensorConfig::connection).
#pragma once

#include <cstdint>

namespace isograsp {

struct FamilyFacts;

struct AtiSensor {
  std::uint8_t base = 0x20;      ///< upper seven bits of its identifiers
  std::uint8_t calibration = 0;  ///< slot of the board that is used, 0 … 15
};

extern const FamilyFacts kAtiFamily;

}  // namespace isograsp
