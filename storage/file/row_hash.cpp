// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/file/row_hash.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

namespace isograsp::storage {

namespace {

using namespace sqlite_api;

constexpr std::array<std::string_view, 7> kWithoutSeals{
    "audit_anchor",  "audit_log",        "login_failures",  "row_seals",
    "signal_blocks", "row_seals_anchor", "emergency_origin"};
/// A wrong password or PIN changes the counters before anybody has a key. Of packed signals the
/// hash of their values stands in the row and is compared whenever they are read.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kNotSealed{
    {{"users", "pin_failed_count"},
     {"key_slots", "failed_count"},
     {"key_slots", "retry_at_unix_s"},
     {"signal_packs", "float64_shuffled_zstd"}}};

/// A reference of one table to another: pairs of columns.
struct Reference {
  std::string table;
  std::vector<std::pair<std::string, std::string>> columns;  ///< from, to
};

/// Of every table, the shortest first.
using ForeignKeys = std::map<std::string, std::vector<Reference>>;

/// One query for all of them: this is done whenever a file is opened.
ForeignKeys foreign_keys_of(soci::session& sql) {
  std::map<std::string, std::map<int, Reference>> numbered;
  std::string table;
  int id = 0;
  std::string to_table;
  std::string from;
  std::string to;
  soci::statement select =
      (sql.prepare << "SELECT m.name, f.id, f.\"table\", f.\"from\", f.\"to\" FROM "
                      "main.sqlite_schema m, pragma_foreign_key_list(m.name, 'main') f WHERE "
                      "m.type = 'table' ORDER BY m.name, f.id, f.seq",
       soci::into(table), soci::into(id), soci::into(to_table), soci::into(from), soci::into(to));
  select.execute();
  while (select.fetch()) {
    Reference& one = numbered[table][id];
    one.table = to_table;
    one.columns.emplace_back(from, to);
  }
  ForeignKeys all;
  for (auto& [name, of_table] : numbered) {
    std::vector<Reference>& shortest_first = all[name];
    for (auto& [number, one] : of_table) shortest_first.push_back(std::move(one));
    // One that is optional (the trial of an event) has more columns than the one that is not.
    std::stable_sort(
        shortest_first.begin(), shortest_first.end(),
        [](const auto& a, const auto& b) { return a.columns.size() < b.columns.size(); });
  }
  return all;
}

/// Nothing: rows of the table belong to nobody.
std::optional<std::string> salt_of(const ForeignKeys& references, const std::string& table,
                                   const std::string& row) {
  if (table == "patients") return row + ".salt";
  const auto of_table = references.find(table);
  if (of_table == references.end()) return std::nullopt;
  for (const Reference& reference : of_table->second) {
    if (reference.table == table) continue;
    const std::string other = row + "x";
    const auto salt = salt_of(references, reference.table, other);
    if (!salt) continue;
    std::string where;
    for (const auto& [from, to] : reference.columns)
      where += (where.empty() ? "" : " AND ") + other + "." + to + " = " + row + "." + from;
    return "(SELECT " + *salt + " FROM main." + reference.table + " " + other + " WHERE " + where +
           ")";
  }
  return std::nullopt;
}

}  // namespace

std::string key_text(const RowKey& key) {
  std::string text;
  for (std::size_t i = 0; i < key.size(); ++i) text += (i == 0 ? "" : ",") + key[i];
  return text;
}

bool SealedTable::has_unsealed() const noexcept {
  return std::any_of(columns.begin(), columns.end(), [](const Column& one) { return !one.sealed; });
}

