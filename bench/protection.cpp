// SPDX-License-Identifier: GPL-3.0-or-later
// What protection costs (docs/decisions): processor time of opening, writing and reading, plain and
// protected, and of encrypting the signals as well. Usage: bench_protection FOLDER
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <random>
#include <string>

#include "storage/access/access.hpp"
#include "storage/access/open_store.hpp"
#include "storage/crypto/seal.hpp"
#include "storage/person/identity.hpp"
#include "storage/records/session_store.hpp"

namespace {

using namespace isograsp;

double cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

template <class T>
T must(Result<T> result) {
  if (!result) {
    std::fprintf(stderr, "%s\n", result.error().message().c_str());
    std::exit(1);
  }
  return std::move(result).value();
}
void must(const Result<void>& result) {
  if (!result) std::exit(1);
}

template <class Work>
void report(const char* what, int times, Work work) {
  const double begin = cpu_ms();
  for (int i = 0; i < times; ++i) work();
  std::printf("  %-52s %10.3f ms\n", what, (cpu_ms() - begin) / times);
}

constexpr int kSeconds = 300;
constexpr std::size_t kRate = 100;
constexpr std::size_t kColumns = 60;

void measure(const std::string& path) {
  auto store = must(storage::open_store(path, storage::OpenMode::create));
  const storage::RowId patient = must(store->add_patient("B-1")).id;
  storage::SessionRecord session;
  session.patient_id = patient;
  session.started_utc = "2026-01-01T00:00:00Z";
  const storage::RowId session_id = must(store->begin_session(session));
  storage::TrialRecord trial;
  trial.session_id = session_id;
  trial.number = 1;
  storage::SignalGroup group{"force", {}};
  for (std::size_t c = 0; c < kColumns; ++c)
    group.columns.push_back("c" + std::to_string(c) + "_N");
  trial.groups = {group};
  trial.id = must(store->begin_trial(trial));
  std::mt19937_64 random(1);
  std::vector<double> rows(kRate * kColumns);
  double force_N = 0.0;
  for (double& value : rows) {
    force_N += static_cast<double>(random() % 11) * 0.02 - 0.1;
    value = force_N;
  }
  int second = 0;
  report("storing one second of 60 columns", kSeconds, [&] {
    must(store->append_blocks(trial.id, second++, std::vector<std::vector<double>>{rows}));
  });
  trial.status = storage::TrialStatus::completed;
  must(store->end_trial(trial, {}));
  const storage::TrialRecord stored = must(store->trials(session_id)).at(0);
  report("reading five minutes", 5, [&] { (void)must(store->signals(stored)); });
  storage::PatientProfile profile;
  profile.notes = std::string(500, 'n');
  profile.goals = std::string(100, 'g');
  constexpr int kTimes = 200;
  report("storing a profile (600 characters of free text)", kTimes,
         [&] { must(store->set_profile(patient, profile)); });
  report("reading it", kTimes, [&] { (void)must(store->profile(patient)); });
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::filesystem::path folder = argv[1];
  std::puts("plain");
  report("opening", 20,
         [&] { (void)must(storage::open_store(folder / "plain.db", storage::OpenMode::create)); });
  measure(folder / "plain.db");
  std::puts("protected");
  const storage::Secret passphrase{std::string_view("a passphrase of the clinic")};
  std::unique_ptr<storage::Access> access;
  report("making, once", 1, [&] {
    access = must(storage::Access::create(folder / "protected.db", passphrase)).access;
  });
  report("login (Argon2id, 256 MiB, 3 passes)", 3,
         [&] { must(access->log_in_with_passphrase(passphrase)); });
  report("opening, logged in", 20, [&] {
    (void)must(storage::open_store(folder / "protected.db", storage::OpenMode::existing));
  });
  measure(folder / "protected.db");
  must(storage::set_identity(*access, "B-1", {"Vera Novak", "1950-03-05", "Berlin"}));
  report("reading an identity, logged", 50,
         [&] { (void)must(storage::read_identity(*access, "B-1")); });
  std::puts("in addition, if the signals were encrypted as well");
  const storage::Secret key = storage::Secret::random(storage::kKeySize);
  const std::string block(kRate * kColumns * sizeof(double), 'x');
  report("sealing 48 kB (one second, not compressed)", 200,
         [&] { (void)storage::seal(key, "", block); });
  return 0;
}
