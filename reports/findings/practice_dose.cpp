// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/findings/practice_dose.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "reports/findings/patient_records.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::reports {

namespace {

int count_of(std::size_t n) {
  return static_cast<int>(n);
}

// One for each kind: a new kind of task does not compile without its line here.
int repetitions(const tasks::RestSpec&) {
  return 0;
}
int repetitions(const tasks::MaximumSpec&) {
  return 1;
}
int repetitions(const tasks::DirectionalMaximaSpec& spec) {
  return count_of(spec.digits.size() * spec.directions.size());
}
int repetitions(const tasks::ForceTrackingSpec& spec) {
  using Shape = tasks::Waveform::Shape;
  const Shape shape = spec.waveform.shape;
  const bool periodic =
      shape == Shape::sine || shape == Shape::triangle || shape == Shape::rectangle;
  return periodic ? std::max(1, static_cast<int>(spec.waveform.frequency_Hz * spec.duration_s)) : 1;
}
int repetitions(const tasks::SteadinessSpec& spec) {
  return count_of(spec.levels.size());
}
int repetitions(const tasks::StepResponseSpec& spec) {
  return spec.repetitions * count_of(spec.to.size());
}
int repetitions(const tasks::GripReleaseSpec& spec) {
  return spec.repetitions;
}
int repetitions(const tasks::ForceSenseSpec& spec) {
  return spec.repetitions;
}
int repetitions(const tasks::FatigueSpec&) {
  return 1;
}
int repetitions(const tasks::IndividuationSpec& spec) {
  return spec.repetitions * count_of(spec.digits.size() * spec.levels.size());
}
int repetitions(const tasks::ForceDirectionSpec& spec) {
  return spec.repetitions * count_of(spec.targets.size());
}
int repetitions(const tasks::PoseTargetsSpec& spec) {
  return count_of(spec.targets.size());
}
int repetitions(const tasks::PoseTrackingSpec&) {
  return 1;
}
int repetitions(const tasks::PickPlaceSpec& spec) {
  return count_of(spec.items.size());
}
int repetitions(const tasks::ObserveSpec&) {
  return 1;
}
int repetitions(const tasks::RecordedSpec&) {
  return 1;
}

void raise(std::optional<int>& most, int value) {
  most = std::max(most.value_or(value), value);
}

}  // namespace

int repetitions_of(const tasks::TaskSpec& spec) {
  return std::visit([](const auto& kind) { return repetitions(kind); }, spec.kind);
}

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
        found->second = repetitions_of(*spec);
    week.repetitions += found->second;
  }
  for (const auto& week : dose.weeks) {
    dose.active_s += week.active_s;
    dose.repetitions += week.repetitions;
  }
  return dose;
}

}  // namespace isograsp::reports
