// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/care/emergency.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <ctime>
#include <filesystem>

#include <soci/soci.h>

#include "core/staging_folder.hpp"
#include "core/time.hpp"
#include "storage/access/access.hpp"
#include "storage/access/open_store.hpp"
#include "storage/file/schema.hpp"
#include "storage/sqlite/sqlite_store.hpp"

namespace isograsp::storage {

namespace fs = std::filesystem;

namespace {

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::string absolute(const std::string& path) {
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(path, ignored), ignored);
}

Result<void> make_folder() {
  const fs::path folder = emergency_folder();
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (!failure) fs::permissions(folder, fs::perms::owner_all, failure);
  if (failure)
    return failed("the folder cannot be made: %1"_text(Known{failure.message()}),
                  "set XDG_STATE_HOME to a folder that you may write to"_text)
        .at(folder);
  return {};
}

Result<EmergencyFile> read_emergency(const std::string& path) {
  auto database = Database::open(path, OpenMode::read_only);
  if (!database) return database.error();
  EmergencyFile file;
  file.path = path;
  const auto read = database->guard("reading an emergency file"_text, [&] {
    soci::session& sql = database->sql();
    sql << "SELECT database_path, database_id, reason FROM emergency_origin",
        soci::into(file.database), soci::into(file.database_id), soci::into(file.reason);
    sql << "SELECT p.code, s.started_utc, (SELECT count(*) FROM trials) FROM sessions s "
           "JOIN patients p ON p.id = s.patient_id",
        soci::into(file.patient_code), soci::into(file.started_utc), soci::into(file.trials);
  });
  if (!read) return read.error();
  std::error_code ignored;
  file.has_whole = fs::exists(file.whole(), ignored);
  return file;
}

/// Nobody needs to be logged in. Empty: there is no such file, or it cannot be read.
std::string id_of(const std::string& path) {
  auto database = Database::open(path, OpenMode::read_only);
  if (!database) return "";
  std::string id;
  const auto read = database->guard("reading who the database is"_text, [&] {
    database->sql() << "SELECT database_id FROM access_settings", soci::into(id);
  });
  return read ? id : "";
}

/// By its id. By its path where the database is gone, also if somebody has begun a new file there
/// since: its copy beside the emergency file is all that is left of it.
bool belongs_to(const EmergencyFile& file, const std::string& id, const std::string& path) {
  return (!id.empty() && file.database_id == id) ||
         (file.database == path && (id.empty() || file.has_whole));
}

bool same_signals(const Signals& a, const Signals& b) {
  if (a.names() != b.names() || a.rows() != b.rows()) return false;
  for (std::size_t c = 0; c < a.names().size(); ++c)
    for (std::size_t row = 0; row < a.rows(); ++row)
      if (std::bit_cast<std::uint64_t>(a.column(c)[row]) !=
          std::bit_cast<std::uint64_t>(b.column(c)[row]))
        return false;
  return true;
}

/// All trials of a file.
Result<std::vector<TrialRecord>> trials_of(SessionStore& store) {
  constexpr int kAll = 1'000'000;
  const auto sessions = store.recent_sessions(kAll);
  if (!sessions) return sessions.error();
  std::vector<TrialRecord> all;
  for (const SessionRecord& session : *sessions) {
    auto trials = store.trials(session.id);
    if (!trials) return trials.error();
    all.insert(all.end(), trials->begin(), trials->end());
  }
  return all;
}

struct Twins {
  std::vector<RowId> poorer;  ///< trials of the database that hold less or other, or cannot be read
  int missing = 0;            ///< trials of the emergency file that the database does not have
};

/// Compares the trials of an emergency file with those of the same UUID in the database.
Result<Twins> compare(const std::string& database, const std::string& emergency) {
  const auto theirs = open_store_to_read(emergency);
  if (!theirs) return theirs.error();
  const auto ours = open_store_to_read(database);
  if (!ours) return ours.error();
  const auto held = trials_of(**theirs);
  if (!held) return held.error();
  const auto known = trials_of(**ours);
  if (!known) return known.error();
  Twins twins;
  for (const TrialRecord& trial : *held) {
    const auto twin = std::find_if(known->begin(), known->end(),
                                   [&](const TrialRecord& one) { return one.uuid == trial.uuid; });
    if (twin == known->end()) {
      ++twins.missing;
      continue;
    }
    const auto good = (*theirs)->signals(trial);
    if (!good) return good.error();
    const auto there = (*ours)->signals(*twin);
    const auto scored = (*theirs)->measures(trial.id);
    if (!scored) return scored.error();
    const auto scored_there = (*ours)->measures(twin->id);
    const bool same = there && twin->status == trial.status && same_signals(*good, *there) &&
                      scored_there && *scored == *scored_there;
    if (!same && (!there || twin->samples <= trial.samples)) twins.poorer.push_back(twin->id);
  }
  return twins;
}

}  // namespace

