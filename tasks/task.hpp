// SPDX-License-Identifier: GPL-3.0-or-later
// A task in progress: a state machine stepped once per frame. No I/O, no clock, no thread; step()
// is real-time safe (make_task() allocates all it needs).
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "hand/arm_links.hpp"
#include "kinematics/postures.hpp"
#include "tasks/references.hpp"
#include "tasks/task_spec.hpp"
#include "tasks/task_view.hpp"

namespace isograsp::tasks {

/// An arm whose start posture is known, and the postures that a task names (KindFacts::postures).
struct ArmPostures {
  Postures library;
  StartPosture start;
  std::string text;  ///< the file of the postures as it is; of an own range what it is of
};

/// What the screening of an arm leaves to its tasks (session/arm/passive_range.hpp).
struct ArmScreening {
  std::vector<PassiveLimit> passive;  ///< no target goes beyond them
  /// Largest part of the way that was done to each file of postures, today or before. Nothing:
  /// there was no screening, and how far a target goes is not asked.
  std::optional<std::map<std::string, double>> way_done;
};

/// Virtual objects that a hand is asked to place: in a bout, then it rests, and in a session.
inline constexpr int kMostOfBout = 6;
inline constexpr int kMostPlacements = 24;
inline constexpr double kBetweenBouts_s = 60.0;

/// What a task may depend on besides its file; stored with the trial.
struct TaskContext {
  double period_s = 0.01;  ///< of the frame grid
  std::uint64_t seed = 0;  ///< of fresh sequences and waits that cannot be foreseen
  ForceReferences references;
  TwoHandsReferences two_hands = {};  ///< of a task of both hands
  /// Of the object that both lift: by so much more they raise it for a metre. Nothing: not known.
  std::optional<double> lift_N_m = std::nullopt;
  /// So often a patient may still be asked to carry with both hands in this session.
  int carries_left = kMostCarries;
  std::vector<OwnRange> ranges;  ///< of the links of this arm, measured in this session
  ArmScreening screening;
  std::optional<ArmPostures> arm;  ///< of a task that names postures
  /// Virtual objects that this hand may still be asked to place in this session.
  int placements_left = kMostPlacements;
};

class Task {
 public:
  virtual ~Task() = default;
  /// One frame of task time. The view's phase becomes `done` at the end and stays so.
  [[nodiscard]] virtual TaskView step(const TaskInput& input) noexcept = 0;
};

/// Refuses a task whose context is incomplete (a sine in % of a maximum that was not measured).
[[nodiscard]] Result<std::unique_ptr<Task>> make_task(const TaskSpec& spec,
                                                      const TaskContext& context);

}  // namespace isograsp::tasks
