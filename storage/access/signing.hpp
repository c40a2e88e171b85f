// SPDX-License-Identifier: GPL-3.0-or-later
// The clinic's signature under backups and exports: who made them, and that no byte of them was
// altered since. What it is worth, of a protected database and of another: docs/storage.md,
// "Signatures". Thread-safe; a large file takes its time.
#pragma once

#include <cstdint>
#include <string>

#include "core/result.hpp"
#include "storage/crypto/signature.hpp"

namespace isograsp::storage {

/// The signature of FILE stands beside it, in FILE.sig.
[[nodiscard]] std::string signature_file_of(const std::string& file);
/// The secret part of the key of a database without protection; made when it is needed first.
[[nodiscard]] std::string signing_key_file_of(const std::string& database);

/// The public key, 64 hexadecimal digits. Empty: nobody is logged in to a protected database; one
/// without protection has not signed yet.
[[nodiscard]] Result<std::string> public_key_of(const std::string& database);

/// Writes FILE.sig with the key of `database`; returns the public key. `made_utc`: may be empty.
/// Empty, and nothing is written: there is no key, since nobody is logged in, or none can be made
/// beside the database.
[[nodiscard]] Result<std::string> sign_file(const std::string& database, const std::string& file,
                                            SignedKind kind, const std::string& made_utc = "");

/// What FILE.sig says of `file`, proved. `key`: the public key that it must be; empty: any, which
/// proves only that nobody without *that* key has altered anything. Errors: failed, if the file is
/// not signed, not as it was signed, or signed with another key; bad_input, if `key` is none. A
/// backup must have no log of changes beside it: SQLite would play it into what is proved here.
[[nodiscard]] Result<FileSignature> check_signature(const std::string& file, SignedKind kind,
                                                    const std::string& key = "");

}  // namespace isograsp::storage
