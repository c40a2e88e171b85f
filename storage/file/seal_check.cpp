// SPDX-License-Identifier: GPL-3.0-or-later
// Proves the lines of row_seals, and that every row is what its last line says.
#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

#include <soci/soci.h>

#include "storage/file/database.hpp"
#include "storage/file/row_seals.hpp"
#include "storage/file/seal_chain.hpp"

namespace isograsp::storage {

namespace {

/// Of one table; the others are counted.
constexpr std::size_t kMostProblems = 100;

/// What the last line of each row of a table says; empty: removed.
using LastSeals = std::unordered_map<std::string, std::string>;

class SealProof {
 public:
  /// Rows of the tables `wanted` are asked for later, of no others.
  SealProof(soci::session& sql, const Secret* key, const std::set<std::string>& wanted)
      : sql_(sql), key_(key) {
    for (const std::string& table : wanted) last_[table];
  }

  void prove_lines() {
    std::string before;
    std::int64_t expected = 1;
    bool keyed = false;
    read_lines([&](const SealLine& one) {
      lines_.summary.note(one.table, one.row);
      if (one.number != expected)
        add("row_seals", "row_seals: rows %1 to %2 are missing"_text(expected, one.number - 1));
      else if (key_ != nullptr && !keyed && chain_of(nullptr, before, one) == one.chain) {
        // Before a database is protected its lines have no key; they prove nothing any more.
      } else if (chain_of(key_, before, one) == one.chain) {
        keyed = true;
        if (const auto table = last_.find(one.table); table != last_.end())
          table->second[one.row] = one.hash;
      } else {
        add("row_seals", "row_seals: row %1 or one before it was changed"_text(one.number));
      }
      before = one.chain;
      expected = one.number + 1;
    });
    lines_.lines = expected - 1;
    lines_.chain = before;
    for (const auto& [table, last] : last_)
      if (is_compared_at_login(table))
        lines_.summary.digests[table] = digest_of(key_, table, sorted(last));
    prove_anchor();
  }

  void prove_rows(const SealedTable& table) {
    LastSeals& last = last_[table.name];
    RowReader reader(sql_, table, RowReader::Which::all);
    while (reader.next()) {
      const std::string row = key_text(reader.key());
      const auto found = last.find(row);
      if (found == last.end() || found->second.empty()) {
        add(table.name, "%1: row %2 was not written by isograsp"_text(table.name, row));
      } else {
        const ContentHash hash = reader.hash(key_);
        if (found->second != bytes_of(hash))
          add(table.name, "%1: row %2 is not what isograsp wrote"_text(table.name, row));
        found->second.clear();  // seen: a second row of this name is one too many
      }
    }
    std::vector<std::string> missing;
    for (const auto& [row, hash] : last)
      if (!hash.empty()) missing.push_back(row);
    std::sort(missing.begin(), missing.end());
    for (const std::string& row : missing)
      add(table.name, "%1: row %2 is missing"_text(table.name, row));
  }

  /// Of lines that prove.
  [[nodiscard]] const ProvedSeals& proved() const noexcept { return lines_; }

  [[nodiscard]] std::vector<SealProblem> problems() {
    for (const auto& [table, count] : counts_)
      if (count > kMostProblems)
        problems_.push_back(
            {table, "%1: %2 more of its rows are not sound"_text(table, count - kMostProblems)});
    return std::move(problems_);
  }

 private:
  void add(const std::string& table, Text problem) {
    if (++counts_[table] <= kMostProblems) problems_.push_back({table, std::move(problem)});
  }

  template <class Take>
  void read_lines(Take take) {
    Statement select(sql_,
                     "SELECT id, of_table, of_row, hash, chain FROM main.row_seals ORDER BY id");
    const auto text = [&](int column) { return std::string(select.bytes(column)); };
    while (select.next()) take({select.number(0), text(1), text(2), text(3), text(4)});
  }

