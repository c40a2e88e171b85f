// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp db and isograsp export, as a user calls them.
#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "core/csv.hpp"
#include "hand/anatomical_axes.hpp"
#include "tests/support/command.hpp"

namespace isograsp::app::database_test {
namespace {

namespace fs = std::filesystem;
using test::isograsp;

struct DatabaseCommands : testing::Test {
  test::TemporaryFolder folder;
  std::string db = folder.path("clinic.db");

  void record(const std::string& patient, const std::string& options = "") const {
    const auto run =
        isograsp("run --protocol-file " ISOGRASP_SOURCE_DIR
                 "/library/protocols/short.toml --device 'sim://healthy?seed=4' --db " +
                 db + " --fast --patient " + patient + options);
    ASSERT_EQ(run.status, 0) << run.err;
  }
  void execute(const std::string& statement) const {
    soci::session sql(soci::sqlite3, db);
    sql << statement;
  }
};

TEST_F(DatabaseCommands, VerifyNamesAMeasureThatItsSignalsDoNotGive) {
  record("T-01");
  EXPECT_EQ(isograsp("db verify " + db).status, 0);
  execute("UPDATE measures SET value = value * (1 + 1e-9) WHERE name = 'rmse'");
  const auto verify = isograsp("db verify " + db);
  EXPECT_EQ(verify.status, 1);
  EXPECT_NE(verify.out.find("patient T-01, session 1, trial 3, rmse of force: stored"),
            std::string::npos)
      << verify.out;
  // A last digit that another libm rounds otherwise is accepted.
  execute("UPDATE measures SET value = value * (1 - 1e-9 + 1e-14) WHERE name = 'rmse'");
  EXPECT_EQ(isograsp("db verify " + db).status, 0);
}

TEST_F(DatabaseCommands, CheckFindsADamagedBlock) {
  record("T-01");
  EXPECT_EQ(isograsp("db check " + db).status, 0);
  execute("UPDATE signal_packs SET values_blake2b = zeroblob(32) WHERE trial_id = 2 AND part = 0");
  const auto check = isograsp("db check " + db);
  EXPECT_EQ(check.status, 1);
  EXPECT_NE(check.out.find("trial 2 of session 1, group task, seconds 0 to 9"), std::string::npos)
      << check.out;
}

TEST_F(DatabaseCommands, VerifyCountsResultsOfOlderVersionsApartAndDoesNotFailForThem) {
  record("T-01");
  execute(
      "UPDATE measures SET version = version - 1, value = value * 1.05, sample_count = 1 "
      "WHERE name = 'rmse'");
  execute("UPDATE measures SET version = version + 100, value = 1.0 WHERE name = 'mae'");
  const auto verify = isograsp("db verify --json " + db);
  EXPECT_EQ(verify.status, 0) << verify.out << verify.err;
  const auto json = nlohmann::json::parse(verify.out);
  EXPECT_GT(json.at("older_version").get<int>(), 0);
  EXPECT_EQ(json.at("older_changed"), json.at("older_version"));
  EXPECT_GT(json.at("newer_version").get<int>(), 0);
  EXPECT_TRUE(json.at("problems").empty());
  EXPECT_NE(isograsp("db verify " + db).out.find("by an older version of their definition"),
            std::string::npos);
}

TEST_F(DatabaseCommands, VerifyAgreesWithWhatReportsHaveComputedAgainAndKept) {
  record("T-01");
  execute("UPDATE measures SET version = version - 1, value = value * 1.05, sample_count = 1");
  const auto verified = [&] {
    const auto verify = isograsp("db verify --json " + db);
    EXPECT_EQ(verify.status, 0) << verify.out << verify.err;
    return nlohmann::json::parse(verify.out);
  };
  const auto before = verified();
  EXPECT_EQ(before.at("identical"), 0);
  ASSERT_EQ(isograsp("report --db " + db + " --all --out " + folder.path("all")).status, 0);
  const auto after = verified();
  EXPECT_EQ(after.at("older_version"), before.at("older_version"))
      << "the old ones are still there";
  EXPECT_GT(after.at("identical").get<int>(), 0);
  EXPECT_EQ(after.at("measures").get<int>(),
            before.at("measures").get<int>() + after.at("identical").get<int>());
  ASSERT_EQ(isograsp("report --db " + db + " --patient T-01 --out " + folder.path("r.html")).status,
            0);
  EXPECT_EQ(verified().at("measures"), after.at("measures")) << "there is nothing to add";
  // The rows that this test has altered, and none of those that the reports added.
  const auto check = isograsp("db check " + db);
  EXPECT_EQ(check.status, 1) << check.err;
  EXPECT_EQ(std::count(check.out.begin(), check.out.end(), '\n'), before.at("measures").get<int>())
      << check.out;
  const auto log = isograsp("db audit " + db);
  EXPECT_NE(log.out.find("recompute measures"), std::string::npos) << log.out;
}

TEST_F(DatabaseCommands, JsonNamesAFileWhoseNameIsNoUtf8) {
  const auto made = isograsp("db init --json " + folder.path("b\xff.db"));
  ASSERT_EQ(made.status, 0) << made.err;
  const auto json = nlohmann::json::parse(made.out);
  EXPECT_NE(json.at("file").get<std::string>().find("b\xef\xbf\xbd.db"), std::string::npos);
}

TEST_F(DatabaseCommands, RestoreStatsAndScheduledBackups) {
  record("T-01");
  const auto stats = isograsp("db stats --json " + db);
  ASSERT_EQ(stats.status, 0) << stats.err;
  EXPECT_NE(stats.out.find("\"trials_not_packed\": 0"), std::string::npos) << stats.out;
  EXPECT_NE(isograsp("db stats " + db).out.find("MB per minute"), std::string::npos);
  EXPECT_EQ(isograsp("db backup " + db).status, 2) << "where to";
  const auto made = isograsp("db backup --scheduled " + db);
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_NE(isograsp("db backup --scheduled " + db).out.find("of today already"),
            std::string::npos);
  const std::string backup = made.out.substr(0, made.out.find(": copied"));
  execute("DELETE FROM measures");
  const auto restored = isograsp("db restore " + db + " --from " + backup);
  EXPECT_EQ(restored.status, 0) << restored.err;
  EXPECT_TRUE(fs::exists(db + ".before-restore"));
  EXPECT_EQ(isograsp("db verify " + db).status, 0);
  const auto counts = [](const std::string& json) {
    auto all = nlohmann::json::parse(json);
    for (const char* size : {"file_bytes", "free_bytes", "bytes_per_minute"}) all.erase(size);
    return all;
  };
  EXPECT_EQ(counts(isograsp("db stats --json " + db).out), counts(stats.out));
}

TEST_F(DatabaseCommands, MergeTakesInAnotherStationOnce) {
  record("T-01");
  const std::string here = db;
  db = folder.path("other.db");
  record("T-02");
  record("t-01");
  const auto refused = isograsp("db merge " + here + " --from " + db);
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.out.find("--same-patient t-01"), std::string::npos) << refused.out;
  const auto merged = isograsp("db merge " + here + " --from " + db + " --same-patient T-01");
  EXPECT_EQ(merged.status, 0) << merged.err;
  EXPECT_NE(merged.out.find("1 patients, 2 sessions"), std::string::npos) << merged.out;
  EXPECT_NE(isograsp("db merge " + here + " --from " + db).out.find("0 patients, 0 sessions, 0"),
            std::string::npos);
  EXPECT_EQ(isograsp("db check " + here).status, 0);
  EXPECT_EQ(isograsp("db verify " + here).status, 0);
}

TEST_F(DatabaseCommands, AClockThatWasSetBackIsToldInTheSession) {
  record("T-01");
  execute("UPDATE sessions SET started_utc = '2099-01-01T00:00:00Z'");
  record("T-01", " --clock-is-right");
  soci::session sql(soci::sqlite3, db);
  std::string kind;
  sql << "SELECT kind FROM events WHERE session_id = 2 ORDER BY id LIMIT 1", soci::into(kind);
  EXPECT_EQ(kind, "clock");
  int told = -1;
  sql << "SELECT count(*) FROM events WHERE kind = 'clock' AND session_id = 1", soci::into(told);
  EXPECT_EQ(told, 0);
}

TEST_F(DatabaseCommands, InitAndBackupNeverOverwrite) {
  EXPECT_EQ(isograsp("db init " + db).status, 0);
  EXPECT_EQ(isograsp("db init " + db).status, 2);
  EXPECT_EQ(isograsp("db backup " + db + " --to " + folder.path("copy.db")).status, 0);
  EXPECT_EQ(isograsp("db backup " + db + " --to " + folder.path("copy.db")).status, 2);
  EXPECT_EQ(isograsp("db migrate " + folder.path("copy.db")).status, 0);
}

TEST_F(DatabaseCommands, AnOldFileIsVerifiedAsItIsAndWrittenOnlyAfterMigration) {
  fs::copy_file(ISOGRASP_SOURCE_DIR "/tests/data/format_1.db", db);
  EXPECT_EQ(isograsp("db verify " + db).status, 0);
  EXPECT_EQ(isograsp("export --db " + db + " --out " + folder.path("old")).status, 0);
  const std::string run = "run --protocol-file " ISOGRASP_SOURCE_DIR
                          "/library/protocols/short.toml --device 'sim://healthy?seed=4' --db " +
                          db + " --fast --patient T-01";
  const auto refused = isograsp(run);
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("isograsp db migrate"), std::string::npos) << refused.err;
  const auto migrated = isograsp("db migrate --json " + db);
  EXPECT_EQ(migrated.status, 0) << migrated.err;
  EXPECT_NE(migrated.out.find("\"migrated\": true"), std::string::npos) << migrated.out;
  EXPECT_TRUE(fs::exists(db + ".format-1"));
  EXPECT_EQ(isograsp(run).status, 0);
  EXPECT_EQ(isograsp("db verify " + db).status, 0);
  EXPECT_EQ(isograsp("db check " + db).status, 0);
}

