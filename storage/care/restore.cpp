// SPDX-License-Identifier: GPL-3.0-or-later
// Restoring from a backup: a copy is made, checked and given its entry in the log beside the
// file; only then does it take the place of what is there, and every step of that can be taken
// back.
#include <filesystem>
#include <functional>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "core/staging_folder.hpp"
#include "storage/access/audit_head_file.hpp"
#include "storage/access/audit_log.hpp"
#include "storage/access/open_store.hpp"
#include "storage/access/signing.hpp"
#include "storage/care/backups.hpp"
#include "storage/file/statement.hpp"
#include "storage/sqlite/sqlite_store.hpp"

namespace isograsp::storage {

namespace fs = std::filesystem;

namespace {

enum class Left { may_be_damaged, is_sound };

/// No other program has the file open; its log is in it. A file that is damaged is left with its
/// log, as it is.
Result<void> close_for_all(const std::string& path, Left left) {
  constexpr int kPrimary = 0xFF;
  try {
    soci::session sql(soci::sqlite3, "db=\"" + path + "\" timeout=0");
    pragma(sql, "journal_mode=DELETE");
  } catch (const soci::sqlite3_soci_error& why) {
    const int code = why.result() & kPrimary;
    if (code == SQLITE_BUSY || code == SQLITE_LOCKED)
      return failed("another program has it open"_text, "close that program, then restore"_text)
          .at(path);
    if (left == Left::is_sound)
      return failed("the copy could not be written"_text, "check the disk and the folder"_text)
          .at(path);
  }
  return {};
}

/// Renamings that are taken back, the last one first, unless all went well.
class Renamings {
 public:
  Renamings() = default;
  Renamings(const Renamings&) = delete;
  Renamings& operator=(const Renamings&) = delete;
  ~Renamings() {
    for (auto step = undo_.rbegin(); step != undo_.rend(); ++step) (*step)();
  }
  /// Nothing if there is no such file.
  [[nodiscard]] std::error_code rename(const std::string& from, const std::string& to) {
    std::error_code failure;
    if (!fs::exists(fs::symlink_status(from, failure))) return {};
    fs::rename(from, to, failure);
    if (!failure) take_back([from, to] { again(to, from); });
    return failure;
  }
  void take_back(std::function<void()> step) { undo_.push_back(std::move(step)); }
  void keep() { undo_.clear(); }

 private:
  static void again(const std::string& from, const std::string& to) {
    std::error_code ignored;
    fs::rename(from, to, ignored);
  }
  std::vector<std::function<void()>> undo_;
};

/// Where a signature stands beside it, it must be of this file. Its key; empty: there is none.
Result<std::string> key_of_signed(const std::string& backup) {
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(signature_file_of(backup), ignored))) return std::string();
  const auto proved = check_signature(backup, SignedKind::backup);
  if (!proved) return proved.error();
  return proved->key;
}

/// Sound to the last value and with a whole audit log; the entry says where it came from.
Result<void> prepare(const std::string& copy, const std::string& backup, const std::string& kept,
                     const LogIn& log_in) {
  auto source = Database::open(backup, OpenMode::read_only);
  if (!source) return source.error();
  const bool current = source->format() == kDatabaseFormat;
  if (!current && is_protected_database(backup))  // nobody logs in to an older format
    return refused("is protected and has the older format %1"_text(source->format()),
                   "run isograsp db migrate on a copy of it, then restore from that"_text)
        .at(backup);
  // Not through a store: the backup stays as it is, its audit log too.
  if (auto copied = SqliteStore(*std::move(source)).backup(copy); !copied) return copied;
  std::unique_ptr<Access> access;
  if (current) {
    auto opened = log_in(copy);
    if (!opened) return opened.error();
    access = *std::move(opened);
    if (access->is_protected())
      if (auto allowed = access->require(Right::write_records, "restore", ""); !allowed)
        return allowed;
  }
  {
    const auto store = open_store(copy, OpenMode::read_only);
    if (!store) return store.error();
    const auto problems = (*store)->check();
    if (!problems) return problems.error();
    if (!problems->empty())
      return failed("the backup is not sound: %1"_text(problems->front()),
                    "take an older backup"_text)
          .at(backup);
  }
  if (access == nullptr) return {};
  std::string files = fs::path(backup).filename();
  if (!kept.empty()) files += "; as it was: " + fs::path(kept).filename().string();
  return log_act(*access, "restore", "", true, files);
}

/// `copy` becomes `target`, and what is there `kept`; or nothing is changed.
Result<void> put_in_place(const std::string& copy, const std::string& target,
                          const std::string& kept) {
  const auto not_renamed = [&](const std::error_code& why) {
    return failed("cannot be renamed: %1"_text(Known{why.message()}),
                  "make its folder writable"_text)
        .at(target);
  };
  const auto lock = RecordingLock::exclusive_if_free(target);
  if (!lock) return lock.error();
  if (!lock->held())
    return failed("another program records into it now"_text, "end that session, then restore"_text)
        .at(target);
  Renamings renamings;
  std::error_code failure;
  if (!kept.empty())
    if (auto closed = close_for_all(target, Left::may_be_damaged); !closed) return closed;
  // The log first: it must never stand beside a file that is not its own. A file that was lost may
  // have left one.
  const std::string aside = kept.empty() ? free_name(target + ".before-restore") : kept;
  for (const char* log : {"-wal", "-journal"})
    if (const auto why = renamings.rename(target + log, aside + log); why) return not_renamed(why);
  fs::remove(target + "-shm", failure);
  if (!kept.empty()) {
    // A second name, so that at no moment there is no file; where there are none, a new one.
    if (::link(target.c_str(), kept.c_str()) == 0)
      renamings.take_back([kept] {
        std::error_code ignored;
        fs::remove(kept, ignored);
      });
    else if (const auto why = renamings.rename(target, kept); why)
      return not_renamed(why);
  }
  if (const std::string old = set_aside_head_file(target); !old.empty())
    renamings.take_back([old, target] {
      std::error_code ignored;
      fs::rename(old, head_file_of(target), ignored);
    });
  if (const auto why = renamings.rename(copy, target); why) return not_renamed(why);
  renamings.keep();
  fs::rename(head_file_of(copy), head_file_of(target), failure);  // there is none where unprotected
  static_cast<void>(sync_path(fs::path(target).parent_path()));
  return {};
}

}  // namespace

Result<Restored> restore_backup(const std::string& backup, const std::string& database,
                                const LogIn& log_in) {
  std::error_code failure;
  const std::string target = fs::weakly_canonical(fs::absolute(database), failure).string();
  if (failure || database.empty())
    return refused("cannot be reached"_text, "check the path"_text).at(database);
  if (fs::equivalent(backup, target, failure))
    return refused("is the backup itself"_text, "name two files"_text).at(database);
  const auto staging = StagingFolder::beside(target);
  if (!staging) return staging.error();
  const std::string& copy = staging->file();
  Restored restored;
  if (fs::exists(fs::symlink_status(target))) restored.kept = free_name(target + ".before-restore");
  const auto key = key_of_signed(backup);
  if (!key) return key.error();
  restored.key = *key;
  auto done = prepare(copy, backup, restored.kept, log_in);
  if (done) done = close_for_all(copy, Left::is_sound);
  if (done) done = put_in_place(copy, target, restored.kept);
  if (done) return restored;
  Error error = done.error();
  if (error.file == copy) error.file = backup;
  return error;
}

}  // namespace isograsp::storage
