// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing in the file changes unnoticed: whatever an SQL program does to a row, `db check` names
// the table and the row. The tables and columns are read from the file: one that is new is tried
// too.
#include "storage/file/row_seals.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "storage/access/audit_chain.hpp"
#include "storage/access/audit_check.hpp"
#include "storage/care/merge.hpp"
#include "storage/care/migration.hpp"
#include "storage/person/consent.hpp"
#include "storage/person/erasure.hpp"
#include "storage/person/identity.hpp"
#include "tests/storage/protected_clinic.hpp"
#include "tests/storage/sealed_write.hpp"
#include "tests/support/every.hpp"

namespace isograsp::storage::row_seals_test {
namespace {

namespace fs = std::filesystem;

/// Columns that may change without a word, and why.
const std::map<std::string, std::string> kNotCovered{
    {"users.pin_failed_count", "a wrong PIN is counted without a key"},
    {"key_slots.failed_count", "a wrong password is counted before there is a key"},
    {"key_slots.retry_at_unix_s", "the same"}};

/// A session with two trials, and everything that is known of a person.
void fill(const std::string& path) {
  const auto store = opened(path);
  const RowId patient = must(store->add_patient("P-0427")).id;
  must(store->set_profile(patient, {Side::left, Hand::right, "2025-12-31", "a note", "a goal"}));
  must(store->add_treatment_mark(patient, {0, "2026-02-01", "drug", "a mark"}));
  must(store->add_clinical_score(patient, {0, "2026-02-02", "ARAT", 20.0, "a score"}));
  must(store->add_primary_measure(
      patient, {0, "Grip force, sine", Hand::left, "rmse", "force", "", "Therapist 7"}));
  must(store->add_stable_period(patient,
                                {0, "2026-01-01", "2026-01-20", "", "Therapist 7", "as before"}));
  SessionRecord about = example_session(patient);
  about.id =
      must(store->begin_session(about, std::vector<SessionAnswer>{{"posture", "seat", "chair"}}));
  PreparationRecord zero = example_preparation(about.id);
  zero.references = {{"drift_N", 0.5}};
  zero.id = must(store->add_preparation(zero));
  for (const int number : {1, 2}) {
    TrialRecord trial = example_trial(about.id, number);
    trial.preparations = {zero.id};
    trial.id = must(store->begin_trial(trial));
    must(store->append_blocks(trial.id, 0, example_rows(trial, 100, 1)));
    trial.status = TrialStatus::completed;
    must(
        store->end_trial(trial, std::vector<Measure>{{"rmse", "force", 0.25, "N", 1, 100, 0, ""}}));
    EventRecord note;
    note.trial_id = trial.id;
    note.kind = "note";
    note.text = "well";
    must(store->add_event(about.id, note));
    RatingRecord rating;
    rating.session_id = about.id;
    rating.trial_id = trial.id;
    rating.recorded_utc = "2026-03-05T09:40:00Z";
    rating.effort = 3;
    must(store->add_rating(rating));
  }
  must(store->end_session(about.id));
}

struct Column {
  std::string table;
  std::string name;
  std::string type;
  int in_key = 0;
};
using Columns = std::vector<Column>;

/// A file with all its triggers gone and all checks off: what an attacker works with.
struct Attack {
  explicit Attack(const std::string& path) : sql(soci::sqlite3, "db=\"" + path + "\"") {
    sql << "PRAGMA synchronous=OFF";  // hundreds of them
    sql << "PRAGMA journal_mode=MEMORY";
    sql << "PRAGMA foreign_keys=OFF";
    sql << "PRAGMA ignore_check_constraints=ON";
    std::vector<std::string> triggers;
    std::string name;
    {
      soci::statement select =
          (sql.prepare << "SELECT name FROM sqlite_schema WHERE type = 'trigger'",
           soci::into(name));
      select.execute();
      while (select.fetch()) triggers.push_back(name);
    }
    for (const auto& trigger : triggers) sql << "DROP TRIGGER " + trigger;
  }
  soci::session sql;
};

/// By table; but seconds of a running trial and wrong passwords that no login has taken in yet, of
/// which docs/storage.md speaks.
std::map<std::string, Columns> tables_of(const std::string& path) {
  soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
  std::map<std::string, Columns> all;
  Column one;
  soci::statement select =
      (sql.prepare << "SELECT m.name, c.name, c.type, c.pk FROM sqlite_schema m, "
                      "pragma_table_info(m.name) c WHERE m.type = 'table' AND m.name NOT IN "
                      "('signal_blocks', 'login_failures') ORDER BY m.name, c.cid",
       soci::into(one.table), soci::into(one.name), soci::into(one.type), soci::into(one.in_key));
  select.execute();
  while (select.fetch()) all[one.table].push_back(one);
  return all;
}

/// The columns of the primary key, in their order.
std::vector<std::string> key_of(const Columns& columns) {
  std::map<int, std::string> key;
  for (const Column& column : columns)
    if (column.in_key > 0) key[column.in_key] = column.name;
  std::vector<std::string> names;
  for (const auto& [place, name] : key) names.push_back(name);
  return names;
}

/// SQL: row `n` of a table by its key, and what names it.
struct Rows {
  Rows(const std::string& path, const std::string& table, const Columns& columns) {
    soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
    std::string name;
    std::string where;
    for (const auto& column : key_of(columns)) {
      name += (name.empty() ? "" : " || ',' || ") + column;
      where += (where.empty() ? "'" : " || ' AND ") + column + " = ' || quote(" + column + ")";
    }
    std::pair<std::string, std::string> row;
    const std::string query = "SELECT " + name + " || '', " + where + " FROM " + table;
    soci::statement select = (sql.prepare << query, soci::into(row.first), soci::into(row.second));
    select.execute();
    while (select.fetch()) all.push_back(row);
  }
  std::vector<std::pair<std::string, std::string>> all;  ///< name, WHERE
};

/// SQL: another value of the same kind.
std::string changed(const Column& column) {
  const std::string& name = column.name;
  if (column.type == "INTEGER") return "coalesce(" + name + ", 0) + 1000";
  if (column.type == "REAL" || column.type == "ANY") return "coalesce(" + name + ", 0.0) + 0.25";
  if (column.type == "BLOB")
    return "CASE WHEN " + name + " IS NULL THEN zeroblob(32) ELSE CAST(substr(" + name +
           ", 1, length(" + name + ") - 1) || CASE WHEN substr(" + name +
           ", -1) = x'7f' THEN x'7e' ELSE x'7f' END AS BLOB) END";
  // Of the same length: some columns have to have it.
  return "CASE WHEN coalesce(" + name + ", '') = '' THEN 'x' ELSE substr(" + name + ", 1, length(" +
         name + ") - 1) || CASE WHEN substr(" + name + ", -1) = 'z' THEN 'y' ELSE 'z' END END";
}

/// Both kinds of databases. Parameter: protected.
struct SealedFile : testing::TestWithParam<bool> {
  TemporaryFolder folder;
  std::string path = folder.file("clinic.db");
  std::unique_ptr<Access> access;

