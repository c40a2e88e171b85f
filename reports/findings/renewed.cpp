// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/findings/renewed.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

#include "tasks/measure_version.hpp"
#include "tasks/score.hpp"

namespace isograsp::reports {

namespace {

/// What trials score, by what they consist of: the same signals in the same task always score the
/// same. For all stores of the program, so that the next report need not read them again.
class KnownScores {
 public:
  std::optional<std::vector<Measure>> find(const std::string& key) {
    const std::lock_guard lock(mutex_);
    const auto known = all_.find(key);
    if (known == all_.end()) return std::nullopt;
    return known->second;
  }
  void keep(const std::string& key, const std::vector<Measure>& measures) {
    constexpr std::size_t kMostTrials = 4000;  // some ten megabytes
    const std::lock_guard lock(mutex_);
    if (all_.size() >= kMostTrials) all_.clear();
    all_[key] = measures;
  }

 private:
  std::mutex mutex_;
  std::map<std::string, std::vector<Measure>> all_;
};

KnownScores& known_scores() {
  static KnownScores all;
  return all;
}

}  // namespace

/// Nothing: the signals or the task cannot be read.
std::optional<std::vector<Measure>> Renewal::scored(const storage::TrialRecord& trial) {
  // Signals that are still in blocks of a second have no hash to be known by.
  const std::string key = trial.signals_hash.empty() ? "" : trial.signals_hash + trial.task_text;
  if (!key.empty())
    if (auto known = known_scores().find(key)) return known;
  const auto spec = tasks::parse_task(trial.task_text, trial.task_name);
  if (!spec) return std::nullopt;
  const auto signals = store_.signals(trial);
  if (!signals) return std::nullopt;
  auto measures = tasks::score(*spec, *signals);
  ++scored_;
  if (!key.empty()) known_scores().keep(key, measures);
  return measures;
}

bool Renewal::renew(storage::RowId patient, const storage::TrialRecord& trial,
                    std::vector<Measure>& measures) {
  if (!tasks::any_is_older(measures)) return true;
  auto again = scored(trial);
  if (!again) {
    ++refused_;
    return false;
  }
  constexpr std::size_t kTrialsAtOnce = 50;  // some thousand rows: a recorder waits no longer
  if (isograsp::tasks::renew(measures, *again) > 0 && can_keep_ && seen_.insert(trial.id).second) {
    if (patient != patient_ || to_keep_.size() >= kTrialsAtOnce) keep();
    patient_ = patient;
    to_keep_.push_back({trial.id, *std::move(again)});
  }
  return !tasks::any_is_older(measures);
}

void Renewal::keep() {
  if (to_keep_.empty()) return;
  // A report does not fail because its results cannot be kept: they are right all the same.
  const auto kept = store_.add_newer_measures(patient_, to_keep_);
  can_keep_ = kept && *kept;
  to_keep_.clear();
}

Result<void> Renewal::renew(storage::PooledValue& value, const storage::PoolQuery& query) {
  if (value.measure_version == query.measure_version) return {};
  auto [known, fresh] = trials_of_.try_emplace(value.session_id);
  if (fresh) {
    auto trials = store_.trials(value.session_id);
    if (!trials) return trials.error();
    known->second = *std::move(trials);
  }
  for (const storage::TrialRecord& trial : known->second) {
    if (trial.id != value.trial_id) continue;
    Measure one;
    one.name = query.measure;
    one.channel = query.channel;
    one.unit = query.unit;
    one.version = value.measure_version;
    one.value = value.value;
    std::vector<Measure> measures{one};
    static_cast<void>(renew(value.patient_id, trial, measures));
    value.value = measures.front().value;
    value.measure_version = measures.front().version;
  }
  return {};
}

Text renewal_words(int results, int trials) {
  if (results == 0) return {};
  if (results == 1)
    return "1 result of 1 trial computed again from the stored signals, with a newer version of "
           "the measure; the stored ones stay unchanged"_text;
  if (trials == 1)
    return "%1 results of 1 trial computed again from the stored signals, with a newer version of "
           "the measure; the stored ones stay unchanged"_text(results);
  return "%1 results of %2 trials computed again from the stored signals, with a newer version of "
         "the measure; the stored ones stay unchanged"_text(results, trials);
}

Result<std::vector<storage::MeasurePoint>> renewed_progress(storage::SessionStore& store,
                                                            storage::RowId patient) {
  auto points = store.progress(patient);
  if (!points) return points;
  Renewal renewal(store);
  storage::RowId session = 0;
  std::vector<storage::TrialRecord> trials;
  for (std::size_t first = 0; first < points->size();) {
    const storage::MeasurePoint& point = (*points)[first];
    std::size_t end = first;
    std::vector<Measure> measures;
    for (; end < points->size() && (*points)[end].trial_id == point.trial_id; ++end)
      measures.push_back((*points)[end].measure);
    if (point.session_id != session) {
      session = point.session_id;
      auto of_session = store.trials(session);
      if (!of_session) return of_session.error();
      trials = *std::move(of_session);
    }
    const auto trial =
        std::find_if(trials.begin(), trials.end(),
                     [&](const storage::TrialRecord& one) { return one.id == point.trial_id; });
    if (trial != trials.end()) renewal.renew(patient, *trial, measures);
    for (std::size_t i = first; i < end; ++i) (*points)[i].measure = std::move(measures[i - first]);
    first = end;
  }
  return points;
}

}  // namespace isograsp::reports
