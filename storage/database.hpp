// SPDX-License-Identifier: GPL-3.0-or-later
// One connection to one database file: what is checked before SQLite may touch it, how it is
// opened, transactions, and the translation of exceptions into errors. Internal to this folder.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/result.hpp"
#include "storage/session_store.hpp"

namespace soci {
class session;
}

namespace isograsp {

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

 private:
  [[nodiscard]] static Result<RecordingLock> take(const std::string& path, int operation);
  int descriptor_ = -1;
};

class Database {
 public:
  /// As SessionStore::open, without the repair of interrupted trials.
  /// `oldest`: format from which on a file may be opened for writing.
  [[nodiscard]] static Result<Database> open(const std::string& path, SessionStore::Open how,
                                             int oldest = kDatabaseFormat);
  Database(Database&&) noexcept;
  ~Database();

  [[nodiscard]] soci::session& sql() noexcept { return *session_; }
  [[nodiscard]] const std::string& path() const noexcept { return path_; }  ///< as the user gave it
  [[nodiscard]] const std::string& real_path() const noexcept { return real_path_; }
  [[nodiscard]] int format() const noexcept { return format_; }  ///< when it was opened
  [[nodiscard]] bool is_scratch() const noexcept { return scratch_; }

  /// Runs `work`; what it throws becomes an Error that names the file and `doing`.
  [[nodiscard]] Result<void> guard(const char* doing, const std::function<void()>& work);
  /// The same, and all that is read is from one moment. @pre no transaction is open
  [[nodiscard]] Result<void> snapshot(const char* doing, const std::function<void()>& work);
  /// The same in one transaction: durable when it returns, or nothing done.
  [[nodiscard]] Result<void> transact(const char* doing, const std::function<void()>& work);

 private:
  friend class AlsoBeforeCommit;
  Database() = default;
  [[nodiscard]] Result<void> enclose(const char* begin, const char* doing,
                                     const std::function<void()>& work);
  std::string path_;
  std::string real_path_;
  int format_ = kDatabaseFormat;
  bool scratch_ = false;
  std::unique_ptr<soci::session> session_;
  std::function<void()> before_commit_;
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

/// A file, or the names in a folder, are on the disk when it returns true.
[[nodiscard]] bool sync_path(const std::string& path);

/// Thrown inside guard() and transact() to give up with an error of our own.
struct Refusal {
  Error error;
};

}  // namespace isograsp