  static RowHashes sorted(const LastSeals& last) {
    RowHashes all;
    for (const auto& [row, hash] : last)
      if (!hash.empty()) all.emplace(row, hash);
    return all;
  }

  /// @pre what a login compares was asked for
  [[nodiscard]] bool is_sum_of_lines(const SealAnchor& anchor) const {
    if (anchor.summary.empty()) return true;
    const auto said = read_summary(anchor.summary);
    const SealSummary& here = lines_.summary;
    return said && said->highest == here.highest &&
           std::ranges::all_of(said->digests, [&](const auto& one) {
             const auto found = here.digests.find(one.first);
             return found != here.digests.end() && found->second == one.second;
           });
  }

  void prove_anchor() {
    const std::string table = "row_seals_anchor";
    long long other = 0;
    sql_ << "SELECT coalesce(max(id), 0) FROM row_seals_anchor WHERE id <> 1", soci::into(other);
    if (other != 0) add(table, "row_seals_anchor: row %1 was not written by isograsp"_text(other));
    const auto anchor = read_anchor(sql_);
    if (!anchor)
      add(table, "row_seals_anchor: row 1 is missing"_text);
    else if (!proves(key_, *anchor))
      add(table, "row_seals_anchor: row 1 was changed"_text);
    else if (anchor->count != lines_.lines || anchor->chain != lines_.chain)
      add("row_seals",
          "row_seals: it ends with row %1, its anchor says %2"_text(lines_.lines, anchor->count));
    else if (!is_sum_of_lines(*anchor))
      add(table, "row_seals_anchor: row 1 was changed"_text);
  }

  soci::session& sql_;
  const Secret* key_;
  std::map<std::string, LastSeals, std::less<>> last_;
  ProvedSeals lines_;
  std::map<std::string, std::size_t, std::less<>> counts_;  ///< of problems, by table
  std::vector<SealProblem> problems_;
};

}  // namespace

Result<std::vector<SealProblem>> seal_problems(Database& database, const Secret* key,
                                               std::span<const std::string_view> only,
                                               std::optional<ProvedSeals>* proved) {
  std::vector<SealProblem> problems;
  const auto done = database.snapshot("checking the seals"_text, [&] {
    std::vector<SealedTable> tables = sealed_tables(database.sql());
    if (!only.empty())
      std::erase_if(tables, [only](const SealedTable& one) {
        return std::find(only.begin(), only.end(), one.name) == only.end();
      });
    std::set<std::string> names;
    for (const SealedTable& table : tables) names.insert(table.name);
    SealProof proof(database.sql(), key, names);
    proof.prove_lines();
    for (const SealedTable& table : tables) proof.prove_rows(table);
    problems = proof.problems();
    if (proved != nullptr && problems.empty()) *proved = proof.proved();
  });
  if (!done) return done.error();
  return problems;
}

Result<bool> are_as_sealed_in_sum(Database& database, const Secret* key) {
  bool same = false;
  const auto done = database.snapshot("checking the seals"_text, [&] {
    soci::session& sql = database.sql();
    const auto anchor = read_anchor(sql);
    if (!anchor || !is_of_last_line(sql, key, *anchor)) return;
    const auto summary = read_summary(anchor->summary);
    if (!summary) return;
    for (const SealedTable& table : sealed_tables(sql)) {
      if (!is_compared_at_login(table.name)) continue;
      RowHashes hashes;
      std::size_t rows = 0;
      RowReader reader(sql, table, RowReader::Which::all);
      for (; reader.next(); ++rows) hashes[key_text(reader.key())] = bytes_of(reader.hash(key));
      const auto digest = summary->digests.find(table.name);
      if (rows != hashes.size() || digest == summary->digests.end() ||
          digest->second != digest_of(key, table.name, hashes))
        return;
    }
    same = true;
  });
  if (!done) return done.error();
  return same;
}

}  // namespace isograsp::storage
