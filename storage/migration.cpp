// SPDX-License-Identifier: GPL-3.0-or-later
// Old files become files of this program's format: a copy first, then all changes or none.
#include <filesystem>

#include <soci/soci.h>

#include "storage/schema.hpp"
#include "storage/sqlite_store.hpp"

namespace isograsp {

namespace {

/// FILE.format-1, or FILE.format-1-2 … where that exists.
std::string name_of_copy(const std::string& path, int format) {
  namespace fs = std::filesystem;
  const std::string first = path + ".format-" + std::to_string(format);
  std::string name = first;
  for (int number = 2; fs::exists(fs::symlink_status(name)); ++number)
    name = first + "-" + std::to_string(number);
  return name;
}

Error failed(const std::string& path, std::string what, std::string remedy) {
  return {Error::Code::failed, std::move(what), std::move(remedy), path, 0, ""};
}

}  // namespace

Result<SessionStore::Migration> SessionStore::migrate(const std::string& path) {
  constexpr int kOldest = 1;
  auto opened = Database::open(path, Open::existing, kOldest);
  if (!opened) return opened.error();
  Migration migration{opened->format(), ""};
  if (migration.from == kDatabaseFormat) return migration;
  const auto lock = RecordingLock::exclusive_if_free(opened->real_path());
  if (!lock) return lock.error();
  if (!lock->held())
    return failed(path, "another program records into the file now",
                  "end that session, then migrate");
  migration.copy = name_of_copy(path, migration.from);
  SqliteStore as_it_was(std::move(*opened));
  if (const auto copied = as_it_was.backup(migration.copy); !copied) return copied.error();

  auto database = Database::open(path, Open::existing, kOldest);
  if (!database) return database.error();
  const auto done = database->transact("migrating", [&] {
    soci::session& sql = database->sql();
    int format = 0;
    sql << "PRAGMA user_version", soci::into(format);
    if (format != migration.from)
      throw Refusal{failed(path, "another program has changed the file meanwhile", "try again")};
    for (++format; format <= kDatabaseFormat; ++format)
      for (const char* statement : schema::statements_to(format)) sql << statement;
    sql << "PRAGMA user_version=" + std::to_string(kDatabaseFormat);
  });
  if (!done) return done.error();
  return migration;
}

}  // namespace isograsp
