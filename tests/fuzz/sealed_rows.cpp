// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of a database that another program has given other values, or taken away: up to three.
#include <bit>
#include <cstdio>

#include "tests/fuzz/altered_database.hpp"

using namespace isograsp;

namespace {

/// A value of any kind, as SQL writes it.
std::string value_in(fuzz::Numbers& in) {
  switch (in.byte() % 5) {
    case 0: return "NULL";
    case 1: return std::to_string(static_cast<std::int64_t>(in.number<std::int8_t>()));
    case 2: return std::to_string(in.number<std::int64_t>());
    case 3: {
      char digits[32];
      std::snprintf(digits, sizeof digits, "%.17g",
                    std::bit_cast<double>(in.number<std::uint64_t>()));
      return digits;  // "nan" and "inf" are refused as names of columns
    }
    default: break;
  }
  const bool is_text = in.byte() % 2 == 0;
  std::string hex;
  for (const std::uint8_t byte : in.bytes(in.byte() % 64U)) {
    char two[3];
    std::snprintf(two, sizeof two, "%02x", byte);
    hex += two;
  }
  return is_text ? "CAST(x'" + hex + "' AS TEXT)" : "x'" + hex + "'";
}

void alter(soci::session& sql, fuzz::Numbers& in) {
  const auto tables = test::tables_of(sql);
  const std::string& table = tables[in.byte() % tables.size()];
  const auto columns = test::columns_of(sql, table);
  const std::string& column = columns[in.byte() % columns.size()];
  const std::string chosen = " WHERE rowid = (SELECT rowid FROM " + table +
                             " ORDER BY rowid LIMIT 1 OFFSET " + std::to_string(in.byte()) +
                             " % max(1, (SELECT count(*) FROM " + table + ")))";
  if (in.byte() % 8 == 0)
    sql << "DELETE FROM " + table + chosen;
  else
    sql << "UPDATE " + table + " SET " + column + " = " + value_in(in) + chosen;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::AlteredDatabase database;
  fuzz::Numbers in(data, size);
  database.prove([&](soci::session& sql) {
    constexpr int kMost = 3;
    for (int row = 0; row < kMost && !in.empty(); ++row) alter(sql, in);
  });
  return 0;
}
