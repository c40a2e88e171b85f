// SPDX-License-Identifier: GPL-3.0-or-later
// How far a task has come: all that those who run, record and show it must know, whatever it is
// about.
#pragma once

#include <cstdint>
#include <string_view>

#include "hand/cue.hpp"

namespace isograsp::tasks {

/// Stages of a trial as stored in the column `phase`.
enum class Phase : std::uint8_t {
  lead_in = 0,    ///< not scored
  active = 1,     ///< scored
  transport = 2,  ///< pose targets: on the way, level
  hold = 3,       ///< pose targets: inside the tolerance
  paused = 4,     ///< device fault or therapist: nothing counts
  done = 5
};
[[nodiscard]] std::string_view name_of(Phase phase) noexcept;

struct TaskProgress {
  Phase phase = Phase::lead_in;
  Cue cue = Cue::relax;
  double task_time_s = 0.0;  ///< stands still while paused
  double duration_s = 0.0;   ///< expected end of the task, for the progress bar
  int segment = 0;           ///< which part of the task, from 0
  int target_index = -1;     ///< which of target_count
  int target_count = 0;
  int targets_reached = 0;
  double hold_fraction = 0.0;  ///< 0 … 1: progress ring
};

}  // namespace isograsp::tasks
