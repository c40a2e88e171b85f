// SPDX-License-Identifier: GPL-3.0-or-later
// How a Robotous RFT sensor is reached and set (SensorConfig::connection).
#pragma once

#include <string>

#include "device/codec/rft_codec.hpp"

namespace isograsp {

struct FamilyFacts;

struct RftSensor {
  RftIds ids;           ///< on CAN
  std::string address;  ///< elsewhere: "192.168.0.200:311" or "/dev/ttyUSB0"
  RftDivisors divisors;
  // The same for all three sensors.
  RftFilterTable filter_table = RftFilterTable::manual;
  unsigned baud = 115200;  ///< serial lines only
};

extern const FamilyFacts kRftFamily;

}  // namespace isograsp
