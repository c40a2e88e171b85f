// SPDX-License-Identifier: GPL-3.0-or-later
// One frame of a trial as it is recorded, and the table that turns it into named columns.
#pragma once

#include <string>
#include <vector>

#include "grasp_model/plan.hpp"
#include "hand/finger.hpp"
#include "session/acquisition/snapshot.hpp"
#include "storage/records/session_store.hpp"
#include "tasks/task.hpp"

namespace isograsp::session {

/// What does not change within a trial and is stored beside its signals; NaN: not known.
struct TrialConstants {
  double resolution_N = tasks::kNotMeasured;     ///< coarsest step of a force component
  double device_delay_s = tasks::kNotMeasured;   ///< of the sensors and their filters
  double display_delay_s = tasks::kNotMeasured;  ///< from the program to the light
};

struct TrialSample {
  double t_s = 0.0;    ///< since the trial began; runs on while paused
  FingerFrame forces;  ///< zeroed; held values stand in where flagged
  NetPush push;
  tasks::TaskView task;
  TrialConstants constants;
  ObjectState object;  ///< at t_s, before this frame's wrench acts
  GraspWrench grasp;
  double lateness_s = 0.0;
  double compute_s = 0.0;  ///< of the frame before this one: its own is not over yet
};

/// The stored columns of a trial; the "object" group only if there is an object.
[[nodiscard]] std::vector<storage::SignalGroup> signal_groups(bool has_object);

/// Appends one row per group, in the order of signal_groups(has_object).
void append_rows(const TrialSample& sample, bool has_object,
                 std::vector<std::vector<double>>& rows_of_group);

}  // namespace isograsp::session
