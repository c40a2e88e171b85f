// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/storage/power_cut_vfs.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/storage/passing_vfs.hpp"

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
  PassingVfs passing;

  explicit Layer(PowerCutVfs* owner) : passing("power_cut", owner) {
    passing.vfs.xOpen = open;
    passing.vfs.xDelete = remove;
    passing.begin();
  }
  Layer(const Layer&) = delete;
  Layer& operator=(const Layer&) = delete;
  ~Layer() { passing.end(); }

  static PowerCutVfs& owner_of(sqlite3_vfs* vfs) {
    return *static_cast<PowerCutVfs*>(layer_of(vfs).owner);
  }
  static PowerCutVfs& owner_of(sqlite3_file* file) {
    return *static_cast<PowerCutVfs*>(storage::passing(file).owner);
  }
  /// nullptr: not of the folder
  static File* file_of(sqlite3_file* file) {
    return static_cast<File*>(storage::passing(file).own);
  }

  static int open(sqlite3_vfs* vfs, const char* name, sqlite3_file* file, int flags, int* out) {
    PowerCutVfs& owner = owner_of(vfs);
    const int done = open_passing(vfs, name, file, flags, out, methods());
    if (done != SQLITE_OK || name == nullptr ||
        std::filesystem::path(name).parent_path() != owner.folder_)
      return done;
    const auto [known, is_new] =
        owner.files_.try_emplace(std::filesystem::path(name).filename().string());
    storage::passing(file).own = &known->second;
    if (!is_new && !known->second.removed) return done;
    std::ifstream in(name, std::ios::binary);
    File& fresh = known->second = {};
    fresh.now.assign(std::istreambuf_iterator<char>(in), {});
    if (!fresh.now.empty()) fresh.sync();  // it was there before
    return done;
  }

  static int remove(sqlite3_vfs* vfs, const char* name, int sync_folder) {
    PowerCutVfs& owner = owner_of(vfs);
    auto* const real = layer_of(vfs).real;
    const int done = real->xDelete(real, name, sync_folder);
    const std::filesystem::path path(name);
    const auto known = owner.files_.find(path.filename().string());
    if (done == SQLITE_OK && known != owner.files_.end() && path.parent_path() == owner.folder_) {
      known->second.removed = true;
      if (sync_folder != 0) known->second.name_durable = false;
      owner.tick();
    }
    return done;
  }

  static int write(sqlite3_file* file, const void* bytes, int count, sqlite3_int64 offset) {
    File* const ours = file_of(file);
    if (ours != nullptr && owner_of(file).writes_left_ == 0) return SQLITE_FULL;
    if (ours != nullptr && owner_of(file).writes_left_ > 0) --owner_of(file).writes_left_;
    const int done = real_of(file)->pMethods->xWrite(real_of(file), bytes, count, offset);
    if (done == SQLITE_OK && ours != nullptr) {
      ours->write(static_cast<const char*>(bytes), static_cast<std::size_t>(count),
                  static_cast<std::size_t>(offset));
      owner_of(file).tick();
    }
    return done;
  }

  static int truncate(sqlite3_file* file, sqlite3_int64 size) {
    File* const ours = file_of(file);
    const int done = real_of(file)->pMethods->xTruncate(real_of(file), size);
    if (done == SQLITE_OK && ours != nullptr)
      ours->now.resize(static_cast<std::size_t>(size), '\0');
    return done;
  }

  static int sync(sqlite3_file* file, int flags) {
    File* const ours = file_of(file);
    if (ours != nullptr) owner_of(file).tick();  // just before
    const int done = real_of(file)->pMethods->xSync(real_of(file), flags);
    if (done == SQLITE_OK && ours != nullptr) {
      ours->sync();
      owner_of(file).tick();
    }
    return done;
  }

  static const sqlite3_io_methods& methods() {
    static const sqlite3_io_methods table = [] {
      sqlite3_io_methods m = passing_methods();
      m.xWrite = write;
      m.xTruncate = truncate;
      m.xSync = sync;
      m.xSectorSize = [](sqlite3_file*) { return static_cast<int>(kSector); };
      return m;
    }();
    return table;
  }
};

PowerCutVfs::PowerCutVfs(std::string folder, unsigned seed)
    : folder_(std::move(folder)), random_(seed), layer_(std::make_unique<Layer>(this)) {}

PowerCutVfs::~PowerCutVfs() = default;

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
