// SPDX-License-Identifier: GPL-3.0-or-later
// The row behind a code, and what of a code may stand in the log. Inside storage/ only.
#pragma once

#include <string>

#include "storage/access/access.hpp"

namespace soci {
class session;
}

namespace isograsp::storage {

struct PersonRow {
  RowId id = 0;
  std::string code;  ///< as stored
  std::string created_utc;
  std::string restricted_until;  ///< ISO 8601; empty: not restricted
};
/// In a guard of the caller; throws a refusal if there is nobody of this code.
[[nodiscard]] PersonRow required_person(soci::session& sql, const std::string& code);
[[nodiscard]] Result<PersonRow> find_person(Access& access, const std::string& code);

/// The code, if it is one: what is none may be a name.
[[nodiscard]] std::string loggable(const std::string& code);

/// A reason that is logged: one line, not empty, at most 200 bytes.
[[nodiscard]] Result<void> check_reason(const std::string& reason);

}  // namespace isograsp::storage
