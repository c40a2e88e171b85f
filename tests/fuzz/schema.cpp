// SPDX-License-Identifier: GPL-3.0-or-later
// The schema of a database as somebody has rewritten it: a table, index or trigger that is changed,
// or one more.
#include <array>

#include "tests/fuzz/altered_database.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::AlteredDatabase database;
  fuzz::Numbers in(data, size);
  const int act = in.byte() % 3;
  const int which = in.byte();
  const int at = in.number<std::uint16_t>();
  const int length = in.byte();
  const auto rest = in.bytes(size);
  const std::string text(rest.begin(), rest.end());
  database.prove([&](soci::session& sql) {
    if (act == 2) {
      constexpr std::array kTypes{"table", "index", "trigger", "view"};
      const std::string type = kTypes[static_cast<std::size_t>(which) % kTypes.size()];
      const int page = at % 8;
      sql << "INSERT INTO sqlite_schema (type, name, tbl_name, rootpage, sql) "
             "VALUES (:type, 'one_more', 'patients', :page, :text)",
          soci::use(type), soci::use(page), soci::use(text);
      return;
    }
    // All of the statement, or a part of it.
    const std::string chosen =
        " WHERE rowid = (SELECT rowid FROM sqlite_schema WHERE sql IS NOT NULL ORDER BY rowid "
        "LIMIT 1 "
        "OFFSET " +
        std::to_string(which) + " % (SELECT count(*) FROM sqlite_schema WHERE sql IS NOT NULL))";
    const std::string place = std::to_string(at) + " % (length(sql) + 1)";
    const std::string sql_text = act == 0 ? ":text"
                                          : "substr(sql, 1, " + place +
                                                ") || :text || substr(sql, 1 + " + place + " + " +
                                                std::to_string(length % 16) + ")";
    sql << "UPDATE sqlite_schema SET sql = " + sql_text + chosen, soci::use(text);
  });
  return 0;
}
