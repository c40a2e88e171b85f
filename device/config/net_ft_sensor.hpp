// SPDX-License-Identifier: GPL-3.0-or-later
// How an ATI Net F/T box is reached (SensorConfig::connection).
#pragma once

#include <string>

namespace isograsp {

struct FamilyFacts;

struct NetFtSensor {
  std::string host = "192.168.1.1";  ///< or with ports (NetFtAddress)
};

extern const FamilyFacts kNetFtFamily;

}  // namespace isograsp
