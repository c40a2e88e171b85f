// SPDX-License-Identifier: GPL-3.0-or-later
// Gathers what a patient's progress report says from the database. SI units.
#pragma once

#include <string>

#include "core/progress.hpp"
#include "core/result.hpp"
#include "reports/findings/patient_records.hpp"
#include "reports/findings/report_content.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::reports {

/// Everything stored about this patient, in the words of a report. The same database gives the same
/// content. Rules of comparison:
/// - a series holds only trials of one hand, one source, one task version with equal parameters and
///   scene, one frame rate, device delay, visual gain and measure version; the newest such group is
///   shown and the others are named in the notes;
/// - practice, helped, aborted and interrupted trials are recorded but not part of any value;
/// - the baseline is the mean of the first two assessment days once there is a later one; before
///   that it is the first day, or the first session if all stand on one day;
/// - primary measures get a verdict of change (docs/change.md), all others none;
/// - sessions outside the scope are as if they were not there, and the content says so.
/// Errors: bad_input for an unknown patient; failed, if the watcher wants to stop (asked between
/// sessions and trials); whatever the database reports. Reads only; the thread of `store`.
[[nodiscard]] Result<ReportContent> gather_progress(storage::SessionStore& store,
                                                    const std::string& code,
                                                    const Progress& progress = {},
                                                    const ReportScope& scope = {});

}  // namespace isograsp::reports
