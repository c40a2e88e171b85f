// SPDX-License-Identifier: GPL-3.0-or-later
// How a training task becomes easier or harder.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace isograsp::tasks {

/// What is multiplied by how much, and what counts as success.
struct Difficulty {
  enum class Factor : std::uint8_t { tolerance, distance, frequency, level, affected_share };
  Factor factor = Factor::tolerance;  ///< what is multiplied
  double easiest = 1.0;               ///< by this at level 0 …
  double hardest = 1.0;               ///< … and by this at level 1
  double start = 0.3;                 ///< level of the first trial
  std::string measure;                ///< success: this measure …
  double at_least = 0.0;              ///< … is not below this
  std::optional<double> chosen;       ///< level of this trial; nothing: the file as it is
};

}  // namespace isograsp::tasks