TEST_F(DatabaseCommands, ExportScoresAsTheSessionDid) {
  record("T-01");
  const std::string out = folder.path("study");
  const auto exported = isograsp("export --db " + db + " --format csv --out " + out);
  ASSERT_EQ(exported.status, 0) << exported.err;
  for (const char* trial : {"1", "2", "3", "4"}) {
    const std::string stem = out + "/patient_1/session_1/trial_" + trial;
    const auto scored =
        isograsp("score --json --task " + stem + "_task.toml --signals " + stem + "_signals.csv");
    ASSERT_EQ(scored.status, 0) << scored.err;
    // The sidecar holds the same numbers, each written as the shortest text that reads back.
    const auto sidecar = *read_text(stem + ".json");
    std::size_t compared = 0;
    for (std::size_t at = 0; (at = scored.out.find("\"value\": ", at)) != std::string::npos; ++at) {
      const auto value = scored.out.substr(at, scored.out.find(',', at) - at + 1);
      EXPECT_NE(sidecar.find(value), std::string::npos) << value;
      ++compared;
    }
    EXPECT_GT(compared, 0u);
  }
}

TEST_F(DatabaseCommands, ExportHoldsForcesInTheAxesOfTheHandBesideWhatIsStored) {
  const std::string run = "run --protocol-file " ISOGRASP_SOURCE_DIR
                          "/library/protocols/short.toml --fast --db " +
                          db + " --patient T-01 --device 'sim://healthy?seed=4' --hand ";
  for (const Hand hand : {Hand::right, Hand::left})
    ASSERT_EQ(isograsp(run + std::string(name_of(hand))).status, 0);
  const std::string out = folder.path("study");
  ASSERT_EQ(isograsp("export --db " + db + " --out " + out).status, 0);
  for (const Hand hand : {Hand::right, Hand::left}) {
    const std::string stem =
        out + "/patient_1/session_" + (hand == Hand::right ? "1" : "2") + "/trial_2";
    const Signals signals = read_signals(stem + "_signals.csv").value();
    ASSERT_GT(signals.rows(), 100u);
    for (const Finger finger : kFingers) {
      const std::string name(name_of(finger));
      double largest_N = 0.0;
      for (std::size_t row = 0; row < signals.rows(); ++row) {
        const Vec3 force_C(signals.column(name + "_fx_N")[row], signals.column(name + "_fy_N")[row],
                           signals.column(name + "_fz_N")[row]);
        const Vec3 force = anatomical(force_C, finger, hand);
        for (const HandAxis axis : kHandAxes)
          ASSERT_EQ(signals.column(anatomical_column(finger, axis))[row],
                    force[static_cast<Eigen::Index>(axis)]);
        largest_N = std::max(largest_N, std::abs(force[2]));
      }
      EXPECT_GT(largest_N, 0.0) << "else the sign of the hand is not seen";
    }
    EXPECT_NE(read_text(stem + ".json")->find("\"name\": \"middle_distal_N\""), std::string::npos);
  }
}

