// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/findings/practice_dose.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "reports/findings/patient_records.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::reports {

namespace {

void raise(std::optional<int>& most, int value) {
  most = std::max(most.value_or(value), value);
}

}  // namespace

Result<PracticeDose> dose_of(storage::SessionStore& store, const PatientRecords& records) {
  PracticeDose dose;
  constexpr double kWeek_days = 7.0;
  std::optional<double> day;
  std::vector<std::size_t> week_of;  // of each session: index into dose.weeks
  for (std::size_t i = 0; i < records.sessions.size(); ++i) {
    const double session_day = records.shown[i].day;
    // The same day of the next week may come an hour earlier.
    const int week = 1 + static_cast<int>(std::floor(std::round(session_day) / kWeek_days));
    while (dose.weeks.empty() || dose.weeks.back().week < week)
      dose.weeks.push_back({dose.weeks.empty() ? week : dose.weeks.back().week + 1});
    DoseWeek& one = dose.weeks.back();
    week_of.push_back(dose.weeks.size() - 1);
    ++one.sessions;
    if (day != session_day) ++dose.days;
    day = session_day;
    const auto ratings = store.ratings(records.sessions[i].id);
    if (!ratings) return ratings.error();
    for (const auto& rating : *ratings) {
      raise(one.most_effort, rating.effort);
      raise(one.most_pain, rating.pain);
      if (rating.shoulder_pain) raise(one.most_shoulder_pain, *rating.shoulder_pain);
    }
  }
  std::map<std::string, int> known;  // task files are long, and the same for many trials
  for (const auto& trial : records.trials) {
    DoseWeek& week = dose.weeks[week_of[trial.session]];
    week.active_s += static_cast<double>(trial.trial.samples) / trial.session_record->rate_Hz;
    if (trial.trial.status != storage::TrialStatus::completed) continue;
    const auto [found, is_new] = known.try_emplace(trial.trial.task_text, 0);
    if (is_new)
      if (const auto spec = tasks::parse_task(trial.trial.task_text, trial.trial.task_name))
        found->second = spec->repetitions();
    week.repetitions += found->second;
  }
  for (const auto& week : dose.weeks) {
    dose.active_s += week.active_s;
    dose.repetitions += week.repetitions;
  }
  return dose;
}

}  // namespace isograsp::reports
