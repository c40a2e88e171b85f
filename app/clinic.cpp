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
#include "storage/merge.hpp"
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

/// Removes the files that a clinic is made with however its making ends.
class Parts {
 public:
  explicit Parts(const std::string& database) : database_(database) {}
  ~Parts() {
    for (std::size_t patient = 0; patient < kEnrolled.size(); ++patient) remove(path(patient));
    remove(whole());
  }
  [[nodiscard]] std::string path(std::size_t patient) const {
    return database_ + "." + code_of(patient) + ".part";
  }
  /// The clinic itself: it gets its name when it is complete.
  [[nodiscard]] std::string whole() const { return database_ + ".part"; }
  static void remove(const std::string& part) {
    for (const char* suffix : {"", "-wal", "-shm", "-lock"}) {
      std::error_code ignored;
      fs::remove(part + suffix, ignored);
    }
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
  options.scratch = true;
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

/// Makes the patients on several threads.
class Workers {
 public:
  Workers(const Parts& parts, int threads) {
    for (int worker = std::clamp(threads, 1, static_cast<int>(kEnrolled.size())); worker > 0;
         --worker)
      threads_.emplace_back([this, &parts] {
        for (std::size_t patient = next_++; patient < kEnrolled.size() && !stop_; patient = next_++)
          if (auto done = make_patient(patient, parts.path(patient), sessions_made_); done)
            made_[patient] = true;
          else
            fail(done.error());
      });
  }
  ~Workers() {
    stop_ = true;
    for (auto& thread : threads_) thread.join();
  }
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// Waits until this patient is made.
  [[nodiscard]] Result<void> wait_for(std::size_t patient, ProgressBar& bar) {
    constexpr double kAll = static_cast<double>(kSessions) * kEnrolled.size();
    while (!made_[patient]) {
      bar.show(sessions_made_ / kAll, std::to_string(sessions_made_) + " sessions");
      constexpr auto kLook = std::chrono::milliseconds(50);
      std::this_thread::sleep_for(kLook);
      const std::lock_guard lock(mutex_);
      if (problem_) return *problem_;
    }
    return {};
  }

 private:
  void fail(const Error& problem) {
    stop_ = true;
    const std::lock_guard lock(mutex_);
    if (!problem_) problem_ = problem;
  }

  std::atomic<std::size_t> next_{0};
  std::atomic<int> sessions_made_{0};
  std::atomic<bool> stop_{false};
  std::array<std::atomic<bool>, kEnrolled.size()> made_{};
  std::mutex mutex_;
  std::optional<Error> problem_;
  std::vector<std::thread> threads_;
};

/// One patient after the other, so that the file does not depend on who was made first.
Result<void> put_together(const Parts& parts, Workers& workers) {
  // Simulated people: the file can be made again, and is the same each time.
  constexpr auto kHow = SessionStore::Open::scratch;
  if (const auto clinic = SessionStore::open(parts.whole(), kHow); !clinic) return clinic.error();
  ProgressBar bar("Making the clinic");
  for (std::size_t patient = 0; patient < kEnrolled.size(); ++patient) {
    if (auto made = workers.wait_for(patient, bar); !made) return made;
    if (const auto done = merge_databases(parts.whole(), parts.path(patient), {}, kHow); !done)
      return done.error();
    Parts::remove(parts.path(patient));
  }
  bar.end();
  return {};
}

}  // namespace

Result<void> make_clinic(const std::string& database, int threads) {
  std::error_code failure;
  if (fs::exists(database, failure))
    return Error{Error::Code::bad_input, "exists already", "name a new file", database, 0, ""};
  const Parts parts(database);
  Workers workers(parts, threads);
  if (auto done = put_together(parts, workers); !done) return done;
  fs::rename(parts.whole(), database, failure);
  if (failure)
    return Error{Error::Code::failed,
                 "could not be made: " + failure.message(),
                 "choose another folder",
                 database,
                 0,
                 ""};
  return {};
}

}  // namespace isograsp
