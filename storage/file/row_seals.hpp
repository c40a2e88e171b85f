// SPDX-License-Identifier: GPL-3.0-or-later
// The seals of rows: for every row that this program writes, changes or removes, a line in
// row_seals with the hash of what the row says from then on, in the same transaction, each line
// chained to the one before. Made with a key where the database is protected. Entries of the audit
// log hold how far the lines had come. What that proves: docs/storage.md. Inside storage/ only.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/result.hpp"
#include "storage/crypto/content_hash.hpp"
#include "storage/crypto/secret.hpp"
#include "storage/file/row_hash.hpp"
#include "storage/file/seal_summary.hpp"

namespace isograsp::storage {

class Database;

/// How far the lines have come.
struct SealHead {
  std::int64_t count = 0;
  std::string chain;  ///< of line `count`, as hexadecimal digits; empty: there is none
};
[[nodiscard]] SealHead seal_head(soci::session& sql);

struct SealAnchor;
struct ProvedSeals;

/// A row gets a seal only if this program made it where there was none, or changed what its last
/// seal says: what another hand has changed or removed stays without, whatever is done to it here.
class RowSeals {
 public:
  /// From now on it notes which rows of `main` this connection touches.
  explicit RowSeals(soci::session& sql);
  ~RowSeals();
  RowSeals(const RowSeals&) = delete;
  RowSeals& operator=(const RowSeals&) = delete;

  /// Whose key: asked when rows are sealed. Without an answer the last one is used, so that a
  /// recording can be ended whoever has logged out meanwhile; without any, a protected database
  /// refuses.
  using KeySource = std::function<const Secret*()>;
  void key_from(KeySource source) { source_ = std::move(source); }

  // Inside a transaction; throw as SOCI does.
  void seal();      ///< the rows that were touched
  void seal_all();  ///< every row of the file, but what triggers changed
  /// Into the anchor, if the lines have come no further than where that was proved.
  void keep_summary(const ProvedSeals& proved);
  void committed() noexcept { end_transaction(); }
  void rolled_back() noexcept;
  /// Of a row that this transaction has not touched. False too: there is none.
  [[nodiscard]] bool is_as_sealed(std::string_view table, const RowKey& row);

 private:
  friend struct SealHook;
  using Row = std::pair<std::size_t, RowKey>;  ///< table, key
  /// What was done to a row first, since seal() was called last.
  struct Touched {
    enum class Act { added, changed, removed } act = Act::added;
    std::string said;  ///< changed, or removed where a login compares: before; without the salt
    std::int64_t person = 0;  ///< to whom it belonged; 0: nobody
  };
  void end_transaction() noexcept;
  [[nodiscard]] const Secret* key();
  [[nodiscard]] std::optional<std::size_t> index_of(std::string_view table) const;
  [[nodiscard]] RowReader& reader_of(std::size_t table);
  /// Empty: the row was removed, or never sealed.
  [[nodiscard]] std::string last_hash(std::size_t table, const RowKey& row);
  /// What the lines of before say: of their anchor, or of the lines themselves, then without
  /// digests.
  [[nodiscard]] SealSummary summary_of(const SealAnchor& anchor, const Secret* key);
  /// By a line of before, of a row that stands there no more. SQLite gives the number of the last
  /// row of a table anew when that is gone.
  [[nodiscard]] bool was_sealed(const SealSummary& before, std::size_t table, const RowKey& row);
  /// As the rows of a table are now. Nothing: some of them triggers have changed.
  [[nodiscard]] std::optional<RowHashes> hashes_now(std::size_t table, const Secret* key);
  /// As they were before they were touched. Nothing: that cannot be told.
  [[nodiscard]] std::optional<RowHashes> hashes_before(std::size_t table, const Secret* key);
  /// Of the tables that were touched: every row of them was what its last seal says.
  [[nodiscard]] std::set<std::size_t> sound_before(const SealSummary& before, const Secret* key);
  [[nodiscard]] RowHashes last_hashes(std::size_t table);

  soci::session& sql_;
  std::vector<SealedTable> tables_;
  std::vector<std::unique_ptr<RowReader>> readers_;  ///< of a table, once it is needed
  std::unique_ptr<Statement> last_line_;             ///< once it is needed
  SealSummary noted_;             ///< of lines that were read, where their anchor has none
  std::int64_t noted_lines_ = 0;  ///< how many
  std::map<Row, Touched> touched_;
  std::set<Row> changed_by_triggers_;  ///< in this transaction
  KeySource source_;
  Secret last_key_;
};

struct SealProblem {
  std::string table;
  Text what;  ///< names the row and its table
};
/// What all lines say in sum, where they and the rows that were asked for prove.
struct ProvedSeals {
  std::int64_t lines = 0;
  std::string chain;  ///< of the last one, 32 bytes
  SealSummary summary;
};
/// What of the file is not what this program wrote. `only`: of these tables alone, and of the lines
/// themselves; empty: of all. `proved`: set if nothing is found. @pre no transaction is open, a
/// protected database has its key
[[nodiscard]] Result<std::vector<SealProblem>> seal_problems(
    Database& database, const Secret* key, std::span<const std::string_view> only = {},
    std::optional<ProvedSeals>* proved = nullptr);
/// The same of what a login compares, without the lines: their anchor proves, they end where it
/// says, and in sum it says what the rows are. False too: it does not say. Who is told so asks
/// seal_problems().
[[nodiscard]] Result<bool> are_as_sealed_in_sum(Database& database, const Secret* key);

}  // namespace isograsp::storage
