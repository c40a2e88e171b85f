// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/clinic.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "app/console.hpp"
#include "app/paths.hpp"
#include "core/staging_folder.hpp"
#include "storage/access/open_store.hpp"
#include "storage/care/merge.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::app {

namespace {

namespace fs = std::filesystem;

/// Temporary files from which a clinic is made: what a killed program left of them is not gone on
/// with, and two programs never make one clinic.
class Parts {
 public:
  explicit Parts(StagingFolder folder) : folder_(std::move(folder)) {}
  [[nodiscard]] std::string path(std::size_t group) const {
    return folder_.path() + "/" + std::to_string(group + 1) + ".part";
  }
  /// The clinic itself: it gets its name when it is complete.
  [[nodiscard]] const std::string& whole() const { return folder_.file(); }
  static void remove(const std::string& part) {
    for (const char* suffix : {"", "-wal", "-shm", "-lock"}) {
      std::error_code ignored;
      fs::remove(part + suffix, ignored);
    }
  }

 private:
  StagingFolder folder_;
};

/// Stores what is known of a person beside the sessions.
Result<void> tell(storage::SessionStore& store, const DemoPerson& person) {
  const auto patient = store.find_patient(person.code);
  if (!patient) return patient.error();
  const storage::RowId id = patient->value().id;
  if (auto done = store.set_profile(id, person.profile); !done) return done;
  for (const auto& mark : person.treatments)
    if (auto done = store.add_treatment_mark(id, mark); !done) return done.error();
  for (const auto& score : person.scores)
    if (auto done = store.add_clinical_score(id, score); !done) return done.error();
  for (const auto& primary : person.primaries)
    if (auto done = store.add_primary_measure(id, primary); !done) return done.error();
  if (person.stable)
    if (auto done = store.add_stable_period(id, *person.stable); !done) return done.error();
  return {};
}

/// All sessions of some people, in order: training goes on where it stopped.
Result<void> make_group(const DemoGroup& group, const std::string& database,
                        std::atomic<int>& sessions_made) {
  for (const DemoPerson& person : group)
    for (const DemoVisit& visit : person.visits) {
      RunOptions options = options_of(visit, person.code);
      options.database = database;
      options.scratch = true;
      options.quiet = true;
      if (auto done = run_session(options); !done) return done;
      ++sessions_made;
    }
  const auto store = storage::open_store(database, storage::OpenMode::scratch);
  if (!store) return store.error();
  for (const DemoPerson& person : group)
    if (auto done = tell(**store, person); !done) return done;
  return {};
}

int sessions_of(const std::vector<DemoGroup>& groups) {
  std::size_t sessions = 0;
  for (const auto& group : groups)
    for (const auto& person : group) sessions += person.visits.size();
  return static_cast<int>(sessions);
}

/// Makes the groups on several threads.
class Workers {
 public:
  Workers(const std::vector<DemoGroup>& groups, const Parts& parts, int threads)
      : sessions_(sessions_of(groups)), made_(groups.size()) {
    const auto count = static_cast<int>(groups.size());
    for (int worker = std::clamp(threads, 1, count); worker > 0; --worker)
      threads_.emplace_back([this, &groups, &parts] {
        for (std::size_t group = next_++; group < groups.size() && !stop_; group = next_++)
          if (auto done = make_group(groups[group], parts.path(group), sessions_made_); done)
            made_[group] = true;
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

  /// Waits until this group is made.
  [[nodiscard]] Result<void> wait_for(std::size_t group, ProgressBar& bar) {
    while (!made_[group]) {
      bar.show(static_cast<double>(sessions_made_) / sessions_,
               "%1 sessions"_text(sessions_made_.load()));
      constexpr auto kLook = std::chrono::milliseconds(20);
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

  int sessions_;
  std::atomic<std::size_t> next_{0};
  std::atomic<int> sessions_made_{0};
  std::atomic<bool> stop_{false};
  std::vector<std::atomic<bool>> made_;  ///< of each group
  std::mutex mutex_;
  std::optional<Error> problem_;
  std::vector<std::thread> threads_;
};

/// One group after the other, so that the file does not depend on who was made first.
Result<void> put_together(std::size_t groups, const Parts& parts, Workers& workers) {
  // Simulated people: the file can be made again, and is the same each time.
  constexpr auto kHow = storage::OpenMode::scratch;
  if (const auto clinic = storage::open_store(parts.whole(), kHow); !clinic) return clinic.error();
  ProgressBar bar("Making the clinic"_text);
  for (std::size_t group = 0; group < groups; ++group) {
    if (auto made = workers.wait_for(group, bar); !made) return made;
    if (const auto done = storage::merge_databases(parts.whole(), parts.path(group), {}, kHow);
        !done)
      return done.error();
    Parts::remove(parts.path(group));
  }
  bar.end();
  return {};
}

}  // namespace

RunOptions options_of(const DemoVisit& visit, const std::string& code) {
  RunOptions options;
  options.protocol_file = library_folder() + "/protocols/" + visit.protocol + ".toml";
  options.protocol_text = visit.protocol_text;
  options.broken_off_in = visit.broken_off_in;
  options.rating = visit.rating;
  options.patient = code;
  options.hand = name_of(visit.hand);
  options.device = visit.device;
  options.started_utc = visit.started_utc;
  options.fast = true;
  return options;
}

Result<void> make_clinic(const std::string& database, const std::vector<DemoGroup>& groups,
                         int threads) {
  std::error_code failure;
  if (fs::exists(database, failure))
    return refused("exists already"_text, "name a new file"_text).at(database);
  auto folder = StagingFolder::beside(database);
  if (!folder) return folder.error();
  const Parts parts(*std::move(folder));
  Workers workers(groups, parts, threads);
  if (auto done = put_together(groups.size(), parts, workers); !done) return done;
  fs::rename(parts.whole(), database, failure);
  if (failure)
    return failed("could not be made: %1"_text(Known{failure.message()}),
                  "choose another folder"_text)
        .at(database);
  return {};
}

}  // namespace isograsp::app
