// SPDX-License-Identifier: GPL-3.0-or-later
// What a corrected measure makes of stored signals stands beside what the trial was scored with.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>
#include <sys/wait.h>

#include "storage/access/open_store.hpp"
#include "storage/care/merge.hpp"
#include "storage/person/erasure.hpp"
#include "tests/storage/protected_clinic.hpp"
#include "tests/storage/sealed_write.hpp"

namespace isograsp::storage::newer_measures_test {
namespace {

Measure measure(const std::string& name, int version, std::optional<double> value) {
  Measure one;
  one.name = name;
  one.channel = "force";
  one.unit = "N";
  one.version = version;
  one.value = value;
  one.reason = value ? "" : "too short";
  one.samples = 100;
  return one;
}

/// What every trial is scored with when it ends.
const std::vector<Measure>& scored_first() {
  static const std::vector<Measure> all{measure("rmse", 1, 1.5), measure("lag", 1, std::nullopt),
                                        measure("mae", 2, 0.25)};
  return all;
}
/// What a newer program makes of it: one that is new, and one that has not changed.
std::vector<Measure> scored_later(int version = 2) {
  return {measure("cv", 1, 7.0), measure("rmse", version, 2.5), measure("lag", version, 0.3),
          measure("mae", 2, 99.0)};
}

RowId add_trial(SessionStore& store, RowId session, int number) {
  TrialRecord trial = example_trial(session, number);
  trial.practice = false;
  trial.id = must(store.begin_trial(trial));
  must(store.append_blocks(trial.id, 0, example_rows(trial, 50, 7)));
  trial.status = TrialStatus::completed;
  must(store.end_trial(trial, scored_first()));
  return trial.id;
}

struct Clinic {
  RowId patient = 0;
  std::vector<ScoredTrial> trials;
};
Clinic add_clinic(SessionStore& store, const std::string& code = "P-1") {
  Clinic clinic;
  clinic.patient = must(store.add_patient(code)).id;
  const RowId session = must(store.begin_session(example_session(clinic.patient)));
  for (int number = 1; number <= 2; ++number)
    clinic.trials.push_back({add_trial(store, session, number), scored_later()});
  return clinic;
}

std::string words(const std::vector<Measure>& measures) {
  std::string text;
  for (const Measure& one : measures)
    text += one.name + " " + std::to_string(one.version) +
            (one.value ? " " + std::to_string(*one.value).substr(0, 4) : "") +
            (one.recomputed ? " again" : "") + "; ";
  return text;
}
constexpr const char* kFirst = "rmse 1 1.50; lag 1; mae 2 0.25; ";
constexpr const char* kBoth = "rmse 1 1.50; lag 1; mae 2 0.25; rmse 2 2.50; lag 2 0.30; ";
constexpr const char* kNewest = "rmse 2 2.50 again; lag 2 0.30 again; mae 2 0.25; ";

struct NewerMeasures : testing::Test {
  TemporaryFolder folder;
  std::string path = folder.file("clinic.db");
  std::unique_ptr<SessionStore> store = opened(path);
  Clinic clinic = add_clinic(*store);
  RowId first = clinic.trials.front().trial_id;

