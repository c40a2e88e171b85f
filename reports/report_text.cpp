// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/report_text.hpp"

#include <algorithm>
#include <charconv>

#include "reports/measure_words.hpp"

namespace isograsp {

namespace {

constexpr const char* kNone = "\u2013";

std::string capital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 32);
  return text;
}

std::string with_unit(const std::string& number, const std::string& unit) {
  const auto printed = printed_unit(unit).text;
  if (printed.empty()) return number;
  return number + (printed == "°" ? "" : "\u00a0") + printed;
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
  return {{"Period", period},
          {"Days since first session", std::to_string(last.day)},
          {"Sessions", std::to_string(content.sessions.size())},
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

std::vector<GlanceRow> glance_rows(const ReportContent& content) {
  std::vector<GlanceRow> rows;
  for (const auto& section : content.sections)
    for (const auto& series : section.series) {
      if (!series.key) continue;
      const auto shown = [&](const std::optional<double>& value) {
        return value ? with_unit(format_value(*value, series.unit), series.unit)
                     : std::string(kNone);
      };
      const auto words = words_for(series.name, series.channel);
      std::string last = shown(series.last);
      if (!series.last && !series.values.empty() && series.values.back().without_value > 0)
        last = "no value";
      rows.push_back({section.task, std::string(name_of(section.hand)), words.title, series.unit,
                      shown(series.baseline), series.baseline ? series.baseline_basis : "", last,
                      series.change ? with_unit(format_change(*series.change, series.unit),
                                                series.unit.starts_with("of ") ? "" : series.unit)
                                    : std::string(kNone),
                      std::string(describe(words.better)),
                      series.verdict.empty() ? kNone : series.verdict});
    }
  return rows;
}

std::string verdict_note() {
  return "A change is judged against the day-to-day variation of stable patients. Too few pairs of "
         "assessments have been collected for that; until then no change is called better or "
         "worse. Practice trials are left out.";
}

std::string section_subtitle(const TaskSection& section) {
  return capital(std::string(name_of(section.hand))) + " hand \u00b7 version " +
         std::to_string(section.version) +
         (section.source == Source::device ? ""
                                           : " \u00b7 " + std::string(name_of(section.source)));
}

std::string series_title(const MeasureSeries& series) {
  return words_for(series.name, series.channel).title;
}

std::string series_subtitle(const MeasureSeries& series) {
  const auto unit = printed_unit(series.unit).text;
  const std::string direction(describe(words_for(series.name, series.channel).better));
  if (unit.empty()) return direction;
  return direction.empty() ? unit : unit + " \u00b7 " + direction;
}

std::string last_trial_title(const TaskSection& section, const ReportContent& content) {
  if (!section.last) return "";
  const auto& session = content.sessions[section.last->session];
  return "Last trial \u00b7 session " + std::to_string(session.number) + ", " +
         format_date(session.date) + ", trial " + std::to_string(section.last->number);
}

std::string last_trial_results(const TaskSection& section) {
  if (!section.last) return "";
  std::string text;
  for (const auto& measure : section.last->measures) {
    const bool in_trend =
        std::any_of(section.series.begin(), section.series.end(), [&](const auto& series) {
          return series.name == measure.name && series.channel == measure.channel;
        });
    const auto words = words_for(measure.name, measure.channel);
    if (in_trend || !words.clinical) continue;
    if (!text.empty()) text += " \u00b7 ";
    text += words.title + ": ";
    text += measure.value ? with_unit(format_value(*measure.value, measure.unit), measure.unit)
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
      trials += (trials.empty() ? "" : "; ") + format_value(trial, series.unit);
    if (value.without_value > 0)
      trials +=
          (trials.empty() ? "" : "; ") + std::to_string(value.without_value) + " without value";
    rows.push_back({std::to_string(session.number) + (value.first_day ? " (first day)" : ""),
                    format_date(session.date),
                    value.mean ? format_value(*value.mean, series.unit) : kNone, trials});
  }
  return rows;
}

std::string trend_key() {
  return "In the trends: filled \u25cf mean of a session (\u25a0 left hand) \u00b7 hollow \u25cb "
         "first day "
         "\u00b7 small dots single trials \u00b7 dotted line baseline \u00b7 \u00d7 a trial "
         "without "
         "a value.";
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

}  // namespace isograsp
