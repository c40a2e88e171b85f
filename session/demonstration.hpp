// SPDX-License-Identifier: GPL-3.0-or-later
// How a task is done, for the patient to watch: a healthy simulated person does it through the same
// closed loop as a trial, with the hand on the platform, with an arm before cameras or with a hand
// before a tracker. Nothing is stored, and no device is needed.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "session/arm/arm_snapshot.hpp"
#include "session/platform/snapshot.hpp"
#include "session/tracked_hand/hand_snapshot.hpp"
#include "tasks/task.hpp"

namespace isograsp::session {

struct Demonstration {
  std::shared_ptr<const tasks::TaskSpec> task;
  tasks::TaskContext context;          ///< the task was made with
  std::shared_ptr<const Scene> scene;  ///< as the hand met it; null: a force task
  double period_s = 0.0;               ///< between frames
  /// From the beginning of the trial on: of the platform, of an arm or of a tracked hand; the
  /// others are empty.
  std::vector<Snapshot> frames;
  std::vector<ArmSnapshot> arm_frames;
  std::vector<HandSnapshot> hand_frames;
  std::optional<ArmSetup> arm;  ///< of an arm: what is fixed of it

  [[nodiscard]] std::size_t size() const noexcept {
    return frames.size() + arm_frames.size() + hand_frames.size();
  }
};

/// Why a task cannot be shown on a screen, with what to do; empty: it can.
[[nodiscard]] Text why_not_shown(const tasks::TaskSpec& spec);

/// Longest part that is shown [s]; tasks repeat themselves.
inline constexpr double kLongestDemonstration_s = 30.0;
/// Of a tracked hand, whose world takes longer to compute: a few placements.
inline constexpr double kLongestOfHand_s = 20.0;

/// What is known of the patient who watches, so that targets look like their own.
struct DemonstrationFor {
  Hand hand = Hand::right;
  /// What was not measured yet is assumed.
  tasks::ForceReferences references = {};
  /// Of the links of the arm. A task within the own range is refused if that was not measured yet.
  std::vector<OwnRange> ranges = {};
};

/// What the screening or the sensors would refuse is shown nevertheless. Of an arm targets are
/// those of the arm that shows it. Takes a fraction of a second, of a tracked hand about one. Any
/// thread.
[[nodiscard]] Result<Demonstration> demonstrate(const tasks::TaskSpec& spec,
                                                const DemonstrationFor& whom,
                                                const std::string& library);

}  // namespace isograsp::session
