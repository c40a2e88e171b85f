// SPDX-License-Identifier: GPL-3.0-or-later
// What all lines of seals say in sum stands in their anchor: a login and a change find by it what
// they found by all lines, and read as little of a large file as of a small one.
#include <filesystem>
#include <functional>

#include "storage/care/migration.hpp"
#include "storage/file/database.hpp"
#include "storage/file/seal_chain.hpp"
#include "storage/person/erasure.hpp"
#include "storage/person/identity.hpp"
#include "tests/storage/clinic_under_attack.hpp"
#include "tests/storage/failing_sqlite.hpp"
#include "tests/support/every.hpp"

namespace isograsp::storage::seals_in_sum_test {
namespace {

namespace fs = std::filesystem;

const Secret& key_of(Access& access) {
  return access.parts().login->login().keys->audit;
}

/// Would the next login be content with the sum?
bool is_summed(Access& access) {
  return must(are_as_sealed_in_sum(access.parts().database, &key_of(access)));
}

SealAnchor anchor_of(const std::string& path) {
  soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
  return read_anchor(sql).value();
}

struct SealsInSum : ClinicUnderAttack {
  void grow(int trials) const {
    const auto store = opened(path);
    const RowId session = must(store->begin_session(example_session(1)));
    const std::vector<Measure> many(100, {"rmse", "force", 0.25, "N", 1, 100, 0, ""});
    for (int number = 1; number <= trials; ++number) {
      TrialRecord trial = example_trial(session, number);
      trial.id = must(store->begin_trial(trial));
      must(store->append_blocks(trial.id, 0, example_rows(trial, 100, 1)));
      trial.status = TrialStatus::completed;
      must(store->end_trial(trial, many));
    }
    must(store->end_session(session));
  }
  /// What SQLite reads of the file until it is done.
  static int reads_of(const std::function<void()>& work) {
    FailingSqlite sqlite;
    sqlite.fail(Asked::read, 0);
    work();
    return sqlite.heal();
  }
};
INSTANTIATE_TEST_SUITE_P(, SealsInSum, testing::Bool(), [](const auto& one) {
  return std::string(one.param ? "Protected" : "Unprotected");
});

TEST_P(SealsInSum, ALoginAndAFirstChangeReadAsLittleOfALargeFileAsOfASmallOne) {
  {
    const auto store = opened(path);
    must(store->set_profile(1, {Side::left, {}, "", "a note", ""}));
  }
  const auto login_and_change = [this] {
    log_in();
    const auto store = opened(path, OpenMode::existing);
    must(store->set_profile(1, {Side::right, {}, "", "another", ""}));
    must(store->add_treatment_mark(1, {0, "2026-02-01", "drug", "a mark"}));
    access.reset();
  };
  access.reset();
  const int of_small = reads_of(login_and_change);
  log_in();
  grow(30);
  access.reset();
  constexpr int kPage_bytes = 4096;
  constexpr int kLine_bytes = 64;  // at least
  constexpr int kLines = 3000;
  const int of_large = reads_of(login_and_change);
  EXPECT_LT(of_large - of_small, kLines * kLine_bytes / kPage_bytes / 2) << of_small;
}

TEST_P(SealsInSum, IsTrueAfterEveryKindOfChange) {
  if (!GetParam()) return;
  const auto expect = [this](const char* what, const std::function<void()>& work) {
    work();
    EXPECT_TRUE(is_summed(*access)) << what;
    EXPECT_TRUE(problems().empty()) << what;
  };
  expect("nothing", [] {});
  expect("an account", [this] {
    must(add_user(*access, "Theo", Role::therapist, secret("theo's password"), kCheapKeyCost));
  });
  expect("another passphrase", [this] {
    must(change_passphrase(*access, secret("another passphrase"), kCheapKeyCost));
    must(change_passphrase(*access, secret("the clinic's passphrase"), kCheapKeyCost));
  });
  expect("no account", [this] { must(remove_user(*access, "Theo")); });
  RowId mark = 0;
  expect("a profile and a mark", [&] {
    const auto store = opened(path);
    must(store->set_profile(1, {Side::left, {}, "", "a note", ""}));
    must(store->set_profile(1, {Side::left, {}, "", "another", ""}));
    mark = must(store->add_treatment_mark(1, {0, "2026-02-01", "drug", "a mark"}));
  });
  expect("the mark is gone", [&] { must(opened(path)->remove_treatment_mark(mark)); });
  expect("a mark of the same number", [&] {
    EXPECT_EQ(must(opened(path)->add_treatment_mark(1, {0, "2026-02-02", "drug", "one"})), mark);
  });
  expect("a name", [this] {
    must(set_identity(*access, "P-1", {"Erika Mustermann", "1950-01-01", ""}));
  });
  expect("what was refused", [this] {
    EXPECT_FALSE(opened(path)->add_treatment_mark(1, {0, "2026-02-30", "drug", ""}).ok());
  });
  must(set_policy(*access, {600, 0}));
  must(erase_patient(*access, "P-1", "asked for it"));
  EXPECT_TRUE(problems().empty());
  log_in();
  EXPECT_TRUE(is_summed(*access)) << "the login has summed up what the erasure left";
}

/// As programs left it that wrote none, and of another hand it proves nothing.
TEST_P(SealsInSum, AnAnchorFromWhichItWasTakenIsNamed) {
  access.reset();
  execute_on(path, {"UPDATE row_seals_anchor SET proof = substr(proof, 1, 32)"});
  if (GetParam()) {
    const auto mine = must(Access::open(path));
    EXPECT_NE(refusal(mine->log_in_with_passphrase(secret("the clinic's passphrase")))
                  .find("row_seals_anchor: row 1 was changed"),
              std::string::npos);
    return;
  }
  EXPECT_EQ(problems(), Problems{"row_seals_anchor: row 1 was changed"});
  must(opened(path)->add_patient("P-2"));
  EXPECT_EQ(problems(), Problems{"row_seals_anchor: row 1 was changed"}) << "for good";
}

TEST_P(SealsInSum, OneThatSaysSomethingElseIsNamed) {
  access.reset();
  const SealAnchor sound = anchor_of(path);
  test::AtLeast tried(20);
  for (std::size_t i = 0; i < sound.summary.size(); i += 40) {
    SealAnchor other = sound;
    other.summary[i] = static_cast<char>(other.summary[i] ^ 1);
    // Where there is no key anybody makes the proof, but no lines that say the same.
    if (!GetParam()) other.proof = seal_proof(nullptr, other);
    {
      soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
      write_anchor(sql, other);
    }
    if (GetParam()) {
      const auto mine = must(Access::open(path));
      EXPECT_FALSE(mine->log_in_with_passphrase(secret("the clinic's passphrase")).ok()) << i;
    } else {
      EXPECT_EQ(problems(), Problems{"row_seals_anchor: row 1 was changed"}) << i;
    }
    ++tried;
  }
}

/// What a file of before has not, the first login makes of what it has proved.
TEST(SealsInSumOfAnOldFile, AreMadeByTheFirstLoginThatHasReadAllLines) {
  const TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  fs::copy_file(std::string(ISOGRASP_SOURCE_DIR) + "/tests/data/format_9_protected.db", path);
  {
    const auto access = must(Access::open_to_migrate(path));
    must(access->log_in_with_passphrase(secret("the clinic's passphrase")));
    static_cast<void>(must(migrate_database(path)));
  }
  const auto access = must(Access::open(path));
  must(access->log_in_with_passphrase(secret("the clinic's passphrase")));
  EXPECT_TRUE(is_summed(*access));
  EXPECT_TRUE(must(opened(path, OpenMode::existing)->check()).empty());
}

/// Row and line agree; the lines do not prove, and who changes another account does not vouch for
/// them.
TEST_P(SealsInSum, AnAccountThatIsPutBackWithItsLineOpensNothingWhateverIsChangedLater) {
  if (!GetParam()) return;
  for (const char* name : {"Ada", "Theo"})
    must(add_user(*access, name, Role::administrator, secret("a long password"), kCheapKeyCost));
  const std::string before = folder.file("before.db");
  must(opened(path, OpenMode::existing)->save_copy(before));
  must(remove_user(*access, "Theo"));
  execute_on(path,
             {"ATTACH DATABASE '" + before + "' AS old", "DELETE FROM users WHERE name = 'Theo'",
              "INSERT INTO users SELECT * FROM old.users WHERE name = 'Theo'",
              "INSERT INTO key_slots SELECT * FROM old.key_slots o WHERE o.id NOT IN (SELECT "
              "id FROM key_slots)",
              "DROP TRIGGER row_seals_are_not_changed",
              "UPDATE row_seals SET hash = (SELECT o.hash FROM old.row_seals o WHERE "
              "o.of_table = row_seals.of_table AND o.of_row = row_seals.of_row ORDER BY o.id "
              "DESC LIMIT 1) WHERE of_table IN ('users', 'key_slots') AND id > (SELECT "
              "max(id) FROM old.row_seals)",
              "CREATE TRIGGER row_seals_are_not_changed BEFORE UPDATE ON row_seals BEGIN "
              "SELECT RAISE(ABORT, 'seals are only added'); END"});
  must(reset_password(*access, "Ada", secret("another password"), kCheapKeyCost));
  EXPECT_FALSE(is_summed(*access));
  access.reset();
  const auto mine = must(Access::open(path));
  EXPECT_NE(refusal(mine->log_in("Theo", secret("a long password")))
                .find("accounts or seals were changed by another program"),
            std::string::npos);
}

}  // namespace
}  // namespace isograsp::storage::seals_in_sum_test
