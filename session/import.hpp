// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings that others made become patients, sessions and trials of the database.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "core/result.hpp"
#include "session/recording.hpp"
#include "storage/session_store.hpp"

namespace isograsp {

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
                                               SessionStore& store,
                                               const std::string& software_version,
                                               const std::function<void(int)>& progress = {});

}  // namespace isograsp
