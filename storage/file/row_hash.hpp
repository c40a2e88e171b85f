// SPDX-License-Identifier: GPL-3.0-or-later
// What a row says, as a hash. Which tables there are, what names a row and to which person it
// belongs is read from the schema of the file: a new table or column is covered without a word
// here. Inside storage/ only.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "storage/crypto/content_hash.hpp"
#include "storage/crypto/secret.hpp"
#include "storage/file/statement.hpp"

namespace isograsp::storage {

/// The values of the primary key, as text.
using RowKey = std::vector<std::string>;
/// As it stands in row_seals.of_row and in messages.
[[nodiscard]] std::string key_text(const RowKey& key);

struct SealedTable {
  struct Column {
    std::string name;
    bool sealed = true;  ///< false: docs/file_formats.md says why
  };
  std::string name;
  std::vector<Column> columns;
  std::vector<int> key;  ///< columns of the primary key, in its order
  int person = -1;       ///< column patient_id; -1: it has none
  /// SQL: the random number of the person to whom row `t` belongs. Who does not have it cannot
  /// guess a row from its hash; it goes with the person.
  std::string salt;
  [[nodiscard]] bool has_unsealed() const noexcept;
};
/// Of `main`, by name. Left out is what has a proof of its own (audit log, seals, seconds of
/// signals), and wrong passwords, which are counted before there is a key. Throws as SOCI does.
[[nodiscard]] std::vector<SealedTable> sealed_tables(soci::session& sql);

/// What a row says: its sealed values in the order of their columns, kind and bits, one after the
/// other.
void add_value(std::string& said, const RowValue& value);
/// `said`: what the row says, and at its end the salt. Nothing as key: everybody can make it.
[[nodiscard]] ContentHash hash_of_row(const Secret* key, const SealedTable& table,
                                      std::string_view said);
/// The salt of a person as it is said; nothing: there is nobody of this number.
[[nodiscard]] std::optional<std::string> salt_of_person(soci::session& sql, std::int64_t person);
[[nodiscard]] std::string salt_of_nobody();  ///< of rows that belong to no person
/// As it stands in a RowKey.
[[nodiscard]] std::string key_part(const RowValue& value);

/// Rows of one table; throws as SOCI does.
class RowReader {
 public:
  enum class Which { one, all };
  /// Both must outlive the reader.
  RowReader(soci::session& sql, const SealedTable& table, Which which);
  /// False: there is none. To be ended by done(). @pre Which::one
  [[nodiscard]] bool find(const RowKey& key);
  void done() { statement_->reset(); }
  [[nodiscard]] bool next();
  [[nodiscard]] RowKey key() const;
  [[nodiscard]] const std::string& salt() const noexcept { return salt_; }  ///< as it is said
  [[nodiscard]] ContentHash hash(const Secret* key) const;

 private:
  const SealedTable& table_;
  std::unique_ptr<Statement> statement_;
  std::string said_;
  std::string salt_;
};

}  // namespace isograsp::storage
