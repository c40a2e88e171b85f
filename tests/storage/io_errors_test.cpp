// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever SQLite asks of the system is refused, call by call, while records are written and
// files cared for: each act ends with a sentence, the file is sound, holds what it held before or
// all of the act, and the same act succeeds once the system answers again.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <set>

#include "storage/access/protection.hpp"
#include "storage/care/backups.hpp"
#include "storage/care/merge.hpp"
#include "storage/care/migration.hpp"
#include "storage/crypto/content_hash.hpp"
#include "storage/file/database.hpp"
#include "storage/person/erasure.hpp"
#include "storage/person/identity.hpp"
#include "tests/storage/clinic_under_attack.hpp"
#include "tests/storage/failing_sqlite.hpp"
#include "tests/support/every.hpp"

namespace isograsp::storage::io_errors_test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kRows = 100;
constexpr int kSeconds = 3;

Secret passphrase() {
  return secret("the clinic's passphrase");
}

/// Where an act is done, and what the program that did it was told.
struct Place {
  std::string folder;
  bool is_protected = false;
  std::function<void()> arm = [] {};  ///< from here on calls fail
  int confirmed_s = -1;               ///< of the trial that was begun; -1: none was

  [[nodiscard]] std::string file(const char* name) const { return folder + "/" + name; }
  [[nodiscard]] std::string clinic() const { return file("clinic.db"); }
};

/// Opens what `path` is and logs in.
Result<std::unique_ptr<Access>> logged_in(const std::string& path) {
  auto access = Access::open(path);
  if (access && (*access)->is_protected())
    if (const auto in = (*access)->log_in_with_passphrase(passphrase()); !in) return in.error();
  return access;
}

/// As `record` of the attacks, years ago, so that it may be erased.
void record_old(const std::string& path, const char* code, const char* note) {
  const auto store = opened(path);
  const RowId patient = must(store->add_patient(code, "2020-01-01T08:00:00Z")).id;
  must(store->set_profile(patient, {Side::left, {}, "", note, ""}));
  SessionRecord session = example_session(patient);
  session.started_utc = "2020-02-28T08:00:00Z";
  session.id = must(store->begin_session(session, {}));
  TrialRecord trial = example_trial(session.id);
  trial.id = must(store->begin_trial(trial));
  must(store->append_blocks(trial.id, 0, example_rows(trial, kRows, 1)));
  trial.status = TrialStatus::completed;
  must(store->end_trial(trial, std::vector<Measure>{{"rmse", "force", 0.25, "N", 1, 100, 0, ""}}));
  must(store->end_session(session.id, "2020-02-28T09:00:00Z"));
}

void make_clinic(const Place& place) {
  std::unique_ptr<Access> access;
  if (place.is_protected) access = make_protected(place.clinic()).access;
  record_old(place.clinic(), "P-1", "SECRETNOTE");
  record_old(place.clinic(), "P-2", "another note");
}
void make_old_clinic(const Place& place) {
  fs::copy_file(std::string(ISOGRASP_SOURCE_DIR) + "/tests/data/format_" +
                    (place.is_protected ? "8_protected" : "7_session") + ".db",
                place.clinic());
}
void make_two_stations(const Place& place) {
  make_clinic(place);
  record_old(place.file("station.db"), "P-3", "note of the other station");
}
void make_backup(const Place& place) {
  make_clinic(place);
  const auto access = must(logged_in(place.clinic()));
  must(opened(place.clinic(), OpenMode::read_only)->backup(place.file("backup.db")));
  record_old(place.clinic(), "P-3", "after the backup");
}

Result<void> begin(Place& place) {
  place.arm();
  const auto access = logged_in(place.clinic());
  if (!access) return access.error();
  const auto store = open_store(place.clinic(), OpenMode::existing);
  if (!store) return store.error();
  const auto patient = (*store)->find_patient("P-1");
  if (!patient) return patient.error();
  if (!*patient) return failed("P-1 is not found"_text, ""_text);
  const std::vector<SessionAnswer> answers{{"posture", "seat", "chair"}};
  const auto session = (*store)->begin_session(example_session((*patient)->id), answers);
  if (!session) return session.error();
  return {};
}

