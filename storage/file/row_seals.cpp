// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/file/row_seals.hpp"

#include <algorithm>
#include <string_view>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "storage/file/database.hpp"
#include "storage/file/seal_chain.hpp"

namespace isograsp::storage {

using namespace sqlite_api;

namespace {

sqlite3* connection_of(soci::session& sql) {
  return static_cast<soci::sqlite3_session_backend*>(sql.get_backend())->conn_;
}

std::string value_text(sqlite3_value* value) {
  const auto* const text = reinterpret_cast<const char*>(sqlite3_value_text(value));
  return text == nullptr ? "" : text;
}

/// Of numbers without fractions, texts and bytes.
bool is_same(sqlite3_value* a, sqlite3_value* b) {
  return sqlite3_value_type(a) == sqlite3_value_type(b) && value_text(a) == value_text(b);
}

}  // namespace

/// SQLite tells of a row before it is changed, and allows no query then.
struct SealHook {
  using Get = int (*)(sqlite3*, int, sqlite3_value**);

  static RowKey key_of(sqlite3* connection, const SealedTable& table, Get get) {
    RowKey key;
    for (const int column : table.key) {
      sqlite3_value* value = nullptr;
      key.push_back(get(connection, column, &value) == SQLITE_OK ? value_text(value) : "");
    }
    return key;
  }

  /// A wrong password was counted, no more.
  static bool only_counts(sqlite3* connection, const SealedTable& table) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      if (!table.columns[i].sealed) continue;
      sqlite3_value* before = nullptr;
      sqlite3_value* after = nullptr;
      const int column = static_cast<int>(i);
      if (sqlite3_preupdate_old(connection, column, &before) != SQLITE_OK ||
          sqlite3_preupdate_new(connection, column, &after) != SQLITE_OK || !is_same(before, after))
        return false;
    }
    return true;
  }

  static void on_change(void* context, sqlite3* connection, int act, const char* file,
                        const char* name, sqlite3_int64, sqlite3_int64) noexcept {
    // What a trigger does this program has not done: it has none that changes rows.
    if (std::string_view(file) != "main" || sqlite3_preupdate_depth(connection) > 0) return;
    RowSeals& seals = *static_cast<RowSeals*>(context);
    const auto found = std::lower_bound(
        seals.tables_.begin(), seals.tables_.end(), std::string_view(name),
        [](const SealedTable& table, std::string_view wanted) { return table.name < wanted; });
    if (found == seals.tables_.end() || found->name != name) return;
    if (act == SQLITE_UPDATE && found->has_unsealed() && only_counts(connection, *found)) return;
    const auto table = static_cast<std::size_t>(found - seals.tables_.begin());
    if (act != SQLITE_INSERT) seals.touch(table, key_of(connection, *found, sqlite3_preupdate_old));
    if (act != SQLITE_DELETE) seals.touch(table, key_of(connection, *found, sqlite3_preupdate_new));
  }
};

RowSeals::RowSeals(soci::session& sql) : sql_(sql), tables_(sealed_tables(sql)) {
  readers_.resize(tables_.size());
  sqlite3_preupdate_hook(connection_of(sql_), SealHook::on_change, this);
}

RowSeals::~RowSeals() {
  sqlite3_preupdate_hook(connection_of(sql_), nullptr, nullptr);
}

const Secret* RowSeals::key() {
  const Secret* const now = source_ ? source_() : nullptr;
  if (now != nullptr && now->text() != last_key_.text()) last_key_ = now->copy();
  if (!last_key_.empty()) return &last_key_;
  int slots = 0;
  sql_ << "SELECT count(*) FROM key_slots", soci::into(slots);
  if (slots > 0)
    throw Refusal{refused("is protected, and nobody is logged in"_text,
                          "give --passphrase-file, or --user and --password-file"_text)};
  return nullptr;
}

void RowSeals::seal() {
  if (touched_.empty()) return;
  const Secret* const key_now = key();
  SealWriter writer(sql_, key_now);
  for (const auto& [index, row] : touched_) {
    auto& reader = readers_[index];
    if (!reader) reader = std::make_unique<RowReader>(sql_, tables_[index], RowReader::Which::one);
    reader->find(row);
    const bool present = reader->next();
    const ContentHash hash = present ? reader->hash(key_now) : ContentHash{};
    if (present) (void)reader->next();  // to its end: a statement that waits would hold a lock
    writer.add(tables_[index].name, key_text(row), present ? &hash : nullptr);
  }
  writer.finish();
  touched_.clear();
}

void RowSeals::seal_all() {
  const Secret* const key_now = key();
  SealWriter writer(sql_, key_now);
  for (const SealedTable& table : tables_) {
    RowReader reader(sql_, table, RowReader::Which::all);
    while (reader.next()) {
      const ContentHash hash = reader.hash(key_now);
      writer.add(table.name, key_text(reader.key()), &hash);
    }
  }
  writer.finish();
  touched_.clear();
}

}  // namespace isograsp::storage
