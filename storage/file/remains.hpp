// SPDX-License-Identifier: GPL-3.0-or-later
// Files that this program wrote elsewhere and cannot change any more, as far as the audit log
// knows. Inside storage/ only.
#pragma once

#include <string>
#include <vector>

namespace soci {
class session;
}

namespace isograsp::storage {

/// Backups, copies, merged and replaced files from `since_utc` to `until_utc`; exports, studies and
/// reports of `code` up to then. Empty: of everybody. In a guard of the caller.
[[nodiscard]] std::vector<std::string> remains_of(soci::session& sql, const std::string& code,
                                                  const std::string& since_utc,
                                                  const std::string& until_utc);

}  // namespace isograsp::storage
