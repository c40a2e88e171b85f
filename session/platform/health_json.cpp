// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/platform/health_json.hpp"

#include <array>
#include <utility>

#include "session/acquisition/json_object.hpp"

namespace isograsp::session {

namespace {

using Counter = std::pair<std::string_view, std::uint64_t SensorCounters::*>;
constexpr std::array<Counter, 11> kCounters{{{"good", &SensorCounters::good},
                                             {"invalid", &SensorCounters::invalid},
                                             {"torn", &SensorCounters::torn},
                                             {"duplicate", &SensorCounters::duplicate},
                                             {"late", &SensorCounters::late},
                                             {"lost", &SensorCounters::lost},
                                             {"stale", &SensorCounters::stale},
                                             {"saturated", &SensorCounters::saturated},
                                             {"overload", &SensorCounters::overload},
                                             {"status_errors", &SensorCounters::status_errors},
                                             {"restarts", &SensorCounters::restarts}}};

}  // namespace

std::string as_json(const DeviceHealth& health) {
  JsonObject json;
  json.add("state", quoted(name_of(health.state)));
  json.add("fault", quoted(name_of(health.fault)));
  json.add("fault_finger", health.finger ? quoted(name_of(*health.finger)) : "null");
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    JsonObject sensor;
    for (const auto& [name, counter] : kCounters) sensor.add(name, health.sensors[f].*counter);
    json.add(kFingerNames[f], sensor.text());
  }
  json.add("foreign_frames", health.foreign_frames);
  json.add("kernel_drops", health.bus.kernel_drops);
  json.add("overflows", health.bus.overflows);
  json.add("error_frames", health.bus.error_frames);
  json.add("unsent", health.bus.unsent);
  return json.text();
}

}  // namespace isograsp::session
