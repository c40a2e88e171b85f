// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/platform/health_json.hpp"

#include <array>
#include <utility>

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

/// None of the words needs an escape.
std::string quoted(std::string_view word) {
  return "\"" + std::string(word) + "\"";
}

/// Collects `"key": value`, the values as JSON.
class Object {
 public:
  void add(std::string_view key, const std::string& value) {
    text_ += (text_.empty() ? "" : ", ") + quoted(key) + ": " + value;
  }
  void add(std::string_view key, std::uint64_t value) { add(key, std::to_string(value)); }
  [[nodiscard]] std::string text() const { return "{" + text_ + "}"; }

 private:
  std::string text_;
};

}  // namespace

std::string as_json(const DeviceHealth& health) {
  Object json;
  json.add("state", quoted(name_of(health.state)));
  json.add("fault", quoted(name_of(health.fault)));
  json.add("fault_finger", health.finger ? quoted(name_of(*health.finger)) : "null");
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    Object sensor;
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
