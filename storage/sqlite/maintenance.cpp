// SPDX-License-Identifier: GPL-3.0-or-later
// Care of the file: is it sound, and a copy of it while others work.
#include <filesystem>

#include <soci/soci.h>

#include "core/staging_folder.hpp"
#include "storage/file/open_mode.hpp"
#include "storage/file/schema_check.hpp"
#include "storage/sqlite/sqlite_store.hpp"

namespace isograsp::storage {

namespace fs = std::filesystem;

namespace {

void add_orphans(soci::session& sql, std::vector<Text>& problems) {
  std::string table;
  std::string row;  // empty: a table of ours without numbers of rows
  std::string parent;
  soci::statement select =
      (sql.prepare << "SELECT \"table\", coalesce(rowid, ''), parent FROM pragma_foreign_key_check",
       soci::into(table), soci::into(row), soci::into(parent));
  select.execute();
  while (select.fetch())
    problems.push_back(
        row.empty()
            ? "a row of %1 refers to a row of %2 that does not exist"_text(table, parent)
            : "row %1 of %2 refers to a row of %3 that does not exist"_text(row, table, parent));
}

/// Nothing reads them, so that nothing else would notice.
void add_blocks_of_packed(soci::session& sql, std::vector<Text>& problems) {
  RowId trial = 0;
  soci::statement select =
      (sql.prepare << "SELECT DISTINCT b.trial_id FROM signal_blocks b JOIN trials t ON t.id = "
                      "b.trial_id WHERE t.signals_blake2b IS NOT NULL ORDER BY b.trial_id",
       soci::into(trial));
  select.execute();
  while (select.fetch())
    problems.push_back(
        "signal_blocks: trial %1 is packed, its rows here were not written by isograsp"_text(
            trial));
}

}  // namespace

Result<std::vector<Text>> SqliteStore::check() {
  return check_through(*this);
}

Result<std::vector<Text>> SqliteStore::check_through(SessionStore& door) {
  std::vector<Text> problems;
  std::vector<RowId> sessions_present;
  const auto done = database_.guard("checking"_text, [&] {
    soci::session& sql = database_.sql();
    std::string line;
    soci::statement integrity = (sql.prepare << "PRAGMA integrity_check", soci::into(line));
    integrity.execute();
    while (integrity.fetch())
      if (line != "ok") problems.push_back("SQLite: %1"_text(line));
    add_orphans(sql, problems);
    add_blocks_of_packed(sql, problems);
    for (Text& problem : schema_problems(sql, database_.format()))
      problems.push_back(std::move(problem));
    RowId session = 0;
    soci::statement select =
        (sql.prepare << "SELECT id FROM sessions ORDER BY id", soci::into(session));
    select.execute();
    while (select.fetch()) sessions_present.push_back(session);
  });
  if (!done) return done.error();
  if (const auto read = check_told(door, problems); !read) return read.error();
  for (const RowId session : sessions_present) {
    const auto all = trials(session);
    if (!all) return all.error();
    for (const TrialRecord& trial : *all)
      if (const auto readable = signals(trial); !readable)
        problems.push_back(readable.error().what);
  }
  return problems;
}

Result<void> SqliteStore::backup(const std::string& to) {
  return copy_if_sound(to, {});
}

Result<void> SqliteStore::copy_if_sound(const std::string& to, const Proof& prove) {
  std::error_code failure;
  const fs::path target = fs::absolute(to, failure);
  if (to.empty() || failure)
    return refused("no file for the backup is given"_text, "name a file"_text).at(path());
  if (fs::exists(fs::symlink_status(target)))
    return refused("exists already"_text, "name a new file"_text).at(to);
  if (!fs::is_directory(target.parent_path(), failure))
    return refused("its folder does not exist"_text, "make the folder"_text).at(to);
  const auto staging = StagingFolder::beside(target);
  if (!staging) return staging.error();
  const std::string& temporary = staging->file();
  // One read transaction: a consistent picture, while others go on writing. The copy is no WAL
  // file, so it can be read from a read-only medium.
  const auto copied = database_.guard("copying"_text, [&] {
    soci::session& sql = database_.sql();
    int query_only = 0;
    sql << "PRAGMA query_only", soci::into(query_only);
    sql << "PRAGMA query_only=OFF";  // it would also forbid writing the copy
    sql << "VACUUM INTO :to", soci::use(temporary);
    sql << "PRAGMA query_only=" + std::to_string(query_only);
  });
  if (!copied) return copied.error();
  auto copy = Database::open(temporary, OpenMode::read_only);
  if (!copy) return copy.error();
  // Not through a store with the rules of access: a copy is sound or not, whoever is logged in.
  SqliteStore copied_store(*std::move(copy));
  auto problems = copied_store.check();
  if (problems && problems->empty() && prove) problems = prove(copied_store.database());
  if (!problems) return problems.error();
  if (!problems->empty())
    return failed("the copy is not sound: %1"_text(problems->front()), "run isograsp db check"_text)
        .at(to);
  const bool synced = sync_path(temporary);
  fs::rename(temporary, target, failure);
  if (!synced || failure)
    return failed("the copy could not be written"_text, "check the disk and the folder"_text)
        .at(to);
  static_cast<void>(sync_path(target.parent_path()));
  return {};
}

}  // namespace isograsp::storage
