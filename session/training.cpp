// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/training.hpp"

#include <algorithm>

#include "session/arm/passive_range.hpp"
#include "tasks/measure_version.hpp"
#include "tasks/score.hpp"

namespace isograsp::session {

namespace {

constexpr std::size_t kBaselineDays = 2;

/// Best maximum of each channel on one day.
using DayMaxima = std::map<ForceChannel, double>;

constexpr const char* kMaximum = "maximum_force";

/// A trial that gave maxima.
struct MaximumTrial {
  storage::TrialRecord trial;
  std::vector<Measure> measures;
};
using Days = std::map<std::string, std::vector<MaximumTrial>>;

/// Newtons of an older definition are not those that a target is reckoned from now: they follow
/// again from the signals of the trial. It does not count if they cannot be read.
void renew_maxima(storage::SessionStore& store, MaximumTrial& one) {
  std::erase_if(one.measures, [](const Measure& measure) { return measure.name != kMaximum; });
  if (!tasks::any_is_older(one.measures)) return;
  const auto spec = tasks::parse_task(one.trial.task_text, one.trial.task_name);
  const auto signals = store.signals(one.trial);
  if (spec && signals) tasks::renew(one.measures, tasks::score(*spec, *signals));
  std::erase_if(one.measures, tasks::is_older);
}

void learn_maxima(const std::vector<Measure>& measures, DayMaxima& day) {
  for (const Measure& measure : measures) {
    const auto channel = force_channel_from_name(measure.channel);
    if (measure.name != kMaximum || !measure.value || !channel) continue;
    const auto [best, first] = day.try_emplace(*channel, *measure.value);
    if (!first) best->second = std::max(best->second, *measure.value);
  }
}

/// The first days that have a maximum, kBaselineDays of each channel. Later ones are not looked at.
std::map<ForceChannel, double> baseline_of(storage::SessionStore& store, Days& days) {
  std::map<ForceChannel, std::vector<double>> of;
  const auto is_wanted = [&of](const Measure& measure) {
    const auto channel = force_channel_from_name(measure.channel);
    return measure.name == kMaximum && channel && of[*channel].size() < kBaselineDays;
  };
  for (auto& [date, trials] : days) {
    DayMaxima day;
    for (auto& one : trials) {
      if (std::none_of(one.measures.begin(), one.measures.end(), is_wanted)) continue;
      renew_maxima(store, one);
      learn_maxima(one.measures, day);
    }
    for (const auto& [channel, force_N] : day)
      if (of[channel].size() < kBaselineDays) of[channel].push_back(force_N);
  }
  std::map<ForceChannel, double> baseline_N;
  for (const auto& [channel, forces_N] : of) {
    if (forces_N.empty()) continue;
    double sum_N = 0.0;
    for (const double force_N : forces_N) sum_N += force_N;
    baseline_N[channel] = sum_N / static_cast<double>(forces_N.size());
  }
  return baseline_N;
}

}  // namespace

bool is_success(const tasks::Difficulty& difficulty, const std::vector<Measure>& measures) {
  return std::any_of(measures.begin(), measures.end(), [&](const Measure& measure) {
    return measure.name == difficulty.measure && measure.value &&
           *measure.value >= difficulty.at_least;
  });
}

Result<Training> Training::read(storage::SessionStore& store,
                                const storage::SessionRecord& session) {
  const auto sessions = store.sessions(session.patient_id);
  if (!sessions) return sessions.error();
  const auto points = store.progress(session.patient_id);
  if (!points) return points.error();
  std::map<storage::RowId, std::vector<Measure>> measures_of;  // by trial
  for (const storage::MeasurePoint& point : *points)
    measures_of[point.trial_id].push_back(point.measure);
  Training training;
  Days days;
  for (const storage::SessionRecord& earlier : *sessions) {
    if (earlier.hand != session.hand || earlier.simulated != session.simulated ||
        earlier.recorded || earlier.id == session.id)
      continue;
    const auto trials = store.trials(earlier.id);
    if (!trials) return trials.error();
    constexpr std::size_t kDateLength = 10;  // YYYY-MM-DD
    for (const storage::TrialRecord& trial : *trials) {
      if (trial.status != storage::TrialStatus::completed || trial.helped) continue;
      const auto& measures = measures_of[trial.id];
      if (!trial.practice)
        days[earlier.started_utc.substr(0, kDateLength)].push_back({trial, measures});
      const auto has = [&trial](const char* key) {
        return trial.task_text.find(key) != std::string::npos;
      };
      if (!has("\n[chosen]\n") && !has("\npostures")) continue;
      const auto spec = tasks::parse_task(trial.task_text, trial.task_name);
      if (!spec) continue;
      training.learn(*spec, trial, measures);
      if (const auto gone = way_of(*spec)) {
        double& way = training.way_done_[gone->postures];
        way = std::max(way, gone->way);
      }
    }
  }
  training.baseline_N_ = baseline_of(store, days);
  return training;
}

double Training::level(const tasks::TaskSpec& spec) const {
  const auto found = staircases_.find({spec.name, spec.version});
  return found == staircases_.end() ? spec.difficulty->start : found->second.level;
}

void Training::learn(const tasks::TaskSpec& spec, const storage::TrialRecord& trial,
                     const std::vector<Measure>& measures) {
  if (trial.status != storage::TrialStatus::completed || trial.helped) return;
  if (!spec.difficulty || !spec.difficulty->chosen) return;
  const tasks::Staircase used{*spec.difficulty->chosen};
  staircases_[{spec.name, spec.version}] = used.after(is_success(*spec.difficulty, measures));
}

}  // namespace isograsp::session
