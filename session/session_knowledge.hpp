// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of a session: what it was opened with, and what its trials have taught so far.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/measure.hpp"
#include "device/sensors/force_device.hpp"
#include "session/acquisition/apparatus.hpp"
#include "session/acquisition/realtime.hpp"
#include "session/arm/arm_snapshot.hpp"
#include "session/resume.hpp"
#include "session/training.hpp"
#include "storage/records/session_store.hpp"
#include "tasks/references.hpp"
#include "tasks/task.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::session {

struct RestOutcome;

/// What trials teach.
struct Lessons {
  tasks::ForceReferences references;    ///< what tasks measure forces against
  tasks::TwoHandsReferences two_hands;  ///< the same of both hands at once
  Training training;                    ///< the level of training tasks, earlier sessions included
  std::vector<OwnRange> ranges;         ///< of the links of an arm, the widest of this session
  tasks::ArmScreening arm_screening;    ///< passive ranges, and how far was gone to postures

  /// Only completed trials teach, and those in which nobody helped. `rest`: of a trial at rest.
  void learn(const tasks::TaskSpec& spec, const storage::TrialRecord& trial,
             const std::vector<Measure>& measures, const RestOutcome* rest);
  /// Maxima and comfortable forces that a trial measured raise the references of their channels.
  void learn_maxima(const std::vector<Measure>& measures);
  /// Maximum and resting force of each hand, of a trial that measured both.
  void learn_hands(const std::vector<Measure>& measures);
  /// A range of motion that a trial measured widens that of its link.
  void learn_range(const tasks::TaskSpec& spec, const std::vector<Measure>& measures);
  /// The way to fixed postures that was gone, if there was a screening.
  void learn_way(const tasks::TaskSpec& spec);
};

struct SessionKnowledge : Lessons {
  storage::SessionRecord record;
  ApparatusInfo apparatus;
  std::vector<PreparationStep> steps;  ///< that the apparatus asks for before the work
  DeviceInfo device;                   ///< of the platform; of another apparatus: what it has of it
  std::optional<ArmSetup> arm;         ///< of an arm seen by markers; nothing: it is something else
  RealtimeGrant realtime;              ///< what the acquisition thread was given
  bool patient_is_new = false;         ///< the code was not in the database before this session
  EarlierWork earlier;                 ///< of a session that is resumed; else empty
  std::size_t trials_begun = 0;        ///< in this session

  [[nodiscard]] bool asks_for(PreparationStep step) const noexcept;
  /// Orders the tasks of this session's protocol, the same way when it is resumed.
  [[nodiscard]] std::uint64_t order_seed() const noexcept;
  /// What the task of the next trial will be made with: the same task made with it is the same.
  [[nodiscard]] tasks::TaskContext next_context() const;
  /// Maximum grip force [N]; nothing: not measured yet.
  [[nodiscard]] std::optional<double> maximum_force_N() const noexcept;
};

}  // namespace isograsp::session
