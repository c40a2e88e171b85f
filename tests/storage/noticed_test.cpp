// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of docs/storage.md that say what is noticed: each row is done, and `db check` asked.
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

#include "storage/access/audit_chain.hpp"
#include "storage/file/database.hpp"
#include "tests/storage/clinic_under_attack.hpp"
#include "tests/support/doc_table.hpp"
#include "tests/support/every.hpp"

namespace isograsp::storage::noticed_test {
namespace {

namespace fs = std::filesystem;

struct NoticedTable : ClinicUnderAttack {
  /// As somebody can do it who knows how, but has no key.
  using Deed = std::function<void()>;
  struct Row {
    std::vector<Deed> deeds;       ///< what the row says
    std::vector<Deed> exceptions;  ///< what it says after "unless": of an unprotected database
  };
  using Rows = std::map<std::string, Row>;

  const std::string backup = folder.file("backup.db");
  const std::string start = folder.file("start.db");

  void do_sql(const std::vector<std::string>& statements) const { execute_on(path, statements); }
  /// Without its triggers, which are put back.
  void change_log(const std::vector<std::string>& statements) const {
    std::vector<std::string> triggers;
    {
      soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
      std::string text;
      soci::statement select =
          (sql.prepare << "SELECT sql FROM sqlite_schema WHERE type = 'trigger'", soci::into(text));
      select.execute();
      while (select.fetch()) triggers.push_back(text);
    }
    constexpr std::size_t kName = 2;  // CREATE TRIGGER name
    for (const std::string& trigger : triggers) {
      std::istringstream words(trigger);
      std::string name;
      for (std::size_t i = 0; i <= kName; ++i) words >> name;
      do_sql({"DROP TRIGGER " + name});
    }
    do_sql(statements);
    do_sql(triggers);
  }
  void copy_from_backup(const std::vector<std::string>& tables) const { copy_from(backup, tables); }
  void copy_from(const std::string& file, const std::vector<std::string>& tables) const {
    std::vector<std::string> statements{"ATTACH DATABASE '" + file + "' AS old"};
    for (const std::string& table : tables) {
      statements.push_back("DELETE FROM main." + table);
      statements.push_back("INSERT INTO main." + table + " SELECT * FROM old." + table);
    }
    change_log(statements);
  }
  void put_back(const std::string& from) const {
    for (const char* suffix : {"", "-wal", "-shm"}) fs::remove(path + suffix);
    fs::copy_file(from, path);
  }
  /// Hash, chain and anchor of every row.
  void seal_anew() const {
    auto database = must(Database::open(path, OpenMode::existing));
    const Secret theirs{std::string_view("a key that somebody has made up.")};
    if (GetParam()) database.seals()->key_from([&theirs] { return &theirs; });
    must(database.transact("testing"_text, [&] { database.seals()->seal_all(); }));
  }
  void log_anew() const {
    std::vector<AuditEntry> entries;
    std::string id;
    {
      auto database = must(Database::open(path, OpenMode::read_only));
      AuditEntry one;
      soci::statement select =
          (database.sql().prepare << "SELECT id, at_utc, actor, role, act, object, result, detail "
                                     "FROM audit_log ORDER BY id",
           soci::into(one.number), soci::into(one.at_utc), soci::into(one.actor),
           soci::into(one.role), soci::into(one.act), soci::into(one.object),
           soci::into(one.result), soci::into(one.detail));
      select.execute();
      while (select.fetch()) entries.push_back(one);
      database.sql() << "SELECT database_id FROM access_settings", soci::into(id);
    }
    AuditHead head{0, first_hash(nullptr, id)};
    std::vector<std::string> statements;
    for (const AuditEntry& one : entries) {
      head = {one.number, entry_hash(nullptr, head.hash, one, "")};
      statements.push_back("UPDATE audit_log SET seals = 0, hash = '" + head.hash +
                           "' WHERE id = " + std::to_string(one.number));
    }
    statements.push_back("UPDATE audit_anchor SET hash = '" + head.hash + "', proof = '" +
                         head_proof(nullptr, id, head) + "'");
    change_log(statements);
  }
  [[nodiscard]] Deed sql(std::vector<std::string> statements) const {
    return [this, statements = std::move(statements)] { change_log(statements); };
  }

