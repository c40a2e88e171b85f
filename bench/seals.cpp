// SPDX-License-Identifier: GPL-3.0-or-later
// What the seals of rows cost; bench/report/seals.py compiles it with a commit of format 8 as well
// and makes the table of docs/storage.md. Prints one `name value` a line. Trials of five minutes,
// 60 columns in four groups at 100 Hz, 20 measures each.
//   bench_seals record FOLDER          closing trials and sessions, bytes per minute
//   bench_seals make FILE GIGABYTES    a clinic with so much in it
//   bench_seals clinic FOLDER          2,000 sessions: opening, login, check
//   bench_seals open FILE              opening and checking a file that is there
//   bench_seals migrate FILE
//   bench_seals close FOLDER plain|protected SECONDS
//       four trials of so many seconds; valgrind counts what closing them takes (end_counted_trial)
//       and what ending their session does (end_counted_session): its row, then every trial read
//       back
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "storage/access/access.hpp"
#include "storage/access/open_store.hpp"
#include "storage/access/protection.hpp"
#include "storage/care/migration.hpp"
#include "storage/crypto/seal.hpp"
#include "storage/file/file_stats.hpp"
#include "storage/records/session_store.hpp"
#include "tests/support/must.hpp"

namespace isograsp {

namespace {

using storage::OpenMode;
using storage::RowId;
using test::must;

constexpr int kRate_Hz = 100;
constexpr std::size_t kColumns = 15;  // of each of the four groups
constexpr std::size_t kMeasures = 20;

double clock_ms(clockid_t which) {
  timespec now{};
  clock_gettime(which, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Medians on the clock and of the processor.
class Times {
 public:
  void of(const std::function<void()>& work) {
    const double before = clock_ms(CLOCK_MONOTONIC);
    const double own = clock_ms(CLOCK_PROCESS_CPUTIME_ID);
    work();
    processor_.push_back(clock_ms(CLOCK_PROCESS_CPUTIME_ID) - own);
    wall_.push_back(clock_ms(CLOCK_MONOTONIC) - before);
  }
  void print(const char* name) const {
    std::printf("%s_ms %.3f\n%s_processor_ms %.3f\n", name, median(wall_), name,
                median(processor_));
  }

 private:
  static double median(std::vector<double> all) {
    std::sort(all.begin(), all.end());
    return all[all.size() / 2];
  }
  std::vector<double> wall_;
  std::vector<double> processor_;
};

/// Of one second, by group.
using Second = std::vector<std::vector<double>>;

/// Noise of a few counts on slow waves, as sensors give it.
Second second_of_signals(std::mt19937_64& random) {
  std::normal_distribution<double> noise(0.0, 2.0);
  Second groups(4);
  for (int row = 0; row < kRate_Hz; ++row)
    for (std::size_t g = 0; g < groups.size(); ++g)
      for (std::size_t c = 0; c < kColumns; ++c) {
        const double t_s = static_cast<double>(row) / kRate_Hz;
        const double counts =
            std::round(4000.0 * std::sin(t_s + static_cast<double>(c)) + noise(random));
        groups[g].push_back(g == 1 ? counts : 0.001 * counts);
      }
  return groups;
}

/// The same minute for every trial: making it would take longer than storing it.
std::vector<Second> minute_of_signals() {
  constexpr std::size_t kSeconds = 60;
  std::mt19937_64 random(7);
  std::vector<Second> all(kSeconds);
  for (Second& one : all) one = second_of_signals(random);
  return all;
}

storage::TrialRecord described(RowId session, int number) {
  storage::TrialRecord trial;
  trial.session_id = session;
  trial.number = number;
  trial.task_name = "bench";
  trial.task_text = std::string(1500, 't');
  trial.references = {{"maximum_force_N", 20.0}, {"resting_force_N", 0.5}};
  for (const char* name : {"force", "raw", "object", "task"}) {
    storage::SignalGroup group{name, {}};
    for (std::size_t c = 0; c < kColumns; ++c) group.columns.push_back(name + std::to_string(c));
    trial.groups.push_back(group);
  }
  return trial;
}

std::vector<Measure> measures() {
  std::vector<Measure> all(kMeasures);
  for (std::size_t m = 0; m < all.size(); ++m) {
    all[m].name = "measure" + std::to_string(m);
    all[m].unit = "N";
    all[m].value = 0.1 * static_cast<double>(m + 1);
  }
  return all;
}

RowId new_session(storage::SessionStore& store, RowId patient) {
  storage::SessionRecord session;
  session.patient_id = patient;
  session.rate_Hz = kRate_Hz;
  session.sensors = {{"thumb", "1"}, {"index", "2"}, {"middle", "3"}};
  return must(store.begin_session(session));
}

/// By its name valgrind knows what to count.
[[gnu::noinline]] void end_counted_trial(storage::SessionStore& store,
                                         const storage::TrialRecord& trial,
                                         const std::vector<Measure>& results) {
  must(store.end_trial(trial, results));
}

/// As the program ends a session: every trial is read once more, each through a connection of its
/// own.
[[gnu::noinline]] void end_counted_session(storage::SessionStore& store, RowId session,
                                           std::size_t trials) {
  must(store.end_session(session));
  for (std::size_t trial = 0; trial < trials; ++trial) {
    const auto other = must(storage::open_store(store.path(), OpenMode::read_only));
    static_cast<void>(must(other->signals(must(other->trials(session)).at(trial))));
  }
}

/// `closing`: what ending it takes.
void record_trial(storage::SessionStore& store, RowId session, int number, int seconds,
                  const std::vector<Second>& minute, Times& closing) {
  storage::TrialRecord trial = described(session, number);
  trial.id = must(store.begin_trial(trial));
  for (int second = 0; second < seconds; ++second)
    must(store.append_blocks(trial.id, second,
                             minute[static_cast<std::size_t>(second) % minute.size()]));
  trial.status = storage::TrialStatus::completed;
  const auto results = measures();
  closing.of([&] { end_counted_trial(store, trial, results); });
}

storage::Secret passphrase() {
  return storage::Secret{std::string_view("a passphrase of the clinic")};
}

std::unique_ptr<storage::Access> protected_one(const std::string& path) {
  return must(storage::Access::create(path, passphrase(), &storage::kCheapKeyCost)).access;
}

void record(const std::string& folder) {
  constexpr int kSessions = 10;
  constexpr int kTrials = 6;
  constexpr int kSeconds = 300;
  constexpr int kShort_s = 20;
  const auto minute = minute_of_signals();
  for (const bool is_protected : {false, true}) {
    const std::string kind = is_protected ? "protected" : "plain";
    const std::string path = folder + "/" + kind + ".db";
    std::unique_ptr<storage::Access> access;
    if (is_protected) access = protected_one(path);
    const auto store = must(storage::open_store(path, OpenMode::create));
    const RowId patient = must(store->add_patient("BENCH-1")).id;
    Times closing;
    Times closing_short;
    Times ending;
    for (int s = 0; s < kSessions; ++s) {
      const RowId session = new_session(*store, patient);
      for (int number = 1; number <= kTrials; ++number)
        record_trial(*store, session, number, number == 1 ? kSeconds : kShort_s, minute,
                     number == 1 ? closing : closing_short);
      ending.of([&] { must(store->end_session(session)); });
    }
    closing.print(("closing_" + kind).c_str());
    closing_short.print(("closing_short_" + kind).c_str());
    ending.print(("ending_" + kind).c_str());
    const auto stats = must(storage::file_stats(path));
    std::printf("kilobytes_a_minute_%s %.2f\n", kind.c_str(), 1e-3 * stats.bytes_per_minute());
  }
}

void close(const std::string& folder, bool is_protected, int seconds) {
  constexpr int kTrials = 4;
  const auto minute = minute_of_signals();
  const std::string path = folder + "/closed.db";
  std::unique_ptr<storage::Access> access;
  if (is_protected) access = protected_one(path);
  const auto store = must(storage::open_store(path, OpenMode::create));
  const RowId session = new_session(*store, must(store->add_patient("BENCH-1")).id);
  Times closing;
  for (int number = 1; number <= kTrials; ++number)
    record_trial(*store, session, number, seconds, minute, closing);
  end_counted_session(*store, session, kTrials);
}

/// Of sessions with six trials each.
int make(const std::string& path, int sessions, int seconds, std::uintmax_t most_bytes) {
  const auto store = must(storage::open_store(path, OpenMode::scratch));
  const auto minute = minute_of_signals();
  Times closing;
  int made = 0;
  for (; made < sessions && std::filesystem::file_size(path) < most_bytes; ++made) {
    constexpr int kSessionsOfOne = 20;
    const std::string code = "BENCH-" + std::to_string(made / kSessionsOfOne + 1);
    auto patient = must(store->find_patient(code));
    if (!patient) {
      patient = must(store->add_patient(code));
      storage::PatientProfile profile;
      profile.notes = std::string(500, 'n');
      must(store->set_profile(patient->id, profile));
    }
    const RowId session = new_session(*store, patient->id);
    for (int number = 1; number <= 6; ++number)
      record_trial(*store, session, number, seconds, minute, closing);
    must(store->end_session(session));
  }
  return made;
}

void open(const std::string& path, const std::string& kind) {
  Times opening;
  for (int round = 0; round < 11; ++round)
    opening.of([&] { static_cast<void>(must(storage::open_store(path, OpenMode::existing))); });
  opening.print(("opening_" + kind).c_str());
  const auto store = must(storage::open_store(path, OpenMode::existing));
  Times first;
  first.of([&] { must(store->set_profile(1, {})); });
  first.print(("first_change_" + kind).c_str());
  Times checking;
  checking.of([&] {
    if (!must(store->check()).empty()) throw std::runtime_error("the file is not sound");
  });
  checking.print(("check_" + kind).c_str());
}

void log_in(const std::string& path, const char* name) {
  Times login;
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds; ++round) {
    const auto access = must(storage::Access::open(path));
    login.of([&] { must(access->log_in_with_passphrase(passphrase())); });
  }
  login.print(name);
}

void clinic(const std::string& folder) {
  constexpr int kSessions = 2000;
  const std::string path = folder + "/clinic.db";
  constexpr auto kNoLimit = static_cast<std::uintmax_t>(-1);
  static_cast<void>(make(path, kSessions, 1, kNoLimit));
  std::printf("clinic_bytes %.0f\n", static_cast<double>(std::filesystem::file_size(path)));
  open(path, "plain");
  const std::string small = folder + "/small.db";
  const auto made = must(storage::Access::create(small, passphrase(), nullptr));
  log_in(small, "login_of_nothing");
  const auto done = must(storage::protect_database(path, passphrase(), nullptr));
  log_in(path, "login");
  open(path, "protected");
}

void migrate(const std::string& path) {
  std::printf("file_bytes %.0f\n", static_cast<double>(std::filesystem::file_size(path)));
  Times migrating;
  migrating.of([&] { static_cast<void>(must(storage::migrate_database(path))); });
  migrating.print("migrate");
}

}  // namespace

}  // namespace isograsp

int main(int argc, char** argv) {
  using namespace isograsp;
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  const std::string act = argc > 2 ? argv[1] : "";
  const std::string where = argc > 2 ? argv[2] : "";
  try {
    if (act == "record") {
      record(where);
    } else if (act == "make" && argc == 4) {
      constexpr int kManySessions = 1 << 20;
      constexpr int kSeconds = 300;
      const auto bytes = static_cast<std::uintmax_t>(1e9 * std::stod(argv[3]));
      std::printf("sessions %d\n", make(where, kManySessions, kSeconds, bytes));
    } else if (act == "close" && argc == 5) {
      close(where, std::string(argv[3]) == "protected", std::stoi(argv[4]));
    } else if (act == "clinic") {
      clinic(where);
    } else if (act == "open") {
      open(where, "file");
    } else if (act == "migrate") {
      migrate(where);
    } else {
      return 2;
    }
  } catch (const std::exception& why) {
    std::fprintf(stderr, "bench_seals: %s\n", why.what());
    return 1;
  }
  return 0;
}
