// SPDX-License-Identifier: GPL-3.0-or-later
// The emergency file, into which a session is recorded when its database has disappeared: a small
// database in the state folder, with the same UUIDs; and its return (`isograsp db rescue`). It
// holds codes, signals and measures as the main file does, texts sealed as they are there, and
// never an identity.
#pragma once

#include <string>
#include <vector>

#include "core/result.hpp"
#include "storage/care/merge.hpp"

namespace isograsp::storage {

/// $XDG_STATE_HOME/isograsp/emergency, else ~/.local/state/isograsp/emergency.
[[nodiscard]] std::string emergency_folder();

struct EmergencyFile {
  std::string path;
  std::string database;     ///< that the session was recorded into
  std::string database_id;  ///< of it
  std::string reason;       ///< why the session did not stay there
  std::string patient_code;
  std::string started_utc;  ///< of the session
  int trials = 0;
  /// A copy of the whole database, made where the file itself was deleted; empty: none.
  [[nodiscard]] std::string whole() const;
  bool has_whole = false;
};

/// An empty one, readable by its owner only. Uses path of `of`, database, database_id and reason.
/// @return with its path
[[nodiscard]] Result<EmergencyFile> make_emergency_file(EmergencyFile of);
/// Those of `database`, oldest first: by its id or, if it is gone or a new file stands in the place
/// of a deleted one, by its path; empty: all. Files that cannot be read are left out.
[[nodiscard]] std::vector<EmergencyFile> emergency_files(const std::string& database = "");

/// If `database` is gone: the copy of it that was made when it was deleted becomes it again.
/// Refused if there is none.
[[nodiscard]] Result<void> put_back(const std::string& database, const EmergencyFile& file);
/// Takes the session into `database` and removes the emergency file when all of it is there. Trials
/// of the same session that are shorter or other there, or cannot be read, are replaced. Where a
/// new file stands in the place of a deleted one, it takes in the copy of that one first. A
/// protected database must be logged in.
[[nodiscard]] Result<MergeReport> rescue(const std::string& database, const EmergencyFile& file);

}  // namespace isograsp::storage
