// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/storage/passing_vfs.hpp"

#include <stdexcept>

namespace isograsp::storage {

sqlite3_io_methods passing_methods() {
  sqlite3_io_methods m{};
  m.iVersion = 2;
  m.xClose = [](sqlite3_file* f) { return real_of(f)->pMethods->xClose(real_of(f)); };
  m.xRead = [](sqlite3_file* f, void* to, int count, sqlite3_int64 offset) {
    return real_of(f)->pMethods->xRead(real_of(f), to, count, offset);
  };
  m.xWrite = [](sqlite3_file* f, const void* from, int count, sqlite3_int64 offset) {
    return real_of(f)->pMethods->xWrite(real_of(f), from, count, offset);
  };
  m.xTruncate = [](sqlite3_file* f, sqlite3_int64 size) {
    return real_of(f)->pMethods->xTruncate(real_of(f), size);
  };
  m.xSync = [](sqlite3_file* f, int flags) {
    return real_of(f)->pMethods->xSync(real_of(f), flags);
  };
  m.xFileSize = [](sqlite3_file* f, sqlite3_int64* size) {
    return real_of(f)->pMethods->xFileSize(real_of(f), size);
  };
  m.xLock = [](sqlite3_file* f, int l) { return real_of(f)->pMethods->xLock(real_of(f), l); };
  m.xUnlock = [](sqlite3_file* f, int l) { return real_of(f)->pMethods->xUnlock(real_of(f), l); };
  m.xCheckReservedLock = [](sqlite3_file* f, int* out) {
    return real_of(f)->pMethods->xCheckReservedLock(real_of(f), out);
  };
  m.xFileControl = [](sqlite3_file* f, int op, void* argument) {
    return real_of(f)->pMethods->xFileControl(real_of(f), op, argument);
  };
  m.xSectorSize = [](sqlite3_file* f) { return real_of(f)->pMethods->xSectorSize(real_of(f)); };
  m.xDeviceCharacteristics = [](sqlite3_file* f) {
    return real_of(f)->pMethods->xDeviceCharacteristics(real_of(f));
  };
  m.xShmMap = [](sqlite3_file* f, int page, int size, int extend, void volatile** to) {
    return real_of(f)->pMethods->xShmMap(real_of(f), page, size, extend, to);
  };
  m.xShmLock = [](sqlite3_file* f, int offset, int n, int flags) {
    return real_of(f)->pMethods->xShmLock(real_of(f), offset, n, flags);
  };
  m.xShmBarrier = [](sqlite3_file* f) { real_of(f)->pMethods->xShmBarrier(real_of(f)); };
  m.xShmUnmap = [](sqlite3_file* f, int remove) {
    return real_of(f)->pMethods->xShmUnmap(real_of(f), remove);
  };
  return m;
}

PassingVfs::PassingVfs(const char* name, void* of) : owner(of) {
  sqlite3_initialize();
  real = sqlite3_vfs_find(nullptr);
  vfs = *real;
  vfs.szOsFile = static_cast<int>(sizeof(PassingFile)) + real->szOsFile;
  vfs.zName = name;
  vfs.pAppData = this;
  vfs.xDelete = [](sqlite3_vfs* layer, const char* path, int sync_folder) {
    auto* const usual = layer_of(layer).real;
    return usual->xDelete(usual, path, sync_folder);
  };
  vfs.xAccess = [](sqlite3_vfs* layer, const char* path, int flags, int* out) {
    auto* const usual = layer_of(layer).real;
    return usual->xAccess(usual, path, flags, out);
  };
  vfs.xFullPathname = [](sqlite3_vfs* layer, const char* path, int size, char* out) {
    auto* const usual = layer_of(layer).real;
    return usual->xFullPathname(usual, path, size, out);
  };
}

void PassingVfs::begin() {
  if (sqlite3_vfs_register(&vfs, 1) != SQLITE_OK)
    throw std::runtime_error("the layer cannot be registered");
}

void PassingVfs::end() {
  sqlite3_vfs_unregister(&vfs);
  sqlite3_vfs_register(real, 1);
}

int open_passing(sqlite3_vfs* vfs, const char* name, sqlite3_file* file, int flags, int* out,
                 const sqlite3_io_methods& methods) {
  PassingVfs& layer = layer_of(vfs);
  PassingFile& one = passing(file);
  one.base.pMethods = nullptr;
  one.owner = layer.owner;
  one.own = nullptr;
  const int done = layer.real->xOpen(layer.real, name, one.real(), flags, out);
  if (done == SQLITE_OK) one.base.pMethods = &methods;
  return done;
}

}  // namespace isograsp::storage
