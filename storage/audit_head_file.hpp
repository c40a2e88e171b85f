// SPDX-License-Identifier: GPL-3.0-or-later
// FILE-audit, beside a protected database: how far its audit log has come. Internal to this folder.
#pragma once

#include <optional>
#include <string>

#include "storage/audit_log.hpp"
#include "storage/secret.hpp"

namespace isograsp {

void write_head_file(const std::string& database, const Secret* key, const std::string& database_id,
                     const AuditHead& head);

struct HeadFile {
  bool present = false;
  std::optional<AuditHead> head;  ///< nothing: not made with this key for this database
};
[[nodiscard]] HeadFile read_head_file(const std::string& database, const Secret* key,
                                      const std::string& database_id);

}  // namespace isograsp