  [[nodiscard]] Rows of_rows() const {
    Rows rows;
    rows["any value of any column altered; a row deleted, added, doubled, moved"].deeds = {
        sql({"UPDATE measures SET value = 0.5 WHERE id = 1"}), sql({"DELETE FROM measures"}),
        sql({"INSERT INTO measures SELECT 9, trial_id, name, channel, value, unit, version, "
             "sample_count, excluded_count, reason FROM measures WHERE id = 1"}),
        sql({"UPDATE measures SET id = 9 WHERE id = 1"}),
        sql({"UPDATE measures SET trial_id = 3 - trial_id"})};
    rows["a row copied from a backup of the same database"].deeds = {
        [this] { copy_from_backup({"trials"}); }};
    rows["a row and all seals copied from a backup"] = {
        {[this] {
          copy_from_backup(
              {"patients", "patient_profiles", "trials", "row_seals", "row_seals_anchor"});
        }},
        {[this] {
          const std::string between = mark_after_a_copy();
          copy_from(between, {"trials", "row_seals", "row_seals_anchor"});
        }}};
    const auto forge = [this] {
      do_sql({"UPDATE measures SET value = 0.5 WHERE id = 1"});
      seal_anew();
      log_anew();
    };
    rows["a row altered and hash, chain, anchor and audit log computed anew"].deeds = {forge};
    rows["the whole file put back to a backup"].deeds = {[this] { put_back(backup); }};
    rows["counters of wrong passwords and PINs; wrong passwords that the log has not taken in yet"]
        .deeds = {sql({"UPDATE key_slots SET failed_count = 7",
                       "UPDATE users SET pin_failed_count = 2", "DELETE FROM login_failures"})};
    rows["a second of a trial that is being recorded, or that could not be packed, altered"]
        .deeds = {sql({"UPDATE signal_blocks SET row_count = row_count - 1 WHERE trial_id = 3"}),
                  sql({"UPDATE signal_blocks SET float64_shuffled_zstd = "
                       "CAST(substr(float64_shuffled_zstd, 1, "
                       "length(float64_shuffled_zstd) - 1) || x'00' AS BLOB) WHERE trial_id = 3"})};
    return rows;
  }
  [[nodiscard]] Rows of_log() const {
    Rows rows;
    rows["an entry changed, moved, taken out by mistake or by hand"].deeds = {
        sql({"UPDATE audit_log SET object = 'P-9' WHERE id = 2"}),
        sql({"UPDATE audit_log SET id = 99 WHERE id = 2"}),
        sql({"DELETE FROM audit_log WHERE id = 2"})};
    rows["the end cut off"] = {
        {sql({"DELETE FROM audit_log WHERE id > 2"})}, {[this] {
          change_log({"DELETE FROM audit_log WHERE id > 2", "UPDATE audit_anchor SET count = 2"});
          log_anew();
        }}};
    rows["the whole chain computed anew"].deeds = {[this] { log_anew(); }};
    rows["the file put back to an earlier state (a backup)"].deeds = {[this] { put_back(backup); }};
    return rows;
  }

  /// A copy from before a change that is no entry of the log.
  [[nodiscard]] std::string mark_after_a_copy() const {
    put_back(backup);
    fs::remove(path + "-audit");
    std::unique_ptr<Access> mine;
    if (GetParam()) {
      mine = must(Access::open(path));
      must(mine->log_in_with_passphrase(secret("the clinic's passphrase")));
    }
    const std::string copy = folder.file("between.db");
    fs::remove(copy);
    const auto store = opened(path, OpenMode::existing);
    must(store->save_copy(copy));
    must(store->mark_helped(1, true));
    return copy;
  }

  /// A backup, changes since with entries of the log, and a trial of which seconds are left.
  void prepare() {
    must(opened(path)->save_copy(backup));
    {
      const auto store = opened(path, OpenMode::existing);
      must(store->set_profile(1, {Side::left, Hand::right, "", "", ""}));
      must(store->mark_helped(1, true));
      TrialRecord trial = example_trial(1, 3);
      trial.id = must(store->begin_trial(trial));
      must(store->append_blocks(trial.id, 0, example_rows(trial, 100, 5)));
    }
    access.reset();
    {  // all of it in one file
      soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
      std::string mode;
      sql << "PRAGMA journal_mode=DELETE", soci::into(mode);
    }
    fs::copy_file(path, start);
    if (GetParam()) head_ = bytes_of(path + "-audit");
  }
  [[nodiscard]] bool is_noticed(const Deed& deed) {
    access.reset();
    put_back(start);
    if (GetParam()) std::ofstream(path + "-audit", std::ios::binary) << head_;
    deed();
    // What login finds is as good as what the check says.
    if (GetParam()) {
      auto mine = Access::open(path);
      if (!mine || !(*mine)->log_in_with_passphrase(secret("the clinic's passphrase"))) return true;
      access = *std::move(mine);
      if (!access->notices().empty()) return true;
    }
    return !must(opened(path, OpenMode::existing)->check()).empty();
  }

  void expect_table(const std::string& head, const Rows& rows) {
    prepare();
    ASSERT_FALSE(is_noticed([] {}));
    const auto says_noticed = [](const std::string& cell) {
      EXPECT_NE(cell.find("noticed"), std::string::npos) << cell;
      return !cell.starts_with("not noticed");
    };
    std::size_t known = 0;
    for (const auto& cells : test::every(test::rows_of_table("storage.md", head))) {
      const auto row = rows.find(cells.at(0));
      ASSERT_NE(row, rows.end()) << cells[0] << ": do it here, too";
      ++known;
      const std::string& said =
          GetParam() && cells.at(2) != "as unprotected" ? cells.at(2) : cells.at(1);
      for (const Deed& deed : test::every(row->second.deeds))
        EXPECT_EQ(is_noticed(deed), says_noticed(said)) << cells[0] << ": " << said;
      if (GetParam() && cells[2] != cells[1]) continue;
      EXPECT_EQ(cells[1].starts_with("noticed, unless "), !row->second.exceptions.empty()) << said;
      for (const Deed& deed : row->second.exceptions) EXPECT_FALSE(is_noticed(deed)) << cells[0];
    }
    EXPECT_EQ(known, rows.size()) << "the table says less than is done here";
  }

 private:
  std::string head_;
};
INSTANTIATE_TEST_SUITE_P(Kinds, NoticedTable, testing::Bool(), [](const auto& kind) {
  return std::string(kind.param ? "Protected" : "Unprotected");
});

TEST_P(NoticedTable, OfRowsSaysWhatTheCheckFinds) {
  expect_table("done to a row by another program", of_rows());
}

TEST_P(NoticedTable, OfTheLogSaysWhatTheCheckFinds) {
  expect_table("change", of_log());
}

}  // namespace
}  // namespace isograsp::storage::noticed_test