TEST_F(DatabaseCommands, ExportHoldsNoDateNoteOrAddress) {
  record("T-01");
  record("T-01");
  execute(
      "UPDATE sessions SET started_utc = '2026-03-01T09:30:00Z', provenance = 'secret' "
      "WHERE id = 1");
  execute(
      "UPDATE sessions SET started_utc = '2026-03-08T08:00:00Z', "
      "device_uri = 'replay:///home/secret/file.csv' WHERE id = 2");
  execute(
      "INSERT INTO events (session_id, trial_id, session_time_s, kind, text) "
      "VALUES (1, 1, 0.5, 'note', 'secret')");
  const std::string out = folder.path("study");
  ASSERT_EQ(isograsp("export --db " + db + " --session 2 --out " + out).status, 0);
  EXPECT_FALSE(fs::exists(out + "/patient_1/session_1"));
  const std::string first = folder.path("study of session 1");  // a folder holds one export
  ASSERT_EQ(isograsp("export --db " + db + " --session 1 --out '" + first + "'").status, 0);
  std::string all;
  for (const std::string& one : {out, first})
    for (const auto& entry : fs::recursive_directory_iterator(one))
      if (entry.is_regular_file()) all += *read_text(entry.path());
  EXPECT_EQ(all.find("secret"), std::string::npos);
  EXPECT_EQ(all.find("2026-03"), std::string::npos);
  EXPECT_NE(all.find("\"days_from_first_session\": 7"), std::string::npos);
}

TEST_F(DatabaseCommands, ExportOverwritesNothingAndLeavesNothingHalfWritten) {
  record("T-01");
  const std::string out = folder.path("study");
  for (const char* wrong : {"--session 9", "--session 0", "--patient T-99", "--format edf"}) {
    const auto refused = isograsp("export --db " + db + " --out " + out + " " + wrong);
    EXPECT_EQ(refused.status, 2) << wrong;
    EXPECT_FALSE(fs::exists(out)) << wrong;
  }
  execute("UPDATE signal_packs SET part = part + 1000 WHERE trial_id = 4 AND position = 1");
  EXPECT_EQ(isograsp("export --db " + db + " --out " + out).status, 1);
  EXPECT_FALSE(fs::exists(out)) << "three sound trials come before the damaged one";
  execute("UPDATE signal_packs SET part = part - 1000 WHERE trial_id = 4 AND position = 1");
  EXPECT_EQ(isograsp("export --db " + db + " --out " + out).status, 0);
  EXPECT_EQ(isograsp("export --db " + db + " --out " + out).status, 2) << "the files exist";
}

}  // namespace
}  // namespace isograsp::app::database_test