  [[nodiscard]] std::string all() const {
    return words(must(store->measures_of_all_versions(first)));
  }
  [[nodiscard]] bool add() const {
    return must(store->add_newer_measures(clinic.patient, clinic.trials));
  }
};

TEST_F(NewerMeasures, StandBesideTheOldOnesAndReadersTakeThem) {
  EXPECT_EQ(words(must(store->measures(first))), kFirst);
  EXPECT_TRUE(add());
  EXPECT_EQ(all(), kBoth);
  EXPECT_EQ(words(must(store->measures(first))), kNewest);
  std::vector<Measure> course;
  for (const auto& point : must(store->progress(clinic.patient))) course.push_back(point.measure);
  EXPECT_EQ(words(course), std::string(kNewest) + kNewest);
  EXPECT_TRUE(add()) << "again: there is nothing to add";
  EXPECT_EQ(all(), kBoth);
  EXPECT_EQ(must(store->check()), std::vector<Text>{});
}

TEST_F(NewerMeasures, OfAPoolAreItsValuesAsFarAsItsVersionGoes) {
  must(store->add_stable_period(clinic.patient, {0, "2026-02-01", "2026-04-01", "", "Dr 3", ""}));
  ASSERT_TRUE(add());
  const auto trial = must(store->trials(1)).at(0);
  PoolQuery query{trial.task_name,
                  trial.task_version,
                  trial.task_text,
                  trial.scene_text,
                  "rmse",
                  "force",
                  "N",
                  2,
                  true,
                  true};
  const auto newest = must(store->stable_values(query));
  ASSERT_EQ(newest.size(), 2u) << "one of each trial";
  EXPECT_EQ(newest[0].value, 2.5);
  EXPECT_EQ(newest[0].measure_version, 2);
  query.measure_version = 1;
  const auto older = must(store->stable_values(query));
  ASSERT_EQ(older.size(), 2u);
  EXPECT_EQ(older[1].value, 1.5);
}

TEST_F(NewerMeasures, AreNotWrittenIntoAFileThatIsOnlyReadRecordedIntoOrWrittenByAnother) {
  {
    const auto reader = opened(path, OpenMode::read_only);
    EXPECT_FALSE(must(reader->add_newer_measures(clinic.patient, clinic.trials)));
  }
  {
    const auto recorder = opened(path);
    TrialRecord trial = example_trial(1, 3);
    trial.id = must(recorder->begin_trial(trial));
    EXPECT_FALSE(add());
    EXPECT_FALSE(must(recorder->add_newer_measures(clinic.patient, clinic.trials)));
    trial.status = TrialStatus::aborted;
    must(recorder->end_trial(trial, {}));
  }
  {
    soci::session writer(soci::sqlite3, "db=\"" + path + "\"");
    writer << "BEGIN IMMEDIATE";
    EXPECT_FALSE(add());
    writer << "ROLLBACK";
  }
  EXPECT_EQ(all(), kFirst);
  EXPECT_TRUE(add());
  EXPECT_EQ(all(), kBoth);
}

TEST_F(NewerMeasures, AreThoseOfThePersonsOwnTrialsThatHaveEnded) {
  const RowId other = must(store->add_patient("P-2")).id;
  EXPECT_TRUE(must(store->add_newer_measures(other, clinic.trials)));
  EXPECT_EQ(all(), kFirst);
  clinic.trials[0].measures[1].value = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(add());
  EXPECT_EQ(all(), "rmse 1 1.50; lag 1; mae 2 0.25; lag 2 0.30; ") << "no number: not stored";
}

TEST_F(NewerMeasures, OfAPersonWhoseRecordsAreRestrictedAreNotStored) {
  soci::session(soci::sqlite3, "db=\"" + path + "\"")
      << "INSERT INTO restrictions (patient_id, since_utc, until_date, requested_by) "
         "VALUES (1, '2026-04-01T00:00:00Z', '2036-04-01', 'P-1')";
  EXPECT_TRUE(add());
  EXPECT_EQ(all(), kFirst);
}

TEST_F(NewerMeasures, AreAllThereOrNoneAfterAnEndWithoutWarning) {
  constexpr int kKills = 10;
  constexpr unsigned kLongestLife_us = 30'000;
  std::mt19937_64 random(20261123);
  int versions_seen = 1;
  for (int run = 0; run < kKills; ++run) {
    store.reset();
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    if (child == 0) {
      auto writer = open_store(path, OpenMode::existing);
      for (int version = versions_seen + 1; writer; ++version) {
        for (auto& trial : clinic.trials) trial.measures = scored_later(version);
        if (!(*writer)->add_newer_measures(clinic.patient, clinic.trials)) break;
        if (write(ends[1], &version, sizeof version) < 0) break;
      }
      _exit(1);
    }
    int confirmed = 0;
    ASSERT_EQ(read(ends[0], &confirmed, sizeof confirmed), static_cast<ssize_t>(sizeof confirmed));
    std::this_thread::sleep_for(std::chrono::microseconds(random() % kLongestLife_us));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    close(ends[1]);
    for (int one = 0; read(ends[0], &one, sizeof one) == static_cast<ssize_t>(sizeof one);)
      confirmed = one;
    close(ends[0]);
    store = opened(path, OpenMode::existing);
    EXPECT_EQ(must(store->check()), std::vector<Text>{});
    std::vector<int> newest;
    for (const auto& trial : clinic.trials)
      for (const auto& one : must(store->measures(trial.trial_id)))
        if (one.name != "mae") newest.push_back(one.version);
    ASSERT_EQ(newest.size(), 4u);
    EXPECT_EQ(std::count(newest.begin(), newest.end(), newest[0]), 4) << "of one transaction";
    EXPECT_GE(newest[0], confirmed);
    versions_seen = newest[0];
    EXPECT_EQ(all().substr(0, std::string(kFirst).size()), kFirst) << "the first results stay";
    EXPECT_EQ(must(store->measures_of_all_versions(first)).size(),
              3u + 2u * static_cast<unsigned>(versions_seen - 1));
  }
}

TEST_F(ProtectedClinic, NewerMeasuresAreLoggedAndWhoMayOnlyReadStoresNone) {
  as("Theo");
  auto store = opened(path);
  const Clinic clinic = add_clinic(*store);
  as("Rita");
  EXPECT_FALSE(must(store->add_newer_measures(clinic.patient, clinic.trials)));
  as("Theo");
  EXPECT_TRUE(must(store->add_newer_measures(clinic.patient, clinic.trials)));
  EXPECT_TRUE(must(store->add_newer_measures(clinic.patient, clinic.trials)));
  EXPECT_EQ(words(must(store->measures(clinic.trials[0].trial_id))), kNewest);
  EXPECT_EQ(must(store->check()), std::vector<Text>{});
  store.reset();
  as("Ada");
  const auto entries = must(read_audit(*access, {"recompute measures", ""}));
  ASSERT_EQ(entries.size(), 1u) << "what changes nothing is no act, nor is what was not tried";
  EXPECT_EQ(entries[0].actor, "Theo");
  EXPECT_EQ(entries[0].object, "P-1");
  EXPECT_EQ(entries[0].detail, "4 results of 2 trials");
  EXPECT_TRUE(must(check_audit(*access)).empty());
}

struct MergeOfNewer : NewerMeasures {
  std::string other = folder.file("other.db");
  [[nodiscard]] std::string copied(const std::string& name) const {
    must(store->backup(folder.file(name)));
    return folder.file(name);
  }
  static void execute(const std::string& file, const std::string& statement) {
    write_sealed(file, statement);
  }
  [[nodiscard]] std::string all_of(const std::string& file) const {
    return words(must(opened(file, OpenMode::read_only)->measures_of_all_versions(first)));
  }
};

TEST_F(MergeOfNewer, WhatOneFileHasComputedAgainComesToTheOtherWhicheverWayRound) {
  const auto without = copied("without.db");
  ASSERT_TRUE(add());
  const auto with = copied("with.db");
  for (const auto& [into, from] : {std::pair{without, with}, {with, without}, {without, with}}) {
    EXPECT_EQ(must(merge_databases(into, from)).conflicts, std::vector<Text>{});
    EXPECT_EQ(all_of(into), kBoth);
  }
}

TEST_F(MergeOfNewer, ResultsOfOneVersionThatDifferAreAConflict) {
  const auto without = copied("without.db");
  ASSERT_TRUE(add());
  const auto with = copied("with.db");
  int number = 0;
  for (const char* change : {"UPDATE measures SET value = 3.0 WHERE version = 2 AND name = 'rmse'",
                             "UPDATE measures SET value = 3.0 WHERE version = 1 AND name = 'rmse'",
                             "DELETE FROM measures WHERE version = 1 AND name = 'rmse'",
                             "DELETE FROM measures WHERE name = 'mae'"}) {
    const auto changed = copied("changed" + std::to_string(++number) + ".db");
    execute(changed, change);
    for (const auto& [into, from] : {std::pair{with, changed}, {changed, with}}) {
      const auto report = must(merge_databases(into, from));
      ASSERT_FALSE(report.conflicts.empty()) << change;
      EXPECT_NE(english(report.conflicts[0]).find("with different measures"), std::string::npos);
    }
  }
  execute(without, "DELETE FROM measures WHERE name = 'rmse'");
  EXPECT_FALSE(must(merge_databases(with, without)).conflicts.empty());
}

}  // namespace
}  // namespace isograsp::storage::newer_measures_test
