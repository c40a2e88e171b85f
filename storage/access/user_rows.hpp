// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of the table of users, and what a password may be. Inside storage/ only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "storage/access/access.hpp"

namespace soci {
class session;
}

namespace isograsp::storage {

// In a guard of the caller; throw as SOCI does.
/// Without those who were removed, by name.
[[nodiscard]] std::vector<User> read_users(soci::session& sql);
[[nodiscard]] std::optional<User> find_user(soci::session& sql, const std::string& name);

/// `field` says which: "passphrase", "password".
[[nodiscard]] Result<void> check_password(const Secret& password, const std::string& field);

}  // namespace isograsp::storage
