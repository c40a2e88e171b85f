// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/config/read_keys.hpp"

#include <string>

namespace isograsp {

std::uint8_t read_id(TomlReader& sensor, std::string_view key, std::int64_t fallback,
                     std::int64_t least, std::int64_t most) {
  const auto id = sensor.integer(key, fallback);
  if (id >= least && id <= most) return static_cast<std::uint8_t>(id);
  sensor.fail(key, "not an identifier of this sensor family"_text,
              "give one from %1 to %2"_text(least, most));
  return static_cast<std::uint8_t>(fallback);
}

double read_positive(TomlReader& sensor, std::string_view key, double fallback) {
  const double value = sensor.number(key, fallback);
  if (value > 0.0) return value;
  sensor.fail(key, "not positive"_text, "give a number above 0"_text);
  return fallback;
}

}  // namespace isograsp
