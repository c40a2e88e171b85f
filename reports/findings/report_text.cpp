// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/findings/report_text.hpp"

#include <algorithm>
#include <cmath>

#include "tasks/facts/measure_words.hpp"
#include "tasks/reasons/reasons.hpp"

namespace isograsp::reports {

namespace {

/// Levels that follow the maximum and levels that stay are never one series.
Text load_words(const TaskSection& section) {
  const tasks::Aim* aim = section.spec ? section.spec->aim() : nullptr;
  if (aim == nullptr) return {};
  switch (aim->scale) {
    case tasks::Scale::of_maximum: return "relative load (% of the day's maximum)"_text;
    case tasks::Scale::of_comfortable: return "relative load (% of the comfortable force)"_text;
    case tasks::Scale::of_baseline: return "fixed load (of the first maximum)"_text;
    case tasks::Scale::newton: return "fixed load"_text;
  }
  return {};
}

Text middle_dotted(const std::vector<Text>& parts) {
  return joined(parts, " \u00b7 "_text);
}

}  // namespace

std::vector<Fact> header_facts(const ReportContent& content, const Language& language) {
  const Speaker say(language);
  if (content.sessions.empty()) return {{say("Sessions"_text), say("none"_text)}};
  const auto& first = content.sessions.front();
  const auto& last = content.sessions.back();
  const auto of_hand = [&](Hand hand) {
    return std::count_if(content.sessions.begin(), content.sessions.end(),
                         [hand](const auto& session) { return session.hand == hand; });
  };
  const auto right = of_hand(Hand::right);
  const auto left = of_hand(Hand::left);
  const Text hand = right > 0 && left > 0 ? "right %1, left %2"_text(right, left)
                    : right + left == 0   ? side_words(std::nullopt)
                                          : side_words(right > 0 ? Hand::right : Hand::left);
  const Text period = last.date == first.date
                          ? day_words(first.date)
                          : "%1 to %2"_text(day_words(first.date), day_words(last.date));
  const auto count = content.sessions.size();
  const Text sessions = static_cast<int>(count) < content.sessions_stored
                            ? "%1 of %2"_text(count, content.sessions_stored)
                            : "%1"_text(count);
  return {{say("Period"_text), say(period)},
          {say("Days since first session"_text), std::to_string(std::lround(last.day))},
          {say("Sessions"_text), say(sessions)},
          {say("Hand"_text), say(hand)},
          {say("Forces"_text), say(words_of(last.source))}};
}

Text watermark(const ReportContent& content) {
  return middle_dotted({content.simulated ? Text("SIMULATED DEVICE"_text) : Text(),
                        content.recorded ? Text("REPLAYED RECORDING"_text) : Text()});
}

Text verdict_words(const ChangeVerdict& verdict) {
  const bool confirmed = verdict.change.confirmed;
  switch (verdict.change.verdict) {
    case Verdict::improved:
      return confirmed ? "improved (confirmed)"_text : "improved (possible)"_text;
    case Verdict::worsened:
      return confirmed ? "worsened (confirmed)"_text : "worsened (possible)"_text;
    case Verdict::within_error: return "not larger than measurement error"_text;
    case Verdict::cannot_be_judged: break;
  }
  return "cannot be judged yet"_text;
}

Text verdict_basis(const ChangeVerdict& verdict) {
  if (verdict.change.verdict == Verdict::cannot_be_judged) return verdict.reason;
  const Text left_out = verdict.left_out == 0 ? Text()
                        : verdict.left_out == 1
                            ? Text("1 outlying pair left out"_text)
                            : "%1 outlying pairs left out"_text(verdict.left_out);
  const Text sureness = verdict.change.verdict == Verdict::within_error ? Text()
                        : verdict.change.confirmed ? Text("two assessments in a row"_text)
                                                   : Text("one assessment so far"_text);
  return apart({listed({sureness, "%1 stable people"_text(verdict.people), left_out}),
                verdict.fall_cannot_be_told ? Text("a fall cannot be told"_text) : Text()});
}

Text mdc_words(const ChangeJudgement& change, const std::string& unit) {
  if (!change.mdc_down || !change.mdc_up) return {};
  const std::string printed = unit.starts_with("of ") ? "" : unit;
  if (-*change.mdc_down == *change.mdc_up)
    return "MDC95 %1"_text(value_words(*change.mdc_up, printed));
  return "MDC95 %1\u00a0/ %2"_text(Number{tasks::format_change(*change.mdc_down, unit)},
                                   change_words(*change.mdc_up, unit));
}

/// The same measure of the other hand, in the same task.
Text other_hand_words(const ReportContent& content, const TaskSection& section,
                      const MeasureSeries& series) {
  for (const auto& other : content.sections) {
    if (other.task != section.task || !other.hand || !section.hand || other.hand == section.hand ||
        other.version != section.version || other.source != section.source)
      continue;
    for (const auto& same : other.series)
      if (same.name == series.name && same.channel == series.channel && same.last &&
          same.unit == series.unit && same.version == series.version)
        return (other.hand == Hand::right ? "right hand %1"_text : "left hand %1"_text)(
            value_words(*same.last, same.unit));
  }
  return {};
}

Text healthy_words(const MeasureSeries& series) {
  if (!series.norm) return {};
  const auto count = series.norm->values.size();
  if (!series.norm->low) return "healthy: n\u00a0%1, no band"_text(count);
  return "healthy %1 to %2 (n\u00a0%3)"_text(value_number(*series.norm->low, series.unit),
                                             value_words(*series.norm->high, series.unit), count);
}

std::vector<GlanceRow> glance_rows(const ReportContent& content, const Language& language) {
  const Speaker say(language);
  std::vector<GlanceRow> rows;
  for (const auto& section : content.sections)
    for (const auto& series : section.series) {
      if (!series.key) continue;
      const auto cell = [&](const std::optional<double>& value) {
        return value ? say(value_words(*value, series.unit)) : std::string(kNoValue);
      };
      const auto words = tasks::words_of(series.name, series.channel);
      std::string last = cell(series.last);
      if (!series.last && !series.values.empty() && series.values.back().without_value > 0)
        last = say("no value"_text);
      GlanceRow row;
      row.task = say(Known{section.task});
      row.hand = say(hand_words(section.hand));
      row.measure = say(series_title(series));
      row.unit = series.unit;
      row.baseline = cell(series.baseline);
      row.baseline_basis = series.baseline ? say(series.baseline_basis) : "";
      row.last = last;
      row.beside = say(apart({other_hand_words(content, section, series), healthy_words(series)}));
      auto change = series.change;
      if (series.verdict && series.verdict->change.change) change = series.verdict->change.change;
      row.change = change ? say(change_words(*change, series.unit)) : std::string(kNoValue);
      row.direction = say(better_words(words.better));
      row.verdict = kNoValue;
      if (series.verdict) {
        row.primary = true;
        row.mdc = say(mdc_words(series.verdict->change, series.unit));
        row.verdict = say(verdict_words(*series.verdict));
        row.verdict_basis = say(verdict_basis(*series.verdict));
      }
      rows.push_back(std::move(row));
    }
  std::stable_partition(rows.begin(), rows.end(), [](const auto& row) { return row.primary; });
  return rows;
}

std::vector<Text> verdict_notes(const ReportContent& content) {
  std::vector<Text> notes;
  if (content.primary_measures == 0)
    notes.emplace_back(
        "No primary measure has been chosen for this patient, so no change is judged. At most four "
        "can be, before the second assessment. Practice and helped trials are left out."_text);
  else
    notes.emplace_back(
        "Verdicts are for the primary measures. A change is improved or worsened if it is larger "
        "than the smallest detectable change (MDC95) from the baseline, the mean of two days. "
        "MDC95 "
        "follows from how much stable people of this clinic differ from day to day. Possible: one "
        "assessment; confirmed: two in a row. Practice and helped trials are left out."_text);
  std::vector<Text> chosen;
  for (const auto& section : content.sections)
    for (const auto& series : section.series)
      if (series.verdict)
        chosen.push_back("%1 (%2) by %3, %4"_text(series_title(series), Known{section.task},
                                                  series.verdict->chosen_by,
                                                  day_words(series.verdict->chosen_on)));
  if (!chosen.empty()) notes.push_back("Chosen: %1."_text(apart(chosen)));
  for (const auto& waiting : content.waiting)
    notes.push_back("Cannot be judged yet: %1."_text(waiting));
  if (content.early)
    notes.emplace_back(
        "Less than six months after the onset: change does not show what caused it."_text);
  return notes;
}

Text session_words(const ReportSession& session) {
  return "%1, %2, %3, %4"_text(session.number, day_words(session.date), hand_words(session.hand),
                               Known{session.device});
}

Text section_subtitle(const TaskSection& section) {
  return middle_dotted(
      {!section.hand                 ? "Both hands"_text
       : section.hand == Hand::right ? "Right hand"_text
                                     : "Left hand"_text,
       "version %1"_text(section.version), load_words(section),
       section.source == Source::device ? Text() : Text(words_of(section.source))});
}

Text series_title(const MeasureSeries& series) {
  return measure_title(series.name, series.channel);
}

Text better_words(tasks::Better better) {
  switch (better) {
    case tasks::Better::lower: return "lower is better"_text;
    case tasks::Better::higher: return "higher is better"_text;
    case tasks::Better::near_zero: return "nearer to zero is better"_text;
    case tasks::Better::unknown: break;
  }
  return {};
}

Text series_subtitle(const MeasureSeries& series) {
  return middle_dotted({tasks::unit_words(tasks::printed_unit(series.unit).text),
                        better_words(tasks::words_of(series.name, series.channel).better)});
}

Text last_trial_title(const TaskSection& section, const ReportContent& content) {
  if (!section.last) return {};
  const auto& session = content.sessions[section.last->session];
  return "Last trial \u00b7 session %1, %2, trial %3"_text(session.number, day_words(session.date),
                                                           section.last->number);
}

Text extreme_title(const TaskSection& section, const DrawnTrial& trial, bool best,
                   const ReportContent& content) {
  const int session = content.sessions[trial.session].number;
  Text text = (best ? "Best trial \u00b7 session %1, trial %2"_text
                    : "Worst trial \u00b7 session %1, trial %2"_text)(session, trial.number);
  const auto key = std::find_if(section.series.begin(), section.series.end(),
                                [](const auto& series) { return series.key; });
  for (const auto& measure : trial.measures)
    if (key != section.series.end() && measure.name == key->name &&
        measure.channel == key->channel && measure.value)
      text = middle_dotted({text, value_words(*measure.value, measure.unit)});
  return text;
}

Text fingers_note() {
  return "Forces of the fingers in their contact frames, along the same time as the way of the "
         "object above: pressing (normal), sideways (x) and along the finger's support (y)."_text;
}

Text last_trial_results(const TaskSection& section) {
  if (!section.last) return {};
  std::vector<Text> results;
  for (const auto& measure : section.last->measures) {
    const bool in_trend =
        std::any_of(section.series.begin(), section.series.end(), [&](const auto& series) {
          return series.name == measure.name && series.channel == measure.channel;
        });
    const auto words = tasks::words_of(measure.name, measure.channel);
    if (in_trend || !words.clinical) continue;
    results.push_back("%1: %2"_text(measure_title(measure.name, measure.channel),
                                    measure.value ? value_words(*measure.value, measure.unit)
                                                  : tasks::reason_words(measure.reason)));
  }
  return middle_dotted(results);
}

std::vector<std::array<std::string, 4>> series_table(const MeasureSeries& series,
                                                     const ReportContent& content,
                                                     const Language& language) {
  const Speaker say(language);
  std::vector<std::array<std::string, 4>> rows;
  for (const auto& value : series.values) {
    const auto& session = content.sessions[value.session];
    std::vector<Text> trials;
    for (const double trial : value.trials)
      trials.push_back("%1"_text(value_number(trial, series.unit)));
    if (value.without_value > 0) trials.push_back("%1 without value"_text(value.without_value));
    rows.push_back(
        {say((value.first_day ? "%1 (first day)"_text : "%1"_text)(session.number)),
         say(day_words(session.date)),
         value.mean ? say(value_number(*value.mean, series.unit)) : std::string(kNoValue),
         say(apart(trials))});
  }
  return rows;
}

Text trend_key(const ReportContent& content) {
  const bool healthy =
      std::any_of(content.sections.begin(), content.sections.end(), [](const auto& section) {
        return std::any_of(section.series.begin(), section.series.end(),
                           [](const auto& series) { return series.norm.has_value(); });
      });
  const bool judged =
      std::any_of(content.sections.begin(), content.sections.end(), [](const auto& section) {
        return std::any_of(section.series.begin(), section.series.end(), [](const auto& series) {
          return series.verdict && series.verdict->change.mdc_up;
        });
      });
  std::vector<Text> marks{
      "In the trends: filled \u25cf mean of a session (\u25a0 left hand) \u00b7 hollow \u25cb "
      "first day \u00b7 small dots single trials \u00b7 dotted line baseline \u00b7 \u00d7 a "
      "trial without a value \u00b7 small hollow \u25cb practice \u00b7 double line: other "
      "conditions from here on \u00b7 dashed upright line: treatment (B botulinum toxin, D drug, "
      "O orthosis, T therapy, X other)"_text};
  if (judged) marks.emplace_back("band: not larger than measurement error"_text);
  if (healthy)
    marks.emplace_back(
        "at the right edge healthy people of the same sex, age decade and dominance: bar the "
        "middle 90 %, \u25b3 one of fewer than twenty, \u2191 \u2193 beyond the scale"_text);
  return "%1. Under the title: trend of all days (Theil and Sen) with its 95 % interval; of times "
         "that did not always come, how often they came and the rank correlation with time (misses "
         "tied as longest, negative: sooner)."_text(middle_dotted(marks));
}

Text footer(const ReportContent& content) {
  return "IsoGrasp %1 is research and training software, not a certified medical device.\nResults "
         "do not replace clinical judgement. Force capacity is not daily use."_text(
             content.software_version);
}

Text nothing_yet() {
  return "No completed trial is stored for this patient yet. Record a session, then make the "
         "report again."_text;
}

}  // namespace isograsp::reports
