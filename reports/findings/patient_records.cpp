// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/findings/patient_records.hpp"

#include <algorithm>

#include "reports/findings/comparable.hpp"
#include "reports/findings/renewed.hpp"
#include "storage/records/trial_answers.hpp"
#include "tasks/questions/questionnaire.hpp"

namespace isograsp::reports {

namespace {

/// Answers to the questions of the task, as measures of the trial; without a number there is none.
void add_answers(const storage::TrialAnswers& answers, std::vector<Measure>& measures) {
  for (const auto& [name, number] : answers) {
    const auto asked = tasks::question_named(name);
    if (!asked || !number) continue;
    measures.push_back({.name = name,
                        .channel = {},
                        .value = static_cast<double>(*number),
                        .unit = "of " + std::to_string(asked->of->most),
                        .samples = 1,
                        .reason = {}});
  }
}

constexpr std::size_t kDateLength = 10;  // of "2026-03-05"

/// The patient, what is told of them, their sessions and measures.
Result<PatientRecords> read_about(storage::SessionStore& store, const std::string& code) {
  const auto patient = store.find_patient(code);
  if (!patient) return patient.error();
  if (!patient->has_value())
    return refused("there is no patient \"%1\" in this database"_text(code),
                   "check the code, or record a session with it first"_text)
        .at(store.path())
        .about("patient");
  auto profile = store.profile((*patient)->id);
  if (!profile) return profile.error();
  auto primaries = store.primary_measures((*patient)->id);
  if (!primaries) return primaries.error();
  auto sessions = store.sessions((*patient)->id);
  if (!sessions) return sessions.error();
  std::stable_sort(sessions->begin(), sessions->end(),
                   [](const auto& a, const auto& b) { return a.started_utc < b.started_utc; });
  PatientRecords records;
  records.patient = **patient;
  records.profile = *std::move(profile);
  records.primaries = *std::move(primaries);
  records.sessions = *std::move(sessions);
  records.sessions_stored = static_cast<int>(records.sessions.size());
  return records;
}

/// Leaves out the sessions beyond the scope.
void keep(const ReportScope& scope, PatientRecords& records) {
  const int all = records.sessions_stored;
  const int last = std::min(scope.last.value_or(all), all);
  records.first_number = std::clamp(scope.first, 1, last + 1);
  auto& sessions = records.sessions;
  sessions.erase(sessions.begin() + last, sessions.end());
  sessions.erase(sessions.begin(), sessions.begin() + (records.first_number - 1));
}

}  // namespace

Result<PatientRecords> read_patient(storage::SessionStore& store, const std::string& code,
                                    const Progress& progress, const ReportScope& scope) {
  auto records = read_about(store, code);
  if (!records) return records;
  DayCounter counter;
  std::vector<double> days;
  for (const auto& session : records->sessions) days.push_back(counter.day_of(session.started_utc));
  keep(scope, *records);
  auto points = store.progress(records->patient.id);
  if (!points) return points.error();
  std::map<storage::RowId, std::vector<Measure>> measures_of;
  for (auto& point : *points) measures_of[point.trial_id].push_back(std::move(point.measure));
  Renewal renewal(store);
  const std::size_t count = records->sessions.size();
  for (std::size_t index = 0; index < count; ++index) {
    const storage::SessionRecord& session = records->sessions[index];
    if (!tell(progress, static_cast<double>(index) / static_cast<double>(count),
              "session %1 of %2"_text(index + 1, count)))
      return cancelled();
    const int number = records->first_number + static_cast<int>(index);
    records->shown.push_back({number, session.started_utc.substr(0, kDateLength),
                              session.started_utc, days[static_cast<std::size_t>(number - 1)],
                              session.hand, source_of(session), session.device_description,
                              session.provenance});
    auto trials = store.trials(session.id);
    if (!trials) return trials.error();
    const auto events = store.events(session.id);
    if (!events) return events.error();
    for (auto& trial : *trials) {
      auto measures = std::move(measures_of[trial.id]);
      renewal.renew(records->patient.id, trial, measures);
      const auto recomputed =
          std::count_if(measures.begin(), measures.end(),
                        [](const Measure& measure) { return measure.recomputed; });
      records->renewed_results += static_cast<int>(recomputed);
      records->renewed_trials += recomputed > 0 ? 1 : 0;
      add_answers(storage::answers_of(trial.id, *events), measures);
      records->trials.push_back({index, &session, std::move(trial), std::move(measures)});
    }
  }
  records->scored_again = renewal.scored();
  records->not_renewed_trials = renewal.refused();
  return records;
}

TrialsOfTasks sort_by_task(const PatientRecords& records) {
  TrialsOfTasks tasks;
  for (const auto& one : records.trials)
    tasks[{one.session_record->hand, one.trial.task_name}].push_back(&one);
  for (auto& [task, all] : tasks) {
    const auto newest = std::find_if(all.rbegin(), all.rend(),
                                     [](const StoredTrial* one) { return counts(one->trial); });
    if (newest != all.rend()) all.erase(newest.base(), all.end());
  }
  return tasks;
}

}  // namespace isograsp::reports
