// SPDX-License-Identifier: GPL-3.0-or-later
// What people did elsewhere, as it was recorded: scored, never run (docs/file_formats.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tasks/kind_spec.hpp"

namespace isograsp::tasks {

struct RecordedSpec {
  enum class Measures : std::uint8_t {
    corridor,      ///< actual_force_N, corridor_error_N: force beyond the nearer edge, 0 inside
    maximum,       ///< actual_force_N: mean of its size over a window of rows
    tracking,      ///< target_force_N, actual_force_N
    finger_forces  ///< X_fz_N of each finger X, beat: 1 in the row of a beat of the metronome
  };
  /// The rows of the window count from the end of the trial: [rows - first, rows - last).
  struct Window {
    std::size_t first = 0;
    std::size_t last = 0;
  };
  Measures measures = Measures::tracking;
  double duration_s = 0.0;           ///< about how long a trial lasts
  Window window;                     ///< maximum only
  std::vector<std::string> fingers;  ///< finger_forces only: two or more
  int beats_per_cycle = 1;           ///< finger_forces only
  int cycles_left_out = 0;           ///< finger_forces only: at the beginning, until in time

  static const KindFacts kFacts;
};

}  // namespace isograsp::tasks