  SealedFile() {
    if (GetParam()) {
      access = must(Access::create(path, secret("the clinic's passphrase"), &kCheapKeyCost)).access;
      must(add_user(*access, "Theo", Role::therapist, secret("theo's password"), kCheapKeyCost));
      must(access->log_in("Theo", secret("theo's password")));
      must(set_own_pin(*access, secret("2580")));
    }
    fill(path);
    auto mine = must(Access::open(path));
    must(add_consent(*mine, "P-0427",
                     {0, "2026-03-05", "research", "consent", "given", "a text", "", ""}));
    if (GetParam()) must(set_identity(*mine, "P-0427", {"Vera Novak", "1950-03-05", ""}));
    // What only a merge, an erasure and a restriction write.
    write_sealed(path,
                 "INSERT INTO patient_aliases (uuid, patient_id) VALUES "
                 "('00000000-0000-4000-8000-000000000000', 1)");
    write_sealed(path,
                 "INSERT INTO tombstones (code, erased_utc, erased_by) VALUES "
                 "('E-1', '2026-01-02T00:00:00Z', 'Ada')");
    write_sealed(path,
                 "INSERT INTO restrictions VALUES (1, '2026-01-02T00:00:00Z', "
                 "'2036-01-02', 'Ada')");
  }
  /// What `db check` says of an attacked copy.
  [[nodiscard]] std::vector<std::string> problems_of(const std::string& file) const {
    if (const auto store = open_store(file, OpenMode::read_only))
      return in_words(must((*store)->check()));
    // Nobody is logged in to a file without its slots, or with another id.
    auto database = must(Database::open(file, OpenMode::read_only));
    const auto mine = must(Access::open(path));
    const LoginState& state = *mine->parts().login;
    const Login login = state.login();
    std::vector<std::string> all;
    for (const auto& one : must(seal_problems(database, audit_key(login))))
      all.push_back(english(one.what));
    for (const auto& one : in_words(must(audit_problems(database, state)))) all.push_back(one);
    return all;
  }
  static std::vector<std::string> in_words(const std::vector<Text>& problems) {
    std::vector<std::string> all;
    for (const auto& one : problems) all.push_back(english(one));
    return all;
  }
  /// Is the row among them? The log says entry and anchor.
  static bool named(const std::vector<std::string>& problems, const std::string& table,
                    const std::string& row) {
    const bool of_log = table == "audit_log";
    const std::string wanted = of_log ? "audit log: entr" : table + ": row " + row + " ";
    const std::string several = table + ": rows " + row + " to " + row + " ";
    return std::any_of(problems.begin(), problems.end(), [&](const std::string& one) {
      return one.starts_with(wanted) || one.starts_with(several) ||
             (of_log && one.starts_with("audit log: it ends")) ||
             (table == "audit_anchor" && one.starts_with("audit log: its anchor")) ||
             (table == "row_seals" && one.starts_with("row_seals: it ends with row"));
    });
  }
  void keep_good() const {
    must(opened(path, OpenMode::existing)->save_copy(folder.file("good.db")));
  }

