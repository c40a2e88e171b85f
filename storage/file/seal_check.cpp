// SPDX-License-Identifier: GPL-3.0-or-later
// Proves the lines of row_seals, and that every row is what its last line says.
#include <algorithm>
#include <cstring>
#include <unordered_map>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "storage/file/database.hpp"
#include "storage/file/row_seals.hpp"
#include "storage/file/seal_chain.hpp"

namespace isograsp::storage {

using namespace sqlite_api;

namespace {

/// More of one kind say no more.
constexpr std::size_t kMostProblems = 1000;

/// What the last line of each row says; empty: removed.
using LastSeals = std::unordered_map<std::string, std::string>;

class SealProof {
 public:
  SealProof(soci::session& sql, const Secret* key) : sql_(sql), key_(key) {}

  void prove_lines() {
    SealLine line;
    std::string before;
    std::int64_t expected = 1;
    bool keyed = false;
    read_lines([&](const SealLine& one) {
      if (one.number != expected)
        add("row_seals: rows %1 to %2 are missing"_text(expected, one.number - 1));
      else if (chain_of(key_, before, one) == one.chain) {
        keyed = true;
        last_[name_of(one.table, one.row)] = one.hash;
      } else if (key_ == nullptr || keyed || chain_of(nullptr, before, one) != one.chain) {
        // Before a database is protected its lines have no key; they prove nothing any more.
        add("row_seals: row %1 or one before it was changed"_text(one.number));
      }
      before = one.chain;
      expected = one.number + 1;
    });
    prove_anchor(expected - 1, before);
  }

  void prove_rows(const SealedTable& table) {
    RowReader reader(sql_, table, RowReader::Which::all);
    while (reader.next()) {
      const std::string row = key_text(reader.key());
      const auto found = last_.find(name_of(table.name, row));
      if (found == last_.end() || found->second.empty()) {
        add("%1: row %2 was not written by isograsp"_text(table.name, row));
      } else {
        const ContentHash hash = reader.hash(key_);
        if (found->second != bytes_of(hash))
          add("%1: row %2 is not what isograsp wrote"_text(table.name, row));
        found->second.clear();  // seen: a second row of this name is one too many
      }
    }
    for (const auto& [name, hash] : last_)
      if (!hash.empty() && name.starts_with(table.name + "\n"))
        missing_.push_back(name.substr(table.name.size() + 1));
    std::sort(missing_.begin(), missing_.end());
    for (const std::string& row : missing_) add("%1: row %2 is missing"_text(table.name, row));
    missing_.clear();
  }

  [[nodiscard]] std::vector<Text> problems() { return std::move(problems_); }

 private:
  static std::string name_of(const std::string& table, const std::string& row) {
    return table + "\n" + row;
  }

  void add(Text problem) {
    if (problems_.size() < kMostProblems) problems_.push_back(std::move(problem));
  }

  template <class Take>
  void read_lines(Take take) {
    sqlite3* const connection =
        static_cast<soci::sqlite3_session_backend*>(sql_.get_backend())->conn_;
    sqlite3_stmt* select = nullptr;
    const int prepared = sqlite3_prepare_v2(
        connection, "SELECT id, of_table, of_row, hash, chain FROM main.row_seals ORDER BY id", -1,
        &select, nullptr);
    const std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> owned(select, sqlite3_finalize);
    const auto must = [&](int code) {
      if (code != SQLITE_OK) throw soci::sqlite3_soci_error(sqlite3_errmsg(connection), code);
    };
    must(prepared);
    const auto bytes = [&](int column) {
      const void* const data = sqlite3_column_blob(select, column);
      return std::string(static_cast<const char*>(data),
                         static_cast<std::size_t>(sqlite3_column_bytes(select, column)));
    };
    while (sqlite3_step(select) == SQLITE_ROW)
      take({sqlite3_column_int64(select, 0), bytes(1), bytes(2), bytes(3), bytes(4)});
    must(sqlite3_reset(select));
  }

  void prove_anchor(std::int64_t last, const std::string& chain) {
    soci::blob noted(sql_);
    soci::blob proof(sql_);
    long long count = 0;
    long long other = 0;
    sql_ << "SELECT coalesce(max(id), 0) FROM row_seals_anchor WHERE id <> 1", soci::into(other);
    if (other != 0) add("row_seals_anchor: row %1 was not written by isograsp"_text(other));
    sql_ << "SELECT count, chain, proof FROM row_seals_anchor WHERE id = 1", soci::into(count),
        soci::into(noted), soci::into(proof);
    if (!sql_.got_data()) {
      add("row_seals_anchor: row 1 is missing"_text);
      return;
    }
    const auto text = [](soci::blob& blob) {
      std::string bytes(blob.get_len(), '\0');
      if (!bytes.empty()) blob.read(0, bytes.data(), bytes.size());
      return bytes;
    };
    if (text(proof) != seal_proof(key_, count, text(noted)))
      add("row_seals_anchor: row 1 was changed"_text);
    else if (count != last || text(noted) != chain)
      add("row_seals: it ends with row %1, its anchor says %2"_text(last, count));
  }

  soci::session& sql_;
  const Secret* key_;
  LastSeals last_;
  std::vector<std::string> missing_;
  std::vector<Text> problems_;
};

}  // namespace

Result<std::vector<Text>> seal_problems(Database& database, const Secret* key,
                                        std::span<const std::string_view> only) {
  std::vector<Text> problems;
  const auto done = database.snapshot("checking the seals"_text, [&] {
    SealProof proof(database.sql(), key);
    proof.prove_lines();
    for (const SealedTable& table : sealed_tables(database.sql()))
      if (only.empty() || std::find(only.begin(), only.end(), table.name) != only.end())
        proof.prove_rows(table);
    problems = proof.problems();
  });
  if (!done) return done.error();
  return problems;
}

}  // namespace isograsp::storage
