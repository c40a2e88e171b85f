// SPDX-License-Identifier: GPL-3.0-or-later
// What the platform records of a frame; its columns are those of hand/columns.hpp.
#pragma once

#include <optional>
#include <vector>

#include "grasp_model/plan.hpp"
#include "hand/finger.hpp"
#include "session/acquisition/trial_row.hpp"
#include "session/platform/snapshot.hpp"
#include "tasks/task_view.hpp"

namespace isograsp::session {

/// What does not change within a trial and is stored beside its signals; nothing: not known.
struct TrialConstants {
  std::optional<double> resolution_N;     ///< coarsest step of a force component
  std::optional<double> device_delay_s;   ///< of the sensors and their filters
  std::optional<double> display_delay_s;  ///< from the program to the light
};

/// One frame as the platform has it at hand.
struct PlatformFrame {
  const FingerFrame& forces;  ///< zeroed; held values stand in where flagged
  const NetPush& push;
  const tasks::SpecialView& special;  ///< of the task
  const TrialConstants& constants;
  const ObjectState* object;  ///< before this frame's wrench acts; null: a force task has none
  const GraspWrench& grasp;
};

/// The stored columns: those about the object only if there is one.
[[nodiscard]] std::vector<storage::SignalGroup> columns_of(const PlatformFrame& seen);
/// One value per column of columns_of(seen), in that order. Real-time safe.
void write_row(const RowFrame& frame, const PlatformFrame& seen, TrialRow& row) noexcept;

}  // namespace isograsp::session