Result<void> put_back(const std::string& database, const EmergencyFile& file) {
  std::error_code ignored;
  if (fs::exists(database, ignored)) return {};
  if (!file.has_whole)
    return failed("is not there, so nothing can be taken into it"_text,
                  "put it back or restore the last backup, then rescue again"_text)
        .at(database);
  const auto staging = StagingFolder::beside(database);
  if (!staging) return staging.error();
  const std::string& part = staging->file();
  std::error_code failure;
  fs::copy_file(file.whole(), part, failure);
  const bool synced = !failure && sync_path(part);
  if (!failure) fs::rename(part, database, failure);
  if (failure || !synced)
    return failed("the copy %1 cannot be put back"_text(file.whole()),
                  "check the disk and the folder"_text)
        .at(database);
  static_cast<void>(sync_path(fs::path(absolute(database)).parent_path()));
  return {};
}

std::string emergency_folder() {
  fs::path base = variable("XDG_STATE_HOME");
  if (base.empty()) base = fs::path(variable("HOME")) / ".local/state";
  return base / "isograsp" / "emergency";
}

std::string EmergencyFile::whole() const {
  return path + ".whole";
}

Result<EmergencyFile> make_emergency_file(EmergencyFile of) {
  if (auto made = make_folder(); !made) return made.error();
  of.database = absolute(of.database);
  std::string time = utc_text(std::time(nullptr));
  std::erase(time, ':');
  const std::string wanted =
      (fs::path(emergency_folder()) / fs::path(of.database).stem()).string() + "-" + time;
  of.path = wanted + ".db";
  for (int number = 2; fs::exists(fs::symlink_status(of.path)); ++number)
    of.path = wanted + "-" + std::to_string(number) + ".db";
  auto database = Database::open(of.path, OpenMode::create);
  if (!database) return database.error();
  for (const char* suffix : {"", "-wal", "-shm"}) {
    std::error_code ignored;
    fs::permissions(of.path + suffix, fs::perms::owner_read | fs::perms::owner_write, ignored);
  }
  const auto done = database->transact("making an emergency file"_text, [&] {
    soci::session& sql = database->sql();
    sql << schema::kEmergencyOrigin;
    sql << "INSERT INTO emergency_origin VALUES (:path, :id, :reason)", soci::use(of.database),
        soci::use(of.database_id), soci::use(of.reason);
  });
  if (!done) return done.error();
  return of;
}

std::vector<EmergencyFile> emergency_files(const std::string& database) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(emergency_folder(), ignored))
    if (entry.path().extension() == ".db") names.push_back(entry.path());
  std::sort(names.begin(), names.end());
  const std::string id = database.empty() ? "" : id_of(database);
  const std::string path = database.empty() ? "" : absolute(database);
  std::vector<EmergencyFile> files;
  for (const std::string& name : names) {
    auto file = read_emergency(name);
    if (!file) continue;
    if (database.empty() || belongs_to(*file, id, path)) files.push_back(*std::move(file));
  }
  std::stable_sort(files.begin(), files.end(),
                   [](const auto& a, const auto& b) { return a.started_utc < b.started_utc; });
  return files;
}

Result<MergeReport> rescue(const std::string& database, const EmergencyFile& file) {
  if (const auto there = put_back(database, file); !there) return there.error();
  if (file.has_whole && id_of(database) != file.database_id) {
    auto all = merge_databases(database, file.whole());
    if (!all || !all->conflicts.empty()) return all;
  }
  const auto before = compare(database, file.path);
  if (!before) return before.error();
  const EmergencyMerge how{before->poorer};
  auto report = merge_databases(database, file.path, {}, OpenMode::existing, &how);
  if (!report || !report->conflicts.empty()) return report;
  const auto after = compare(database, file.path);
  if (!after) return after.error();
  if (after->missing > 0 || !after->poorer.empty())
    return failed("does not hold all of %1 after it was taken in"_text(file.path),
                  "keep that file, run isograsp db check, and rescue again"_text)
        .at(database);
  std::error_code ignored;
  for (const char* suffix : {"", "-wal", "-shm", "-lock", ".whole"})
    fs::remove(file.path + suffix, ignored);
  return report;
}

}  // namespace isograsp::storage
