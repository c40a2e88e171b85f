// SPDX-License-Identifier: GPL-3.0-or-later
// A person asks to be forgotten: restricted while the law asks to keep the records, erased
// afterwards so that the bytes are gone from the file. Needs Right::manage. In every database.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "storage/access/access.hpp"

namespace isograsp::storage {

/// What happens on request, today.
struct ErasurePlan {
  std::string code;
  std::string last_record_date;  ///< newest of sessions and all that is told of the person
  std::string keep_until_date;   ///< retention_years later
  bool may_erase = false;        ///< that day has passed
  bool restricted = false;       ///< already
};

struct ErasureDone {
  bool erased = false;  ///< false: restricted until plan.keep_until_date
  ErasurePlan plan;
  std::map<std::string, std::int64_t> rows;  ///< erased, by table
  /// What this program cannot reach, from the audit log: backups, copies of older formats, merged
  /// and replaced files by name, exports, studies and reports by day (their names could tell who
  /// the person is and are not kept).
  std::vector<std::string> remains;
  /// The rows are gone, but the file could not be rewritten, so it may still hold their bytes:
  /// erase the same code again.
  std::optional<Error> not_swept;
};

/// What is left of an erased person.
struct Tombstone {
  std::string code;
  std::string erased_utc;
  std::string erased_by;
};

[[nodiscard]] Result<ErasurePlan> plan_erasure(Access& access, const std::string& code);
/// Restricts or erases as the plan says. `reason` is logged: no identity in it. Erasing rewrites
/// the file without the person's rows and empties its journal; refused while somebody records. Of a
/// code that was erased: only that is done again.
[[nodiscard]] Result<ErasureDone> erase_patient(Access& access, const std::string& code,
                                                const std::string& reason);
/// Ends a restriction (the request was withdrawn).
[[nodiscard]] Result<void> lift_restriction(Access& access, const std::string& code,
                                            const std::string& reason);
[[nodiscard]] Result<bool> is_restricted(Access& access, const std::string& code);
[[nodiscard]] Result<std::vector<Tombstone>> tombstones(Access& access);

}  // namespace isograsp::storage
