// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/findings/report_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "tasks/facts/measure_words.hpp"

namespace isograsp::reports {

namespace {

constexpr const char* kNone = "\u2013";

std::string with_capital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 32);
  return text;
}

std::string with_unit(const std::string& number, const std::string& unit) {
  const auto printed = tasks::printed_unit(unit).text;
  if (printed.empty()) return number;
  return number + (printed == "°" ? "" : "\u00a0") + printed;
}

/// Levels that follow the maximum and levels that stay are never one series.
std::string load_words(const TaskSection& section) {
  const tasks::Aim* aim = section.spec ? section.spec->aim() : nullptr;
  if (aim == nullptr) return "";
  switch (aim->scale) {
    case tasks::Scale::of_maximum: return " \u00b7 relative load (% of the day's maximum)";
    case tasks::Scale::of_comfortable: return " \u00b7 relative load (% of the comfortable force)";
    case tasks::Scale::of_baseline: return " \u00b7 fixed load (of the first maximum)";
    case tasks::Scale::newton: return " \u00b7 fixed load";
  }
  return "";
}

}  // namespace

std::string format_date(const std::string& iso) {
  static constexpr std::array kMonths{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                      "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  unsigned month = 0;
  unsigned day = 0;
  if (iso.size() < 10) return iso;
  std::from_chars(iso.data() + 5, iso.data() + 7, month);
  std::from_chars(iso.data() + 8, iso.data() + 10, day);
  if (month < 1 || month > kMonths.size()) return iso;
  return std::to_string(day) + "\u00a0" + kMonths[month - 1] + "\u00a0" + iso.substr(0, 4);
}

std::vector<Fact> header_facts(const ReportContent& content) {
  if (content.sessions.empty()) return {{"Sessions", "none"}};
  const auto& first = content.sessions.front();
  const auto& last = content.sessions.back();
  const auto of_hand = [&](Hand hand) {
    return std::count_if(content.sessions.begin(), content.sessions.end(),
                         [hand](const auto& session) { return session.hand == hand; });
  };
  const auto right = of_hand(Hand::right);
  const auto left = of_hand(Hand::left);
  std::string hand = right > 0 ? "right" : "left";
  if (right > 0 && left > 0)
    hand = "right " + std::to_string(right) + ", left " + std::to_string(left);
  std::string period = format_date(first.date);
  if (last.date != first.date) period += " to " + format_date(last.date);
  const int count = static_cast<int>(content.sessions.size());
  std::string sessions = std::to_string(count);
  if (count < content.sessions_stored) sessions += " of " + std::to_string(content.sessions_stored);
  return {{"Period", period},
          {"Days since first session", std::to_string(std::lround(last.day))},
          {"Sessions", sessions},
          {"Hand", hand},
          {"Forces", std::string(name_of(last.source))}};
}

std::string watermark(const ReportContent& content) {
  std::string text;
  if (content.simulated) text = "SIMULATED DEVICE";
  if (content.recorded)
    text += (text.empty() ? "" : " \u00b7 ") + std::string("REPLAYED RECORDING");
  return text;
}

std::string verdict_words(const ChangeVerdict& verdict) {
  const char* sureness = verdict.change.confirmed ? " (confirmed)" : " (possible)";
  switch (verdict.change.verdict) {
    case Verdict::improved: return std::string("improved") + sureness;
    case Verdict::worsened: return std::string("worsened") + sureness;
    case Verdict::within_error: return "not larger than measurement error";
    case Verdict::cannot_be_judged: break;
  }
  return "cannot be judged yet";
}

std::string verdict_basis(const ChangeVerdict& verdict) {
  if (verdict.change.verdict == Verdict::cannot_be_judged) return verdict.reason;
  std::string people = std::to_string(verdict.people) + " stable people";
  if (verdict.left_out > 0)
    people += ", " + std::to_string(verdict.left_out) +
              (verdict.left_out == 1 ? " outlying pair" : " outlying pairs") + " left out";
  if (verdict.fall_cannot_be_told) people += "; a fall cannot be told";
  if (verdict.change.verdict == Verdict::within_error) return people;
  return (verdict.change.confirmed ? "two assessments in a row, " : "one assessment so far, ") +
         people;
}

std::string mdc_words(const ChangeJudgement& change, const std::string& unit) {
  if (!change.mdc_down || !change.mdc_up) return "";
  const std::string printed = unit.starts_with("of ") ? "" : unit;
  const bool even = -*change.mdc_down == *change.mdc_up;
  return "MDC95 " + (even ? with_unit(tasks::format_value(*change.mdc_up, unit), printed)
                          : tasks::format_change(*change.mdc_down, unit) + "\u00a0/ " +
                                with_unit(tasks::format_change(*change.mdc_up, unit), printed));
}

/// The same measure of the other hand, in the same task.
std::string other_hand_words(const ReportContent& content, const TaskSection& section,
                             const MeasureSeries& series) {
  for (const auto& other : content.sections) {
    if (other.task != section.task || other.hand == section.hand ||
        other.version != section.version || other.source != section.source)
      continue;
    for (const auto& same : other.series)
      if (same.name == series.name && same.channel == series.channel && same.last &&
          same.unit == series.unit && same.version == series.version)
        return std::string(name_of(other.hand)) + " hand " +
               with_unit(tasks::format_value(*same.last, same.unit), same.unit);
  }
  return "";
}

std::string healthy_words(const MeasureSeries& series) {
  if (!series.norm) return "";
  const std::string count = "n\u00a0" + std::to_string(series.norm->values.size());
  if (!series.norm->low) return "healthy: " + count + ", no band";
  return "healthy " + tasks::format_value(*series.norm->low, series.unit) + " to " +
         with_unit(tasks::format_value(*series.norm->high, series.unit), series.unit) + " (" +
         count + ")";
}

std::vector<GlanceRow> glance_rows(const ReportContent& content) {
  std::vector<GlanceRow> rows;
  for (const auto& section : content.sections)
    for (const auto& series : section.series) {
      if (!series.key) continue;
      const auto shown = [&](const std::optional<double>& value) {
        return value ? with_unit(tasks::format_value(*value, series.unit), series.unit)
                     : std::string(kNone);
      };
      const auto words = tasks::words_for(series.name, series.channel);
      std::string last = shown(series.last);
      if (!series.last && !series.values.empty() && series.values.back().without_value > 0)
        last = "no value";
      GlanceRow row;
      row.task = section.task;
      row.hand = name_of(section.hand);
      row.measure = words.title;
      row.unit = series.unit;
      row.baseline = shown(series.baseline);
      row.baseline_basis = series.baseline ? series.baseline_basis : "";
      row.last = last;
      row.beside = other_hand_words(content, section, series);
      if (const auto healthy = healthy_words(series); !healthy.empty())
        row.beside += (row.beside.empty() ? "" : "; ") + healthy;
      auto change = series.change;
      if (series.verdict && series.verdict->change.change) change = series.verdict->change.change;
      row.change = change ? with_unit(tasks::format_change(*change, series.unit),
                                      series.unit.starts_with("of ") ? "" : series.unit)
                          : std::string(kNone);
      row.direction = tasks::describe(words.better);
      row.verdict = kNone;
      if (series.verdict) {
        row.primary = true;
        row.mdc = mdc_words(series.verdict->change, series.unit);
        row.verdict = verdict_words(*series.verdict);
        row.verdict_basis = verdict_basis(*series.verdict);
      }
      rows.push_back(std::move(row));
    }
  std::stable_partition(rows.begin(), rows.end(), [](const auto& row) { return row.primary; });
  return rows;
}

std::vector<std::string> verdict_notes(const ReportContent& content) {
  std::vector<std::string> notes;
  if (content.primary_measures == 0)
    notes.push_back(
        "No primary measure has been chosen for this patient, so no change is judged. At most four "
        "can be, before the second assessment. Practice and helped trials are left out.");
  else
    notes.push_back(
        "Verdicts are for the primary measures. A change is improved or worsened if it is larger "
        "than the smallest detectable change (MDC95) from the baseline, the mean of two days. "
        "MDC95 "
        "follows from how much stable people of this clinic differ from day to day. Possible: one "
        "assessment; confirmed: two in a row. Practice and helped trials are left out.");
  std::string chosen;
  for (const auto& section : content.sections)
    for (const auto& series : section.series)
      if (series.verdict)
        chosen += (chosen.empty() ? "Chosen: " : "; ") +
                  tasks::words_for(series.name, series.channel).title + " (" + section.task +
                  ") by " + series.verdict->chosen_by + ", " +
                  format_date(series.verdict->chosen_on);
  if (!chosen.empty()) notes.push_back(chosen + ".");
  for (const auto& waiting : content.waiting)
    notes.push_back("Cannot be judged yet: " + waiting + ".");
  if (content.early)
    notes.push_back("Less than six months after the onset: change does not show what caused it.");
  return notes;
}

std::string section_subtitle(const TaskSection& section) {
  return with_capital(std::string(name_of(section.hand))) + " hand \u00b7 version " +
         std::to_string(section.version) + load_words(section) +
         (section.source == Source::device ? ""
                                           : " \u00b7 " + std::string(name_of(section.source)));
}

std::string series_title(const MeasureSeries& series) {
  return tasks::words_for(series.name, series.channel).title;
}

std::string series_subtitle(const MeasureSeries& series) {
  const auto unit = tasks::printed_unit(series.unit).text;
  const std::string direction(
      tasks::describe(tasks::words_for(series.name, series.channel).better));
  if (unit.empty()) return direction;
  return direction.empty() ? unit : unit + " \u00b7 " + direction;
}

std::string last_trial_title(const TaskSection& section, const ReportContent& content) {
  if (!section.last) return "";
  const auto& session = content.sessions[section.last->session];
  return "Last trial \u00b7 session " + std::to_string(session.number) + ", " +
         format_date(session.date) + ", trial " + std::to_string(section.last->number);
}

std::string extreme_title(const TaskSection& section, const DrawnTrial& trial, bool best,
                          const ReportContent& content) {
  const auto& session = content.sessions[trial.session];
  std::string text = std::string(best ? "Best" : "Worst") + " trial \u00b7 session " +
                     std::to_string(session.number) + ", trial " + std::to_string(trial.number);
  const auto key = std::find_if(section.series.begin(), section.series.end(),
                                [](const auto& series) { return series.key; });
  for (const auto& measure : trial.measures)
    if (key != section.series.end() && measure.name == key->name &&
        measure.channel == key->channel && measure.value)
      text +=
          " \u00b7 " + with_unit(tasks::format_value(*measure.value, measure.unit), measure.unit);
  return text;
}

std::string fingers_note() {
  return "Forces of the fingers in their contact frames, along the same time as the way of the "
         "object above: pressing (normal), sideways (x) and along the finger's support (y).";
}

std::string last_trial_results(const TaskSection& section) {
  if (!section.last) return "";
  std::string text;
  for (const auto& measure : section.last->measures) {
    const bool in_trend =
        std::any_of(section.series.begin(), section.series.end(), [&](const auto& series) {
          return series.name == measure.name && series.channel == measure.channel;
        });
    const auto words = tasks::words_for(measure.name, measure.channel);
    if (in_trend || !words.clinical) continue;
    if (!text.empty()) text += " \u00b7 ";
    text += words.title + ": ";
    text += measure.value
                ? with_unit(tasks::format_value(*measure.value, measure.unit), measure.unit)
                : measure.reason;
  }
  return text;
}

std::vector<std::array<std::string, 4>> series_table(const MeasureSeries& series,
                                                     const ReportContent& content) {
  std::vector<std::array<std::string, 4>> rows;
  for (const auto& value : series.values) {
    const auto& session = content.sessions[value.session];
    std::string trials;
    for (const double trial : value.trials)
      trials += (trials.empty() ? "" : "; ") + tasks::format_value(trial, series.unit);
    if (value.without_value > 0)
      trials +=
          (trials.empty() ? "" : "; ") + std::to_string(value.without_value) + " without value";
    rows.push_back({std::to_string(session.number) + (value.first_day ? " (first day)" : ""),
                    format_date(session.date),
                    value.mean ? tasks::format_value(*value.mean, series.unit) : kNone, trials});
  }
  return rows;
}

std::string trend_key(const ReportContent& content) {
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
  std::string key =
      "In the trends: filled \u25cf mean of a session (\u25a0 left hand) \u00b7 hollow \u25cb "
      "first day \u00b7 small dots single trials \u00b7 dotted line baseline \u00b7 \u00d7 a "
      "trial without a value \u00b7 small hollow \u25cb practice \u00b7 double line: other "
      "conditions from here on \u00b7 dashed upright line: treatment (B botulinum toxin, D drug, "
      "O orthosis, T therapy, X other)";
  if (judged) key += " \u00b7 band: not larger than measurement error";
  if (healthy)
    key +=
        " \u00b7 at the right edge healthy people of the same sex, age decade and dominance: bar "
        "the middle 90 %, \u25b3 one of fewer than twenty, \u2191 \u2193 beyond the scale";
  return key +
         ". Under the title: trend of all days (Theil and Sen) with its 95 % interval; of times "
         "that did not always come, how often they came and the rank correlation with time (misses "
         "tied as longest, negative: sooner).";
}

std::string footer(const ReportContent& content) {
  return "IsoGrasp " + content.software_version +
         " is research and training software, not a certified medical device.\nResults do not "
         "replace clinical judgement. Force capacity is not daily use.";
}

std::string nothing_yet() {
  return "No completed trial is stored for this patient yet. Record a session, then make the "
         "report "
         "again.";
}

}  // namespace isograsp::reports
