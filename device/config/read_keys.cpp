// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/config/read_keys.hpp"

#include <string>

namespace isograsp {

std::uint8_t read_id(TomlReader& sensor, std::string_view key, std::int64_t fallback,
                     std::int64_t least, std::int64_t most) {
  const auto id = sensor.integer(key, fallback);
  if (id >= least && id <= most) return static_cast<std::uint8_t>(id);
  sensor.fail(key, "not an identifier of this sensor family",
              "give one from " + std::to_string(least) + " to " + std::to_string(most));
  return static_cast<std::uint8_t>(fallback);
}

double read_positive(TomlReader& sensor, std::string_view key, double fallback) {
  const double value = sensor.number(key, fallback);
  if (value > 0.0) return value;
  sensor.fail(key, "not positive", "give a number above 0");
  return fallback;
}

}  // namespace isograsp
