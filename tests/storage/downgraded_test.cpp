// SPDX-License-Identifier: GPL-3.0-or-later
// Somebody makes a file look as if an older program had made it, so that a migration would give
// what they have changed new seals: docs/risk.md, "Threats to the records".
#include "storage/care/migration.hpp"
#include "storage/file/schema_access.hpp"
#include "tests/storage/clinic_under_attack.hpp"
#include "tests/support/every.hpp"

namespace isograsp::storage::downgraded_test {
namespace {

const std::string kForged = "UPDATE measures SET value = 0.5 WHERE id = 1";

struct Downgraded : ClinicUnderAttack {
  Downgraded() {
    const auto store = opened(path);
    must(store->set_profile(1, {Side::left, {}, "", "a note", ""}));
  }
  void say_format(int format) const {
    execute_on(path, {"PRAGMA user_version=" + std::to_string(format)});
  }
  /// As a file of the last format without seals is: the tables that have changed since as they were
  /// then, and no lines.
  void take_seals_away() const {
    constexpr int kWithout = schema::kSealFormat - 1;
    soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
    sql << "PRAGMA foreign_keys=OFF";
    sql << "PRAGMA legacy_alter_table=ON";
    sql << "ATTACH DATABASE '" ISOGRASP_SOURCE_DIR "/tests/data/format_8.db' AS then_";
    const std::vector<std::pair<std::string, std::string>> changed{
        {"patients", "id, code, created_utc, uuid"},
        {"patient_aliases", "uuid, patient_id"},
        {"audit_log", "id, at_utc, actor, role, act, object, result, detail, hash"}};
    for (const auto& [table, columns] : changed) {
      sql << "ALTER TABLE main." + table + " RENAME TO old_" + table;
      std::vector<std::string> statements;
      std::string one;
      soci::statement select =
          (sql.prepare << "SELECT sql FROM then_.sqlite_schema WHERE tbl_name = '" + table +
                              "' AND sql <> '' ORDER BY type DESC",
           soci::into(one));
      select.execute();
      while (select.fetch()) statements.push_back(one);
      const auto of_kind = [&](bool tables) {
        for (const std::string& statement : statements)
          if (statement.starts_with("CREATE TABLE") == tables) sql << statement;
      };
      of_kind(true);
      sql << "INSERT INTO main." + table + " (" + columns + ") SELECT " + columns +
                 " FROM main.old_" + table;
      sql << "DROP TABLE main.old_" + table;
      of_kind(false);
    }
    sql << "DROP TABLE main.row_seals";
    sql << "DROP TABLE main.row_seals_anchor";
    sql << "PRAGMA main.user_version=" + std::to_string(kWithout);
  }
  [[nodiscard]] std::string migrating() const {
    std::unique_ptr<Access> mine;
    if (GetParam()) {
      mine = must(Access::open_to_migrate(path));
      if (const auto in = mine->log_in_with_passphrase(secret("the clinic's passphrase")); !in)
        return in.error().message();
    }
    return refusal(migrate_database(path));
  }
};
INSTANTIATE_TEST_SUITE_P(, Downgraded, testing::Bool(), [](const auto& one) {
  return std::string(one.param ? "Protected" : "Unprotected");
});

TEST_P(Downgraded, ToTheFormatWithUnboundTextsItKeepsItsSealsAndItsTextsAreNotBoundAnew) {
  access.reset();
  say_format(kDatabaseFormat - 1);
  const std::string said = migrating();
  if (GetParam()) {
    EXPECT_NE(said.find("patient_profiles.notes of P-1 was changed"), std::string::npos) << said;
    say_format(kDatabaseFormat);
    log_in();
  } else {
    EXPECT_EQ(said, "") << "nothing of it was changed";
  }
  EXPECT_EQ(problems(), Problems{});
  access.reset();
  execute_on(path, {kForged});
  say_format(kDatabaseFormat - 1);
  EXPECT_NE(migrating().find("measures: row 1 is not what isograsp wrote"), std::string::npos);
}

TEST_P(Downgraded, ToTheFormatWithoutSealsItsLogTellsThatItHadThem) {
  access.reset();
  execute_on(path, {kForged});
  take_seals_away();
  const std::string said = migrating();
  EXPECT_NE(said.find("audit log: entry"), std::string::npos) << said;
  EXPECT_EQ(open_store(path, OpenMode::read_only).ok(), !GetParam());
}

}  // namespace
}  // namespace isograsp::storage::downgraded_test
