// SPDX-License-Identifier: GPL-3.0-or-later
// Adds protection to a database that was made without it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "storage/access/access.hpp"

namespace isograsp::storage {

struct Protection {
  std::unique_ptr<Access> access;  ///< logged in as the clinic's passphrase
  /// To be printed once; kept nowhere. Opens nothing before accept_recovery_key(): who is ended
  /// before has a database without one, which a login says, and protecting it again makes another.
  /// Empty: it has one that was accepted.
  Secret recovery_key;
  std::string copy;                  ///< checked copy of the file as it was, in plain text
  std::vector<std::string> remains;  ///< that copy and others that the audit log tells of
  /// Everything is sealed, but the file could not be rewritten, so it may still hold the bytes of
  /// the plain text: protect it again with the same passphrase.
  std::optional<Error> not_swept;
};

/// Makes a copy beside the file, then keys, and seals all free text, in one transaction; then the
/// file is rewritten without what stood there. Of a protected database: only that is done again.
/// Refused, with nothing changed: another program has the file open; a passphrase of fewer than
/// kLeastPassword characters, or one that does not open it. Takes the time of Argon2id.
[[nodiscard]] Result<Protection> protect_database(const std::string& database,
                                                  const Secret& passphrase,
                                                  const KeyCost* cost = nullptr);

}  // namespace isograsp::storage
