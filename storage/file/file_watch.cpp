// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/file/file_watch.hpp"

#include <array>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include "storage/file/statement.hpp"

namespace isograsp::storage {

/// A file as its name leads to it.
struct NamedFile {
  bool there = false;
  dev_t device = 0;
  ino_t inode = 0;
  std::int64_t bytes = 0;
  std::int64_t changed_ns = 0;

  [[nodiscard]] bool same_file(const NamedFile& other) const {
    return there == other.there && device == other.device && inode == other.inode;
  }
};

namespace {

NamedFile named(const std::string& path) {
  struct stat found {};
  if (lstat(path.c_str(), &found) != 0) return {};  // a link in its place is another file
  constexpr std::int64_t kNs = 1'000'000'000;
  return {true, found.st_dev, found.st_ino, found.st_size,
          found.st_mtim.tv_sec * kNs + found.st_mtim.tv_nsec};
}

template <std::size_t kBytes>
bool read_at(sqlite_api::sqlite3_file* file, std::int64_t offset,
             std::array<unsigned char, kBytes>& bytes) {
  return file != nullptr && file->pMethods != nullptr &&
         file->pMethods->xRead(file, bytes.data(), static_cast<int>(kBytes), offset) == SQLITE_OK;
}

std::uint32_t big_endian_32(const unsigned char* bytes) {
  return (std::uint32_t{bytes[0]} << 24) | (std::uint32_t{bytes[1]} << 16) |
         (std::uint32_t{bytes[2]} << 8) | std::uint32_t{bytes[3]};
}

// The index of the write-ahead log (sqlite.org/walformat.html, "WAL-LogIndex File Format").
constexpr std::size_t kIndexBytes = 136;
constexpr std::size_t kFrames = 16;      ///< mxFrame
constexpr std::size_t kChecksum = 24;    ///< of the last frame
constexpr std::size_t kSalt = 32;        ///< of the log
constexpr std::size_t kCheckpoint = 96;  ///< nBackfill
constexpr std::size_t kAttempted = 128;  ///< nBackfillAttempted
constexpr int kRegion = 32768;

}  // namespace

struct LogIndex {
  std::array<unsigned char, kIndexBytes> bytes{};

  [[nodiscard]] std::uint32_t number(std::size_t at) const {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
  }
  [[nodiscard]] bool checkpoint_runs() const { return number(kCheckpoint) != number(kAttempted); }
  /// No checkpoint has begun or ended between the two.
  [[nodiscard]] bool same_checkpoints(const LogIndex& other) const {
    return std::memcmp(bytes.data() + kSalt, other.bytes.data() + kSalt, 8) == 0 &&
           number(kCheckpoint) == other.number(kCheckpoint) &&
           number(kAttempted) == other.number(kAttempted);
  }
};

struct FileWatch::Picture {
  sqlite_api::sqlite3* connection = nullptr;
  std::string path;
  int descriptor = -1;  ///< O_PATH: closing it drops no lock of the process
  NamedFile main;
  NamedFile log;
  NamedFile index_file;
  LogIndex index;
  bool index_known = false;
  std::array<unsigned char, 100> header{};