/// A trial and its seconds; `end`: only its end fails.
Result<void> recorded(Place& place, bool end) {
  if (!end) place.arm();
  const auto access = logged_in(place.clinic());
  if (!access) return access.error();
  const auto store = open_store(place.clinic(), OpenMode::existing);
  if (!store) return store.error();
  const auto session = (*store)->begin_session(example_session(1));
  if (!session) return session.error();
  TrialRecord trial = example_trial(*session);
  const auto id = (*store)->begin_trial(trial);
  if (!id) return id.error();
  trial.id = *id;
  place.confirmed_s = 0;
  for (int second = 0; second < kSeconds; ++second) {
    const auto rows = example_rows(trial, kRows, static_cast<unsigned>(second));
    if (const auto done = (*store)->append_blocks(trial.id, second, rows); !done) return done;
    place.confirmed_s = second + 1;
  }
  if (!end) return {};
  place.arm();
  trial.status = TrialStatus::completed;
  const std::vector<Measure> measures{{"rmse", "force", 0.25, "N", 1, 100, 0, ""}};
  if (const auto done = (*store)->end_trial(trial, measures); !done) return done;
  if (const auto noted = (*store)->add_event(*session, {trial.id, 1.0, "note", "tired"}); !noted)
    return noted;
  return (*store)->end_session(*session);
}
Result<void> record_trial(Place& place) {
  return recorded(place, false);
}
Result<void> end(Place& place) {
  return recorded(place, true);
}

Result<void> migrate(Place& place) {
  place.arm();
  std::unique_ptr<Access> access;
  if (place.is_protected) {
    auto opened = Access::open_to_migrate(place.clinic());
    if (!opened) return opened.error();
    access = *std::move(opened);
    if (auto in = access->log_in_with_passphrase(secret("the clinic's passphrase")); !in) return in;
  }
  const auto done = migrate_database(place.clinic());
  if (!done) return done.error();
  return {};
}

Result<void> merge(Place& place) {
  place.arm();
  const auto report = merge_databases(place.clinic(), place.file("station.db"));
  if (!report) return report.error();
  if (!report->conflicts.empty()) return failed(report->conflicts.front(), "merge again"_text);
  return {};
}

Result<void> erase(Place& place) {
  place.arm();
  const auto access = logged_in(place.clinic());
  if (!access) return access.error();
  const auto done = erase_patient(**access, "P-1", "asked for it");
  if (!done) return done.error();
  if (done->not_swept) return *done->not_swept;
  return {};
}

Result<void> protect(Place& place) {
  place.arm();
  const auto done = protect_database(place.clinic(), passphrase(), &kCheapKeyCost);
  if (!done) return done.error();
  if (done->not_swept) return *done->not_swept;
  return {};
}

Result<void> back_up(Place& place) {
  place.arm();
  const auto access = logged_in(place.clinic());
  if (!access) return access.error();
  const auto store = open_store(place.clinic(), OpenMode::read_only);
  if (!store) return store.error();
  return (*store)->backup(place.file("copy.db"));
}

Result<void> restore(Place& place) {
  place.arm();
  const auto done = restore_backup(place.file("backup.db"), place.clinic(), logged_in);
  if (!done) return done.error();
  return {};
}

struct Act {
  const char* name;
  void (*prepare)(const Place&);
  Result<void> (*run)(Place&);
  bool also_protected;
  /// It is done wholly or not at all, and succeeds when it is asked for again.
  bool all_or_nothing;
};
constexpr std::array kActs{Act{"Begin", make_clinic, begin, true, false},
                           Act{"Record", make_clinic, record_trial, true, false},
                           Act{"End", make_clinic, end, true, false},
                           Act{"Migrate", make_old_clinic, migrate, true, true},
                           Act{"Merge", make_two_stations, merge, false, true},
                           Act{"Erase", make_clinic, erase, true, true},
                           Act{"Protect", make_clinic, protect, false, true},
                           Act{"BackUp", make_clinic, back_up, true, true},
                           Act{"Restore", make_backup, restore, true, true}};

struct Failure {
  const char* name;
  Asked what;
  bool for_good;
};
constexpr std::array kFailures{Failure{"Read", Asked::read, false},
                               Failure{"ReadForGood", Asked::read, true},
                               Failure{"Write", Asked::write, false},
                               Failure{"WriteForGood", Asked::write, true},
                               Failure{"Sync", Asked::sync, false},
                               Failure{"SyncForGood", Asked::sync, true},
                               Failure{"Truncate", Asked::truncate, false},
                               Failure{"TruncateForGood", Asked::truncate, true},
                               Failure{"Open", Asked::open, false},
                               Failure{"OpenForGood", Asked::open, true},
                               Failure{"Remove", Asked::remove, true},
                               Failure{"Size", Asked::size, false},
                               Failure{"Map", Asked::map, false},
                               Failure{"Memory", Asked::memory, false},
                               Failure{"MemoryForGood", Asked::memory, true}};

bool has_log(soci::session& sql) {
  int tables = 0;
  sql << "SELECT count(*) FROM sqlite_schema WHERE name = 'audit_log'", soci::into(tables);
  return tables > 0;
}

