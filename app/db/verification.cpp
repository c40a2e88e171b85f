// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/db/verification.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <mutex>
#include <optional>
#include <thread>

#include "app/console.hpp"
#include "storage/access/open_store.hpp"
#include "storage/records/session_store.hpp"
#include "tasks/score.hpp"

namespace isograsp::app {

namespace {

/// Above this difference a stored measure does not follow from its signals: the same build and CPU
/// agree to the bit; another libm may round the last digits in another way.
constexpr double kLargestRelativeDifference = 1e-12;

double relative_difference(double a, double b) {
  if (a == b) return 0.0;
  return std::abs(a - b) / std::max(std::abs(a), std::abs(b));
}

Number all_digits(double value) {
  char digits[40];
  std::snprintf(digits, sizeof digits, "%.17g", value);
  return {digits};
}

bool same_value(const Measure& a, const Measure& b) {
  if (!a.value || !b.value) return a.value.has_value() == b.value.has_value();
  return relative_difference(*a.value, *b.value) <= kLargestRelativeDifference;
}

void compare(const std::string& place, const std::vector<Measure>& stored,
             const std::vector<Measure>& recomputed, Verification& result) {
  // A newer program may give more measures than are stored, never fewer.
  for (const Measure& a : stored) {
    const std::string name = place + ", " + a.name + " of " + a.channel;
    ++result.measures;
    const auto found = std::find_if(recomputed.begin(), recomputed.end(), [&](const Measure& one) {
      return one.name == a.name && one.channel == a.channel && one.unit == a.unit;
    });
    if (found == recomputed.end()) {
      result.problems.push_back("%1: its signals give no such measure"_text(name));
      continue;
    }
    const Measure& b = *found;
    if (a.version < b.version) {
      ++result.older_version;
      if (!same_value(a, b)) ++result.older_changed;
    } else if (a.version > b.version) {
      ++result.newer_version;
    } else if (a.value.has_value() != b.value.has_value()) {
      result.problems.push_back(a.value ? "%1: only the stored one has a value"_text(name)
                                        : "%1: only the recomputed one has a value"_text(name));
    } else if (a.samples != b.samples || a.excluded != b.excluded) {
      result.problems.push_back("%1: was computed from other samples"_text(name));
    } else if (!a.value ||
               std::bit_cast<std::uint64_t>(*a.value) == std::bit_cast<std::uint64_t>(*b.value)) {
      ++result.identical;
    } else {
      const double difference = relative_difference(*a.value, *b.value);
      if (result.largest_at.empty() || difference > result.largest_relative_difference) {
        result.largest_relative_difference = difference;
        result.largest_at = name;
      }
      if (!(difference <= kLargestRelativeDifference)) {
        result.problems.push_back(
            "%1: stored %2, recomputed %3"_text(name, all_digits(*a.value), all_digits(*b.value)));
      }
    }
  }
}

/// Calls `visit` for every trial of the file that is closed.
Result<void> for_each_trial(
    storage::SessionStore& store,
    const std::function<void(const std::string&, const storage::TrialRecord&)>& visit) {
  const auto patients = store.patients();
  if (!patients) return patients.error();
  for (const auto& patient : *patients) {
    const auto sessions = store.sessions(patient.id);
    if (!sessions) return sessions.error();
    for (std::size_t s = 0; s < sessions->size(); ++s) {
      const auto trials = store.trials((*sessions)[s].id);
      if (!trials) return trials.error();
      for (const auto& trial : *trials)
        if (trial.status != storage::TrialStatus::running)
          visit("patient " + patient.code + ", session " + std::to_string(s + 1) + ", trial " +
                    std::to_string(trial.number),
                trial);
    }
  }
  return {};
}

/// One trial: its place, and the result of checking it.
struct Checked {
  std::string place;
  storage::TrialRecord trial;
  Verification result;
};

Result<void> check_trial(storage::SessionStore& store, Checked& one) {
  one.result.trials = 1;
  const auto stored = store.measures_of_all_versions(one.trial.id);
  if (!stored) return stored.error();
  // An interrupted trial was never scored.
  if (stored->empty() && one.trial.status == storage::TrialStatus::interrupted) return {};
  const auto signals = store.signals(one.trial);
  const auto task = tasks::parse_task(one.trial.task_text, "the task of " + one.place);
  if (!signals)
    one.result.problems.push_back(signals.error().what);
  else if (!task)
    one.result.problems.push_back("%1"_text(task.error().message()));
  else
    compare(one.place, *stored, tasks::score(*task, *signals), one.result);
  return {};
}

void add(const Verification& one, Verification& all) {
  all.trials += one.trials;
  all.measures += one.measures;
  all.identical += one.identical;
  all.older_version += one.older_version;
  all.older_changed += one.older_changed;
  all.newer_version += one.newer_version;
  if (!one.largest_at.empty() && (all.largest_at.empty() || one.largest_relative_difference >
                                                                all.largest_relative_difference)) {
    all.largest_relative_difference = one.largest_relative_difference;
    all.largest_at = one.largest_at;
  }
  all.problems.insert(all.problems.end(), one.problems.begin(), one.problems.end());
}

}  // namespace

Result<Verification> verify_database(const std::string& file, int threads) {
  const auto first = storage::open_store_to_read(file);
  if (!first) return first.error();
  std::vector<Checked> trials;
  const auto listed = for_each_trial(
      **first, [&trials](const std::string& place, const storage::TrialRecord& trial) {
        trials.push_back({place, trial, {}});
      });
  if (!listed) return listed.error();
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  std::mutex problem_mutex;
  std::optional<Error> problem;
  std::atomic<int> at_work{
      std::clamp(threads, 1, static_cast<int>(std::max<std::size_t>(1, trials.size())))};
  std::vector<std::thread> workers;
  for (int worker = at_work; worker > 0; --worker)
    workers.emplace_back([&] {
      auto done = Result<void>();
      if (const auto store = storage::open_store(file, storage::OpenMode::read_only); !store)
        done = store.error();
      else
        for (std::size_t i = next++; i < trials.size() && !failed && done; i = next++)
          done = check_trial(**store, trials[i]);
      if (!done) {
        failed = true;
        const std::lock_guard lock(problem_mutex);
        if (!problem) problem = done.error();
      }
      --at_work;
    });
  ProgressBar bar("Verifying"_text);
  while (at_work > 0) {
    const auto done = std::min(next.load(), trials.size());
    if (done > 0)
      bar.show(static_cast<double>(done) / static_cast<double>(trials.size()),
               "%1"_text(trials[done - 1].place));
    constexpr auto kLook = std::chrono::milliseconds(20);
    std::this_thread::sleep_for(kLook);
  }
  for (auto& worker : workers) worker.join();
  bar.end();
  if (problem) return *problem;
  Verification all;
  for (const Checked& one : trials) add(one.result, all);
  return all;
}

}  // namespace isograsp::app
