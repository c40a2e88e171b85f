// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/access/open_store.hpp"

#include <unistd.h>

#include "storage/access/guarded_store.hpp"

namespace isograsp::storage {

Result<std::unique_ptr<SessionStore>> open_store(const std::string& path, OpenMode how) {
  auto database = Database::open(path, how);
  if (!database) return database.error();
  auto state = login_at(*database, how != OpenMode::read_only);
  if (!state) return state.error();
  auto store = std::make_unique<SqliteStore>(*std::move(database));
  if (how != OpenMode::read_only)
    if (const auto repaired = store->repair(); !repaired) return repaired.error();
  return std::unique_ptr<SessionStore>(
      std::make_unique<GuardedStore>(std::move(store), *std::move(state)));
}

Result<std::unique_ptr<SessionStore>> open_store_to_read(const std::string& path) {
  auto store = open_store(path, OpenMode::existing);
  if (store || access(path.c_str(), R_OK) != 0) return store;
  auto reader = open_store(path, OpenMode::read_only);
  return reader ? std::move(reader) : std::move(store);
}

}  // namespace isograsp::storage
