// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/storage/power_cut_vfs.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <sqlite3.h>

namespace isograsp::storage {

namespace {

constexpr std::size_t kSector = 512;

}  // namespace

struct PowerCutVfs::File {
  std::string now;
  std::string durable;
  bool name_durable = false;  ///< the name survives a cut for certain
  bool removed = false;       ///< but perhaps not for certain
  std::map<std::size_t, std::vector<std::string>> versions;  ///< of sectors, since the last sync

  void write(const char* bytes, std::size_t count, std::size_t offset) {
    if (now.size() < offset + count) now.resize(offset + count, '\0');
    std::memcpy(now.data() + offset, bytes, count);
    for (std::size_t sector = offset / kSector; sector * kSector < offset + count; ++sector)
      versions[sector].push_back(now.substr(sector * kSector, kSector));
  }
  void sync() {
    durable = now;
    versions.clear();
    name_durable = true;
  }
};

struct PowerCutVfs::Layer {
  sqlite3_vfs vfs{};
  sqlite3_vfs* real = nullptr;
  PowerCutVfs* owner = nullptr;

  /// An open file: ours, with the usual layer's behind it.
  struct Handle {
    sqlite3_file base;
    PowerCutVfs* owner;
    File* file;  ///< nullptr: not of the folder
    sqlite3_file* real() { return reinterpret_cast<sqlite3_file*>(this + 1); }
  };
  static Handle& handle(sqlite3_file* file) { return *reinterpret_cast<Handle*>(file); }
  static sqlite3_file* real_of(sqlite3_file* file) { return handle(file).real(); }
  static Layer& layer(sqlite3_vfs* vfs) { return *static_cast<Layer*>(vfs->pAppData); }

  static int open(sqlite3_vfs* vfs, const char* name, sqlite3_file* file, int flags, int* out) {
    Layer& self = layer(vfs);
    Handle& one = handle(file);
    one.base.pMethods = nullptr;
    one.owner = self.owner;
    one.file = nullptr;
    const int done = self.real->xOpen(self.real, name, one.real(), flags, out);
    if (done != SQLITE_OK) return done;
    one.base.pMethods = &methods();
    if (name == nullptr || std::filesystem::path(name).parent_path() != self.owner->folder_)
      return done;
    const auto [known, is_new] =
        self.owner->files_.try_emplace(std::filesystem::path(name).filename().string());
    one.file = &known->second;
    if (!is_new && !known->second.removed) return done;
    std::ifstream in(name, std::ios::binary);
    File& fresh = known->second = {};
    fresh.now.assign(std::istreambuf_iterator<char>(in), {});
    if (!fresh.now.empty()) fresh.sync();  // it was there before
    return done;
  }

  static int remove(sqlite3_vfs* vfs, const char* name, int sync_folder) {
    Layer& self = layer(vfs);
    const int done = self.real->xDelete(self.real, name, sync_folder);
    const std::filesystem::path path(name);
    const auto known = self.owner->files_.find(path.filename().string());
    if (done == SQLITE_OK && known != self.owner->files_.end() &&
        path.parent_path() == self.owner->folder_) {
      known->second.removed = true;
      if (sync_folder != 0) known->second.name_durable = false;
      self.owner->tick();
    }
    return done;
  }

  static int write(sqlite3_file* file, const void* bytes, int count, sqlite3_int64 offset) {
    Handle& one = handle(file);
    if (one.file != nullptr && one.owner->writes_left_ == 0) return SQLITE_FULL;
    if (one.file != nullptr && one.owner->writes_left_ > 0) --one.owner->writes_left_;
    const int done = one.real()->pMethods->xWrite(one.real(), bytes, count, offset);
    if (done == SQLITE_OK && one.file != nullptr) {
      one.file->write(static_cast<const char*>(bytes), static_cast<std::size_t>(count),
                      static_cast<std::size_t>(offset));
      one.owner->tick();
    }
    return done;
  }

  static int truncate(sqlite3_file* file, sqlite3_int64 size) {
    Handle& one = handle(file);
    const int done = one.real()->pMethods->xTruncate(one.real(), size);
    if (done == SQLITE_OK && one.file != nullptr)
      one.file->now.resize(static_cast<std::size_t>(size), '\0');
    return done;
  }

  static int sync(sqlite3_file* file, int flags) {
    Handle& one = handle(file);
    if (one.file != nullptr) one.owner->tick();  // just before
    const int done = one.real()->pMethods->xSync(one.real(), flags);
    if (done == SQLITE_OK && one.file != nullptr) {
      one.file->sync();
      one.owner->tick();
    }
    return done;
  }

