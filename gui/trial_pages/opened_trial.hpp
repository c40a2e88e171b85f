// SPDX-License-Identifier: GPL-3.0-or-later
// One stored trial with its signals, and what there is to say about it. Reading is for the worker.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "core/signals.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::gui {

/// Something that happened, on the time axis of the trial.
struct TrialMark {
  double t_s = 0.0;  ///< since the trial began
  std::string kind;  ///< as EventRecord
  std::string text;
};

struct OpenedTrial {
  storage::SessionRecord session;
  storage::TrialRecord trial;
  std::vector<Measure> measures;
  std::vector<TrialMark> marks;
  Signals signals;
  /// Why `signals` are not all that was recorded, in words; empty: they are.
  std::string damage;
};

/// Damaged signals are no error: what can be read before or beside the damage is there, and
/// `damage` says what is not.
[[nodiscard]] Result<OpenedTrial> open_trial(storage::SessionStore& store,
                                             const storage::SessionRecord& session,
                                             const storage::TrialRecord& trial);

/// "Task version" and "2": one line of what is known about a trial besides its measures.
struct TrialFact {
  QString what;
  QString value;
  bool doubtful = false;  ///< a reason to doubt the values of the trial
};
[[nodiscard]] std::vector<TrialFact> facts_of(const OpenedTrial& trial);

}  // namespace isograsp::gui
