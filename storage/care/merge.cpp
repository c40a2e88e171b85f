// SPDX-License-Identifier: GPL-3.0-or-later
// Every row of the other file gets a number here: that of the row with the same UUID or the same
// content, else the next free one. Then the rows with new numbers are copied.
#include "storage/care/merge.hpp"

#include <filesystem>
#include <utility>
#include <vector>

#include <soci/soci.h>

#include "storage/access/access.hpp"
#include "storage/access/audit_chain.hpp"
#include "storage/access/open_store.hpp"
#include "storage/access/proof.hpp"
#include "storage/access/sealed_text.hpp"
#include "storage/care/merge_tables.hpp"
#include "storage/sqlite/sqlite_store.hpp"

namespace isograsp::storage {

namespace {

using Hashes = std::vector<std::pair<RowId, ContentHash>>;

/// Of the trials that are not packed. One that cannot be read has none, and then differs from one
/// that has.
Result<Hashes> hashes_of_unpacked(const std::string& path) {
  auto database = Database::open(path, OpenMode::read_only);
  if (!database) return database.error();
  SqliteStore store(*std::move(database));
  const auto unpacked = store.unpacked();
  if (!unpacked) return unpacked.error();
  Hashes hashes;
  for (const RowId trial : *unpacked)
    if (const auto hash = store.hash_of_blocks(trial); hash && *hash)
      hashes.emplace_back(trial, **hash);
  return hashes;
}

void note_hashes(soci::session& sql, const std::string& file, const Hashes& hashes) {
  for (const auto& [id, hash] : hashes) {
    soci::blob bytes(sql);
    bytes.append(bytes_of(hash).data(), hash.size());
    sql << "INSERT INTO temp.hashes VALUES (:file, :id, :hash)", soci::use(file), soci::use(id),
        soci::use(bytes);
  }
}

/// An emergency file holds its session whole, so nothing is lost with a poorer twin of a trial.
void make_room(soci::session& sql, const EmergencyMerge& emergency) {
  for (const RowId trial : emergency.replaced) {
    sql << "DELETE FROM main.preparation_references WHERE preparation_id IN "
           "(SELECT id FROM main.preparations WHERE trial_id = :id)",
        soci::use(trial);
    for (const char* table :
         {"ratings", "trial_preparations", "trial_references", "preparations", "events", "measures",
          "signal_packs", "signal_blocks", "signal_groups"})
      sql << "DELETE FROM main." + std::string(table) + " WHERE trial_id = :id", soci::use(trial);
    sql << "DELETE FROM main.trials WHERE id = :id", soci::use(trial);
  }
}

/// Its notes were sealed as programs of before did it. An emergency file has no key, so its
/// migration has left them so; its log says what it was.
bool is_of_older_format(soci::session& sql) {
  int migrations = 0;
  sql << "SELECT count(*) FROM other.audit_log WHERE act = 'migrate' AND result = 'done' AND "
         "detail LIKE 'from format %' AND CAST(substr(detail, 13) AS INTEGER) < :format",
      soci::use(kBoundToRowFormat), soci::into(migrations);
  return migrations > 0;
}

std::vector<RowId> added_events(soci::session& sql) {
  std::vector<RowId> added;
  RowId here = 0;
  soci::statement select =
      (sql.prepare << "SELECT here FROM temp.numbers WHERE name = 'events' AND added",
       soci::into(here));
  select.execute();
  while (select.fetch()) added.push_back(here);
  return added;
}

MergeReport merge(Database& database, const LoginState& state,
                  std::span<const std::string> same_patients, const Hashes& ours,
                  const Hashes& theirs, const EmergencyMerge* emergency) {
  soci::session& sql = database.sql();
  MergeReport report;
  if (emergency != nullptr) make_room(sql, *emergency);
  sql << "CREATE TEMP TABLE hashes (file TEXT NOT NULL, id INTEGER NOT NULL, blake2b BLOB NOT "
         "NULL, "
         "PRIMARY KEY (file, id))";
  note_hashes(sql, "main", ours);
  note_hashes(sql, "other", theirs);
  sql << "CREATE TEMP TABLE numbers (name TEXT NOT NULL, there INTEGER NOT NULL, "
         "here INTEGER NOT NULL, added INTEGER NOT NULL, PRIMARY KEY (name, there))";
  merge_people(sql, same_patients, report);
  if (!report.conflicts.empty()) return report;
  for (const MergeTable& table : merge_tables()) {
    number_rows(sql, table);
    find_conflicts(sql, table, emergency != nullptr, report);
  }
  find_conflicts_of_parts(sql, report);
  find_collisions(sql, report);
  if (!report.conflicts.empty()) return report;
  for (const MergeTable& table : merge_tables()) {
    take_late_columns(sql, table);
    copy_rows(sql, table);
  }
  copy_parts(sql);
  if (emergency != nullptr && is_of_older_format(sql))
    bind_notes_to_rows(database, state, added_events(sql));
  const auto count = [&sql](const char* which) {
    int number = 0;
    sql << "SELECT count(*) FROM temp.numbers WHERE " + std::string(which), soci::into(number);
    return number;
  };
  report.sessions_added = count("name = 'sessions' AND added");
  report.trials_added = count("name = 'trials' AND added");
  report.trials_present = count("name = 'trials' AND NOT added");
  sql << "DROP TABLE temp.numbers";
  sql << "DROP TABLE temp.hashes";
  return report;
}

/// Proved where it has to be, of this program's format, and nobody records into it.
Result<void> check_mergeable(const std::string& path, OpenMode how, bool proved) {
  // First: what follows writes.
  if (proved)
    if (auto sound = prove_file(path); !sound) return sound;
  {
    // Marks trials that a program left running when it ended.
    const auto store =
        how == OpenMode::read_only ? open_store_to_read(path) : open_store(path, how);
    if (!store) return store.error();
  }
  auto database = Database::open(path, OpenMode::read_only);
  if (!database) return database.error();
  if (database->format() != kDatabaseFormat)
    return refused("has format %1 instead of %2"_text(database->format(), kDatabaseFormat),
                   "run isograsp db migrate on it, or on a copy of it"_text)
        .at(path);
  int running = 0;
  const auto read = database->guard("reading"_text, [&] {
    database->sql() << "SELECT count(*) FROM trials WHERE status = 'running'", soci::into(running);
  });
  if (!read) return read.error();
  if (running > 0)
    return failed("a trial is being recorded into it"_text, "end that session, then merge"_text)
        .at(path);
  return {};
}

}  // namespace

Result<MergeReport> merge_databases(const std::string& into, const std::string& from,
                                    std::span<const std::string> same_patients, OpenMode into_how,
                                    const EmergencyMerge* emergency) {
  std::error_code ignored;
  if (std::filesystem::equivalent(into, from, ignored))
    return refused("is the same file"_text, "name two files"_text).at(from).about("--from");
  if ((emergency == nullptr && is_protected_database(into)) || is_protected_database(from))
    return refused("a protected database cannot be merged with another one: their keys differ"_text,
                   "export from one, or work with both"_text)
        .at(is_protected_database(into) ? into : from);
  // An emergency file has what a damaged file lost; and who merges in scratch files has just made
  // them.
  const bool scratch = into_how == OpenMode::scratch;
  if (const auto good = check_mergeable(into, into_how, !scratch && emergency == nullptr); !good)
    return good.error();
  if (const auto good = check_mergeable(from, OpenMode::read_only, !scratch); !good)
    return good.error();
  auto database = Database::open(into, into_how);
  if (!database) return database.error();
  const auto ours = hashes_of_unpacked(into);
  if (!ours) return ours.error();
  const auto theirs = hashes_of_unpacked(from);
  if (!theirs) return theirs.error();
  std::shared_ptr<LoginState> state;
  const auto attached = database->guard("opening the other file"_text, [&] {
    state = login_state_of(*database);
    database->sql() << "ATTACH DATABASE :other AS other", soci::use(from);
  });
  if (!attached) return attached.error();
  MergeReport report;
  AuditEntry entry = entry_of("merge", std::filesystem::path(from).filename());
  const auto work = [&] {
    return database->transact("merging"_text, [&] {
      report = merge(*database, *state, same_patients, *ours, *theirs, emergency);
      if (!report.conflicts.empty())
        throw Refusal{failed("the files do not agree"_text, {}).at(from)};
    });
  };
  const auto done = database->is_scratch() ? work() : audited(*database, *state, entry, work);
  if (!done && report.conflicts.empty()) return done.error();
  return report;
}

}  // namespace isograsp::storage
