// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/training.hpp"

#include <algorithm>

namespace isograsp {

namespace {

constexpr std::size_t kBaselineDays = 2;

/// Best maximum of each channel on one day.
using DayMaxima = std::map<ForceChannel, double>;

void learn_maxima(const std::vector<Measure>& measures, DayMaxima& day) {
  for (const Measure& measure : measures) {
    const auto channel = force_channel_from_name(measure.channel);
    if (measure.name != "maximum_force" || !measure.value || !channel) continue;
    const auto [best, first] = day.try_emplace(*channel, *measure.value);
    if (!first) best->second = std::max(best->second, *measure.value);
  }
}

std::map<ForceChannel, double> baseline_of(const std::map<std::string, DayMaxima>& days) {
  std::map<ForceChannel, std::vector<double>> of;
  for (const auto& [date, day] : days)
    for (const auto& [channel, force_N] : day)
      if (of[channel].size() < kBaselineDays) of[channel].push_back(force_N);
  std::map<ForceChannel, double> baseline_N;
  for (const auto& [channel, forces_N] : of) {
    double sum_N = 0.0;
    for (const double force_N : forces_N) sum_N += force_N;
    baseline_N[channel] = sum_N / static_cast<double>(forces_N.size());
  }
  return baseline_N;
}

}  // namespace

bool is_success(const Difficulty& difficulty, const std::vector<Measure>& measures) {
  return std::any_of(measures.begin(), measures.end(), [&](const Measure& measure) {
    return measure.name == difficulty.measure && measure.value &&
           *measure.value >= difficulty.at_least;
  });
}

Result<Training> Training::read(SessionStore& store, const SessionRecord& session) {
  const auto sessions = store.sessions(session.patient_id);
  if (!sessions) return sessions.error();
  const auto points = store.progress(session.patient_id);
  if (!points) return points.error();
  std::map<RowId, std::vector<Measure>> measures_of;  // by trial
  for (const MeasurePoint& point : *points) measures_of[point.trial_id].push_back(point.measure);
  Training training;
  std::map<std::string, DayMaxima> days;
  for (const SessionRecord& earlier : *sessions) {
    if (earlier.hand != session.hand || earlier.simulated != session.simulated ||
        earlier.recorded || earlier.id == session.id)
      continue;
    const auto trials = store.trials(earlier.id);
    if (!trials) return trials.error();
    constexpr std::size_t kDateLength = 10;  // YYYY-MM-DD
    for (const TrialRecord& trial : *trials) {
      if (trial.status != TrialStatus::completed || trial.helped) continue;
      const auto& measures = measures_of[trial.id];
      if (!trial.practice) learn_maxima(measures, days[earlier.started_utc.substr(0, kDateLength)]);
      if (trial.task_text.find("\n[chosen]\n") == std::string::npos) continue;
      if (const auto spec = parse_task(trial.task_text, trial.task_name))
        training.learn(*spec, trial, measures);
    }
  }
  training.baseline_N_ = baseline_of(days);
  return training;
}

double Training::level(const TaskSpec& spec) const {
  const auto found = staircases_.find({spec.name, spec.version});
  return found == staircases_.end() ? spec.difficulty->start : found->second.level;
}

void Training::learn(const TaskSpec& spec, const TrialRecord& trial,
                     const std::vector<Measure>& measures) {
  if (trial.status != TrialStatus::completed || trial.helped) return;
  if (!spec.difficulty || !spec.difficulty->chosen) return;
  const Staircase used{*spec.difficulty->chosen};
  staircases_[{spec.name, spec.version}] = used.after(is_success(*spec.difficulty, measures));
}

}  // namespace isograsp
