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

namespace isograsp::storage {

class Database;

/// How far the lines have come.
struct SealHead {
  std::int64_t count = 0;
  std::string chain;  ///< of line `count`, as hexadecimal digits; empty: there is none
};
[[nodiscard]] SealHead seal_head(soci::session& sql);

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
    std::string said;  ///< changed: before; without the salt
  };
  void end_transaction() noexcept;
  [[nodiscard]] const Secret* key();
  [[nodiscard]] std::optional<std::size_t> index_of(std::string_view table) const;
  [[nodiscard]] RowReader& reader_of(std::size_t table);
  /// Empty: the row was removed, or never sealed.
  [[nodiscard]] std::string last_hash(std::size_t table, const RowKey& row);
  /// Notes the lines that were added since.
  void catch_up();
  /// By a line that catch_up() has noted, of a row that stands there no more. SQLite gives the
  /// number of the last row of a table anew when that is gone.
  [[nodiscard]] bool was_sealed(std::size_t table, const RowKey& row);

  soci::session& sql_;
  std::vector<SealedTable> tables_;
  std::vector<std::unique_ptr<RowReader>> readers_;  ///< of a table, once it is needed
  std::unique_ptr<Statement> last_line_;             ///< once it is needed
  std::unique_ptr<Statement> later_lines_;           ///< the same
  std::vector<std::int64_t> highest_;  ///< number of a row that was ever sealed, by table
  std::int64_t noted_ = 0;             ///< lines
  std::map<Row, Touched> touched_;
  std::set<Row> changed_by_triggers_;  ///< in this transaction
  KeySource source_;
  Secret last_key_;
};

struct SealProblem {
  std::string table;
  Text what;  ///< names the row and its table
};
/// What of the file is not what this program wrote. `only`: of these tables alone, and of the lines
/// themselves; empty: of all. @pre no transaction is open, a protected database has its key
[[nodiscard]] Result<std::vector<SealProblem>> seal_problems(
    Database& database, const Secret* key, std::span<const std::string_view> only = {});

}  // namespace isograsp::storage
