// SPDX-License-Identifier: GPL-3.0-or-later
// Trials as files for research: pseudonymous, patient codes, no dates, no notes, no paths. What is
// exported: exports/export_source.hpp; how: exports/export_writer.hpp. The thread of the store.
#pragma once

#include <string>
#include <vector>

#include "core/english.hpp"
#include "core/progress.hpp"
#include "exports/export_source.hpp"
#include "exports/export_writer.hpp"

namespace isograsp::exports {

/// The files that write_export() makes, below its folder; numbers only. Errors: bad_input for a
/// patient who is not there.
[[nodiscard]] Result<std::vector<std::string>> list_export(storage::SessionStore& store,
                                                           const ExportRequest& request,
                                                           ExportFormat format = ExportFormat::csv);

/// Writes them into `folder`, which is made if it does not exist: all of them appear or none, and
/// nothing is overwritten. Returns the number of trials; none at all is refused. Errors: failed, if
/// the watcher wants to stop (asked before every trial). `language`: of descriptions
/// (make_export_writer()).
[[nodiscard]] Result<std::size_t> write_export(storage::SessionStore& store,
                                               const ExportRequest& request, ExportFormat format,
                                               const std::string& folder,
                                               const Progress& progress = {},
                                               const Language& language = kEnglish);

}  // namespace isograsp::exports
