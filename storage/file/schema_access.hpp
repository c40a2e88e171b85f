// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of access and privacy: accounts, wrapped keys, identities, consent, erasure, audit
// log.
#pragma once

#include <span>

namespace isograsp::storage::schema {

/// Statements that add them to a file that has none.
[[nodiscard]] std::span<const char* const> access_statements();
/// First format that has them.
inline constexpr int kAccessFormat = 7;

}  // namespace isograsp::storage::schema
