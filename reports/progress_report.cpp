// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/progress_report.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <map>
#include <set>
#include <utility>

#include "reports/data_quality.hpp"
#include "reports/measure_series.hpp"
#include "reports/measure_words.hpp"

namespace isograsp {

namespace {

constexpr int kMostPrimaries = 4;  // clinical rule: at most four verdicts per patient
constexpr const char* kNoVerdictYet = "cannot be judged yet";

double share(std::size_t done, std::size_t all) {
  return static_cast<double>(done) / static_cast<double>(all);
}
/// "3 of 7" while the element at `index` is at work.
std::string part(std::size_t index, std::size_t all) {
  return std::to_string(index + 1) + " of " + std::to_string(all);
}

Source source_of(const SessionRecord& session) {
  if (session.simulated) return Source::simulated;
  return session.recorded ? Source::recorded : Source::device;
}

/// Days since 1970 of "YYYY-MM-DD…"; 0 for anything else.
int day_number(const std::string& date) {
  int year = 0;
  unsigned month = 0;
  unsigned day = 0;
  if (date.size() < 10) return 0;
  const char* text = date.data();
  std::from_chars(text, text + 4, year);
  std::from_chars(text + 5, text + 7, month);
  std::from_chars(text + 8, text + 10, day);
  const std::chrono::year_month_day ymd{std::chrono::year{year}, std::chrono::month{month},
                                        std::chrono::day{day}};
  if (!ymd.ok()) return 0;
  return static_cast<int>(std::chrono::sys_days{ymd}.time_since_epoch().count());
}

/// Why two trials of one task and hand must not be compared; empty: they may.
std::string difference(const StoredTrial& a, const StoredTrial& b) {
  if (source_of(*a.session_record) != source_of(*b.session_record)) return "other source of forces";
  if (a.trial.task_version != b.trial.task_version) return "other version of the task";
  if (a.trial.task_text != b.trial.task_text) return "other task parameters";
  if (a.trial.scene_text != b.trial.scene_text) return "other object or scene";
  if (a.session_record->device_delay_s != b.session_record->device_delay_s)
    return "other filter delay of the device";
  if (a.session_record->rate_Hz != b.session_record->rate_Hz) return "other frame rate";
  return "";
}

bool counts(const TrialRecord& trial) {
  return trial.status == TrialStatus::completed && !trial.practice && !trial.helped;
}

void add_last_trial(SessionStore& store, const StoredTrial& newest, TaskSection& section) {
  LastTrial last{newest.session, newest.trial.number, {}, newest.measures, ""};
  auto signals = store.signals(newest.trial);
  if (!signals) {
    last.problem = "The signals of this trial cannot be read: " + signals.error().message();
  } else {
    for (const auto& name : signals->names()) {
      const bool drawn = name == "t_s" || name == "phase" || name == "sample_flags" ||
                         name.starts_with("target_") || name.starts_with("actual_");
      if (!drawn || last.curves.has(name)) continue;
      const auto column = signals->column(name);
      last.curves.add_column(name, {column.begin(), column.end()});
    }
    if (!last.curves.has("t_s") || last.curves.rows() < 2)
      last.problem = "This trial holds no signals to draw.";
  }
  section.last = std::move(last);
}

TaskSection make_section(SessionStore& store, const std::vector<const StoredTrial*>& all,
                         const std::vector<ReportSession>& sessions) {
  const StoredTrial& newest = *all.back();
  TaskSection section;
  section.task = newest.trial.task_name;
  section.version = newest.trial.task_version;
  section.hand = newest.session_record->hand;
  section.source = source_of(*newest.session_record);
  if (auto spec = parse_task(newest.trial.task_text, newest.trial.task_name))
    section.spec = std::move(*spec);

  std::vector<const StoredTrial*> compared;
  std::map<std::string, std::set<std::size_t>> left_out;
  int practice = 0;
  int helped = 0;
  int unfinished = 0;
  for (const StoredTrial* entry : all) {
    if (const auto why = difference(*entry, newest); !why.empty())
      left_out[why].insert(entry->session);
    else if (entry->trial.practice)
      ++practice;
    else if (entry->trial.helped)
      ++helped;
    else if (entry->trial.status != TrialStatus::completed)
      ++unfinished;
    else
      compared.push_back(entry);
  }
  for (const auto& [why, which] : left_out) {
    auto text = list_sessions(which) + " not compared: " + why;
    text[0] = 'S';
    section.notes.push_back(std::move(text));
  }
  const auto note = [&](int n, const char* one, const char* many) {
    if (n > 0) section.notes.push_back(std::to_string(n) + (n == 1 ? one : many));
  };
  note(practice, " practice trial left out", " practice trials left out");
  note(helped, " trial with the therapist's help left out",
       " trials with the therapist's help left out");
  note(unfinished, " trial that did not end left out", " trials that did not end left out");
  if (compared.empty()) return section;

  for (const Measure& measure : compared.back()->measures) {
    if (place_of(section.spec, measure.name, measure.channel).prominence == Prominence::none)
      continue;
    section.series.push_back(make_series(measure, compared, sessions, section));
  }
  const auto place = [&](const MeasureSeries& series) {
    return place_of(section.spec, series.name, series.channel);
  };
  std::stable_sort(section.series.begin(), section.series.end(),
                   [&](const auto& a, const auto& b) { return place(a).rank < place(b).rank; });
  for (auto& series : section.series) series.key = place(series).prominence == Prominence::key;
  add_last_trial(store, *compared.back(), section);
  return section;
}

/// Tasks in the order of an assessment; the hand with more trials first.
void put_in_order(std::vector<TaskSection>& sections, const std::vector<ReportSession>& sessions) {
  const auto right = std::count_if(sessions.begin(), sessions.end(),
                                   [](const auto& session) { return session.hand == Hand::right; });
  const bool left_first = right * 2 < static_cast<long>(sessions.size());
  std::stable_sort(sections.begin(), sections.end(), [&](const auto& a, const auto& b) {
    if (a.hand != b.hand) return (a.hand == Hand::left) == left_first;
    const std::size_t kind_a = a.spec ? a.spec->kind.index() : std::variant_npos;
    const std::size_t kind_b = b.spec ? b.spec->kind.index() : std::variant_npos;
    return kind_a != kind_b ? kind_a < kind_b : a.task < b.task;
  });
  int primaries = 0;
  for (auto& section : sections)
    for (auto& series : section.series) {
      if (!series.key || primaries == kMostPrimaries) continue;
      ++primaries;
      series.primary = true;
      series.verdict = kNoVerdictYet;
    }
}

}  // namespace

std::string_view name_of(Source source) noexcept {
  switch (source) {
    case Source::simulated: return "simulated device";
    case Source::recorded: return "replayed recording";
    case Source::device: break;
  }
  return "device";
}

Result<ReportContent> gather_progress(SessionStore& store, const std::string& code,
                                      const Progress& progress) {
  // Shares of the time of sessions, last trials and quality, roughly.
  constexpr double kSessionsEnd = 0.3;
  constexpr double kTrialsEnd = 0.6;
  const auto patient = store.find_patient(code);
  if (!patient) return patient.error();
  if (!patient->has_value())
    return Error{Error::Code::bad_input,
                 "there is no patient \"" + code + "\" in this database",
                 "check the code, or record a session with it first",
                 store.path(),
                 0,
                 "patient"};
  ReportContent content;
  content.code = code;
  content.software_version = ISOGRASP_VERSION;

  auto records = store.sessions((*patient)->id);
  if (!records) return records.error();
  std::stable_sort(records->begin(), records->end(),
                   [](const auto& a, const auto& b) { return a.started_utc < b.started_utc; });
  std::map<RowId, std::vector<Measure>> measures_of;
  auto points = store.progress((*patient)->id);
  if (!points) return points.error();
  for (auto& point : *points) measures_of[point.trial_id].push_back(std::move(point.measure));

  std::vector<StoredTrial> entries;
  std::vector<TrialRecord> last_trials;
  for (const auto& record : *records) {
    const std::size_t index = content.sessions.size();
    if (!tell(progress, kSessionsEnd * share(index, records->size()),
              "session " + part(index, records->size())))
      return cancelled();
    const int day = day_number(record.started_utc) - day_number(records->front().started_utc);
    content.sessions.push_back({static_cast<int>(index) + 1, record.started_utc.substr(0, 10), day,
                                record.hand, source_of(record), record.device_description,
                                record.provenance});
    content.simulated = content.simulated || record.simulated;
    content.recorded = content.recorded || record.recorded;
    auto trials = store.trials(record.id);
    if (!trials) return trials.error();
    last_trials = *trials;
    for (auto& trial : *trials) {
      auto measures = std::move(measures_of[trial.id]);
      entries.push_back({index, &record, std::move(trial), std::move(measures)});
    }
  }

  std::map<std::pair<Hand, std::string>, std::vector<const StoredTrial*>> tasks;
  for (const auto& entry : entries)
    tasks[{entry.session_record->hand, entry.trial.task_name}].push_back(&entry);
  for (auto& [task, all] : tasks) {
    const std::size_t index = content.sections.size();
    if (!tell(progress, kSessionsEnd + (kTrialsEnd - kSessionsEnd) * share(index, tasks.size()),
              "task " + part(index, tasks.size())))
      return cancelled();
    // The newest trial that counts decides with what the others are compared.
    const auto newest = std::find_if(all.rbegin(), all.rend(),
                                     [](const StoredTrial* entry) { return counts(entry->trial); });
    if (newest != all.rend()) all.erase(newest.base(), all.end());
    content.sections.push_back(make_section(store, all, content.sessions));
  }
  put_in_order(content.sections, content.sessions);
  if (!records->empty()) {
    const auto checked = [&](double fraction, const std::string& words) {
      return tell(progress, kTrialsEnd + (1.0 - kTrialsEnd) * fraction, words);
    };
    auto quality = assess_quality(store, records->back(), last_trials, checked);
    if (!quality) return quality.error();
    content.quality = std::move(*quality);
  }
  return content;
}

}  // namespace isograsp
