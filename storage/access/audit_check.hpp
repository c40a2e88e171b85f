// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the chain of the audit log on any connection. Inside storage/ only.
#pragma once

#include <string>
#include <vector>

#include "storage/access/login.hpp"

namespace isograsp::storage {

/// While others add to the log, too: all is read as of one moment. @pre no transaction is open
[[nodiscard]] Result<std::vector<Text>> audit_problems(Database& database, const LoginState& state);

}  // namespace isograsp::storage
