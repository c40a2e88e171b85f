// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/storage/failing_sqlite.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

#include <execinfo.h>

#include "tests/storage/passing_vfs.hpp"

namespace isograsp::storage {

namespace {

// One for the process: the functions of SQLite's allocator are given nothing of ours.
Asked counted = Asked::read;
int fails_at = 0;
bool fails_for_good = false;
int calls = 0;
bool failed_once = false;
bool is_armed = false;
sqlite3_mem_methods usual_memory{};
using Stack = std::array<void*, 64>;
std::map<Stack, std::pair<int, int>> calls_of;  ///< first and last call

void note_place() {
  Stack stack{};
  backtrace(stack.data(), static_cast<int>(stack.size()));
  calls_of.try_emplace(stack, calls, calls).first->second.second = calls;
}

/// This call fails.
bool fails(Asked what) {
  if (!is_armed || what != counted) return false;
  ++calls;
  if (what == Asked::memory && fails_at == 0) note_place();
  const bool now = calls == fails_at || (fails_for_good && fails_at > 0 && calls > fails_at);
  failed_once = failed_once || now;
  return now;
}

void configure(int option, void* with) {
  if (sqlite3_config(option, with) != SQLITE_OK)
    throw std::runtime_error("SQLite's allocator cannot be replaced: a connection is open");
}

void set_lookaside(int size, int count) {
  if (sqlite3_config(SQLITE_CONFIG_LOOKASIDE, size, count) != SQLITE_OK)
    throw std::runtime_error("SQLite's store of small allocations cannot be set");
}

// SQLite's own default.
constexpr int kUsualSlot_bytes = 1200;
constexpr int kUsualSlots = 40;

}  // namespace

struct FailingSqlite::Layer {
  PassingVfs passing{"failing", nullptr};

  static int open(sqlite3_vfs* vfs, const char* name, sqlite3_file* file, int flags, int* out) {
    if (fails(Asked::open)) {
      file->pMethods = nullptr;
      return SQLITE_CANTOPEN;
    }
    return open_passing(vfs, name, file, flags, out, methods());
  }
  static int remove(sqlite3_vfs* vfs, const char* name, int sync_folder) {
    if (fails(Asked::remove)) return SQLITE_IOERR_DELETE;
    auto* const usual = layer_of(vfs).real;
    return usual->xDelete(usual, name, sync_folder);
  }

  static const sqlite3_io_methods& methods() {
    static const sqlite3_io_methods usual = passing_methods();
    static const sqlite3_io_methods table = [] {
      sqlite3_io_methods m = passing_methods();
      m.xRead = [](sqlite3_file* f, void* to, int count, sqlite3_int64 offset) {
        return fails(Asked::read) ? SQLITE_IOERR_READ : usual.xRead(f, to, count, offset);
      };
      m.xWrite = [](sqlite3_file* f, const void* from, int count, sqlite3_int64 offset) {
        return fails(Asked::write) ? SQLITE_IOERR_WRITE : usual.xWrite(f, from, count, offset);
      };
      m.xSync = [](sqlite3_file* f, int flags) {
        return fails(Asked::sync) ? SQLITE_IOERR_FSYNC : usual.xSync(f, flags);
      };
      m.xTruncate = [](sqlite3_file* f, sqlite3_int64 size) {
        return fails(Asked::truncate) ? SQLITE_IOERR_TRUNCATE : usual.xTruncate(f, size);
      };
      m.xFileSize = [](sqlite3_file* f, sqlite3_int64* size) {
        return fails(Asked::size) ? SQLITE_IOERR_FSTAT : usual.xFileSize(f, size);
      };
      m.xShmMap = [](sqlite3_file* f, int page, int size, int extend, void volatile** to) {
        return fails(Asked::map) ? SQLITE_IOERR_SHMMAP : usual.xShmMap(f, page, size, extend, to);
      };
      return m;
    }();
    return table;
  }
};

FailingSqlite::FailingSqlite() {
  sqlite3_shutdown();
  configure(SQLITE_CONFIG_GETMALLOC, &usual_memory);
  sqlite3_mem_methods failing = usual_memory;
  failing.xMalloc = [](int bytes) -> void* {
    return fails(Asked::memory) ? nullptr : usual_memory.xMalloc(bytes);
  };
  failing.xRealloc = [](void* old, int bytes) -> void* {
    return fails(Asked::memory) ? nullptr : usual_memory.xRealloc(old, bytes);
  };
  configure(SQLITE_CONFIG_MALLOC, &failing);
  set_lookaside(0, 0);  // else most small requests would not come by here
  layer_ = std::make_unique<Layer>();
  layer_->passing.vfs.xOpen = Layer::open;
  layer_->passing.vfs.xDelete = Layer::remove;
  layer_->passing.begin();
}

FailingSqlite::~FailingSqlite() {
  heal();
  layer_->passing.end();
  sqlite3_shutdown();
  sqlite3_config(SQLITE_CONFIG_MALLOC, &usual_memory);
  sqlite3_config(SQLITE_CONFIG_LOOKASIDE, kUsualSlot_bytes, kUsualSlots);
  sqlite3_initialize();
}

void FailingSqlite::fail(Asked what, int nth, bool for_good) {
  counted = what;
  fails_at = nth;
  fails_for_good = for_good;
  calls = 0;
  if (nth == 0) calls_of.clear();
  failed_once = false;
  is_armed = true;
}

int FailingSqlite::heal() {
  is_armed = false;
  return calls;
}

std::vector<int> FailingSqlite::calls_by_place() const {
  std::vector<int> numbers;
  for (const auto& [stack, ends] : calls_of) {
    numbers.push_back(ends.first);
    if (ends.second != ends.first) numbers.push_back(ends.second);
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

bool FailingSqlite::has_failed() const {
  return failed_once;
}

}  // namespace isograsp::storage
