// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/file/row_seals.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <string_view>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "storage/file/database.hpp"
#include "storage/file/seal_chain.hpp"

namespace isograsp::storage {

using namespace sqlite_api;

namespace {

/// Of a change that SQLite tells of.
RowValue as_told(sqlite3_value* value) {
  RowValue one{sqlite3_value_type(value), 0, {}};
  switch (one.kind) {
    case SQLITE_NULL: break;
    case SQLITE_INTEGER: one.bits = static_cast<std::uint64_t>(sqlite3_value_int64(value)); break;
    case SQLITE_FLOAT: one.bits = std::bit_cast<std::uint64_t>(sqlite3_value_double(value)); break;
    default: {
      const void* const data = sqlite3_value_blob(value);
      const int size = sqlite3_value_bytes(value);
      one.bytes = {static_cast<const char*>(data), static_cast<std::size_t>(size)};
    }
  }
  return one;
}

/// 0: it is none.
std::int64_t number_in(std::string_view text) {
  std::int64_t number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  return read.ptr == text.data() + text.size() ? number : 0;
}

}  // namespace

/// SQLite tells of a row before it is changed, and allows no query then.
struct SealHook {
  using Get = int (*)(sqlite3*, int, sqlite3_value**);

  static RowValue value_of(sqlite3* connection, int column, Get get) {
    sqlite3_value* value = nullptr;
    if (get(connection, column, &value) != SQLITE_OK) return {};  // of no kind
    return as_told(value);
  }

  static RowKey key_of(sqlite3* connection, const SealedTable& table, Get get) {
    RowKey key;
    for (const int column : table.key) key.push_back(key_part(value_of(connection, column, get)));
    return key;
  }

  /// As RowReader reads it, without the salt.
  static std::string said_by(sqlite3* connection, const SealedTable& table, Get get) {
    std::string said;
    for (std::size_t i = 0; i < table.columns.size(); ++i)
      if (table.columns[i].sealed) add_value(said, value_of(connection, static_cast<int>(i), get));
    return said;
  }

