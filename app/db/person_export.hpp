// SPDX-License-Identifier: GPL-3.0-or-later
// All that the database holds about one person, for that person (GDPR Art. 15 and 20).
#pragma once

#include <string>

#include "core/result.hpp"
#include "storage/access/access.hpp"

namespace isograsp::app {

/// Makes `folder` (refused if it exists) with person.json, measures.csv and session_S/trial_T.csv.
/// With the identity where the database holds one, also of a restricted person. Needs
/// Right::identities in a protected database.
[[nodiscard]] Result<int> export_person(storage::Access& access, const std::string& code,
                                        const std::string& folder);

}  // namespace isograsp::app
