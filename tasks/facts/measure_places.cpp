// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/facts/measure_words.hpp"

namespace isograsp::tasks {

Place place_of(const std::optional<TaskSpec>& spec, std::string_view name,
               std::string_view channel) {
  if (!spec) return {};
  int rank = 0;
  for (const PlacedMeasure& placed : spec->kind->places) {
    if (placed.name == name && (placed.channel.empty() || placed.channel == channel))
      return {placed.prominence, rank};
    ++rank;
  }
  return {};
}

}  // namespace isograsp::tasks
