// SPDX-License-Identifier: GPL-3.0-or-later
// The secret part of the clinic's key. Of a protected database it stands nowhere: it follows from
// the key of the audit log, which every slot opens. Of another one it stands in a file beside it,
// so that no copy of the database has it. Inside storage/ only.
#pragma once

#include <optional>
#include <string>

#include "storage/access/login.hpp"
#include "storage/access/signing.hpp"

namespace isograsp::storage {

/// Nothing: nobody is logged in, or there is none. `make`: then a file is made, if that can be.
[[nodiscard]] std::optional<Secret> signing_seed(const Database& database, const LoginState& state,
                                                 bool make);

/// The signature of a file under any name.
[[nodiscard]] Result<FileSignature> signature_of(const Secret& seed, const std::string& file,
                                                 SignedKind kind, const std::string& made_utc);

}  // namespace isograsp::storage
