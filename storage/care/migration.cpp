// SPDX-License-Identifier: GPL-3.0-or-later
// Old files become files of this program's format: a copy first, then all changes or none; then
// their signals are packed.
#include "storage/care/migration.hpp"

#include <array>
#include <filesystem>
#include <utility>
#include <vector>

#include <soci/soci.h>

#include "storage/access/audit_chain.hpp"
#include "storage/access/guarded_store.hpp"
#include "storage/access/proof.hpp"
#include "storage/access/sealed_text.hpp"
#include "storage/crypto/content_hash.hpp"
#include "storage/file/old_formats.hpp"
#include "storage/file/open_mode.hpp"
#include "storage/file/schema_access.hpp"
#include "storage/sqlite/sqlite_store.hpp"

namespace isograsp::storage {

namespace {

constexpr int kOldest = 1;
constexpr int kFirstWithUuids = 6;

/// Made of what the rows say, so that two copies of one file that are migrated on their own get the
/// same ones.
void give_uuids(soci::session& sql) {
  struct Table {
    const char* name;
    const char* text;  ///< what names a row
  };
  constexpr std::array kWithUuid{
      Table{"patients", "code || char(10) || created_utc"},
      Table{"sessions",
            "(SELECT uuid FROM patients p WHERE p.id = patient_id) || char(10) || sessions.id || "
            "char(10) || started_utc || char(10) || device_uri || char(10) || seed"},
      Table{"trials",
            "(SELECT uuid FROM sessions s WHERE s.id = session_id) || char(10) || number"}};
  for (const auto& [name, text] : kWithUuid) {
    const std::string table(name);
    std::vector<std::pair<RowId, std::string>> rows;
    RowId id = 0;
    std::string named;
    const std::string query = "SELECT id, " + std::string(text) + " FROM " + table + " ORDER BY id";
    soci::statement select = (sql.prepare << query, soci::into(id), soci::into(named));
    select.execute();
    while (select.fetch()) rows.emplace_back(id, uuid_of(table + "\n" + named));
    for (const auto& [row, uuid] : rows)
      sql << "UPDATE " + table + " SET uuid = :uuid WHERE id = :id", soci::use(uuid),
          soci::use(row);
  }
}

/// Trial by trial: an interruption costs nothing, and the next call goes on.
Result<Migration> pack_all(Database database, Migration migration) {
  const auto keys = database.guard("opening"_text, [&] { (void)login_state_of(database); });
  if (!keys) return keys.error();
  SqliteStore store(std::move(database));
  const auto waiting = store.unpacked();
  if (!waiting) return waiting.error();
  for (const RowId trial : *waiting)
    if (const auto packed = store.pack_trial(trial); packed)
      ++migration.packed;
    else
      migration.not_packed.push_back(packed.error().what);
  return migration;
}

/// In one transaction.
Result<void> change_tables(const std::string& path, const Migration& migration) {
  auto database = Database::open(path, OpenMode::existing, kOldest);
  if (!database) return database.error();
  // Tables are replaced under the names by which others refer to them; looked at before the end.
  const auto prepared = database->guard("migrating"_text, [&] {
    database->sql() << "PRAGMA foreign_keys=OFF";
    database->sql() << "PRAGMA legacy_alter_table=ON";
  });
  if (!prepared) return prepared;
  const auto done = database->transact("migrating"_text, [&] {
    soci::session& sql = database->sql();
    int format = 0;
    sql << "PRAGMA user_version", soci::into(format);
    if (format != migration.from)
      throw Refusal{
          failed("another program has changed the file meanwhile"_text, "try again"_text).at(path)};
    for (++format; format <= kDatabaseFormat; ++format) {
      for (const std::string& statement : schema::statements_to(format)) sql << statement;
      if (format == kFirstWithUuids) give_uuids(sql);
    }
    int orphans = 0;
    sql << "SELECT count(*) FROM pragma_foreign_key_check", soci::into(orphans);
    if (orphans > 0)
      throw Refusal{failed("migrating: the database is damaged"_text,
                           "run isograsp db check, then restore the last backup"_text)
                        .at(path)};
    sql << "PRAGMA user_version=" + std::to_string(kDatabaseFormat);
    database->begin_to_seal();
    const auto state = login_state_of(*database);
    bind_texts_to_rows(*database, *state);
    // Rows that have seals keep them: new ones are for what was changed here.
    if (migration.from < schema::kSealFormat) database->seals()->seal_all();
    (void)append_audit(*database, *state,
                       entry_of("migrate", std::filesystem::path(migration.copy).filename(),
                                "from format " + std::to_string(migration.from)));
  });
  if (!done) return done;
  // The format is read from the file itself, not from its log; a reader may keep it there.
  return database->guard("migrating"_text,
                         [&] { database->sql() << "PRAGMA wal_checkpoint(TRUNCATE)"; });
}

}  // namespace

Result<Migration> migrate_database(const std::string& path) {
  auto opened = Database::open(path, OpenMode::existing, kOldest);
  if (!opened) return opened.error();
  Migration migration{opened->format(), ""};
  const auto login = login_at(*opened, true);
  if (!login) return login.error();
  // What is there gets new seals, so what was changed by another hand would, too. A file of today's
  // that was made to look older has a log whose entries hold seals.
  if (migration.from >= schema::kAccessFormat)
    if (const auto proved = prove(*opened, **login); !proved) return proved.error();
  if (migration.from == kDatabaseFormat) return pack_all(std::move(*opened), migration);
  const auto lock = RecordingLock::exclusive_if_free(opened->real_path());
  if (!lock) return lock.error();
  if (!lock->held())
    return failed("another program records into the file now"_text,
                  "end that session, then migrate"_text)
        .at(path);
  migration.copy = free_name(path + ".format-" + std::to_string(migration.from));
  {
    SqliteStore as_it_was(std::move(*opened));
    if (const auto copied = as_it_was.backup(migration.copy); !copied) return copied.error();
  }

  if (const auto done = change_tables(path, migration); !done) return done.error();
  auto current = Database::open(path, OpenMode::existing);
  if (!current) return current.error();
  return pack_all(std::move(*current), migration);
}

}  // namespace isograsp::storage