/// What a file holds, in numbers that are the same whenever an act is done.
std::string picture_of(const std::string& path) {
  soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
  std::string all;
  const auto add = [&](const std::string& query) {
    std::string one;
    soci::indicator there = soci::i_null;
    sql << query, soci::into(one, there);
    all += (all.empty() ? "" : " ") + (there == soci::i_ok ? one : "-");
  };
  add("SELECT user_version || ' format' FROM pragma_user_version");
  for (const char* table :
       {"patients", "sessions", "trials", "measures", "session_answers", "patient_profiles"})
    add("SELECT count(*) || ' " + std::string(table) + "' FROM " + table);
  add("SELECT count(*) || ' ended' FROM sessions WHERE ended_utc IS NOT NULL");
  add("SELECT group_concat(status, ',') FROM (SELECT status FROM trials ORDER BY id)");
  add("SELECT count(*) || ' notes' FROM events WHERE kind = 'note'");
  if (has_log(sql))
    add("SELECT group_concat(act, ',') FROM (SELECT act FROM audit_log WHERE act IN ('restore', "
        "'merge', 'erase', 'protect') AND result = 'done' ORDER BY id)");
  return all;
}

/// Sound, with an audit log that proves; whoever has the passphrase is let in. Empty: all is well.
std::string wrong_with(const std::string& path) {
  const bool is_old = picture_of(path).find(std::to_string(kDatabaseFormat) + " format") != 0;
  if (is_old && is_protected_database(path)) return "";  // opens for a migration only
  const auto access =
      is_old ? Result<std::unique_ptr<Access>>(std::unique_ptr<Access>()) : logged_in(path);
  if (!is_old && !access) return "nobody can log in: " + access.error().message();
  const auto store = open_store(path, is_old ? OpenMode::read_only : OpenMode::existing);
  if (!store) return "cannot be opened: " + store.error().message();
  const auto problems = (*store)->check();
  if (!problems) return "cannot be checked: " + problems.error().message();
  return problems->empty() ? "" : "is not sound: " + english(problems->front());
}

/// Every second that was confirmed can be read, and at most one more.
std::string wrong_with_trial(const Place& place) {
  if (place.confirmed_s < 0) return "";
  const auto access = must(logged_in(place.clinic()));
  const auto store = opened(place.clinic(), OpenMode::existing);
  const auto sessions = must(store->recent_sessions(1));
  const auto trials = must(store->trials(sessions.at(0).id));
  if (trials.empty()) return "the trial is lost";
  const auto stored = static_cast<int>(trials[0].samples / static_cast<std::int64_t>(kRows));
  if (stored < place.confirmed_s || stored > place.confirmed_s + 1)
    return std::to_string(stored) + " s of " + std::to_string(place.confirmed_s);
  const auto signals = store->signals(trials[0]);
  if (!signals) return signals.error().message();
  for (int second = 0; second < stored; ++second)
    if (!same_bits(signals->column(0)[static_cast<std::size_t>(second) * kRows],
                   example_rows(trials[0], kRows, static_cast<unsigned>(second))[0][0]))
      return "a value is another one";
  return "";
}

std::string wrong_with_sentence(const Error& error) {
  const std::string said = error.message();
  for (const char* bad : {"bad_alloc", "std::", "\n", "basic_string", "UNKNOWN"})
    if (said.find(bad) != std::string::npos) return "is no sentence: " + said;
  return error.remedy.empty() || english(error.what).empty() ? "says nothing: " + said : "";
}

/// Of every byte of every file of a folder.
std::string state_of(const std::string& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  ContentHasher whole;
  for (const fs::path& file : files) {
    whole.add_text(fs::relative(file, folder).string());
    whole.add_text(bytes_of(file.string()));
  }
  return std::string(bytes_of(whole.hash()));
}

using Case = std::tuple<Act, Failure, bool>;
struct InputOutput : testing::TestWithParam<Case> {};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const Act& act : kActs)
    for (const Failure& failure : kFailures)
      for (const bool is_protected : {false, true})
        if (!is_protected || act.also_protected) all.emplace_back(act, failure, is_protected);
  return all;
}
std::string name_of_case(const testing::TestParamInfo<Case>& one) {
  const auto& [act, failure, is_protected] = one.param;
  return std::string(act.name) + failure.name + (is_protected ? "Protected" : "");
}
INSTANTIATE_TEST_SUITE_P(, InputOutput, testing::ValuesIn(cases()), name_of_case);

