// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings that others made become patients, sessions and trials of the database; so do signals
// that were exported before.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/measure.hpp"
#include "core/result.hpp"
#include "session/import/recording.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::session {

struct Imported {
  int patients = 0;
  int sessions = 0;
  int trials = 0;
  std::int64_t samples = 0;
};

/// Stores every trial with its signals and measures, completed, in sessions marked as recorded.
/// Patients that exist already are refused before anything is written. `progress` is told how many
/// trials are stored. @pre trials are in the order of read_recording()
[[nodiscard]] Result<Imported> store_recording(const RecordingSpec& spec,
                                               std::span<const RecordedTrial> trials,
                                               storage::SessionStore& store,
                                               const std::string& software_version,
                                               const std::function<void(int)>& progress = {});

/// Stores one trial as a session of its own, marked as recorded (or simulated, if the trial is),
/// and scores it. The patient is created if the code is new. The rate is that of the signals.
/// Returns the measures.
/// @pre signals hold t_s and two rows, increasing, as read_signals() gives them
[[nodiscard]] Result<std::vector<Measure>> store_signals_trial(const RecordedTrial& trial,
                                                               Hand hand,
                                                               storage::SessionStore& store,
                                                               const std::string& software_version);

}  // namespace isograsp::session
