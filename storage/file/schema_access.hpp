// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of access and privacy: accounts, wrapped keys, identities, consent, erasure, audit
// log; and the seals of all rows.
#pragma once

#include <span>

namespace isograsp::storage::schema {

/// Statements that add them to a file that has none.
[[nodiscard]] std::span<const char* const> access_statements();
/// First format that has them.
inline constexpr int kAccessFormat = 7;

/// Statements that add the seals of rows.
[[nodiscard]] std::span<const char* const> seal_statements();
/// First format that has them.
inline constexpr int kSealFormat = 9;

}  // namespace isograsp::storage::schema
