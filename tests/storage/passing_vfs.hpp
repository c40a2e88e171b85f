// SPDX-License-Identifier: GPL-3.0-or-later
// A file layer for SQLite (VFS) that passes every call on to the usual one, for layers that do more
// with some of them.
#pragma once

#include <memory>

#include <sqlite3.h>

namespace isograsp::storage {

/// An open file of such a layer, with that of the usual one behind it.
struct PassingFile {
  sqlite3_file base;
  void* owner;  ///< of the layer
  void* own;    ///< what the layer knows of this file; nullptr: nothing

  [[nodiscard]] sqlite3_file* real() { return reinterpret_cast<sqlite3_file*>(this + 1); }
};
inline PassingFile& passing(sqlite3_file* file) {
  return *reinterpret_cast<PassingFile*>(file);
}
inline sqlite3_file* real_of(sqlite3_file* file) {
  return passing(file).real();
}

/// With shared memory, without memory mapping.
[[nodiscard]] sqlite3_io_methods passing_methods();

/// Registered by its owner; the functions that need no file of ours are the usual ones.
struct PassingVfs {
  sqlite3_vfs vfs{};
  sqlite3_vfs* real = nullptr;
  void* owner = nullptr;

  PassingVfs(const char* name, void* of);
  /// The layer of all new connections of this process, or no more.
  void begin();
  void end();
};
inline PassingVfs& layer_of(sqlite3_vfs* vfs) {
  return *static_cast<PassingVfs*>(vfs->pAppData);
}

/// Opens a file through the usual layer, with these methods before it.
[[nodiscard]] int open_passing(sqlite3_vfs* vfs, const char* name, sqlite3_file* file, int flags,
                               int* out, const sqlite3_io_methods& methods);

}  // namespace isograsp::storage
