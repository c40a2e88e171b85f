// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/file/row_seals.hpp"

#include <algorithm>
#include <bit>
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
    Touched touched{Touched::Act::added, "", 0};
    if (act != SQLITE_INSERT && table.person >= 0)
      touched.person =
          static_cast<std::int64_t>(value_of(connection, table.person, sqlite3_preupdate_old).bits);
    if (act == SQLITE_DELETE) {
      touched.act = Touched::Act::removed;
      if (is_compared_at_login(table.name))
        touched.said = said_by(connection, table, sqlite3_preupdate_old);
    }
    if (act == SQLITE_UPDATE) {
      touched.act = Touched::Act::changed;
      touched.said = said_by(connection, table, sqlite3_preupdate_old);
      // A wrong password was counted, no more.
      if (table.has_unsealed() && said_by(connection, table, sqlite3_preupdate_new) == touched.said)
        return;
    }
    for (RowKey& key : keys) seals.touched_.try_emplace({*index, std::move(key)}, touched);
  }
};

RowSeals::RowSeals(soci::session& sql) : sql_(sql), tables_(sealed_tables(sql)) {
  readers_.resize(tables_.size());
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

SealSummary RowSeals::summary_of(const SealAnchor& anchor, const Secret* key) {
  if (!anchor.summary.empty() && is_of_last_line(sql_, key, anchor))
    if (auto known = read_summary(anchor.summary)) return *std::move(known);
  Statement later(sql_, "SELECT id, of_table, of_row FROM main.row_seals WHERE id > ? ORDER BY id");
  later.bind(1, noted_lines_);
  while (later.next()) {
    noted_lines_ = later.number(0);
    noted_.note(later.bytes(1), later.bytes(2));
  }
  return noted_;
}

bool RowSeals::was_sealed(const SealSummary& before, std::size_t table, const RowKey& row) {
  // Of another kind of key (a place in a session, a name) nothing new is ever given.
  if (row.size() != 1) return false;
  const auto highest = before.highest.find(tables_[table].name);
  return highest != before.highest.end() && number_of_row(row[0]) <= highest->second &&
         !last_hash(table, row).empty();
}

RowHashes RowSeals::last_hashes(std::size_t table) {
  Statement lines(sql_, "SELECT of_row, hash FROM main.row_seals WHERE of_table = ? ORDER BY id");
  lines.bind_text(1, tables_[table].name);
  RowHashes last;
  while (lines.next()) {
    const std::string row(lines.bytes(0));
    if (lines.bytes(1).empty())
      last.erase(row);
    else
      last[row] = lines.bytes(1);
  }
  return last;
}

std::optional<RowHashes> RowSeals::hashes_now(std::size_t table, const Secret* key) {
  for (const auto& [index, row] : changed_by_triggers_)
    if (index == table) return std::nullopt;
  RowHashes hashes;
  RowReader reader(sql_, tables_[table], RowReader::Which::all);
  while (reader.next()) hashes[key_text(reader.key())] = bytes_of(reader.hash(key));
  return hashes;
}

std::optional<RowHashes> RowSeals::hashes_before(std::size_t table, const Secret* key) {
  auto hashes = hashes_now(table, key);
  if (!hashes) return std::nullopt;
  const SealedTable& of = tables_[table];
  for (auto one = touched_.lower_bound({table, {}});
       one != touched_.end() && one->first.first == table; ++one) {
    const auto& [place, touched] = *one;
    const std::string row = key_text(place.second);
    hashes->erase(row);
    if (touched.act == Touched::Act::added) continue;
    // Gone with the person who was erased, or the row belongs to nobody.
    const auto salt = of.person < 0 ? salt_of_nobody() : salt_of_person(sql_, touched.person);
    if (!salt) return std::nullopt;
    hashes->emplace(row, bytes_of(hash_of_row(key, of, touched.said + *salt)));
  }
  return hashes;
}

std::set<std::size_t> RowSeals::sound_before(const SealSummary& before, const Secret* key) {
  std::set<std::size_t> sound;
  for (std::size_t i = 0; i < tables_.size(); ++i) {
    const std::string& name = tables_[i].name;
    if (!is_compared_at_login(name)) continue;
    const auto first = touched_.lower_bound({i, {}});
    if (first == touched_.end() || first->first.first != i) continue;
    const auto hashes = hashes_before(i, key);
    if (!hashes) continue;
    const auto digest = before.digests.find(name);
    // Where nothing is protected no login will sum up what the lines say.
    const bool same = digest != before.digests.end()
                          ? digest->second == digest_of(key, name, *hashes)
                          : key == nullptr && last_hashes(i) == *hashes;
    if (same) sound.insert(i);
  }
  return sound;
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
  SealWriter writer(sql_, key_now);
  SealSummary summary = summary_of(writer.anchor(), key_now);
  const std::set<std::size_t> sound = sound_before(summary, key_now);
  const SealSummary before = summary;
  for (const auto& [place, touched] : touched_) {
    const auto& [index, row] = place;
    const SealedTable& table = tables_[index];
    if (!sound.contains(index)) summary.digests.erase(table.name);
    if (changed_by_triggers_.contains(place)) continue;
    RowReader& reader = reader_of(index);
    const bool present = reader.find(row);
    const ContentHash hash = present ? reader.hash(key_now) : ContentHash{};
    const std::string salt = present ? reader.salt() : "";
    reader.done();
    if (present && !sound.contains(index)) {
      if (touched.act == Touched::Act::changed &&
          last_hash(index, row) != bytes_of(hash_of_row(key_now, table, touched.said + salt)))
        continue;
      if (touched.act == Touched::Act::added && was_sealed(before, index, row)) continue;
    }
    writer.add(table.name, key_text(row), present ? &hash : nullptr);
    summary.note(table.name, key_text(row));
  }
  for (const std::size_t index : sound)
    summary.digests[tables_[index].name] =
        digest_of(key_now, tables_[index].name, hashes_now(index, key_now).value());
  writer.finish(summary);
  touched_.clear();
}

void RowSeals::seal_all() {
  const Secret* const key_now = key();
  SealWriter writer(sql_, key_now);
  SealSummary summary = summary_of(writer.anchor(), key_now);
  summary.digests.clear();
  for (std::size_t i = 0; i < tables_.size(); ++i) {
    const std::string& name = tables_[i].name;
    RowHashes hashes;
    RowReader reader(sql_, tables_[i], RowReader::Which::all);
    while (reader.next()) {
      const RowKey row = reader.key();
      if (changed_by_triggers_.contains({i, row})) continue;
      const ContentHash hash = reader.hash(key_now);
      writer.add(name, key_text(row), &hash);
      summary.note(name, key_text(row));
      if (is_compared_at_login(name)) hashes[key_text(row)] = bytes_of(hash);
    }
    if (is_compared_at_login(name)) summary.digests[name] = digest_of(key_now, name, hashes);
  }
  writer.finish(summary, true);
  touched_.clear();
}

void RowSeals::keep_summary(const ProvedSeals& proved) {
  auto anchor = read_anchor(sql_);
  const Secret* const key_now = key();
  if (!anchor || anchor->count != proved.lines || anchor->chain != proved.chain ||
      !is_of_last_line(sql_, key_now, *anchor))
    return;
  anchor->summary = written(proved.summary);
  anchor->proof = seal_proof(key_now, *anchor);
  write_anchor(sql_, *anchor);
}

void RowSeals::rolled_back() noexcept {
  end_transaction();
  noted_ = {};  // their lines may have been among them
  noted_lines_ = 0;
}

void RowSeals::end_transaction() noexcept {
  touched_.clear();
  changed_by_triggers_.clear();
}

}  // namespace isograsp::storage
