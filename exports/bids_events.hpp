// SPDX-License-Identifier: GPL-3.0-or-later
// Events of a trial as a table of BIDS: phases and cues of the task with their durations, faults
// and pauses. Onsets count from the first row of the signals.
#pragma once

#include <string>

#include "exports/export_trial.hpp"

namespace isograsp::exports {

/// A cell of text: no tab, no line break, no formula (without_formula()); "n/a" if it is empty.
[[nodiscard]] std::string tsv_cell(std::string text);
[[nodiscard]] std::string bids_events(const ExportTrial& trial);
/// What its columns and words mean.
[[nodiscard]] std::string bids_events_sidecar(const Language& language);

}  // namespace isograsp::exports