  static const sqlite3_io_methods& methods() {
    static const sqlite3_io_methods table = [] {
      sqlite3_io_methods m{};
      m.iVersion = 2;  // with shared memory, without memory mapping
      m.xClose = [](sqlite3_file* f) { return real_of(f)->pMethods->xClose(real_of(f)); };
      m.xRead = [](sqlite3_file* f, void* to, int count, sqlite3_int64 offset) {
        return real_of(f)->pMethods->xRead(real_of(f), to, count, offset);
      };
      m.xWrite = write;
      m.xTruncate = truncate;
      m.xSync = sync;
      m.xFileSize = [](sqlite3_file* f, sqlite3_int64* size) {
        return real_of(f)->pMethods->xFileSize(real_of(f), size);
      };
      m.xLock = [](sqlite3_file* f, int l) { return real_of(f)->pMethods->xLock(real_of(f), l); };
      m.xUnlock = [](sqlite3_file* f, int l) {
        return real_of(f)->pMethods->xUnlock(real_of(f), l);
      };
      m.xCheckReservedLock = [](sqlite3_file* f, int* out) {
        return real_of(f)->pMethods->xCheckReservedLock(real_of(f), out);
      };
      m.xFileControl = [](sqlite3_file* f, int op, void* argument) {
        return real_of(f)->pMethods->xFileControl(real_of(f), op, argument);
      };
      m.xSectorSize = [](sqlite3_file*) { return static_cast<int>(kSector); };
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
    }();
    return table;
  }
};

PowerCutVfs::PowerCutVfs(std::string folder, unsigned seed)
    : folder_(std::move(folder)), random_(seed), layer_(std::make_unique<Layer>()) {
  sqlite3_initialize();
  layer_->real = sqlite3_vfs_find(nullptr);
  layer_->owner = this;
  layer_->vfs = *layer_->real;  // the functions that need no file of ours
  layer_->vfs.szOsFile = static_cast<int>(sizeof(Layer::Handle)) + layer_->real->szOsFile;
  layer_->vfs.zName = "power_cut";
  layer_->vfs.pAppData = layer_.get();
  layer_->vfs.xOpen = Layer::open;
  layer_->vfs.xDelete = Layer::remove;
  layer_->vfs.xAccess = [](sqlite3_vfs* vfs, const char* name, int flags, int* out) {
    auto* const real = Layer::layer(vfs).real;
    return real->xAccess(real, name, flags, out);
  };
  layer_->vfs.xFullPathname = [](sqlite3_vfs* vfs, const char* name, int size, char* out) {
    auto* const real = Layer::layer(vfs).real;
    return real->xFullPathname(real, name, size, out);
  };
  if (sqlite3_vfs_register(&layer_->vfs, 1) != SQLITE_OK)
    throw std::runtime_error("the layer cannot be registered");
}

PowerCutVfs::~PowerCutVfs() {
  sqlite3_vfs_unregister(&layer_->vfs);
  sqlite3_vfs_register(layer_->real, 1);
}

void PowerCutVfs::confirm(std::size_t counter, int value) {
  if (confirmed_.size() <= counter) confirmed_.resize(counter + 1, 0);
  confirmed_[counter] = value;
}

void PowerCutVfs::tick() {
  if (every_ == 0 || random_() % every_ != 0) return;
  Cut cut;
  cut.confirmed = confirmed_;
  for (const auto& [name, file] : files_) {
    const bool there = file.removed ? file.name_durable && random_() % 2 == 0
                                    : file.name_durable || random_() % 2 == 0;
    if (there) cut.files[name] = after_cut(file);
  }
  cuts_.push_back(std::move(cut));
}

std::string PowerCutVfs::after_cut(const File& file) {
  std::string bytes = file.durable;
  if (random_() % 2 == 0) bytes.resize(file.now.size(), '\0');
  for (const auto& [sector, versions] : file.versions) {
    const std::size_t chosen = random_() % (versions.size() + 1);
    if (chosen == versions.size()) continue;  // none of them has reached the disk
    const std::string& content = versions[chosen];
    bytes.resize(std::max(bytes.size(), sector * kSector + content.size()), '\0');
    std::memcpy(bytes.data() + sector * kSector, content.data(), content.size());
  }
  return bytes;
}

void PowerCutVfs::Cut::restore(const std::string& folder) const {
  for (const auto& [name, bytes] : files)
    std::ofstream(std::filesystem::path(folder) / name, std::ios::binary) << bytes;
}

}  // namespace isograsp::storage
