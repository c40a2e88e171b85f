// SPDX-License-Identifier: GPL-3.0-or-later
// What stands beside the measures: goals, what limits this hand, the compass, the dose, the
// signature.
#include <algorithm>
#include <cmath>

#include "reports/findings/report_text.hpp"
#include "reports/paper/panel.hpp"
#include "reports/paper/plots.hpp"
#include "tasks/facts/measure_words.hpp"

namespace isograsp::reports {

namespace {

constexpr const char* kNothingKnown = "\u2013";

std::string capital(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

std::string percent(double share) {
  return std::to_string(std::lround(100.0 * share)) + "\u00a0%";
}

std::string interval(const Share& share) {
  return std::to_string(std::lround(100.0 * share.low)) + " to " + percent(share.high);
}

/// "ARAT 31, 40", oldest first: the first and the newest of each scale.
std::vector<std::vector<std::string>> score_rows(
    const std::vector<storage::ClinicalScore>& scores) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& scale : storage::kClinicalScales) {
    const storage::ClinicalScore* first = nullptr;
    const storage::ClinicalScore* last = nullptr;
    for (const auto& score : scores) {
      if (score.scale != scale.name) continue;
      if (first == nullptr) first = &score;
      last = &score;
    }
    if (first == nullptr) continue;
    const auto shown = [&](const storage::ClinicalScore& score) {
      const std::string unit = scale.unit.empty() ? "" : "\u00a0" + std::string(scale.unit);
      return tasks::format_value(score.value, "") + unit + ", " + format_date(score.on_date);
    };
    rows.push_back(
        {std::string(scale.name), first == last ? kNothingKnown : shown(*first), shown(*last)});
  }
  return rows;
}

std::optional<Panel> goals_panel(const ReportContent& content) {
  Panel panel;
  panel.heading = "Goals and everyday use";
  panel.lines.push_back(content.goals.empty() ? "No goal is written down."
                                              : "Goal: " + content.goals);
  const auto rows = score_rows(content.scores);
  if (rows.empty())
    panel.lines.push_back(
        "No score of everyday use or impairment is stored: whether the forces "
        "agree with daily life cannot be said.");
  else
    panel.table =
        PanelTable{"Clinical scales", {"Scale", "First", "Newest"}, {0.2, 0.4, 0.4}, rows};
  return panel;
}

std::string_view words_of(Standing standing) {
  switch (standing) {
    case Standing::below: return "clearly below";
    case Standing::not_clear: return "not clearly different";
    case Standing::as_good: return "as good";
    case Standing::cannot_be_said: break;
  }
  return "cannot be said";
}

std::string answer(const LimitsOfHand& limits) {
  const ComponentResult* main = main_limit(limits);
  const auto said = std::count_if(limits.components.begin(), limits.components.end(),
                                  [](const auto& one) { return one.share.has_value(); });
  if (said == 0) return "Cannot be said yet: nothing to compare with.";
  if (main == nullptr) return "Nothing that was compared is clearly below its reference.";
  std::string text = capital(std::string(name_of(main->component))) + " limits the " +
                     std::string(name_of(limits.hand)) +
                     " hand most: " + percent(main->share->share) + " of its reference (" +
                     main->reference_basis + "; 95 % interval " + interval(*main->share) + ").";
  const auto others = beside(limits, *main);
  std::string names;
  for (const auto* one : others)
    names += (names.empty() ? "" : ", ") + std::string(name_of(one->component));
  if (!names.empty()) text += " Not to be told apart from it: " + names + ".";
  return text + " Train next: " + std::string(training_for(main->component)) + ".";
}

std::optional<Panel> limits_panel(const ReportContent& content) {
  const LimitsOfHand& limits = content.limits;
  if (limits.components.empty()) return std::nullopt;
  Panel panel;
  panel.heading = "What limits this hand";
  panel.lines.push_back(answer(limits));
  PanelTable table{"Components of the " + std::string(name_of(limits.hand)) + " hand",
                   {"Component", "This hand", "Reference", "Share (95 % interval)", "Standing",
                    "Train with; treatment"},
                   {0.13, 0.19, 0.19, 0.15, 0.14, 0.20},
                   {}};
  for (const auto& one : limits.components) {
    const auto shown = [&](double value) {
      const auto unit = tasks::printed_unit(one.unit).text;
      return tasks::format_value(value, one.unit) +
             (unit.empty() || unit == "°" ? unit : "\u00a0" + unit);
    };
    table.rows.push_back(
        {capital(std::string(name_of(one.component))),
         one.value ? shown(*one.value) + "\n" + one.measure : kNothingKnown,
         one.reference ? shown(*one.reference) + "\n" + one.reference_basis : kNothingKnown,
         one.share ? percent(one.share->share) + "\n" + interval(*one.share) : kNothingKnown,
         std::string(words_of(one.standing)) + (one.reason.empty() ? "" : "\n" + one.reason),
         std::string(training_for(one.component)) +
             (one.treatment.empty() ? "" : "\n" + one.treatment)});
  }
  panel.table = std::move(table);
  panel.notes.push_back(
      "Rule: each component is the mean of the newest assessment days (three at most, of four "
      "weeks), as a share of the less affected hand in the same task; without one, of the hand's "
      "own "
      "best day before. 100 % is as good, less is worse (times and errors turned over). The "
      "interval "
      "takes days to differ by 20 %, or by what they did if that is more. Clearly below: the whole "
      "interval lies under 100 %. The smallest share limits most. No values of other people are "
      "used; the two hands of a healthy person differ, too.");
  return panel;
}

std::optional<Panel> compass_panel(const ReportContent& content) {
  if (content.compasses.empty()) return std::nullopt;
  Panel panel;
  panel.heading = "Closing and opening in six directions";
  std::string of;
  for (const auto& compass : content.compasses)
    of += (of.empty() ? "" : "; ") + std::string(name_of(compass.hand)) + " hand " +
          format_date(content.sessions[compass.session].date);
  panel.lines.push_back(capital(of) +
                        ". Both hands in the axes of the hand: equal pictures are mirror images.");
  PanelTable table{"Forces in six directions, above rest", {"Digit", "Hand"}, {0.09, 0.07}, {}};
  for (std::size_t p = 0; p < kCompassPoints; ++p) {
    table.heads.push_back(capital(std::string(name_of(static_cast<CompassPoint>(p)))) + " [N]");
    table.shares.push_back(0.1);
  }
  for (const char* head : {"At rest [N]", "Co-flexion [%]", "Beside [°]"}) {
    table.heads.emplace_back(head);
    table.shares.push_back(0.24 / 3.0);
  }
  for (const Finger finger : kFingers) {
    panel.plots.push_back({capital(std::string(name_of(finger))),
                           "Largest forces of the " + std::string(name_of(finger)) +
                               " in six directions; the table below holds the same numbers.",
                           1.0 / 3.0, 150.0, [&content, finger](QSizeF size, double unit) {
                             return compass_plot(content.compasses, finger,
                                                 compass_range(content.compasses), size, unit);
                           }});
    for (const auto& compass : content.compasses) {
      const CompassDigit& digit = compass.digits[index_of(finger)];
      const auto shown = [](const std::optional<double>& value, const char* unit) {
        return value ? tasks::format_value(*value, unit) : std::string(kNothingKnown);
      };
      std::vector<std::string> row{capital(std::string(name_of(finger))),
                                   std::string(name_of(compass.hand))};
      for (const auto& force : digit.force_N) row.push_back(shown(force, "N"));
      row.push_back(shown(digit.resting_N, "N"));
      row.push_back(shown(digit.coflexion_percent, "%"));
      double sum = 0.0;
      int count = 0;
      for (const auto& error : digit.error_rad)
        if (error) sum += *error, ++count;
      row.push_back(shown(count > 0 ? std::optional(sum / count) : std::nullopt, "rad"));
      table.rows.push_back(std::move(row));
    }
  }
  panel.table = std::move(table);
  panel.notes.push_back(
      "The outer ring is the force written beside it; a hand much weaker than the other has a ring "
      "of "
      "its own. \u25cf right, \u25a0 and dashed left hand; arc: mean direction error on either "
      "side; \u25c7 "
      "pressed (upward) or pulled at rest; co-flexion: press of any digit while this one opens, of "
      "the pull.");
  return panel;
}

std::optional<Panel> dose_panel(const ReportContent& content) {
  const PracticeDose& dose = content.dose;
  if (dose.weeks.empty()) return std::nullopt;
  Panel panel;
  panel.heading = "Practice";
  panel.lines.push_back(std::to_string(dose.days) + (dose.days == 1 ? " day, " : " days, ") +
                        std::to_string(std::lround(dose.active_s / 60.0)) + " active minutes, " +
                        std::to_string(dose.repetitions) + " repetitions.");
  // Of a long course the table shows the newest weeks, the plot all.
  constexpr std::size_t kMostRows = 8;
  panel.plots.push_back(
      {"Active minutes per week",
       dose.weeks.size() > kMostRows ? "The table below holds the numbers of the newest weeks."
                                     : "The table below holds the same numbers.",
       1.0, 74.0,
       [&dose](QSizeF size, double unit) { return dose_plot(dose, false, size, unit); }});
  PanelTable table{"Practice per week",
                   {"Week", "Sessions", "Active minutes", "Repetitions", "Most effort (0 to 10)",
                    "Most pain (0 to 10)"},
                   {0.1, 0.14, 0.19, 0.17, 0.2, 0.2},
                   {}};
  const std::size_t first = dose.weeks.size() > kMostRows ? dose.weeks.size() - kMostRows : 0;
  for (std::size_t i = first; i < dose.weeks.size(); ++i) {
    const DoseWeek& week = dose.weeks[i];
    const auto said = [](const std::optional<int>& value) {
      return value ? std::to_string(*value) : std::string(kNothingKnown);
    };
    char minutes[16];
    std::snprintf(minutes, sizeof minutes, "%.1f", week.active_s / 60.0);
    table.rows.push_back({std::to_string(week.week), std::to_string(week.sessions), minutes,
                          std::to_string(week.repetitions), said(week.most_effort),
                          said(week.most_pain)});
  }
  panel.table = std::move(table);
  panel.notes.push_back(
      (first > 0 ? "The newest " + std::to_string(kMostRows) + " weeks. " : std::string()) +
      "Active: time of all trials, without rests. Repetitions: efforts of completed trials.");
  return panel;
}

}  // namespace

std::vector<Panel> panels_above(const ReportContent& content) {
  std::vector<Panel> panels;
  if (content.sessions.empty()) return panels;
  for (auto& panel : {goals_panel(content), limits_panel(content)})
    if (panel) panels.push_back(*panel);
  return panels;
}

std::vector<Panel> panels_between(const ReportContent& content) {
  std::vector<Panel> panels;
  for (auto& panel : {compass_panel(content), dose_panel(content)})
    if (panel) panels.push_back(*panel);
  return panels;
}

std::vector<Panel> panels_below(const ReportContent& content) {
  if (content.sessions.empty()) return {};
  Panel signature;
  signature.heading = "Signature";
  signature.blanks = {"Therapist", "Place and date", "Signature"};
  return {signature, patient_page(content)};
}

}  // namespace isograsp::reports
