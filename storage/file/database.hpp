// SPDX-License-Identifier: GPL-3.0-or-later
// One connection to one database file: what is checked before SQLite may touch it, how it is
// opened, transactions, and the translation of exceptions into errors. Inside storage/ only.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/result.hpp"
#include "storage/file/file_watch.hpp"
#include "storage/file/open_mode.hpp"
#include "storage/file/row_seals.hpp"

namespace soci {
class session;
}

namespace isograsp::storage {

/// Holds while this program records; other programs can tell that it lives (flock: the kernel
/// releases it however the program ends).
class RecordingLock {
 public:
  RecordingLock() = default;
  RecordingLock(RecordingLock&& other) noexcept;
  RecordingLock& operator=(RecordingLock&& other) noexcept;
  ~RecordingLock();
  /// Waits while another program repairs the file (milliseconds). Any number may record.
  [[nodiscard]] static Result<RecordingLock> shared(const std::string& path);
  /// Not held (see held()) if somebody records.
  [[nodiscard]] static Result<RecordingLock> exclusive_if_free(const std::string& path);
  [[nodiscard]] bool held() const noexcept { return descriptor_ >= 0; }
  /// Other programs that ask for the lock of `path` still find this one.
  [[nodiscard]] bool in_place(const std::string& path) const noexcept;

 private:
  [[nodiscard]] static Result<RecordingLock> take(const std::string& path, int operation);
  int descriptor_ = -1;
};

class Database {
 public:
  /// As open_store(), without the repair of interrupted trials.
  /// `oldest`: format from which on a file may be opened for writing.
  [[nodiscard]] static Result<Database> open(const std::string& path, OpenMode how,
                                             int oldest = kDatabaseFormat);
  Database(Database&&) noexcept;
  ~Database();

  [[nodiscard]] soci::session& sql() noexcept { return *session_; }
  [[nodiscard]] const std::string& path() const noexcept { return path_; }  ///< as the user gave it
  [[nodiscard]] const std::string& real_path() const noexcept { return real_path_; }
  [[nodiscard]] int format() const noexcept {
    return format_;
  }  ///< when it was opened, or migrated
  [[nodiscard]] bool is_scratch() const noexcept { return scratch_; }
  [[nodiscard]] bool is_read_only() const noexcept { return read_only_; }

  /// Runs `work`; what it throws becomes an Error that names the file and `doing`.
  [[nodiscard]] Result<void> guard(const Text& doing, const std::function<void()>& work);
  /// The same, and all that is read is from one moment. @pre no transaction is open
  [[nodiscard]] Result<void> snapshot(const Text& doing, const std::function<void()>& work);
  /// The same in one transaction: durable when it returns, or nothing done. Refused, and nothing
  /// done, once the file or those beside it are not what was opened (storage/file/file_watch.hpp).
  [[nodiscard]] Result<void> transact(const Text& doing, const std::function<void()>& work);
  /// transact() that does not wait. False, and nothing done: another program is writing.
  [[nodiscard]] Result<bool> transact_if_free(const Text& doing, const std::function<void()>& work);
  /// What transact() does before it commits; for what is to hold the seals of its own transaction.
  void seal_rows() {
    if (seals_) seals_->seal();
  }
  /// None: the file is only read, or has an older format.
  [[nodiscard]] RowSeals* seals() noexcept { return seals_.get(); }
  /// The file has got the present format: from now on rows are sealed.
  void begin_to_seal() {
    format_ = kDatabaseFormat;
    seals_ = std::make_unique<RowSeals>(*session_);
  }
  /// The check that transact() makes, outside of a transaction.
  [[nodiscard]] Result<void> in_place();
  void watch_no_more() { watch_.reset(); }
  /// The file was unlinked: its content ends with this connection.
  [[nodiscard]] bool is_last_hold() const { return watch_ && watch_->is_last_hold(); }

 private:
  friend class AlsoBeforeCommit;
  Database() = default;
  [[nodiscard]] Result<void> enclose(const char* begin, const Text& doing,
                                     const std::function<void()>& work);
  std::string path_;
  std::string real_path_;
  int format_ = kDatabaseFormat;
  bool scratch_ = false;
  bool read_only_ = false;
  [[nodiscard]] Error lost(const Text& doing, const Text& fault) const;
  /// Inside a transaction only its own COMMIT commits: where SQLite has rolled back by itself (out
  /// of memory) and nobody has heard of it, what follows would be stored statement by statement.
  struct CommitGate {
    bool closed = false;
    bool refused = false;
  };
  std::unique_ptr<CommitGate> gate_;  ///< outlives the session, which asks it
  std::unique_ptr<soci::session> session_;
  std::unique_ptr<FileWatch> watch_;  ///< none: read only, scratch
  std::function<void()> before_commit_;
  std::unique_ptr<RowSeals> seals_;
};

/// While it lives, `also` runs at the end of every transaction of `database`, as a part of it.
class AlsoBeforeCommit {
 public:
  AlsoBeforeCommit(Database& database, std::function<void()> also) : database_(database) {
    database_.before_commit_ = std::move(also);
  }
  AlsoBeforeCommit(const AlsoBeforeCommit&) = delete;
  AlsoBeforeCommit& operator=(const AlsoBeforeCommit&) = delete;
  ~AlsoBeforeCommit() { database_.before_commit_ = {}; }

 private:
  Database& database_;
};

/// The file and its folder may be written.
[[nodiscard]] bool may_be_written(const std::string& path);

/// `wanted`, or `wanted-2`, `wanted-3` … where that exists.
[[nodiscard]] std::string free_name(const std::string& wanted);

/// Who may use the database may use the file beside it.
void give_permissions_of(const std::string& database, const std::string& beside);

/// A file, or the names in a folder, are on the disk when it returns true.
[[nodiscard]] bool sync_path(const std::string& path);

/// Thrown inside guard() and transact() to give up with an error of our own.
struct Refusal {
  Error error;
};

}  // namespace isograsp::storage
