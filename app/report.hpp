// SPDX-License-Identifier: GPL-3.0-or-later
// The progress report, for `isograsp report` and `isograsp demo`.
#pragma once

#include <string>

#include "core/result.hpp"

namespace isograsp::app {

/// Reads the patient's data and writes `path`; its ending decides: .pdf or .html.
[[nodiscard]] Result<void> write_report(const std::string& database, const std::string& patient,
                                        const std::string& path);

}  // namespace isograsp::app
