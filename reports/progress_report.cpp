// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/progress_report.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "reports/data_quality.hpp"
#include "reports/measure_words.hpp"

namespace isograsp {

namespace {

constexpr int kMostPrimaries = 4;  // clinical rule: at most four verdicts per patient
constexpr const char* kNoVerdictYet = "cannot be judged yet";

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

/// One trial with all that decides whether it may be compared with another.
struct Entry {
  std::size_t session = 0;
  const SessionRecord* session_record = nullptr;
  TrialRecord trial;
  std::vector<Measure> measures;
};

/// Why two trials of one task and hand must not be compared; empty: they may.
std::string difference(const Entry& a, const Entry& b) {
  if (source_of(*a.session_record) != source_of(*b.session_record)) return "other source of forces";
  if (a.trial.task_version != b.trial.task_version) return "other version of the task";
  if (a.trial.task_text != b.trial.task_text) return "other task parameters";
  if (a.trial.scene_text != b.trial.scene_text) return "other object or scene";
  if (a.session_record->device_delay_s != b.session_record->device_delay_s)
    return "other filter delay of the device";
  if (a.session_record->rate_Hz != b.session_record->rate_Hz) return "other frame rate";
  return "";
}

std::string list_sessions(const std::set<std::size_t>& sessions) {
  std::string text = sessions.size() == 1 ? "session " : "sessions ";
  std::string separator;
  for (const auto session : sessions) {
    text += separator + std::to_string(session + 1);
    separator = ", ";
  }
  return text;
}

bool counts(const TrialRecord& trial) {
  return trial.status == TrialStatus::completed && !trial.practice;
}

/// Baseline, last and change from the session means (the baseline is the mean of two days).
void summarise(MeasureSeries& series, const std::vector<ReportSession>& sessions) {
  std::vector<std::pair<int, double>> means;  // day, mean
  for (const auto& value : series.values)
    if (value.mean) means.emplace_back(sessions[value.session].day, *value.mean);
  if (means.empty()) return;
  if (series.values.back().mean) series.last = means.back().second;
  std::vector<int> days;
  for (const auto& [day, mean] : means)
    if (days.empty() || days.back() != day) days.push_back(day);
  if (means.size() < 2) return;
  std::size_t used = 1;
  series.baseline_basis = "first session";
  if (days.size() >= 2) {
    const int last_day = days.size() >= 3 ? days[1] : days[0];
    series.baseline_basis = days.size() >= 3 ? "first two days" : "first day";
    used = static_cast<std::size_t>(std::count_if(
        means.begin(), means.end(), [&](const auto& mean) { return mean.first <= last_day; }));
  }
  series.baseline =
      std::accumulate(means.begin(), means.begin() + static_cast<long>(used), 0.0,
                      [](double sum, const auto& mean) { return sum + mean.second; }) /
      static_cast<double>(used);
  if (series.last) series.change = *series.last - *series.baseline;
}

MeasureSeries make_series(const Measure& like, const std::vector<const Entry*>& entries,
                          const std::vector<ReportSession>& sessions, TaskSection& section) {
  MeasureSeries series{like.name, like.channel, like.unit, like.version, false, false,
                       {},        {},           "",        {},           {},    ""};
  const bool censored = words_for(like.name, like.channel).censored;
  std::set<std::size_t> other_version;
  for (const Entry* entry : entries)
    for (const auto& measure : entry->measures) {
      if (measure.name != like.name || measure.channel != like.channel) continue;
      if (measure.version != like.version || measure.unit != like.unit) {
        other_version.insert(entry->session);
        continue;
      }
      if (series.values.empty() || series.values.back().session != entry->session)
        series.values.push_back({entry->session, {}, 0, {}, false});
      SessionValue& value = series.values.back();
      if (measure.value)
        value.trials.push_back(*measure.value);
      else
        ++value.without_value;
    }
  for (auto& value : series.values) {
    value.first_day = sessions[value.session].day == sessions[series.values.front().session].day &&
                      sessions[series.values.back().session].day != sessions[value.session].day;
    const bool failed = censored && value.without_value > 0;
    if (!value.trials.empty() && !failed)
      value.mean = std::accumulate(value.trials.begin(), value.trials.end(), 0.0) /
                   static_cast<double>(value.trials.size());
  }
  summarise(series, sessions);
  if (!other_version.empty())
    section.notes.push_back(words_for(like.name, like.channel).title + ": " +
                            list_sessions(other_version) +
                            " not compared, another version of the measure");
  return series;
}

void add_last_trial(SessionStore& store, const Entry& newest, TaskSection& section) {
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

TaskSection make_section(SessionStore& store, const std::vector<const Entry*>& all,
                         const std::vector<ReportSession>& sessions) {
  const Entry& newest = *all.back();
  TaskSection section;
  section.task = newest.trial.task_name;
  section.version = newest.trial.task_version;
  section.hand = newest.session_record->hand;
  section.source = source_of(*newest.session_record);
  if (auto spec = parse_task(newest.trial.task_text, newest.trial.task_name))
    section.spec = std::move(*spec);

  std::vector<const Entry*> compared;
  std::map<std::string, std::set<std::size_t>> left_out;
  int practice = 0;
  int unfinished = 0;
  for (const Entry* entry : all) {
    if (const auto why = difference(*entry, newest); !why.empty())
      left_out[why].insert(entry->session);
    else if (entry->trial.practice)
      ++practice;
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

Result<ReportContent> gather_progress(SessionStore& store, const std::string& code) {
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

  std::vector<Entry> entries;
  std::vector<TrialRecord> last_trials;
  for (const auto& record : *records) {
    const std::size_t index = content.sessions.size();
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

  std::map<std::pair<Hand, std::string>, std::vector<const Entry*>> tasks;
  for (const auto& entry : entries)
    tasks[{entry.session_record->hand, entry.trial.task_name}].push_back(&entry);
  for (auto& [task, all] : tasks) {
    // The newest trial that counts decides with what the others are compared.
    const auto newest = std::find_if(all.rbegin(), all.rend(),
                                     [](const Entry* entry) { return counts(entry->trial); });
    if (newest != all.rend()) all.erase(newest.base(), all.end());
    content.sections.push_back(make_section(store, all, content.sessions));
  }
  put_in_order(content.sections, content.sessions);
  if (!records->empty()) {
    auto quality = assess_quality(store, records->back(), last_trials);
    if (!quality) return quality.error();
    content.quality = std::move(*quality);
  }
  return content;
}

}  // namespace isograsp
