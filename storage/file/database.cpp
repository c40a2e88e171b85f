// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/file/database.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string_view>

#include <fcntl.h>
#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "storage/file/old_formats.hpp"
#include "storage/file/open_mode.hpp"
#include "storage/file/schema.hpp"
#include "storage/file/statement.hpp"

namespace isograsp::storage {

namespace fs = std::filesystem;

namespace {

constexpr int kBusyTimeout_s = 5;  // below the ten seconds that the recorder's queue bridges

bool files_are_limited() {
  rlimit limit{};
  return getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

/// What SQLite's result code means to a user.
Error explain(const std::string& path, const Text& doing, int code, const std::string& message) {
  constexpr int kPrimary = 0xFF;
  switch (code & kPrimary) {
    case SQLITE_NOTADB:
    case SQLITE_CORRUPT:
      return failed("%1: the database is damaged"_text(doing),
                    "run isograsp db check, then restore the last backup"_text)
          .at(path);
    case SQLITE_FULL:
    case SQLITE_IOERR:
      if (files_are_limited())
        return failed(
                   "%1: the file has reached the size that this program may write "
                   "(RLIMIT_FSIZE), or the disk is full"_text(doing),
                   "raise that limit (ulimit -f unlimited), or free some space; everything "
                   "confirmed before is stored"_text)
            .at(path);
      return failed("%1: the disk is full or does not answer"_text(doing),
                    "free some space; everything confirmed before is stored"_text)
          .at(path);
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return failed("%1: the database is locked by another program"_text(doing),
                    "close that program or wait until it is done"_text)
          .at(path);
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
      return failed("%1: the file or its folder is not writable"_text(doing),
                    "check the permissions of both, or copy the file to a writable folder"_text)
          .at(path);
    case SQLITE_NOMEM:
      return failed("%1: there is not enough memory"_text(doing),
                    "close other programs; everything confirmed before is stored"_text)
          .at(path);
    case SQLITE_CONSTRAINT:
      return refused("%1: refused by the database (%2)"_text(doing, message),
                     "give values as docs/file_formats.md describes them"_text)
          .at(path);
    default:
      return failed("%1: %2"_text(doing, Known{message}), "run isograsp db check"_text).at(path);
  }
}

struct Header {
  bool sqlite = false;
  std::int32_t application_id = 0;
  int user_version = 0;
};

std::int32_t big_endian(const unsigned char* bytes) {
  return static_cast<std::int32_t>((std::uint32_t{bytes[0]} << 24) |
                                   (std::uint32_t{bytes[1]} << 16) |
                                   (std::uint32_t{bytes[2]} << 8) | std::uint32_t{bytes[3]});
}

/// Reads the first 100 bytes without a lock, a journal or any other trace. Through SQLite's own
/// file layer: closing a plain descriptor would drop the POSIX locks of every other connection that
/// this process has to the file.
std::optional<Header> read_header(const std::string& real_path) {
  using namespace sqlite_api;
  sqlite3_initialize();
  sqlite3_vfs* const vfs = sqlite3_vfs_find(nullptr);
  if (vfs == nullptr) return {};
  std::string memory(static_cast<std::size_t>(vfs->szOsFile), '\0');
  auto* const file = reinterpret_cast<sqlite3_file*>(memory.data());
  const std::string name = real_path + std::string(4, '\0');  // SQLite wants an empty URI list
  int flags = SQLITE_OPEN_READONLY | SQLITE_OPEN_MAIN_DB;
  if (vfs->xOpen(vfs, name.c_str(), file, flags, &flags) != SQLITE_OK) return {};
  std::array<unsigned char, 100> bytes{};
  const int done = file->pMethods->xRead(file, bytes.data(), static_cast<int>(bytes.size()), 0);
  file->pMethods->xClose(file);
  if (done != SQLITE_OK && done != SQLITE_IOERR_SHORT_READ) return {};
  constexpr char kMagic[] = "SQLite format 3";  // with its final zero: 16 bytes
  Header header;
  header.sqlite = std::memcmp(bytes.data(), kMagic, sizeof kMagic) == 0;
  header.user_version = big_endian(bytes.data() + 60);
  header.application_id = big_endian(bytes.data() + 68);
  return header;
}

/// A path as SOCI's connection string carries it.
std::string connection(const std::string& real_path, bool read_only) {
  return "db=\"" + real_path + "\" timeout=" + std::to_string(kBusyTimeout_s) +
         (read_only ? " readonly=true" : "");
}

bool writable(const std::string& path) {
  return faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0;
}

/// Makes an empty database under a name of its own, then gives it its name: either the whole file
/// is there or none. Somebody else's file that appears meanwhile is kept.
Result<void> create_file(const std::string& path, const fs::path& real_path, bool scratch) {
  const fs::path folder = real_path.parent_path();
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored))
    return refused("its folder does not exist"_text, "make the folder %1"_text(folder.string()))
        .at(path);
  if (!writable(folder))
    return failed("its folder is read-only"_text, "choose a folder that you may write to"_text)
        .at(path);
  const std::string temporary = real_path.string() + ".part" + std::to_string(getpid());
  const auto tidy = [&] {
    for (const char* suffix : {"", "-journal"}) fs::remove(temporary + suffix, ignored);
  };
  tidy();
  try {
    soci::session sql(soci::sqlite3, connection(temporary, false));
    sql << "PRAGMA synchronous=FULL";
    sql << "PRAGMA application_id=" + std::to_string(schema::kApplicationId);
    sql << "PRAGMA user_version=" + std::to_string(kDatabaseFormat);
    soci::transaction whole(sql);
    for (const std::string& statement : schema::statements()) sql << statement;
    if (scratch)  // the same each time; no keys depend on it
      sql << "UPDATE access_settings SET database_id = lower(hex(zeroblob(16)))";
    RowSeals(sql).seal_all();
    whole.commit();
  } catch (const soci::sqlite3_soci_error& why) {
    tidy();
    return explain(path, "making the database"_text, why.result(), why.get_error_message());
  } catch (const std::exception& why) {
    tidy();
    return failed("making the database: %1"_text(why.what()), "try again"_text).at(path);
  }
  // That of a protected database of this name which is gone.
  const std::string head = real_path.string() + "-audit";
  if (fs::exists(head, ignored) && !fs::exists(real_path, ignored))
    fs::rename(head, free_name(head + ".old"), ignored);
  const bool named = ::link(temporary.c_str(), real_path.c_str()) == 0 || errno == EEXIST;
  std::error_code failure;
  if (!named) fs::rename(temporary, real_path, failure);  // a file system without hard links
  tidy();
  static_cast<void>(sync_path(folder));
  if (failure)
    return failed("could not be made: %1"_text(Known{failure.message()}),
                  "choose another folder"_text)
        .at(path);
  return {};
}

/// What a file may make this program hold at once: as much as the largest block of signals. A file
/// of a kilobyte could otherwise ask for gigabytes.
void limit(soci::session& sql) {
  constexpr int kLargestValue = (1 << 27) + (1 << 20);  // bytes
  sqlite_api::sqlite3_limit(connection_of(sql), SQLITE_LIMIT_LENGTH, kLargestValue);
  sqlite_api::sqlite3_db_config(connection_of(sql), SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sql << "PRAGMA cell_size_check=ON";
}

/// Our tables hold what was written. A view or a computed column could produce any values when it
/// is read, in any number and of any size.
void refuse_what_computes(soci::session& sql, const std::string& path) {
  int views = 0;
  sql << "SELECT count(*) FROM sqlite_schema WHERE type = 'view' OR sql LIKE 'CREATE VIRTUAL%'",
      soci::into(views);
  int computed = 0;
  if (views == 0)
    sql << "SELECT count(*) FROM sqlite_schema s, pragma_table_xinfo(s.name) c "
           "WHERE s.type = 'table' AND c.hidden > 1",
        soci::into(computed);
  if (views + computed > 0)
    throw Refusal{refused("holds views or computed columns, which isograsp never makes"_text,
                          "do not use it: take a backup that you trust"_text)
                      .at(path)};
}

/// A pipe of such a name would let SQLite or a lock wait for ever.
Result<void> check_side_files(const std::string& real_path) {
  std::error_code ignored;
  for (const char* suffix : {"-wal", "-shm", "-journal", "-lock", "-audit"}) {
    const auto status = fs::status(real_path + suffix, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status))
      return refused("is not a plain file"_text, "remove it"_text).at(real_path + suffix);
  }
  return {};
}

/// Is this file one of ours that may be opened so?
Result<void> check_file(const std::string& path, const std::string& real_path, OpenMode how,
                        int oldest) {
  if (faccessat(AT_FDCWD, real_path.c_str(), R_OK, AT_EACCESS) != 0)
    return failed("may not be read"_text, "check its permissions"_text).at(path);
  const auto header = read_header(real_path);
  if (!header)
    return failed("cannot be read"_text, "check the disk and the permissions"_text).at(path);
  if (!header->sqlite)
    return refused("is not a database"_text, "give a file made by isograsp db init"_text).at(path);
  if (header->application_id != schema::kApplicationId)
    return refused("is a database of another program"_text,
                   "give a file made by isograsp db init"_text)
        .at(path);
  if (how == OpenMode::read_only) return {};
  if (header->user_version > kDatabaseFormat)
    return refused("was made by a newer isograsp (format %1, this program knows %2)"_text(
                       header->user_version, kDatabaseFormat),
                   "install the newer program; report and export still read it if they can"_text)
        .at(path);
  if (header->user_version < oldest)
    return refused("was made by an older isograsp (format %1, this program writes %2)"_text(
                       header->user_version, kDatabaseFormat),
                   "run isograsp db migrate on it; a copy of the file as it is now is kept"_text)
        .at(path);
  if (!writable(real_path))
    return failed("is read-only"_text, "make it writable, or copy it to where you may write"_text)
        .at(path);
  if (!writable(fs::path(real_path).parent_path()))
    return failed("stands in a read-only folder"_text,
                  "make the folder writable, or copy the file to where you may write"_text)
        .at(path);
  return {};
}

}  // namespace

