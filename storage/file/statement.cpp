// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/file/statement.hpp"

#include <bit>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

namespace isograsp::storage {

using namespace sqlite_api;

sqlite3* connection_of(soci::session& sql) {
  return static_cast<soci::sqlite3_session_backend*>(sql.get_backend())->conn_;
}

Statement::Statement(soci::session& sql, const std::string& query)
    : connection_(connection_of(sql)) {
  must(sqlite3_prepare_v2(connection_, query.data(), static_cast<int>(query.size()), &compiled_,
                          nullptr));
}

Statement::~Statement() {
  sqlite3_finalize(compiled_);
}

void Statement::must(int code) const {
  if (code != SQLITE_OK) throw soci::sqlite3_soci_error(sqlite3_errmsg(connection_), code);
}

void Statement::bind(int place, std::int64_t number) {
  must(sqlite3_bind_int64(compiled_, place, number));
}

void Statement::bind_text(int place, std::string_view text) {
  must(sqlite3_bind_text(compiled_, place, text.data(), static_cast<int>(text.size()),
                         SQLITE_TRANSIENT));
}

void Statement::bind_bytes(int place, std::string_view bytes) {
  must(bytes.empty() ? sqlite3_bind_null(compiled_, place)
                     : sqlite3_bind_blob(compiled_, place, bytes.data(),
                                         static_cast<int>(bytes.size()), SQLITE_TRANSIENT));
}

bool Statement::next() {
  if (sqlite3_step(compiled_) == SQLITE_ROW) return true;
  must(sqlite3_reset(compiled_));
  return false;
}

void Statement::run() {
  while (next()) {
  }
}

void Statement::reset() {
  sqlite3_reset(compiled_);
}

RowValue Statement::value(int column) const {
  RowValue value{sqlite3_column_type(compiled_, column), 0, {}};
  switch (value.kind) {
    case SQLITE_INTEGER: value.bits = static_cast<std::uint64_t>(number(column)); break;
    case SQLITE_FLOAT:
      value.bits = std::bit_cast<std::uint64_t>(sqlite3_column_double(compiled_, column));
      break;
    case SQLITE_NULL: break;
    default: value.bytes = bytes(column);
  }
  return value;
}

std::int64_t Statement::number(int column) const {
  return sqlite3_column_int64(compiled_, column);
}

std::string_view Statement::bytes(int column) const {
  // The value first, then its size: SQLite's order.
  const void* const data = sqlite3_column_blob(compiled_, column);
  const int size = sqlite3_column_bytes(compiled_, column);
  return {static_cast<const char*>(data), static_cast<std::size_t>(size)};
}

std::string pragma(soci::session& sql, const std::string& text) {
  Statement asked(sql, "PRAGMA " + text);
  std::string answer;
  while (asked.next()) answer = asked.bytes(0);
  return answer;
}

}  // namespace isograsp::storage
