// SPDX-License-Identifier: GPL-3.0-or-later
// What stands beside the measures: goals, what limits this hand, the compass, the dose, the
// signature.
#include <algorithm>
#include <array>
#include <cmath>

#include "reports/findings/report_text.hpp"
#include "reports/paper/panel.hpp"
#include "reports/paper/plots.hpp"
#include "tasks/facts/measure_words.hpp"

namespace isograsp::reports {

namespace {

/// "64 to 103 %"
Text interval(const Share& share) {
  return "%1 to %2"_text(std::lround(100.0 * share.low), percent_words(share.high));
}

/// What begins a line or a sentence.
Words at_the_beginning(Component component) {
  static constexpr std::array<Words, kComponentCount> kWords{
      "Strength"_text, "Opening"_text,       "Release"_text,
      "Control"_text,  "Individuation"_text, "Direction"_text};
  return kWords[static_cast<std::size_t>(component)];
}
Words at_the_beginning(Finger finger) {
  static constexpr std::array kWords{"Thumb"_text, "Index"_text, "Middle"_text};
  return kWords[index_of(finger)];
}

std::vector<std::string> said(const Speaker& say, const std::vector<Text>& all) {
  std::vector<std::string> words;
  for (const Text& text : all) words.push_back(say(text));
  return words;
}

/// "ARAT 31, 40", oldest first: the first and the newest of each scale.
std::vector<std::vector<std::string>> score_rows(const std::vector<storage::ClinicalScore>& scores,
                                                 const Speaker& say) {
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
    const auto cell = [&](const storage::ClinicalScore& score) {
      return say(
          listed({value_words(score.value, std::string(scale.unit)), day_words(score.on_date)}));
    };
    rows.push_back({say(Known{std::string(scale.name)}),
                    first == last ? std::string(kNoValue) : cell(*first), cell(*last)});
  }
  return rows;
}

std::optional<Panel> goals_panel(const ReportContent& content, const Speaker& say) {
  Panel panel;
  panel.heading = say("Goals and everyday use"_text);
  panel.lines.push_back(say(content.goals.empty() ? "No goal is written down."_text
                                                  : "Goal: %1"_text(content.goals)));
  const auto rows = score_rows(content.scores, say);
  if (rows.empty())
    panel.lines.push_back(
        say("No score of everyday use or impairment is stored: whether the forces agree with daily "
            "life cannot be said."_text));
  else
    panel.table = PanelTable{say("Clinical scales"_text),
                             said(say, {"Scale"_text, "First"_text, "Newest"_text}),
                             {0.2, 0.4, 0.4},
                             rows};
  return panel;
}

Words standing_words(Standing standing) {
  switch (standing) {
    case Standing::below: return "clearly below"_text;
    case Standing::not_clear: return "not clearly different"_text;
    case Standing::as_good: return "as good"_text;
    case Standing::cannot_be_said: break;
  }
  return "cannot be said"_text;
}

Text answer(const LimitsOfHand& limits) {
  const ComponentResult* main = main_limit(limits);
  const auto compared = std::count_if(limits.components.begin(), limits.components.end(),
                                      [](const auto& one) { return one.share.has_value(); });
  if (compared == 0) return "Cannot be said yet: nothing to compare with."_text;
  if (main == nullptr) return "Nothing that was compared is clearly below its reference."_text;
  const auto limited =
      limits.hand == Hand::right
          ? "%1 limits the right hand most: %2 of its reference (%3; 95 % interval %4)."_text
          : "%1 limits the left hand most: %2 of its reference (%3; 95 % interval %4)."_text;
  std::vector<Text> others;
  for (const auto* one : beside(limits, *main)) others.emplace_back(words_of(one->component));
  return joined({limited(at_the_beginning(main->component), percent_words(main->share->share),
                         main->reference_basis, interval(*main->share)),
                 others.empty() ? Text() : "Not to be told apart from it: %1."_text(listed(others)),
                 "Train next: %1."_text(Known{std::string(training_for(main->component))})});
}

std::optional<Panel> limits_panel(const ReportContent& content, const Speaker& say) {
  const LimitsOfHand& limits = content.limits;
  if (limits.components.empty()) return std::nullopt;
  Panel panel;
  panel.heading = say("What limits this hand"_text);
  panel.lines.push_back(say(answer(limits)));
  PanelTable table{
      say(limits.hand == Hand::right ? "Components of the right hand"_text
                                     : "Components of the left hand"_text),
      said(say, {"Component"_text, "This hand"_text, "Reference"_text, "Share (95 % interval)"_text,
                 "Standing"_text, "Train with; treatment"_text}),
      {0.13, 0.19, 0.19, 0.15, 0.14, 0.20},
      {}};
  for (const auto& one : limits.components) {
    // What stands behind a line break is small.
    const auto cell = [&](const Text& above, const Text& below) {
      return say(above) + (below.empty() ? "" : "\n" + say(below));
    };
    const auto value_cell = [&](const std::optional<double>& value, const Text& below) {
      return value ? cell(value_words(*value, one.unit), below) : std::string(kNoValue);
    };
    table.rows.push_back({say(at_the_beginning(one.component)), value_cell(one.value, one.measure),
                          value_cell(one.reference, one.reference_basis),
                          one.share ? cell(percent_words(one.share->share), interval(*one.share))
                                    : std::string(kNoValue),
                          cell(standing_words(one.standing), one.reason),
                          cell(Known{std::string(training_for(one.component))}, one.treatment)});
  }
  panel.table = std::move(table);
  panel.notes.push_back(
      say("Rule: each component is the mean of the newest assessment days (three at most, of four "
          "weeks), as a share of the less affected hand in the same task; without one, of the "
          "hand's own best day before. 100 % is as good, less is worse (times and errors turned "
          "over). The interval takes days to differ by 20 %, or by what they did if that is more. "
          "Clearly below: the whole interval lies under 100 %. The smallest share limits most. No "
          "values of other people are used; the two hands of a healthy person differ, too."_text));
  return panel;
}

std::optional<Panel> compass_panel(const ReportContent& content, const Speaker& say) {
  if (content.compasses.empty()) return std::nullopt;
  Panel panel;
  panel.heading = say("Closing and opening in six directions"_text);
  std::vector<Text> of;
  for (const auto& compass : content.compasses) {
    const bool right = compass.hand == Hand::right;
    const Text day = day_words(content.sessions[compass.session].date);
    of.push_back(of.empty() ? (right ? "Right hand %1"_text : "Left hand %1"_text)(day)
                            : (right ? "right hand %1"_text : "left hand %1"_text)(day));
  }
  panel.lines.push_back(say(
      "%1. Both hands in the axes of the hand: equal pictures are mirror images."_text(apart(of))));
  PanelTable table{
      say("Forces in six directions, above rest"_text),
      said(say, {"Digit"_text, "Hand"_text, "Closing [N]"_text, "Opening [N]"_text,
                 "Radial [N]"_text, "Ulnar [N]"_text, "Distal [N]"_text, "Proximal [N]"_text,
                 "At rest [N]"_text, "Co-flexion [%]"_text, "Beside [°]"_text}),
      {0.09, 0.07, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.08, 0.08, 0.08},
      {}};
  constexpr std::array kDescriptions{
      "Largest forces of the thumb in six directions; the table below holds the same numbers."_text,
      "Largest forces of the index in six directions; the table below holds the same numbers."_text,
      "Largest forces of the middle in six directions; the table below holds the same "
      "numbers."_text};
  for (const Finger finger : kFingers) {
    panel.plots.push_back(
        {say(at_the_beginning(finger)), say(kDescriptions[index_of(finger)]), 1.0 / 3.0, 150.0,
         [&content, finger, &language = say.language()](QSizeF size, double unit) {
           return compass_plot(content.compasses, finger, compass_range(content.compasses), size,
                               unit, language);
         }});
    for (const auto& compass : content.compasses) {
      const CompassDigit& digit = compass.digits[index_of(finger)];
      const auto cell = [&](const std::optional<double>& value, const char* unit) {
        return value ? say(value_number(*value, unit)) : std::string(kNoValue);
      };
      std::vector<std::string> row{say(at_the_beginning(finger)), say(side_words(compass.hand))};
      for (const auto& force : digit.force_N) row.push_back(cell(force, "N"));
      row.push_back(cell(digit.resting_N, "N"));
      row.push_back(cell(digit.coflexion_percent, "%"));
      double sum = 0.0;
      int count = 0;
      for (const auto& error : digit.error_rad)
        if (error) sum += *error, ++count;
      row.push_back(cell(count > 0 ? std::optional(sum / count) : std::nullopt, "rad"));
      table.rows.push_back(std::move(row));
    }
  }
  panel.table = std::move(table);
  panel.notes.push_back(say(
      "The outer ring is the force written beside it; a hand much weaker than the other has a "
      "ring of its own. \u25cf right, \u25a0 and dashed left hand; arc: mean direction error on "
      "either side; \u25c7 pressed (upward) or pulled at rest; co-flexion: press of any digit "
      "while this one opens, of the pull."_text));
  return panel;
}

std::optional<Panel> dose_panel(const ReportContent& content, const Speaker& say) {
  const PracticeDose& dose = content.dose;
  if (dose.weeks.empty()) return std::nullopt;
  Panel panel;
  panel.heading = say("Practice"_text);
  const long minutes_in_all = std::lround(dose.active_s / 60.0);
  panel.lines.push_back(say(dose.days == 1 ? "1 day, %1 active minutes, %2 repetitions."_text(
                                                 minutes_in_all, dose.repetitions)
                                           : "%1 days, %2 active minutes, %3 repetitions."_text(
                                                 dose.days, minutes_in_all, dose.repetitions)));
  // Of a long course the table shows the newest weeks, the plot all.
  constexpr std::size_t kMostRows = 8;
  panel.plots.push_back({say("Active minutes per week"_text),
                         say(dose.weeks.size() > kMostRows
                                 ? "The table below holds the numbers of the newest weeks."_text
                                 : "The table below holds the same numbers."_text),
                         1.0, 74.0, [&dose, &language = say.language()](QSizeF size, double unit) {
                           return dose_plot(dose, false, size, unit, language);
                         }});
  PanelTable table{
      say("Practice per week"_text),
      said(say, {"Week"_text, "Sessions"_text, "Active minutes"_text, "Repetitions"_text,
                 "Most effort (0 to 10)"_text, "Most pain (0 to 10)"_text}),
      {0.1, 0.14, 0.19, 0.17, 0.2, 0.2},
      {}};
  // Of hands that are carried to their targets.
  const bool of_shoulder = std::ranges::any_of(
      dose.weeks, [](const DoseWeek& week) { return week.most_shoulder_pain.has_value(); });
  if (of_shoulder) {
    table.heads.push_back(say("Most shoulder pain (0 to 10)"_text));
    table.shares = {0.08, 0.11, 0.16, 0.15, 0.15, 0.15, 0.2};
  }
  const std::size_t first = dose.weeks.size() > kMostRows ? dose.weeks.size() - kMostRows : 0;
  for (std::size_t i = first; i < dose.weeks.size(); ++i) {
    const DoseWeek& week = dose.weeks[i];
    const auto number_or_dash = [](const std::optional<int>& value) {
      return value ? std::to_string(*value) : std::string(kNoValue);
    };
    table.rows.push_back({std::to_string(week.week), std::to_string(week.sessions),
                          say(fixed(week.active_s / 60.0, 1)), std::to_string(week.repetitions),
                          number_or_dash(week.most_effort), number_or_dash(week.most_pain)});
    if (of_shoulder) table.rows.back().push_back(number_or_dash(week.most_shoulder_pain));
  }
  panel.table = std::move(table);
  panel.notes.push_back(say(joined(
      {first > 0 ? "The newest %1 weeks."_text(kMostRows) : Text(),
       "Active: time of all trials, without rests. Repetitions: efforts of completed trials."_text})));
  return panel;
}

}  // namespace

std::vector<Panel> panels_above(const ReportContent& content, const Language& language) {
  const Speaker say(language);
  std::vector<Panel> panels;
  if (content.sessions.empty()) return panels;
  for (auto& panel : {goals_panel(content, say), limits_panel(content, say)})
    if (panel) panels.push_back(*panel);
  return panels;
}

std::vector<Panel> panels_between(const ReportContent& content, const Language& language) {
  const Speaker say(language);
  std::vector<Panel> panels;
  for (auto& panel : {compass_panel(content, say), dose_panel(content, say)})
    if (panel) panels.push_back(*panel);
  for (Panel& panel : both_hands_panels(content, language)) panels.push_back(std::move(panel));
  return panels;
}

std::vector<Panel> panels_below(const ReportContent& content, const Language& language) {
  if (content.sessions.empty()) return {};
  Panel signature;
  const Speaker say(language);
  signature.heading = say("Signature"_text);
  signature.blanks = said(say, {"Therapist"_text, "Place and date"_text, "Signature"_text});
  if (!content.signing_key.empty())
    signature.notes.push_back(
        say("Backups and exports of this clinic are signed with the key %1."_text(
            content.signing_key)));
  return {signature, patient_page(content, language)};
}

}  // namespace isograsp::reports
