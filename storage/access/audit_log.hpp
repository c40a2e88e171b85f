// SPDX-License-Identifier: GPL-3.0-or-later
// Who did what, when, to what, with which result: only appended to, every entry chained to the one
// before by a hash. What the chain proves, and against whom: docs/storage.md, "Audit log".
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "storage/access/access.hpp"

namespace isograsp::storage {

/// No field ever holds an identity, a note, a password or the text of an error.
struct AuditEntry {
  std::int64_t number = 0;  ///< 1, 2, 3 … without a gap
  std::string at_utc;       ///< ISO 8601
  std::string actor;        ///< name of the account; empty: not protected
  std::string role;
  std::string act;         ///< "login", "read identity", "add patient", … (docs/file_formats.md)
  std::string object;      ///< a patient's code, a user's name, the name of a file
  std::string result;      ///< "done", "refused", "failed"
  std::string detail;      ///< numbers, roles, reasons given
  std::string hash;        ///< 64 hexadecimal digits
  std::int64_t seals = 0;  ///< rows of row_seals when it was written; the entry holds their chain
};

/// How far a log has come. Noted elsewhere (a printout, another medium), it proves later that
/// nothing up to there was changed or cut.
struct AuditHead {
  std::int64_t count = 0;
  std::string hash;
};

struct AuditFilter {
  std::string act;     ///< empty: all
  std::string object;  ///< empty: all
};

/// Oldest first. Needs Right::manage in a protected database.
[[nodiscard]] Result<std::vector<AuditEntry>> read_audit(Access& access,
                                                         const AuditFilter& filter = {});
[[nodiscard]] Result<AuditHead> audit_head(Access& access);
/// Adds an act that this folder cannot see: an export, a report. No identity in any field.
[[nodiscard]] Result<void> log_act(Access& access, const std::string& act,
                                   const std::string& object, bool done,
                                   const std::string& detail = "");
/// The same for a file that may be open with `access` or not (null). Files that cannot be written,
/// or of an older format, have no log; an object that is no code may be a name and stays out.
[[nodiscard]] Result<void> log_act_of(const std::string& database, Access* access,
                                      const std::string& act, const std::string& object, bool done,
                                      const std::string& detail = "");
/// What is wrong with the chain: changed, moved, missing, cut entries. Empty: nothing. A
/// protected database must be logged in.
[[nodiscard]] Result<std::vector<Text>> check_audit(Access& access);
/// Is `head`, noted earlier, part of this chain?
[[nodiscard]] Result<bool> audit_contains(Access& access, const AuditHead& head);

}  // namespace isograsp::storage
