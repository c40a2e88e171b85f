// SPDX-License-Identifier: GPL-3.0-or-later
// How a JR3 sensor on a PCI card is reached (SensorConfig::connection).
#pragma once

namespace isograsp {

struct FamilyFacts;

struct Jr3ComediSensor {
  unsigned subdevice = 0;  ///< 0 … 3
};

extern const FamilyFacts kJr3ComediFamily;

}  // namespace isograsp
