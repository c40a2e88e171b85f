// SPDX-License-Identifier: GPL-3.0-or-later
// One trial of a tracked hand, and what is recorded of a frame; its columns are those of
// hand/hand_columns.hpp.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "hand_world/assisted_grasp.hpp"
#include "session/acquisition/apparatus.hpp"
#include "session/tracked_hand/hand_snapshot.hpp"
#include "virtual_hand/study_plan.hpp"

namespace isograsp::session {

/// The virtual hand of a trial, and what it may be given.
struct VirtualObjects {
  VirtualObjects(const virtual_hand::HandModel& hand, double period_s, double table_m);

  /// Does what the task says. Real-time safe.
  void obey(const tasks::HandView& task) noexcept;

  hand_world::AssistedGrasp grasp;
  std::array<hand_world::GraspObject, virtual_hand::kStudyObjects> objects;
  std::array<hand_world::StartPlace, virtual_hand::kStudyObjects> places;
};

class HandTrial final : public TrialSetup {
 public:
  [[nodiscard]] std::vector<storage::SignalGroup> columns() const override;
  [[nodiscard]] std::string health_json() const override;
  /// One value per column, in that order. Real-time safe.
  void write(const RowFrame& frame, const HandSnapshot& seen, TrialRow& row) const noexcept;

  virtual_hand::HandModel model;  ///< the hand of the person, or one of usual size
  bool keeps_joints = false;      ///< where they are is recorded: research consent stands
  /// Null: the task has no object.
  std::unique_ptr<VirtualObjects> objects;
  HandHealth health;  ///< at its end
};

}  // namespace isograsp::session