std::vector<SealedTable> sealed_tables(soci::session& sql) {
  std::vector<SealedTable> all;
  std::string table;
  std::string column;
  int in_key = 0;
  std::map<int, int> key;  // place in the key: column
  const auto finish = [&] {
    if (!all.empty())
      for (const auto& [place, index] : key) all.back().key.push_back(index);
    key.clear();
  };
  {
    soci::statement select =
        (sql.prepare << "SELECT m.name, c.name, c.pk FROM main.sqlite_schema m, "
                        "pragma_table_info(m.name, 'main') c WHERE m.type = 'table' AND m.name NOT "
                        "LIKE 'sqlite!_%' ESCAPE '!' ORDER BY m.name, c.cid",
         soci::into(table), soci::into(column), soci::into(in_key));
    select.execute();
    while (select.fetch()) {
      if (std::find(kWithoutSeals.begin(), kWithoutSeals.end(), table) != kWithoutSeals.end())
        continue;
      if (all.empty() || all.back().name != table) {
        finish();
        all.push_back({table, {}, {}, -1, {}});
      }
      const bool left_out = std::any_of(kNotSealed.begin(), kNotSealed.end(), [&](const auto& one) {
        return one.first == table && one.second == column;
      });
      if (in_key > 0) key[in_key] = static_cast<int>(all.back().columns.size());
      if (column == "patient_id") all.back().person = static_cast<int>(all.back().columns.size());
      all.back().columns.push_back({column, !left_out});
    }
    finish();
  }
  const ForeignKeys references = foreign_keys_of(sql);
  for (SealedTable& one : all) one.salt = salt_of(references, one.name, "t").value_or("NULL");
  return all;
}

void add_value(std::string& said, const RowValue& value) {
  const auto add_number = [&said](std::uint64_t number) {
    said.append(reinterpret_cast<const char*>(&number), sizeof number);
  };
  add_number(static_cast<std::uint64_t>(value.kind));
  switch (value.kind) {
    case SQLITE_NULL: break;
    case SQLITE_INTEGER:
    case SQLITE_FLOAT: add_number(value.bits); break;
    default: add_number(value.bytes.size()); said += value.bytes;
  }
}

ContentHash hash_of_row(const Secret* key, const SealedTable& table, std::string_view said) {
  ContentHasher whole(key != nullptr ? key->text() : std::string_view());
  whole.add_text("IsoGrasp row 1");
  whole.add_text(table.name);
  whole.add(said);
  return whole.hash();
}

std::optional<std::string> salt_of_person(soci::session& sql, std::int64_t person) {
  Statement select(sql, "SELECT salt FROM main.patients WHERE id = ?");
  select.bind(1, person);
  if (!select.next()) return std::nullopt;
  std::string salt;
  add_value(salt, select.value(0));
  select.reset();
  return salt;
}

std::string salt_of_nobody() {
  std::string salt;
  add_value(salt, {SQLITE_NULL, 0, {}});
  return salt;
}

std::string key_part(const RowValue& value) {
  // A number that was read as text would be one for SQLite from then on.
  if (value.kind == SQLITE_INTEGER) return std::to_string(static_cast<std::int64_t>(value.bits));
  return std::string(value.bytes);
}

RowReader::RowReader(soci::session& sql, const SealedTable& table, Which which) : table_(table) {
  std::string names;
  for (const auto& column : table.columns)
    names += (column.sealed ? "t." + column.name : std::string("NULL")) + ", ";
  std::string keys;
  for (const int index : table.key)
    keys += (keys.empty() ? " WHERE t." : " AND t.") +
            table.columns[static_cast<std::size_t>(index)].name + " = ?";
  statement_ =
      std::make_unique<Statement>(sql, "SELECT " + names + table.salt + " FROM main." + table.name +
                                           " t" + (which == Which::one ? keys : ""));
}

bool RowReader::find(const RowKey& key) {
  statement_->reset();
  for (std::size_t i = 0; i < key.size(); ++i)
    statement_->bind_text(static_cast<int>(i + 1), key[i]);
  return next();
}

bool RowReader::next() {
  if (!statement_->next()) return false;
  said_.clear();
  for (std::size_t i = 0; i < table_.columns.size(); ++i)
    if (table_.columns[i].sealed) add_value(said_, statement_->value(static_cast<int>(i)));
  salt_.clear();
  add_value(salt_, statement_->value(static_cast<int>(table_.columns.size())));
  return true;
}

RowKey RowReader::key() const {
  RowKey key;
  for (const int index : table_.key) key.push_back(key_part(statement_->value(index)));
  return key;
}

ContentHash RowReader::hash(const Secret* key) const {
  return hash_of_row(key, table_, said_ + salt_);
}

}  // namespace isograsp::storage