  [[nodiscard]] std::string attacked(const std::vector<std::string>& statements) const {
    const std::string bad = folder.file("bad.db");
    for (const char* suffix : {"", "-wal", "-shm"}) fs::remove(bad + suffix);
    fs::copy_file(folder.file("good.db"), bad);
    Attack attack(bad);
    for (const auto& statement : statements) attack.sql << statement;
    return bad;
  }
};
INSTANTIATE_TEST_SUITE_P(Kinds, SealedFile, testing::Bool(), [](const auto& kind) {
  return std::string(kind.param ? "Protected" : "Unprotected");
});

TEST_P(SealedFile, AsTheProgramWroteItProves) {
  EXPECT_EQ(must(opened(path)->check()), std::vector<Text>{});
}

TEST_P(SealedFile, EveryColumnOfEveryTableThatIsAlteredIsNamedWithItsRow) {
  keep_good();
  test::AtLeast tried(150);
  for (const auto& [table, columns] : tables_of(path)) {
    const Rows rows(folder.file("good.db"), table, columns);
    if (!GetParam() && (table == "users" || table == "key_slots" || table == "identities")) {
      EXPECT_TRUE(rows.all.empty());
      continue;
    }
    ASSERT_FALSE(rows.all.empty()) << table << ": give it a row";
    const auto& [row, where] = rows.all.front();
    for (const Column& column : columns) {
      if (kNotCovered.contains(table + "." + column.name)) continue;
      ++tried;
      const std::string bad = attacked({"UPDATE " + table + " SET " + column.name + " = " +
                                        changed(column) + " WHERE " + where});
      if (column.name == "float64_shuffled_zstd") {  // its values have a hash of their own
        const auto found = must(opened(bad, OpenMode::read_only)->check());
        ASSERT_FALSE(found.empty());  // the triggers that had to go come first
        EXPECT_EQ(
            english(found.back()),
            "trial 1 of session 1, group force, seconds 0 to 9: the block is damaged (content)");
        continue;
      }
      const auto problems = problems_of(bad);
      EXPECT_TRUE(named(problems, table, row))
          << table << "." << column.name << " of " << row << ": "
          << (problems.empty() ? "nothing" : problems.front());
    }
  }
}

TEST_P(SealedFile, EveryRowThatIsDeletedIsNamed) {
  keep_good();
  test::AtLeast tried(100);
  for (const auto& [table, columns] : tables_of(path)) {
    if (table == "audit_anchor") continue;  // where unprotected it is made anew with its log
    for (const auto& [row, where] : Rows(folder.file("good.db"), table, columns).all) {
      ++tried;
      const auto problems = problems_of(attacked({"DELETE FROM " + table + " WHERE " + where}));
      EXPECT_TRUE(named(problems, table, row)) << table << ", row " << row;
    }
  }
}

TEST_P(SealedFile, EveryRowThatIsDoubledIsNamed) {
  keep_good();
  test::AtLeast tried(25);
  for (const auto& [table, columns] : tables_of(path)) {
    const Rows rows(folder.file("good.db"), table, columns);
    if (rows.all.empty()) continue;
    // Another value in the last column of the key; tables that can have one row alone refuse it.
    const std::string last = key_of(columns).back();
    std::string names;
    std::string values;
    for (const Column& column : columns) {
      names += (names.empty() ? "" : ", ") + column.name;
      const bool other = column.name == last || column.name == "uuid" || column.name == "code" ||
                         (table == "users" && column.name == "name") ||
                         (table == "trials" && column.name == "number") ||
                         (table == "key_slots" && column.name == "kind");
      values += (values.empty() ? "" : ", ") + (other ? changed(column) : column.name);
    }
    std::string bad;
    try {
      bad = attacked({"INSERT INTO " + table + " (" + names + ") SELECT " + values + " FROM " +
                      table + " WHERE " + rows.all.front().second});
    } catch (const soci::soci_error& refused) {
      EXPECT_NE(std::string(refused.what()).find("UNIQUE"), std::string::npos) << refused.what();
      continue;
    }
    ++tried;
    const auto problems = problems_of(bad);
    EXPECT_TRUE(std::any_of(problems.begin(), problems.end(),
                            [&table = table](const std::string& one) {
                              return one.starts_with(table + ": row") ||
                                     (table.starts_with("audit") && one.starts_with("audit log"));
                            }))
        << table;
  }
}

/// What a person legally became in between, put back by copying rows of a backup; and with them
/// their seals.
TEST_P(SealedFile, RowsCopiedFromABackupAreNamedWithAndWithoutTheirSeals) {
  const std::string backup = folder.file("backup.db");
  must(opened(path, OpenMode::existing)->save_copy(backup));
  {
    const auto store = opened(path);
    must(store->set_profile(1, {Side::right, Hand::right, "2025-12-31", "another", "goal"}));
    must(store->mark_helped(1, true));
    must(store->remove_clinical_score(1));
    RatingRecord rating = must(store->ratings(1)).at(0);
    rating.effort = 9;
    must(store->correct_rating(rating));
  }
  keep_good();
  for (const std::string table : {"patient_profiles", "trials", "clinical_scores", "ratings"}) {
    const std::string row = "1";
    const std::vector<std::string> put_back{
        "ATTACH DATABASE '" + backup + "' AS old", "DELETE FROM main." + table,
        "INSERT INTO main." + table + " SELECT * FROM old." + table};
    EXPECT_TRUE(named(problems_of(attacked(put_back)), table, row)) << table;
    auto with_seals = put_back;
    for (const char* of_seals : {"row_seals", "row_seals_anchor"}) {
      with_seals.push_back("DELETE FROM main." + std::string(of_seals));
      with_seals.push_back("INSERT INTO main." + std::string(of_seals) + " SELECT * FROM old." +
                           of_seals);
    }
    EXPECT_FALSE(problems_of(attacked(with_seals)).empty()) << table;
  }
  // All of them, so that nothing but the log can tell.
  std::vector<std::string> all{"ATTACH DATABASE '" + backup + "' AS old"};
  for (const auto& [table, columns] : tables_of(path)) {
    if (table.starts_with("audit_")) continue;
    all.push_back("DELETE FROM main." + table);
    all.push_back("INSERT INTO main." + table + " SELECT * FROM old." + table);
  }
  const auto problems = problems_of(attacked(all));
  ASSERT_FALSE(problems.empty()) << "the log held the seals";
  std::size_t of_log = 0;
  for (const std::string& one : test::every(problems))
    if (one.starts_with("audit log: entry")) ++of_log;
  EXPECT_GT(of_log, 0u);
  EXPECT_FALSE(named(problems, "trials", "1")) << "rows and seals agree";
}

TEST_P(SealedFile, AfterAnErasureTheSealsProveAndTellNothing) {
  const auto mine = must(Access::open(path));
  if (GetParam()) must(mine->log_in_with_passphrase(secret("the clinic's passphrase")));
  must(set_policy(*mine, {600, 0}));
  std::string salt;
  {
    soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
    soci::blob bytes(sql);
    sql << "SELECT salt FROM patients", soci::into(bytes);
    salt.resize(bytes.get_len());
    bytes.read(0, salt.data(), salt.size());
    ASSERT_NE(salt, std::string(16, '\0')) << "random";
  }
  const auto holds_salt = [&] {
    std::string files = bytes_of(path);
    for (const char* suffix : {"-wal", "-shm"})
      if (fs::exists(path + suffix)) files += bytes_of(path + suffix);
    return files.find(salt) != std::string::npos;
  };
  EXPECT_TRUE(holds_salt());
  ASSERT_TRUE(must(erase_patient(*mine, "P-0427", "asked for it")).erased);
  EXPECT_EQ(must(opened(path)->check()), std::vector<Text>{});
  EXPECT_TRUE(must(opened(path)->patients()).empty());
  EXPECT_FALSE(holds_salt()) << "without it the lines that stay tell nothing";
}

/// Without the random number a row could be guessed from its hash.
TEST(RowHash, OfEqualRowsOfTwoPeopleDiffers) {
  const TemporaryFolder folder;
  // Of two files, so that not even the number of the person differs.
  const auto hash_in = [&folder](const std::string& name) {
    const std::string path = folder.file(name);
    {
      const auto store = opened(path);
      if (must(store->patients()).empty())
        must(store->set_profile(must(store->add_patient("P-1")).id, {Side::left, {}, "", "", ""}));
    }
    soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
    for (const SealedTable& table : sealed_tables(sql))
      if (table.name == "patient_profiles") {
        RowReader reader(sql, table, RowReader::Which::one);
        EXPECT_TRUE(reader.find({"1"}));
        return reader.hash(nullptr);
      }
    return ContentHash{};
  };
  const ContentHash one = hash_in("one.db");
  EXPECT_EQ(hash_in("one.db"), one);
  EXPECT_NE(hash_in("two.db"), one);
}

TEST(RowHash, KnowsThePersonOfEveryTableThatHangsOnOne) {
  const TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  opened(path);
  soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
  const std::set<std::string> of_nobody{"access_settings", "key_slots", "tombstones", "users"};
  for (const SealedTable& table : test::every(sealed_tables(sql)))
    EXPECT_EQ(table.salt == "NULL", of_nobody.contains(table.name)) << table.name;
}

TEST_P(SealedFile, LegalChangesProve) {
  {
    const auto store = opened(path);
    must(store->set_profile(1, {Side::right, Hand::right, "2025-12-31", "another", "goal"}));
    must(store->mark_helped(1, true));
    must(store->remove_clinical_score(1));
    must(store->remove_treatment_mark(1));
    RatingRecord rating = must(store->ratings(1)).at(0);
    rating.effort = 9;
    must(store->correct_rating(rating));
    PreparationRecord later = example_preparation(1, 2.0);
    later.drifted = true;
    must(store->add_preparation(later));
    EXPECT_EQ(must(store->check()), std::vector<Text>{});
  }
  const auto mine = must(Access::open(path));
  if (GetParam()) must(mine->log_in_with_passphrase(secret("the clinic's passphrase")));
  const auto before = must(read_audit(*mine)).back();
  must(opened(path)->add_treatment_mark(1, {0, "2026-02-03", "therapy", ""}));
  const auto entry = must(read_audit(*mine)).back();
  EXPECT_GT(entry.seals, before.seals) << "the entry holds the seal of its row";
}

}  // namespace
}  // namespace isograsp::storage::row_seals_test