TEST_P(InputOutput, AtAnyCallEndsWithASentenceAndASoundFile) {
  const auto& [act, failure, is_protected] = GetParam();
  const TemporaryFolder before;
  act.prepare({before.path(), is_protected});
  FailingSqlite sqlite;
  const auto fresh = [&](const TemporaryFolder& folder) {
    fs::copy(before.path(), folder.path(), fs::copy_options::recursive);
    return Place{folder.path(), is_protected};
  };
  // How many calls there are, and what the act makes of the file.
  std::string after;
  int calls = 0;
  {
    const TemporaryFolder folder;
    Place place = fresh(folder);
    place.arm = [&, what = failure.what] { sqlite.fail(what, 0); };
    must(act.run(place));
    calls = sqlite.heal();
    ASSERT_EQ(wrong_with(place.clinic()), "");
    after = picture_of(place.clinic());
  }
  const std::string unchanged = picture_of(before.file("clinic.db"));
  // scripts/test --long sets it: every call (for memory: from every place), else kPoints of them.
  constexpr std::size_t kPoints = 2;
  const bool every_call = std::getenv("ISOGRASP_LONG") != nullptr;
  std::vector<int> numbers = sqlite.calls_by_place();
  if (failure.what != Asked::memory) {
    numbers.resize(static_cast<std::size_t>(calls));
    std::iota(numbers.begin(), numbers.end(), 1);
  }
  const std::size_t step = every_call ? 1 : std::max<std::size_t>(1, numbers.size() / kPoints);
  // What a refusal left of the files decides all that follows: most leave every byte as it was.
  std::set<std::string> proved;
  bool through = false;
  int errors = 0;
  for (std::size_t point = step / 2; !through; point += step) {
    const int nth = point < numbers.size() ? numbers[point]
                                           : calls + 1 + static_cast<int>(point - numbers.size());
    constexpr std::size_t kPointsToTell = 500;
    if (every_call && point % kPointsToTell == 0)
      std::printf("%zu of %zu\n", point, numbers.size());
    const TemporaryFolder folder;
    Place place = fresh(folder);
    place.arm = [&, how = failure] { sqlite.fail(how.what, nth, how.for_good); };
    const auto done = act.run(place);
    sqlite.heal();
    through = !sqlite.has_failed();
    SCOPED_TRACE("call " + std::to_string(nth) + " of " + std::to_string(calls) + ": " +
                 (done ? "done" : done.error().message()));
    if (!done) {
      ++errors;
      EXPECT_EQ(wrong_with_sentence(done.error()), "");
    }
    ASSERT_TRUE(done || !through) << "nothing was refused to it";
    if (!done && place.confirmed_s < 0 && !proved.insert(state_of(place.folder)).second) {
      ASSERT_FALSE(HasFailure());
      continue;
    }
    EXPECT_EQ(wrong_with(place.clinic()), "");
    EXPECT_EQ(wrong_with_trial(place), "");
    const std::string picture = picture_of(place.clinic());
    EXPECT_TRUE(picture == after || (!done && !act.all_or_nothing) ||
                (!done && picture == unchanged))
        << picture;
    if (!done && act.all_or_nothing) {
      fs::remove(place.file("copy.db"));
      place.arm = [] {};
      const auto again = act.run(place);
      EXPECT_TRUE(again.ok()) << "again: " << again.error().message();
      EXPECT_EQ(wrong_with(place.clinic()), "");
      EXPECT_EQ(picture_of(place.clinic()), after);
    }
    ASSERT_FALSE(HasFailure());
    ASSERT_LT(nth, 2 * calls + 1000);
  }
  RecordProperty("calls", calls);
  RecordProperty("places", static_cast<int>(numbers.size()));
  RecordProperty("errors", errors);
  RecordProperty("states", static_cast<int>(proved.size()));
  // One refusal may be survived, as while a trial is packed; the others are asked for in few acts,
  // or their refusal is taken for an answer.
  if (calls > 1 && (failure.for_good || every_call) &&
      (failure.what == Asked::read || failure.what == Asked::write || failure.what == Asked::sync ||
       failure.what == Asked::memory)) {
    EXPECT_GT(errors, 0);
  }
}

/// Out of memory SQLite may roll back by itself; what the program goes on to write would be stored
/// statement by statement.
TEST(ATransactionThatWasGivenUp, IsAnErrorAndStoresNothingOfWhatFollows) {
  const TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  must(opened(path)->add_patient("P-1"));
  auto database = must(Database::open(path, OpenMode::existing));
  for (const bool goes_on : {false, true}) {
    const auto done = database.transact("testing"_text, [&] {
      database.sql() << "UPDATE patients SET created_utc = 'first'";
      database.sql() << "ROLLBACK";
      if (goes_on) database.sql() << "UPDATE patients SET created_utc = 'second'";
    });
    EXPECT_NE(refusal(done).find("there is not enough memory"), std::string::npos) << refusal(done);
  }
  EXPECT_TRUE(must(opened(path, OpenMode::existing)->check()).empty());
  must(database.transact("testing"_text,
                         [&] { database.sql() << "UPDATE patients SET created_utc = 'third'"; }));
  EXPECT_EQ(must(opened(path, OpenMode::existing)->patients()).at(0).created_utc, "third");
}

}  // namespace
}  // namespace isograsp::storage::io_errors_test
