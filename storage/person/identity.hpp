// SPDX-License-Identifier: GPL-3.0-or-later
// The person behind a code. Only in a protected database, encrypted with a key of its own; every
// reading is logged with the name of the reader. Needs Right::identities.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/result.hpp"
#include "storage/access/access.hpp"

namespace isograsp::storage {

struct Identity {
  std::string name;        ///< required
  std::string birth_date;  ///< ISO 8601; empty: not told
  std::string contact;     ///< may be empty; several lines
  bool operator==(const Identity&) const = default;
};
inline constexpr std::size_t kMostIdentityText = 4096;  ///< bytes of a field

[[nodiscard]] Result<void> check_identity(const Identity& identity);
/// Replaces what was known.
[[nodiscard]] Result<void> set_identity(Access& access, const std::string& code,
                                        const Identity& identity);
/// Nothing: not told. Of a restricted person only in an emergency: `emergency` is the reason, which
/// is logged.
[[nodiscard]] Result<std::optional<Identity>> read_identity(Access& access, const std::string& code,
                                                            const std::string& emergency = "");
/// For the person themself, who may ask what is stored at any time (GDPR Art. 15), also while
/// restricted; the log says so.
[[nodiscard]] Result<std::optional<Identity>> read_identity_for_person(Access& access,
                                                                       const std::string& code);
/// Code and identity of everybody who is not restricted, to look for a name; one entry in the log.
[[nodiscard]] Result<std::vector<std::pair<std::string, Identity>>> all_identities(Access& access);

}  // namespace isograsp::storage
