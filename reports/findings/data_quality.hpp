// SPDX-License-Identifier: GPL-3.0-or-later
// Was this session's measurement valid? Plain words from what was recorded with it. SI units.
#pragma once

#include <vector>

#include "core/progress.hpp"
#include "core/result.hpp"
#include "reports/findings/report_content.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::reports {

/// The data-quality box of one session. A trial whose signals cannot be read is named in it. The
/// watcher is asked before each trial.
[[nodiscard]] Result<std::vector<QualityLine>> assess_quality(
    storage::SessionStore& store, const storage::SessionRecord& session,
    const std::vector<storage::TrialRecord>& trials, const Progress& progress = {});

}  // namespace isograsp::reports
