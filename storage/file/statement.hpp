// SPDX-License-Identifier: GPL-3.0-or-later
// A statement whose values are bound and read as they are: SOCI would copy bytes through a BLOB of
// their own, one open of it a row. Inside storage/ only; throws as SOCI does.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace soci {
class session;
}
namespace sqlite_api {  // SOCI reads SQLite's header so
struct sqlite3;
struct sqlite3_stmt;
}  // namespace sqlite_api

namespace isograsp::storage {

[[nodiscard]] sqlite_api::sqlite3* connection_of(soci::session& sql);

/// One value as SQLite holds it.
struct RowValue {
  int kind = 0;            ///< SQLITE_INTEGER …
  std::uint64_t bits = 0;  ///< of a number
  std::string_view bytes;  ///< of a text or BLOB; until the next row
};

class Statement {
 public:
  /// The connection must outlive it.
  Statement(soci::session& sql, const std::string& query);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  // What is bound is copied; the first place is 1.
  void bind(int place, std::int64_t number);
  void bind_text(int place, std::string_view text);
  void bind_bytes(int place, std::string_view bytes);  ///< none: NULL
  /// False: there is no further row; the statement can run again.
  [[nodiscard]] bool next();
  void run();    ///< to its end
  void reset();  ///< ends early; a statement that waits would hold a lock

  [[nodiscard]] RowValue value(int column) const;
  [[nodiscard]] std::int64_t number(int column) const;
  [[nodiscard]] std::string_view bytes(int column) const;  ///< NULL: none

 private:
  void must(int code) const;
  sqlite_api::sqlite3* connection_;
  sqlite_api::sqlite3_stmt* compiled_ = nullptr;
};

/// What a PRAGMA answers, run to its end: SQLite answers first and writes then, so that one that is
/// left at its answer has not said whether it could.
std::string pragma(soci::session& sql, const std::string& text);

}  // namespace isograsp::storage
