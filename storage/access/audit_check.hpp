// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the chain of the audit log on any connection. Inside storage/ only.
#pragma once

#include <string>
#include <vector>

#include "storage/access/login.hpp"

namespace isograsp::storage {

/// Others may add to the log meanwhile: all is read in one transaction. @pre no transaction is open
[[nodiscard]] Result<std::vector<std::string>> audit_problems(Database& database,
                                                              const LoginState& state);

}  // namespace isograsp::storage
