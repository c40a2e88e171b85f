// SPDX-License-Identifier: GPL-3.0-or-later
// What follows from earlier sessions of a patient for today's: the level of each training task, the
// baseline of each force and how far an arm has gone to postures. Only sessions of the same hand
// and the same kind of device (real, or simulated) count, and no recordings.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "core/result.hpp"
#include "hand/force_channel.hpp"
#include "storage/records/session_store.hpp"
#include "tasks/staircase.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::session {

class Training {
 public:
  /// Reads what is stored of the patient of `session`, before it.
  [[nodiscard]] static Result<Training> read(storage::SessionStore& store,
                                             const storage::SessionRecord& session);

  /// The level at which this task goes on; its start if it was never trained. @pre spec.difficulty
  [[nodiscard]] double level(const tasks::TaskSpec& spec) const;
  /// A trial of today. Only completed ones at a chosen level count, without help.
  void learn(const tasks::TaskSpec& spec, const storage::TrialRecord& trial,
             const std::vector<Measure>& measures);

  /// Mean of the best maxima of the first two days of assessment, per channel [N].
  [[nodiscard]] const std::map<ForceChannel, double>& baseline_N() const noexcept {
    return baseline_N_;
  }
  /// Largest part of the way that was gone to each file of fixed postures.
  [[nodiscard]] const std::map<std::string, double>& way_done() const noexcept { return way_done_; }

 private:
  using Key = std::pair<std::string, int>;  ///< name and version of the task
  std::map<Key, tasks::Staircase> staircases_;
  std::map<ForceChannel, double> baseline_N_;
  std::map<std::string, double> way_done_;
};

/// The measure that decides reached what the task asks for.
[[nodiscard]] bool is_success(const tasks::Difficulty& difficulty,
                              const std::vector<Measure>& measures);

}  // namespace isograsp::session
