// SPDX-License-Identifier: GPL-3.0-or-later
// Recomputes every measure of a database from its stored signals and compares.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/result.hpp"

namespace isograsp::app {

/// What recomputing all measures showed. The same for any number of threads.
struct Verification {
  std::int64_t trials = 0;
  std::int64_t measures = 0;
  std::int64_t identical = 0;      ///< to the bit
  std::int64_t older_version = 0;  ///< of the measure: the signals give a newer one …
  std::int64_t older_changed = 0;  ///< … and with it another value, or none
  std::int64_t newer_version = 0;  ///< than this program's: cannot be compared
  double largest_relative_difference = 0.0;
  std::string largest_at;
  std::vector<Text> problems;
};

/// With a progress bar on a terminal; each thread reads through its own connection.
[[nodiscard]] Result<Verification> verify_database(const std::string& file, int threads);

}  // namespace isograsp::app
