// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the trials that are asked for and takes from the database what may leave the clinic. No
// other part of the export sees the rest. Runs on the thread of the store.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "exports/export_trial.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::exports {

struct ExportRequest {
  std::string patient;                   ///< code; empty: all
  int first_session = 1;                 ///< of each patient
  std::optional<int> last_session = {};  ///< nothing: up to the newest
};

/// A trial of the database that is asked for.
struct ExportSource {
  ExportPlace place;
  const storage::PatientRecord* patient = nullptr;
  const storage::PatientProfile* profile = nullptr;
  const storage::SessionRecord* session = nullptr;
  const storage::TrialRecord* trial = nullptr;
  std::string first_started_utc;  ///< of the patient's first session
};

/// The error for a person whose last answer on research was no, or whose records are restricted.
/// `field`: of `file` or an option.
[[nodiscard]] Error not_released(const std::string& code, const std::string& file,
                                 const std::string& field);

/// How many of the people asked for are left out because their last answer on research was no, or
/// because their records are restricted.
[[nodiscard]] Result<std::size_t> count_not_released(storage::SessionStore& store,
                                                     const ExportRequest& request);

/// Calls `visit` for each trial asked for, by patient, session and trial. Those being recorded now
/// are not among them, nor those of people who are not released for research. Errors: bad_input for
/// a patient who is named and not there, or not released.
[[nodiscard]] Result<void> for_each_trial(
    storage::SessionStore& store, const ExportRequest& request,
    const std::function<Result<void>(const ExportSource&)>& visit);

/// Reads it, without anything that could tell who, when or where.
[[nodiscard]] Result<ExportTrial> load_trial(storage::SessionStore& store,
                                             const ExportSource& source);

}  // namespace isograsp::exports
