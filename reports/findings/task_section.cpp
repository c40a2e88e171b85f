// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/findings/task_section.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/ties.hpp"
#include "reports/findings/arm_findings.hpp"
#include "reports/findings/comparable.hpp"
#include "reports/findings/series_trend.hpp"
#include "tasks/facts/measure_words.hpp"

namespace isograsp::reports {

namespace {

/// Where trials that count were done under other conditions than those before. Levels that follow
/// success change with every trial: they are no breaks.
std::vector<SeriesBreak> breaks_of(const TaskSection& section,
                                   const std::vector<const StoredTrial*>& all) {
  std::vector<SeriesBreak> breaks;
  if (section.spec && section.spec->difficulty) return breaks;
  const StoredTrial* before = nullptr;
  for (const StoredTrial* trial : all) {
    if (!counts(trial->trial)) continue;
    if (before != nullptr)
      if (auto why = difference(*before, *trial); !why.empty())
        breaks.push_back({trial->session, std::move(why)});
    before = trial;
  }
  return breaks;
}

void add_practice(const std::vector<const StoredTrial*>& practised, MeasureSeries& series) {
  for (const StoredTrial* trial : practised)
    for (const auto& measure : trial->measures)
      if (measure.name == series.name && measure.channel == series.channel && measure.value &&
          measure.version == series.version && measure.unit == series.unit)
        series.practice.push_back({trial->session, *measure.value});
}

/// What healthy people do in one measure.
Result<std::optional<NormBand>> norm_of(const VerdictContext& context, const StoredTrial& like,
                                        const MeasureSeries& series) {
  const auto query = pool_query(like, series);
  const auto healthy = renewed_values(context.renewal, query, context.store.healthy_values(query));
  if (!healthy) return healthy.error();
  return norm_band(*healthy, like, context.profile,
                   tasks::words_of(series.name, series.channel).censored);
}

/// To the key measures, and to the shares of the links of an arm, what healthy people do.
Result<void> add_norms(const VerdictContext& context, const StoredTrial& like,
                       TaskSection& section) {
  const storage::PatientProfile& person = context.profile;
  if (!person.sex || !person.birth_year || !person.dominant) return {};
  if (section.spec && section.spec->difficulty) return {};  // levels follow success: no assessment
  for (auto& series : section.series) {
    if (!series.key && primary_of(context, section, series.name, series.channel) == nullptr)
      continue;
    auto norm = norm_of(context, like, series);
    if (!norm) return norm.error();
    series.norm = *std::move(norm);
  }
  for (std::size_t link = 0; link < kArmLinkCount; ++link)
    for (const Measure& measure : like.measures) {
      if (measure.name != "relative_rotation" || measure.channel != kArmLinkNames[link]) continue;
      MeasureSeries series;
      series.name = measure.name;
      series.channel = measure.channel;
      series.unit = measure.unit;
      series.version = measure.version;
      auto norm = norm_of(context, like, series);
      if (!norm) return norm.error();
      section.link_shares[link] = *std::move(norm);
    }
  return {};
}

/// Those of the session of the last.
std::vector<const StoredTrial*> newest_session_of(const std::vector<const StoredTrial*>& trials) {
  std::vector<const StoredTrial*> newest;
  for (const StoredTrial* trial : trials)
    if (trial->session == trials.back()->session) newest.push_back(trial);
  return newest;
}

}  // namespace

Result<TaskSection> make_section(const VerdictContext& context,
                                 const std::vector<const StoredTrial*>& all,
                                 const std::vector<ReportSession>& sessions) {
  const StoredTrial& newest = *all.back();
  TaskSection section;
  section.task = newest.trial.task_name;
  section.version = newest.trial.task_version;
  section.hand = newest.session_record->hand;
  section.source = source_of(*newest.session_record);
  if (auto spec = tasks::parse_task(newest.trial.task_text, newest.trial.task_name))
    section.spec = std::move(*spec);

  std::vector<const StoredTrial*> compared;
  std::vector<const StoredTrial*> practised;
  std::map<std::string_view, std::set<std::size_t>> left_out;  // by why, in English
  int practice = 0;
  int helped = 0;
  int unfinished = 0;
  for (const StoredTrial* entry : all) {
    if (const auto why = difference(*entry, newest); !why.empty())
      left_out[why.english()].insert(entry->session);
    else if (entry->trial.practice) {
      ++practice;
      if (entry->trial.status == storage::TrialStatus::completed && !entry->trial.helped)
        practised.push_back(entry);
    } else if (entry->trial.helped)
      ++helped;
    else if (entry->trial.status != storage::TrialStatus::completed)
      ++unfinished;
    else
      compared.push_back(entry);
  }
  section.breaks = breaks_of(section, all);
  section.postures = posture_results(section, newest_session_of(compared));
  for (Text& line : sharing_lines(section, compared)) section.notes.push_back(std::move(line));
  for (const auto& [why, which] : left_out)
    section.notes.push_back((which.size() == 1 ? "Session %1 not compared: %2"_text
                                               : "Sessions %1 not compared: %2"_text)(
        session_numbers(which, sessions), Known{std::string(why)}));
  const auto note = [&](int n, Words one, Phrase<1> many) {
    if (n == 1) section.notes.emplace_back(one);
    if (n > 1) section.notes.push_back(many(n));
  };
  note(practice, "1 practice trial left out"_text, "%1 practice trials left out"_text);
  note(helped, "1 trial with the therapist's help left out"_text,
       "%1 trials with the therapist's help left out"_text);
  note(unfinished, "1 trial that did not end left out"_text,
       "%1 trials that did not end left out"_text);
  if (compared.empty()) return section;
  // What is research stands in no report of a patient, whatever was chosen as primary.
  if (section.spec && section.spec->kind->research) {
    section.notes.push_back(
        "What this task measures is of research: exports have it, this report does not."_text);
    return section;
  }

  for (const Measure& measure : compared.back()->measures) {
    if (tasks::place_of(section.spec, measure.name, measure.channel).prominence ==
            tasks::Prominence::none &&
        primary_of(context, section, measure.name, measure.channel) == nullptr)
      continue;
    section.series.push_back(make_series(measure, compared, sessions, section));
    add_practice(practised, section.series.back());
    section.series.back().trend = trend_words(section.series.back(), sessions);
  }
  const auto place = [&](const MeasureSeries& series) {
    return tasks::place_of(section.spec, series.name, series.channel);
  };
  std::stable_sort(section.series.begin(), section.series.end(),
                   [&](const auto& a, const auto& b) { return place(a).rank < place(b).rank; });
  for (auto& series : section.series)
    series.key = place(series).prominence == tasks::Prominence::key;
  if (auto compared_with = add_norms(context, *compared.back(), section); !compared_with)
    return compared_with.error();
  if (auto judged = judge_section(context, *compared.back(), sessions, section); !judged)
    return judged.error();
  return section;
}

Extremes extremes_of(const TaskSection& section, const std::vector<const StoredTrial*>& all) {
  Extremes extremes;
  if (!section.spec || !section.spec->kind->follows_curve) return extremes;
  const auto key = std::find_if(section.series.begin(), section.series.end(),
                                [](const MeasureSeries& series) { return series.key; });
  if (key == section.series.end()) return extremes;
  const tasks::Better better = tasks::words_of(key->name, key->channel).better;
  if (better == tasks::Better::unknown) return extremes;
  const auto badness = [better](double value) {
    return better == tasks::Better::higher  ? -value
           : better == tasks::Better::lower ? value
                                            : std::abs(value);
  };
  std::vector<const StoredTrial*> compared;
  std::vector<double> bad;
  for (const StoredTrial* trial : all) {
    if (!counts(trial->trial) || !difference(*trial, *all.back()).empty()) continue;
    for (const auto& measure : trial->measures) {
      if (measure.name != key->name || measure.channel != key->channel || !measure.value ||
          measure.version != key->version)
        continue;
      compared.push_back(trial);
      bad.push_back(badness(*measure.value));
    }
  }
  if (bad.empty()) return extremes;
  const auto first_tied_with = [&](double value) {  // the oldest of trials that are alike
    const auto found = std::find_if(
        bad.begin(), bad.end(), [&](double one) { return are_tied(one, value, tie_width(bad)); });
    return compared[static_cast<std::size_t>(found - bad.begin())];
  };
  const auto [least, most] = std::minmax_element(bad.begin(), bad.end());
  extremes.best = first_tied_with(*least);
  extremes.worst = first_tied_with(*most);
  return extremes.best == extremes.worst ? Extremes{} : extremes;
}

void put_in_order(std::vector<TaskSection>& sections, const std::vector<ReportSession>& sessions) {
  const auto right = std::count_if(sessions.begin(), sessions.end(),
                                   [](const auto& session) { return session.hand == Hand::right; });
  const std::size_t last = tasks::all_kinds().size();
  const bool left_first = right * 2 < static_cast<long>(sessions.size());
  std::stable_sort(sections.begin(), sections.end(), [&](const auto& a, const auto& b) {
    if (a.hand != b.hand) return (a.hand == Hand::left) == left_first;
    const std::size_t kind_a = a.spec ? tasks::order_of(*a.spec->kind) : last;
    const std::size_t kind_b = b.spec ? tasks::order_of(*b.spec->kind) : last;
    return kind_a != kind_b ? kind_a < kind_b : a.task < b.task;
  });
}

}  // namespace isograsp::reports
