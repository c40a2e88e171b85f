// SPDX-License-Identifier: GPL-3.0-or-later
// Checked copies beside the database, made daily, with old ones removed; and restoring from one.
#pragma once

#include <ctime>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "storage/access/access.hpp"

namespace isograsp::storage {

/// How many are kept: the newest of each of the last days, weeks (Monday to Sunday) and months
/// that have one. UTC.
struct BackupRotation {
  int days = 7;
  int weeks = 4;
  int months = 12;
};

struct BackupFile {
  std::string path;
  std::string made_utc;  ///< ISO 8601, from its name
};

/// The backups of one database, in the folder `FILE.backups` beside it, each named
/// `YYYY-MM-DDThhmmssZ.db`. Other files of that folder are left alone. Holds nothing open and keeps
/// no state: every call looks at the folder. May be called on any thread, while others record; a
/// copy of a large file takes its time, so call make() on a thread of its own.
class Backups {
 public:
  explicit Backups(const std::string& database, BackupRotation rotation = {});

  [[nodiscard]] const std::string& folder() const noexcept { return folder_; }
  /// Newest first; empty if there is no folder.
  [[nodiscard]] Result<std::vector<BackupFile>> list() const;
  /// There is none of this day (UTC). A backup from the future (the clock was set back) does not
  /// count as one of today.
  [[nodiscard]] Result<bool> due(std::time_t now) const;

  struct Made {
    BackupFile backup;
    std::vector<std::string> removed;  ///< older ones that the rotation no longer keeps
  };
  /// A copy, checked to the last value; then the rotation. If the copy is not made or not sound,
  /// for instance because the database is damaged, this is an error and no backup is removed.
  [[nodiscard]] Result<Made> make(std::time_t now) const;
  /// make() if it is due.
  [[nodiscard]] Result<std::optional<Made>> make_if_due(std::time_t now) const;

 private:
  std::string database_;
  std::string folder_;
  BackupRotation rotation_;
};

/// Those of `backups` (newest first) that the rotation keeps, as marks in their order. A pure
/// function of their times.
[[nodiscard]] std::vector<bool> kept_by(const BackupRotation& rotation,
                                        const std::vector<std::time_t>& backups);

/// Opens a database and logs in where it asks for that.
using LogIn = std::function<Result<std::unique_ptr<Access>>(const std::string& database)>;

struct Restored {
  std::string kept;  ///< the file that was there, under its new name; empty: there was none
  std::string key;   ///< public, that the backup was signed with; empty: it was not signed
};
/// A checked copy of `backup` becomes `database`, with this act as the last entry of its audit log;
/// the backup itself is only read. A file that is there is kept as `FILE.before-restore` (or `-2`
/// …) with its log, and its `FILE-audit` as `FILE-audit.old` (or `-2` …). Refused while a program
/// has the database open for recording, if the backup is not sound, and to who may not change
/// records: then all is as it was.
[[nodiscard]] Result<Restored> restore_backup(
    const std::string& backup, const std::string& database,
    const LogIn& log_in = [](const std::string& copy) { return Access::open(copy); });

}  // namespace isograsp::storage
