// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/read_keys.hpp"

#include "core/csv.hpp"

namespace isograsp::tasks {

double read_within(TomlReader& reader, std::string_view key, double least, double most,
                   std::optional<double> fallback) {
  const double value = reader.number(key, fallback);
  if (reader.has(key) && !(value >= least && value <= most))
    reader.fail(key, "%1 is out of range"_text(shortest(value)),
                "write a number from %1 to %2"_text(shortest(least), shortest(most)));
  return value;
}

double read_duration(TomlReader& reader, std::string_view key, double fallback) {
  const double value = read_within(reader, key, 0.0, kLongestPart_s, fallback);
  if (reader.has(key) && value == 0.0)
    reader.fail(key, "0 is out of range"_text, "write a number above 0"_text);
  return value;
}

double read_wait(TomlReader& reader, std::string_view key, double fallback) {
  return read_within(reader, key, 0.0, kLongestPart_s, fallback);
}

int read_count(TomlReader& reader, std::string_view key, std::optional<int> fallback, int most) {
  const auto count = reader.integer(key, fallback);
  if (count >= 1 && count <= most) return static_cast<int>(count);
  reader.fail(key, "%1 is out of range"_text(count),
              "write a whole number from 1 to %1"_text(most));
  return 1;
}

}  // namespace isograsp::tasks
