// SPDX-License-Identifier: GPL-3.0-or-later
// FILE-audit, beside a protected database: how far its audit log has come. Inside storage/ only.
#pragma once

#include <optional>
#include <string>

#include "storage/access/audit_log.hpp"
#include "storage/crypto/secret.hpp"

namespace isograsp::storage {

/// On the disk when it returns. Problems are ignored: the log itself is stored.
void write_head_file(const std::string& database, const Secret* key, const std::string& database_id,
                     const AuditHead& head);

struct HeadFile {
  bool present = false;
  std::optional<AuditHead> head;  ///< nothing: not made with this key for this database
};
[[nodiscard]] HeadFile read_head_file(const std::string& database, const Secret* key,
                                      const std::string& database_id);

/// One that is left from another file of this name is evidence: it becomes FILE-audit.old (or -2
/// …). Its new name; empty: there was none, or it could not be renamed.
[[nodiscard]] std::string set_aside_head_file(const std::string& database);
/// FILE-audit
[[nodiscard]] std::string head_file_of(const std::string& database);

}  // namespace isograsp::storage
