// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/clinic.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "app/console.hpp"
#include "app/paths.hpp"
#include "app/run.hpp"
#include "core/time.hpp"
#include "storage/session_store.hpp"

namespace isograsp {

namespace {

namespace fs = std::filesystem;

struct Enrolled {
  const char* person;
  const char* course;
};
constexpr std::array<Enrolled, 12> kEnrolled{{{"mild", "recovery"},
                                              {"moderate", "recovery"},
                                              {"severe", "recovery"},
                                              {"spastic", "botulinum"},
                                              {"opening_loss", "recovery"},
                                              {"direction_error", "plateau"},
                                              {"arm_push", "plateau"},
                                              {"sensory_loss", "recovery"},
                                              {"inattention", "plateau"},
                                              {"fatiguing", "loosened_strap"},
                                              {"moderate", "decline"},
                                              {"slow_wander", "plateau"}}};
constexpr int kSessions = 20;
constexpr int kDaysBetween = 3;
/// Fixed, so that the clinic is the same whenever it is made.
constexpr const char* kFirstDay = "2026-01-05T09:00:00Z";

std::string date_of(int day) {
  constexpr std::time_t kSecondsPerDay = 86400;
  return utc_text(*time_of_utc(kFirstDay) + day * kSecondsPerDay);
}

std::string code_of(std::size_t patient) {
  const std::string number = std::to_string(patient + 1);
  return "CLINIC-" + std::string(number.size() < 2 ? "0" : "") + number;
}

/// Removes the parts of a clinic however its making ends.
class Parts {
 public:
  explicit Parts(const std::string& database) : database_(database) {}
  ~Parts() {
    for (std::size_t patient = 0; patient < kEnrolled.size(); ++patient)
      for (const char* suffix : {"", "-wal", "-shm", "-lock"}) {
        std::error_code ignored;
        fs::remove(path(patient) + suffix, ignored);
      }
  }
  [[nodiscard]] std::string path(std::size_t patient) const {
    return database_ + "." + code_of(patient) + ".part";
  }

 private:
  std::string database_;
};

/// All sessions of one patient, in order: training goes on where it stopped.
Result<void> make_patient(std::size_t patient, const std::string& database,
                          std::atomic<int>& sessions_made) {
  RunOptions options;
  options.protocol_file = library_folder() + "/protocols/training.toml";
  options.database = database;
  options.patient = code_of(patient);
  options.fast = true;
  options.quiet = true;
  for (int session = 0; session < kSessions; ++session) {
    const int day = kDaysBetween * session;
    constexpr int kSeedsPerPatient = 1000;
    const int seed = kSeedsPerPatient * static_cast<int>(patient + 1);
    options.device = std::string("sim://") + kEnrolled[patient].person +
                     "?seed=" + std::to_string(seed) + "&course=" + kEnrolled[patient].course +
                     "&day=" + std::to_string(day);
    options.started_utc = date_of(day);
    if (auto done = run_session(options); !done) return done;
    ++sessions_made;
  }
  return {};
}

}  // namespace

Result<void> make_clinic(const std::string& database, int threads) {
  std::error_code ignored;
  if (fs::exists(database, ignored))
    return Error{Error::Code::bad_input, "exists already", "name a new file", database, 0, ""};
  const Parts parts(database);
  std::atomic<std::size_t> next{0};
  std::atomic<int> sessions_made{0};
  std::atomic<bool> failed{false};
  std::mutex problem_mutex;
  std::optional<Error> problem;
  std::vector<std::thread> workers;
  std::atomic<int> at_work{std::clamp(threads, 1, static_cast<int>(kEnrolled.size()))};
  for (int worker = at_work; worker > 0; --worker)
    workers.emplace_back([&] {
      for (std::size_t patient = next++; patient < kEnrolled.size() && !failed; patient = next++) {
        const auto done = make_patient(patient, parts.path(patient), sessions_made);
        if (done) continue;
        failed = true;
        const std::lock_guard lock(problem_mutex);
        if (!problem) problem = done.error();
      }
      --at_work;
    });
  ProgressBar bar("Making the clinic");
  constexpr double kAll = static_cast<double>(kSessions) * kEnrolled.size();
  while (at_work > 0) {
    bar.show(sessions_made / kAll, std::to_string(sessions_made) + " sessions");
    constexpr auto kLook = std::chrono::milliseconds(50);
    std::this_thread::sleep_for(kLook);
  }
  for (auto& worker : workers) worker.join();
  if (problem) return *problem;
  // One after the other, so that the file does not depend on who was first.
  const auto clinic = SessionStore::open(database, SessionStore::Open::create);
  if (!clinic) return clinic.error();
  for (std::size_t patient = 0; patient < kEnrolled.size(); ++patient) {
    bar.show(1.0, "putting together " + code_of(patient));
    if (auto done = (*clinic)->absorb(parts.path(patient)); !done) return done;
  }
  bar.end();
  return {};
}

}  // namespace isograsp
