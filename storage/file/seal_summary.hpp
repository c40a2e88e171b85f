// SPDX-License-Identifier: GPL-3.0-or-later
// What all lines of row_seals say in sum. It stands in their anchor, proved with it, so that
// neither a login nor a change has to read them all; whoever proves them all compares it. What is
// found without the lines: docs/storage.md. Inside storage/file/ and storage/access/ only.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "storage/crypto/content_hash.hpp"
#include "storage/crypto/secret.hpp"

namespace isograsp::storage {

/// Accounts and what opens them.
inline constexpr std::array<std::string_view, 2> kTablesOfAccounts{"key_slots", "users"};
/// With sealed texts. Of events nothing older can be put back: they are neither changed nor
/// removed.
inline constexpr std::array<std::string_view, 7> kTablesOfTexts{
    "clinical_scores",  "consents",       "identities",     "patient_profiles",
    "primary_measures", "stable_periods", "treatment_marks"};
/// What a login compares: small, and changed long after it was written.
[[nodiscard]] bool is_compared_at_login(std::string_view table) noexcept;

/// The hashes that the rows of a table have, or their seals, by key as it stands in a line.
using RowHashes = std::map<std::string, std::string, std::less<>>;

struct SealSummary {
  /// By table: the largest number of a row that ever had a line.
  std::map<std::string, std::int64_t, std::less<>> highest;
  /// By table that is compared at a login: digest_of() its seals; absent: not known.
  std::map<std::string, std::string, std::less<>> digests;

  void note(std::string_view table, std::string_view row);  ///< a line
  bool operator==(const SealSummary&) const = default;
};
/// Of the key of a line; 0: it is no number.
[[nodiscard]] std::int64_t number_of_row(std::string_view row) noexcept;
/// 64 hexadecimal digits.
[[nodiscard]] std::string digest_of(const Secret* key, std::string_view table,
                                    const RowHashes& hashes);

/// As it stands in the anchor: a line a table, `NAME HIGHEST DIGEST`.
[[nodiscard]] std::string written(const SealSummary& summary);
/// Nothing: it is none.
[[nodiscard]] std::optional<SealSummary> read_summary(std::string_view text);

}  // namespace isograsp::storage