bool may_be_written(const std::string& path) {
  std::error_code failure;
  const fs::path real_path = fs::weakly_canonical(fs::absolute(path), failure);
  return !failure && writable(real_path) && writable(real_path.parent_path());
}

std::string free_name(const std::string& wanted) {
  std::string name = wanted;
  for (int number = 2; fs::exists(fs::symlink_status(name)); ++number)
    name = wanted + "-" + std::to_string(number);
  return name;
}

bool sync_path(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool done = fsync(descriptor) == 0;
  close(descriptor);
  return done;
}

void give_permissions_of(const std::string& database, const std::string& beside) {
  std::error_code failure;
  const auto allowed = fs::status(database, failure).permissions() & fs::perms::all;
  if (!failure) fs::permissions(beside, allowed, failure);
}

RecordingLock::RecordingLock(RecordingLock&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)) {}

RecordingLock& RecordingLock::operator=(RecordingLock&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

RecordingLock::~RecordingLock() {
  if (descriptor_ >= 0) close(descriptor_);
}

Result<RecordingLock> RecordingLock::take(const std::string& path, int operation) {
  RecordingLock lock;
  const std::string side_file = path + "-lock";
  // Read access is enough for flock, and everybody who may write the database must get it.
  int descriptor = ::open(side_file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0 && errno == ENOENT) {
    descriptor = ::open(side_file.c_str(), O_RDONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0600);
    if (descriptor >= 0) give_permissions_of(path, side_file);
  }
  if (descriptor < 0)
    return failed("cannot be opened: %1"_text(Known{std::strerror(errno)}),
                  "check the permissions of the file and its folder"_text)
        .at(side_file);
  int done = 0;
  do done = flock(descriptor, operation);
  while (done != 0 && errno == EINTR);
  if (done == 0)
    lock.descriptor_ = descriptor;
  else
    close(descriptor);
  if (done != 0 && errno != EWOULDBLOCK)
    return failed("cannot be locked: %1"_text(Known{std::strerror(errno)}),
                  "keep the database on a local disk"_text)
        .at(side_file);
  return lock;
}

Result<RecordingLock> RecordingLock::shared(const std::string& path) {
  return take(path, LOCK_SH);
}

Result<RecordingLock> RecordingLock::exclusive_if_free(const std::string& path) {
  return take(path, LOCK_EX | LOCK_NB);
}

bool RecordingLock::in_place(const std::string& path) const noexcept {
  struct stat ours {};
  struct stat named {};
  return held() && fstat(descriptor_, &ours) == 0 && stat((path + "-lock").c_str(), &named) == 0 &&
         ours.st_dev == named.st_dev && ours.st_ino == named.st_ino;
}

Database::Database(Database&&) noexcept = default;
Database::~Database() = default;

Result<Database> Database::open(const std::string& path, OpenMode how, int oldest) {
  if (path.empty()) return refused("no database file is given"_text, "name a file"_text);
  if (path.find('"') != std::string::npos)
    return refused("the name of a database may not hold a quotation mark"_text, "rename it"_text)
        .at(path);
  std::error_code failure;
  // SQLite keeps its journal beside the file itself, not beside a link to it; so do we.
  const fs::path real_path = fs::weakly_canonical(fs::absolute(path), failure);
  if (failure)
    return refused("cannot be reached: %1"_text(Known{failure.message()}), "check the path"_text)
        .at(path);
  const auto status = fs::status(real_path, failure);
  if (fs::is_directory(status))
    return refused("is a folder"_text, "name a file in it"_text).at(path);
  if (fs::exists(status) && !fs::is_regular_file(status))
    return refused("is not a plain file"_text, "give a file made by isograsp db init"_text)
        .at(path);
  const bool made_now = !fs::exists(status);
  if (made_now) {
    if (how != OpenMode::create && how != OpenMode::scratch)
      return refused("does not exist"_text, "make it with isograsp db init, or check the path"_text)
          .at(path);
    if (const auto made = create_file(path, real_path, how == OpenMode::scratch); !made)
      return made.error();
  }
  if (const auto plain = check_side_files(real_path); !plain) return plain.error();
  if (const auto ours = check_file(path, real_path, how, oldest); !ours) return ours.error();

  Database database;
  database.path_ = path;
  database.real_path_ = real_path;
  const bool read_only = how == OpenMode::read_only;
  database.read_only_ = read_only;
  // A reader that may write the file still opens it so (and then promises not to): SQLite can then
  // remove its journal when the last connection closes, instead of leaving it beside the file.
  const bool sealed = read_only && !may_be_written(real_path);
  const auto opened = database.guard("opening"_text, [&] {
    database.session_ =
        std::make_unique<soci::session>(soci::sqlite3, connection(real_path, sealed));
    soci::session& sql = *database.session_;
    database.gate_ = std::make_unique<CommitGate>();
    const auto commits = [](void* gate) {
      auto& asked = *static_cast<CommitGate*>(gate);
      asked.refused = asked.refused || asked.closed;
      return asked.closed ? 1 : 0;
    };
    sqlite_api::sqlite3_commit_hook(connection_of(sql), commits, database.gate_.get());
    limit(sql);
    sql << "PRAGMA foreign_keys=ON";
    sql << "PRAGMA trusted_schema=OFF";
    refuse_what_computes(sql, path);
    constexpr int kOff = 0;
    constexpr int kFull = 2;
    database.scratch_ = how == OpenMode::scratch;
    const std::string synchronous = std::to_string(database.scratch_ ? kOff : kFull);
    sql << "PRAGMA synchronous=" + synchronous;
    database.format_ = std::stoi(pragma(sql, "user_version"));
    if (read_only) {
      for (const std::string& view : schema::views_of(database.format_)) sql << view;
      sql << "PRAGMA query_only=ON";
    }
    const bool wal = read_only || pragma(sql, "journal_mode=WAL") == "wal";
    if (!wal || pragma(sql, "synchronous") != synchronous || pragma(sql, "foreign_keys") != "1")
      throw Refusal{failed("the database cannot be set to durable writing"_text,
                           "keep it on a local disk"_text)
                        .at(path)};
    if (!read_only && (database.format_ < oldest || database.format_ > kDatabaseFormat))
      throw Refusal{refused("has a format that this program does not know"_text,
                            "use the program that made it"_text)
                        .at(path)};
    if (!read_only && database.format_ == kDatabaseFormat) database.begin_to_seal();
    if (!read_only && !database.scratch_)
      database.watch_ = std::make_unique<FileWatch>(sql, real_path);
  });
  if (!opened) return opened.error();
  return database;
}

Result<void> Database::guard(const Text& doing, const std::function<void()>& work) {
  try {
    work();
    return {};
  } catch (const Refusal& refusal) {
    return refusal.error;
  } catch (const soci::sqlite3_soci_error& why) {
    return explain(path_, doing, why.result(), why.get_error_message());
  } catch (const std::exception& why) {
    return failed("%1: %2"_text(doing, Known{why.what()}), "run isograsp db check"_text).at(path_);
  }
}

Result<void> Database::snapshot(const Text& doing, const std::function<void()>& work) {
  return enclose("BEGIN", doing, work);
}

Result<void> Database::transact(const Text& doing, const std::function<void()>& work) {
  // IMMEDIATE: waits for other writers now, instead of failing after the first read.
  return enclose("BEGIN IMMEDIATE", doing, work);
}

Result<bool> Database::transact_if_free(const Text& doing, const std::function<void()>& work) {
  const auto wait_ms = [&](int most) {
    return guard(doing, [&] { sql() << "PRAGMA busy_timeout=" + std::to_string(most); });
  };
  constexpr int kMilliseconds = 1000;
  if (const auto set = wait_ms(0); !set) return set.error();
  bool begun = false;
  const auto done = transact(doing, [&] {
    begun = true;
    work();
  });
  if (const auto set = wait_ms(kMilliseconds * kBusyTimeout_s); !set) return set.error();
  if (!begun) return false;
  if (!done) return done.error();
  return true;
}

Error Database::lost(const Text& doing, const Text& fault) const {
  return failed("%1: %2 while it was open"_text(doing, fault),
                "put it back as it was, or restore the last backup"_text)
      .at(path_);
}

Result<void> Database::in_place() {
  if (!watch_) return {};
  const auto& fault = watch_->fault(false);
  if (!fault) return {};
  watch_->leave();
  return lost("looking at the database"_text, *fault);
}

Result<void> Database::enclose(const char* begin, const Text& doing,
                               const std::function<void()>& work) {
  const bool writing = std::string_view(begin) != "BEGIN";
  const auto given_up = [&] { return explain(path_, doing, SQLITE_NOMEM, ""); };
  const auto stop_if_lost = [&] {
    if (!watch_ || !writing) return;
    if (const auto& fault = watch_->fault(true)) throw Refusal{lost(doing, *fault)};
  };
  auto done = guard(doing, [&] {
    sql() << begin;
    try {
      *gate_ = {writing, false};
      work();
      seal_rows();
      if (before_commit_) before_commit_();
      stop_if_lost();
      if (sqlite_api::sqlite3_get_autocommit(connection_of(sql())) != 0) throw Refusal{given_up()};
      gate_->closed = false;
      sql() << "COMMIT";
      if (seals_) seals_->committed();
    } catch (...) {
      gate_->closed = false;
      if (seals_) seals_->rolled_back();
      try {
        sql() << "ROLLBACK";
      } catch (const soci::soci_error&) {  // SQLite has rolled back by itself (full disk)
      }
      if (gate_->refused) throw Refusal{given_up()};
      throw;
    }
  });
  if (done || !watch_) return done;
  // Whatever SQLite says of a file that was taken away: this is why.
  const auto& fault = watch_->fault(false);
  if (!fault) return done;
  watch_->leave();
  return lost(doing, *fault);
}

}  // namespace isograsp::storage