  [[nodiscard]] sqlite_api::sqlite3_file* file(int which) const {
    sqlite_api::sqlite3_file* found = nullptr;
    sqlite_api::sqlite3_file_control(connection, "main", which, &found);
    return found;
  }
  [[nodiscard]] bool read_index(LogIndex& into) const {
    sqlite_api::sqlite3_file* const main_file = file(SQLITE_FCNTL_FILE_POINTER);
    if (main_file == nullptr || main_file->pMethods == nullptr ||
        main_file->pMethods->iVersion < 2 || main_file->pMethods->xShmMap == nullptr)
      return false;
    void volatile* region = nullptr;
    if (main_file->pMethods->xShmMap(main_file, 0, kRegion, 0, &region) != SQLITE_OK ||
        region == nullptr)
      return false;
    const auto* const from = static_cast<const volatile unsigned char*>(region);
    for (std::size_t at = 0; at < kIndexBytes; ++at) into.bytes[at] = from[at];
    return true;
  }
};

FileWatch::FileWatch(soci::session& sql, std::string real_path)
    : before_(std::make_unique<Picture>()) {
  Picture& p = *before_;
  p.connection = connection_of(sql);
  p.path = std::move(real_path);
  p.descriptor = open(p.path.c_str(), O_PATH | O_CLOEXEC);
  p.main = named(p.path);
  p.log = named(p.path + "-wal");
  p.index_file = named(p.path + "-shm");
  static_cast<void>(read_at(p.file(SQLITE_FCNTL_FILE_POINTER), 0, p.header));
}

FileWatch::~FileWatch() {
  if (before_->descriptor >= 0) close(before_->descriptor);
}

bool FileWatch::is_last_hold() const {
  struct stat held {};
  return sound_ && fstat(before_->descriptor, &held) == 0 && held.st_nlink == 0;
}

const std::optional<Text>& FileWatch::fault(bool writing) {
  if (!fault_) fault_ = look(writing);
  return fault_;
}

std::optional<Text> FileWatch::look(bool writing) {
  auto of_main = look_at_main();
  auto of_log = look_at_log(writing);
  return of_main ? of_main : of_log;
}

std::optional<Text> FileWatch::look_at_main() {
  Picture& p = *before_;
  sqlite_api::sqlite3_file* const file = p.file(SQLITE_FCNTL_FILE_POINTER);
  LogIndex index;
  const bool index_read = p.read_index(index);
  const NamedFile now = named(p.path);
  LogIndex after;
  const bool still = index_read && p.read_index(after) && index.same_checkpoints(after) &&
                     !index.checkpoint_runs();
  int moved = 0;
  sqlite_api::sqlite3_file_control(p.connection, "main", SQLITE_FCNTL_HAS_MOVED, &moved);
  const bool replaced = now.there && (moved != 0 || !now.same_file(p.main));

  std::array<unsigned char, 100> header{};
  constexpr std::size_t kFixed = 24;  // name of the format, size of a page, versions
  constexpr std::size_t kPageCount = 28;
  constexpr std::size_t kApplication = 68;
  if (!read_at(file, 0, header) || std::memcmp(header.data(), p.header.data(), kFixed) != 0 ||
      std::memcmp(header.data() + kApplication, p.header.data() + kApplication, 4) != 0) {
    sound_ = false;
    if (!replaced && now.there)
      return now.bytes == 0 ? "the file was emptied"_text : "the file was overwritten"_text;
  }
  if (!now.there) return "the file was deleted or moved away"_text;
  if (replaced) return "another file was put in its place"_text;
  const std::int64_t page =
      header[16] == 0 && header[17] == 1 ? 65536 : header[16] * 256 + header[17];
  if (now.bytes < p.main.bytes && now.bytes < page * big_endian_32(header.data() + kPageCount)) {
    sound_ = false;
    return "the file was cut off"_text;
  }
  // Only checkpoints change it, and they count themselves.
  if (still && p.index_known && index.same_checkpoints(p.index) &&
      now.changed_ns != p.main.changed_ns) {
    sound_ = false;
    return "something else wrote into the file"_text;
  }
  if (still || !index_read) {
    p.main = now;
    p.index = index;
    p.index_known = index_read;
  }
  return std::nullopt;
}

std::optional<Text> FileWatch::look_at_log(bool writing) {
  Picture& p = *before_;
  const NamedFile log = named(p.path + "-wal");
  const NamedFile index_file = named(p.path + "-shm");
  const auto gone = [&](const NamedFile& now, NamedFile& then, Words replaced,
                        Words removed) -> std::optional<Text> {
    if (!then.there) then = now;  // made since
    if (now.same_file(then)) return std::nullopt;
    // Somebody else may use the new one; where there is none, the old one is complete.
    if (now.there) sound_ = false;
    return now.there ? replaced : removed;
  };
  auto found = gone(log, p.log, "the write-ahead log (-wal) beside the file was replaced"_text,
                    "the write-ahead log (-wal) beside the file was deleted or moved away"_text);
  if (auto shared =
          gone(index_file, p.index_file, "the index (-shm) beside the file was replaced"_text,
               "the index (-shm) beside the file was deleted or moved away"_text);
      shared && !found)
    found = std::move(shared);
  if (found) return found;

  LogIndex index;
  if (!p.read_index(index) || index.number(kFrames) == 0) return std::nullopt;
  const NamedFile whole = named(p.path + "-wal");
  sqlite_api::sqlite3_file* const file = p.file(SQLITE_FCNTL_JOURNAL_POINTER);
  constexpr std::int64_t kLogHeader = 32;
  constexpr std::int64_t kFrameHeader = 24;
  const std::int64_t page =
      p.header[16] == 0 && p.header[17] == 1 ? 65536 : p.header[16] * 256 + p.header[17];
  const std::int64_t frames = index.number(kFrames);
  const std::int64_t last = kLogHeader + (frames - 1) * (kFrameHeader + page);
  std::array<unsigned char, 32> head{};
  std::array<unsigned char, 24> frame{};
  const auto same_salt = [&](const unsigned char* at) {
    return std::memcmp(at, index.bytes.data() + kSalt, 8) == 0;
  };
  if (whole.bytes >= last + kFrameHeader + page && read_at(file, 0, head) &&
      read_at(file, last, frame) && same_salt(head.data() + 16) && same_salt(frame.data() + 8) &&
      big_endian_32(frame.data() + 16) == index.number(kChecksum))
    return std::nullopt;
  // The index is written after frames and before the log begins anew.
  LogIndex after;
  constexpr std::size_t kHeader = 48;
  if (!writing &&
      (!p.read_index(after) || std::memcmp(index.bytes.data(), after.bytes.data(), kHeader) != 0))
    return std::nullopt;
  sound_ = false;
  return "the write-ahead log (-wal) beside the file was cut off or overwritten"_text;
}

void FileWatch::leave() {
  if (!fault_ || std::exchange(left_, true)) return;
  sqlite_api::sqlite3* const connection = before_->connection;
  if (sound_)
    sqlite_api::sqlite3_wal_checkpoint_v2(connection, "main", SQLITE_CHECKPOINT_TRUNCATE, nullptr,
                                          nullptr);
  sqlite_api::sqlite3_db_config(connection, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
}

}  // namespace isograsp::storage
