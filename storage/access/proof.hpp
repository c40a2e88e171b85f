// SPDX-License-Identifier: GPL-3.0-or-later
// Is a file what this program has made of it? Asked before anything gets new seals for what is
// there, and of every backup. Inside storage/ only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "storage/access/login.hpp"
#include "storage/file/row_seals.hpp"

namespace isograsp::storage {

/// What seals and audit log tell of another hand; of an older format as much as it has. @pre no
/// transaction is open, a protected database has its key
[[nodiscard]] Result<std::vector<Text>> changes_by_others(Database& database,
                                                          const LoginState& state);
/// Refused with the first of them, or of what of the schema is not ours.
[[nodiscard]] Result<void> prove(Database& database, const LoginState& state);
struct AccountProof {
  /// What of the rows with sealed texts is not what this program wrote, such as an older text that
  /// was put back into its own row.
  std::vector<Text> of_texts;
  /// All lines were read, as their anchor does not say what they are in sum: to be kept there.
  std::optional<ProvedSeals> to_keep;
};
/// prove() of accounts and key slots alone: a revoked account, an old passphrase or PIN that was
/// put back opens nothing. Reads the lines of seals only where their anchor does not say the same
/// in sum. `key`: of the audit log.
[[nodiscard]] Result<AccountProof> prove_accounts(Database& database, const Secret& key);
/// prove() on a connection of its own.
[[nodiscard]] Result<void> prove_file(const std::string& path);

}  // namespace isograsp::storage
