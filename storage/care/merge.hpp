// SPDX-License-Identifier: GPL-3.0-or-later
// Merges two databases: what one station recorded is added to the file of another.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "storage/file/open_mode.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::storage {

struct MergeReport {
  int patients_added = 0;
  int sessions_added = 0;
  int trials_added = 0;
  int trials_present = 0;  ///< of the other file, that were here already with the same content
  /// What stands in the way, one sentence each. Not empty: nothing was changed.
  std::vector<Text> conflicts;
};

/// `from` is the emergency file of a session of `into` (storage/care/emergency.hpp): where it was
/// sealed, it was with the same keys.
struct EmergencyMerge {
  std::vector<RowId> replaced;  ///< trials of `into` whose richer twins are in `from`
};

/// Takes all that `from` holds into `into`, in one transaction. Patients, sessions and trials are
/// told apart by their UUID, all else by its content, so that
/// - what is there already is not added again: merging twice changes nothing;
/// - a into b and b into a hold the same, up to the numbers of rows.
/// Conflicts: a UUID that stands for different content (a trial's signals by their hash), one code
/// that two files gave separately, a person who was erased in one file and is in the other. Who was
/// erased in either stays so. `same_patients`: codes of which it is known that they mean the
/// same person in both files; that person has both UUIDs from then on.
/// What one file does not know yet (the end of a session that was open when it was copied, the
/// drift of a later zero) is taken from the other and is no conflict. Both files must prove (their
/// seals), and what is taken in gets new seals. Both files must have the
/// format of this program; nobody may record into either. `into_how`: existing, or scratch, where
/// nothing is logged and the same files give the same bytes.
[[nodiscard]] Result<MergeReport> merge_databases(const std::string& into, const std::string& from,
                                                  std::span<const std::string> same_patients = {},
                                                  OpenMode into_how = OpenMode::existing,
                                                  const EmergencyMerge* emergency = nullptr);

}  // namespace isograsp::storage
