// SPDX-License-Identifier: GPL-3.0-or-later
// Accounts, passwords, PINs, passphrase and policy of a protected database. Everything here is
// logged. Errors: not protected, not allowed, refused values (field `name`, `password`, `pin`, …).
#pragma once

#include <string>

#include "storage/access/access.hpp"
#include "storage/crypto/seal.hpp"

namespace isograsp::storage {

inline constexpr std::size_t kLeastPassword = 8;  ///< characters (NIST SP 800-63B, 5.1.1.1)
inline constexpr std::size_t kLeastPin = 4;       ///< digits
inline constexpr std::size_t kMostPin = 12;

// By an administrator.
/// A name is never given to somebody else, because the audit log names people.
[[nodiscard]] Result<User> add_user(Access& access, const std::string& name, Role role,
                                    const Secret& password, const KeyCost& cost = {});
[[nodiscard]] Result<void> remove_user(Access& access, const std::string& name);
/// A new password where the old one is forgotten; also ends a wait.
[[nodiscard]] Result<void> reset_password(Access& access, const std::string& name,
                                          const Secret& password, const KeyCost& cost = {});
[[nodiscard]] Result<void> set_policy(Access& access, const AccessPolicy& policy);
/// Wraps the same data key anew: nothing else is written. Backups keep the passphrase they had.
[[nodiscard]] Result<void> change_passphrase(Access& access, const Secret& passphrase,
                                             const KeyCost& cost = {});
/// For a new recovery key: shown first, then accepted, so that at no moment there is one that
/// nobody has seen. Opens nothing yet; that of before still does.
[[nodiscard]] Result<Secret> new_recovery_key(Access& access);
/// A key of new_recovery_key() or protect_database() that somebody has on paper now: from now on it
/// opens the database, and the one before nothing any more.
[[nodiscard]] Result<void> accept_recovery_key(Access& access, const Secret& key);

// By the user who is logged in.
[[nodiscard]] Result<void> change_own_password(Access& access, const Secret& old_password,
                                               const Secret& password, const KeyCost& cost = {});
/// 4 to 12 digits, neither all the same nor in a row (1234); empty: none any more.
[[nodiscard]] Result<void> set_own_pin(Access& access, const Secret& pin);

}  // namespace isograsp::storage