  static void on_change(void* context, sqlite3* connection, int act, const char* file,
                        const char* name, sqlite3_int64, sqlite3_int64) noexcept {
    if (std::string_view(file) != "main") return;
    RowSeals& seals = *static_cast<RowSeals*>(context);
    const auto index = seals.index_of(name);
    if (!index) return;
    const SealedTable& table = seals.tables_[*index];
    std::vector<RowKey> keys;
    if (act != SQLITE_INSERT) keys.push_back(key_of(connection, table, sqlite3_preupdate_old));
    if (act != SQLITE_DELETE) keys.push_back(key_of(connection, table, sqlite3_preupdate_new));
    // What a trigger does this program has not done: it has none that changes rows.
    if (sqlite3_preupdate_depth(connection) > 0) {
      for (RowKey& key : keys) seals.changed_by_triggers_.emplace(*index, std::move(key));
      return;
    }
    using Touched = RowSeals::Touched;
    Touched touched{act == SQLITE_INSERT ? Touched::Act::added : Touched::Act::removed, ""};
    if (act == SQLITE_UPDATE) {
      touched = {Touched::Act::changed, said_by(connection, table, sqlite3_preupdate_old)};
      // A wrong password was counted, no more.
      if (table.has_unsealed() && said_by(connection, table, sqlite3_preupdate_new) == touched.said)
        return;
    }
    for (RowKey& key : keys) seals.touched_.try_emplace({*index, std::move(key)}, touched);
  }
};

RowSeals::RowSeals(soci::session& sql) : sql_(sql), tables_(sealed_tables(sql)) {
  readers_.resize(tables_.size());
  highest_.resize(tables_.size());
  sqlite3_preupdate_hook(connection_of(sql_), SealHook::on_change, this);
}

RowSeals::~RowSeals() {
  sqlite3_preupdate_hook(connection_of(sql_), nullptr, nullptr);
}

std::optional<std::size_t> RowSeals::index_of(std::string_view table) const {
  const auto found = std::lower_bound(
      tables_.begin(), tables_.end(), table,
      [](const SealedTable& one, std::string_view wanted) { return one.name < wanted; });
  if (found == tables_.end() || found->name != table) return std::nullopt;
  return static_cast<std::size_t>(found - tables_.begin());
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

RowReader& RowSeals::reader_of(std::size_t table) {
  auto& reader = readers_[table];
  if (!reader) reader = std::make_unique<RowReader>(sql_, tables_[table], RowReader::Which::one);
  return *reader;
}

std::string RowSeals::last_hash(std::size_t table, const RowKey& row) {
  // From the end on: what is changed was mostly written not long ago.
  if (!last_line_)
    last_line_ = std::make_unique<Statement>(
        sql_,
        "SELECT hash FROM main.row_seals WHERE of_table = ? AND of_row = ? ORDER BY id DESC "
        "LIMIT 1");
  last_line_->bind_text(1, tables_[table].name);
  last_line_->bind_text(2, key_text(row));
  std::string hash;
  if (last_line_->next()) hash = last_line_->bytes(0);
  last_line_->reset();
  return hash;
}

void RowSeals::catch_up() {
  if (!later_lines_)
    later_lines_ = std::make_unique<Statement>(
        sql_, "SELECT id, of_table, of_row FROM main.row_seals WHERE id > ? ORDER BY id");
  later_lines_->bind(1, noted_);
  while (later_lines_->next()) {
    noted_ = later_lines_->number(0);
    if (const auto table = index_of(later_lines_->bytes(1)))
      highest_[*table] = std::max(highest_[*table], number_in(later_lines_->bytes(2)));
  }
}

bool RowSeals::was_sealed(std::size_t table, const RowKey& row) {
  // Of another kind of key (a place in a session, a name) nothing new is ever given.
  return row.size() == 1 && number_in(row[0]) <= highest_[table] && !last_hash(table, row).empty();
}

bool RowSeals::is_as_sealed(std::string_view table, const RowKey& row) {
  const auto index = index_of(table);
  const Secret* const key_now = key();
  RowReader& reader = reader_of(index.value());
  const bool same = reader.find(row) && last_hash(*index, row) == bytes_of(reader.hash(key_now));
  reader.done();
  return same;
}

void RowSeals::seal() {
  if (touched_.empty()) return;
  const Secret* const key_now = key();
  catch_up();
  SealWriter writer(sql_, key_now);
  for (const auto& [place, touched] : touched_) {
    if (changed_by_triggers_.contains(place)) continue;
    const auto& [index, row] = place;
    const SealedTable& table = tables_[index];
    RowReader& reader = reader_of(index);
    const bool present = reader.find(row);
    const ContentHash hash = present ? reader.hash(key_now) : ContentHash{};
    const std::string salt = present ? reader.salt() : "";
    reader.done();
    if (present && touched.act == Touched::Act::changed &&
        last_hash(index, row) != bytes_of(hash_of_row(key_now, table, touched.said + salt)))
      continue;
    if (present && touched.act == Touched::Act::added && was_sealed(index, row)) continue;
    writer.add(table.name, key_text(row), present ? &hash : nullptr);
  }
  writer.finish();
  touched_.clear();
}

void RowSeals::seal_all() {
  const Secret* const key_now = key();
  SealWriter writer(sql_, key_now);
  for (std::size_t i = 0; i < tables_.size(); ++i) {
    RowReader reader(sql_, tables_[i], RowReader::Which::all);
    while (reader.next()) {
      const RowKey row = reader.key();
      if (changed_by_triggers_.contains({i, row})) continue;
      const ContentHash hash = reader.hash(key_now);
      writer.add(tables_[i].name, key_text(row), &hash);
    }
  }
  writer.finish(true);
  touched_.clear();
}

void RowSeals::rolled_back() noexcept {
  end_transaction();
  noted_ = 0;  // their lines may have been among them
}

void RowSeals::end_transaction() noexcept {
  touched_.clear();
  changed_by_triggers_.clear();
}

}  // namespace isograsp::storage
