// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/study_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/toml_reader.hpp"

namespace isograsp::reports {

namespace {

constexpr std::size_t kLongestTitle = 80;
constexpr std::size_t kLongestName = 24;  // fits under a box of a plot
constexpr std::size_t kMostFactors = 2;
constexpr std::size_t kMostLevels = 12;
constexpr std::array<std::string_view, 5> kSelecting{"task", "channel", "hand", "sessions", "days"};

/// Keys of one table that select trials.
std::set<std::string_view> keys_of(const TomlReader& table) {
  std::set<std::string_view> keys;
  for (const auto key : kSelecting)
    if (table.has(key)) keys.insert(key);
  return keys;
}

/// Whole numbers of at least `least`.
std::vector<int> whole_numbers(TomlReader& table, std::string_view key, std::size_t fewest,
                               std::size_t most, int least) {
  std::vector<int> result;
  for (const double number : table.numbers(key, fewest, most)) {
    constexpr double kMost = 100000.0;
    if (number != std::floor(number) || number < least || number > kMost)
      table.fail(key, "holds what is no whole number from %1"_text(least),
                 "write whole numbers"_text);
    else
      result.push_back(static_cast<int>(number));
  }
  return result;
}

TrialSelection read_selection(TomlReader& table) {
  TrialSelection selection;
  if (table.has("task")) selection.task = table.text("task");
  if (table.has("channel")) selection.channel = table.text("channel");
  if (table.has("hand"))
    selection.hand = static_cast<StudyHand>(
        table.choice("hand", {"right", "left", "affected", "other", "both"}));
  if (table.has("sessions")) {
    constexpr std::size_t kMostSessions = 1000;
    selection.sessions = whole_numbers(table, "sessions", 1, kMostSessions, 1);
    const std::set<int> different(selection.sessions.begin(), selection.sessions.end());
    if (different.size() != selection.sessions.size())
      table.fail("sessions", "names a session twice"_text, "name each once"_text);
  }
  if (table.has("days")) {
    const auto days = whole_numbers(table, "days", 2, 2, 0);
    if (days.size() == 2) {
      if (days[1] < days[0])
        table.fail("days", "ends before it begins"_text,
                   "write [first, last] day, 0 is the first session"_text);
      selection.days = {days[0], days[1]};
    }
  }
  return selection;
}

/// A name that no other has.
std::string read_name(TomlReader& table, std::set<std::string>& names) {
  auto name = table.text("name");
  if (name.empty() || name.size() > kLongestName)
    table.fail("name", "has no or more than %1 characters"_text(kLongestName),
               "choose a short name"_text);
  if (!names.insert(name).second)
    table.fail("name", "'%1' is given twice"_text(name), "rename one"_text);
  return name;
}

StudyGroup read_group(TomlReader& table, std::set<std::string>& names,
                      std::set<std::string>& patients) {
  StudyGroup group;
  group.name = read_name(table, names);
  group.patients = table.texts("patients");
  if (group.patients.empty())
    table.fail("patients", "names nobody"_text, "list codes of patients"_text);
  for (const auto& code : group.patients)
    if (!patients.insert(code).second)
      table.fail("patients", "'%1' is listed twice"_text(code), "list each person once"_text);
  return group;
}

StudyFactor read_factor(TomlReader& table, std::set<std::string>& names,
                        std::set<std::string_view>& taken) {
  StudyFactor factor;
  factor.name = read_name(table, names);
  std::set<std::string> levels;
  std::set<std::string_view> keys;
  for (auto& level : table.tables("level")) {
    const auto here = keys_of(level);
    if (factor.levels.empty()) {
      keys = here;
      if (keys.empty())
        level.fail("name", "selects nothing"_text,
                   "give task, channel, hand, sessions or days"_text);
      for (const auto key : keys)
        if (!taken.insert(key).second)
          level.fail(key, "is given elsewhere too"_text,
                     "give it once: above, or in one factor"_text);
    } else if (here != keys) {
      level.fail("name", "selects by other keys than the level before it"_text,
                 "give the same keys in all levels of a factor"_text);
    }
    auto name = read_name(level, levels);
    factor.levels.push_back({std::move(name), read_selection(level)});
  }
  if (factor.levels.size() < 2 || factor.levels.size() > kMostLevels)
    table.fail("level", "there are %1 levels"_text(factor.levels.size()),
               "give 2 to %1 tables [[factor.level]]"_text(kMostLevels));
  return factor;
}

void read_analyses(TomlReader& root, Study& study) {
  std::set<StudyAnalysis> chosen;
  for (const auto& word : root.texts("analyses")) {
    constexpr std::array<std::string_view, 3> kWords{"anova", "ranks", "reliability"};
    const auto at = std::find(kWords.begin(), kWords.end(), word);
    if (at == kWords.end()) {
      root.fail("analyses", "'%1' is no analysis"_text(word),
                "choose anova, ranks, reliability"_text);
      return;
    }
    const auto analysis = static_cast<StudyAnalysis>(at - kWords.begin());
    if (!chosen.insert(analysis).second)
      root.fail("analyses", "names '%1' twice"_text(word), "name each once"_text);
    study.analyses.push_back(analysis);
    if (study.factors.size() == kMostFactors && analysis != StudyAnalysis::anova)
      root.fail("analyses", "'%1' has one factor, the file two"_text(word),
                "write a file for each level of the other factor"_text);
  }
  if (study.analyses.empty())
    root.fail("analyses", "names none"_text, "choose from anova, ranks, reliability"_text);
}

/// What both select together; no key is in both.
TrialSelection together(TrialSelection a, const TrialSelection& b) {
  if (b.task) a.task = b.task;
  if (b.channel) a.channel = b.channel;
  if (b.hand) a.hand = b.hand;
  if (!b.sessions.empty()) a.sessions = b.sessions;
  if (b.days) a.days = b.days;
  return a;
}

}  // namespace

Result<Study> parse_study(std::string_view text, const std::string& file) {
  auto root = TomlReader::parse(text, file, "isograsp-study-1");
  if (!root) return root.error();
  Study study;
  study.title = root->text("title");
  if (study.title.empty() || study.title.size() > kLongestTitle)
    root->fail("title", "has no or more than %1 characters"_text(kLongestTitle),
               "choose a short title"_text);
  study.measure = root->text("measure");
  study.source = static_cast<Source>(root->choice("source", {"device", "simulated", "recorded"},
                                                  static_cast<std::size_t>(Source::device)));
  study.confidence = root->number("confidence", 0.95);
  study.practice = root->boolean("practice", false);
  if (!(study.confidence >= 0.5 && study.confidence < 1.0))
    root->fail("confidence", "is not between 0.5 and 1"_text, "0.95 is usual"_text);
  auto taken = keys_of(*root);
  study.common = read_selection(*root);
  std::set<std::string> names;
  std::set<std::string> patients;
  for (auto& group : root->tables("group"))
    study.groups.push_back(read_group(group, names, patients));
  if (study.groups.empty()) root->fail("group", "there is none"_text, "add a table [[group]]"_text);
  names.clear();
  for (auto& factor : root->tables("factor"))
    study.factors.push_back(read_factor(factor, names, taken));
  if (study.factors.empty() || study.factors.size() > kMostFactors)
    root->fail("factor", "there are %1 factors"_text(study.factors.size()),
               "give one or two tables [[factor]]"_text);
  for (const char* key : {"task", "hand"})
    if (!taken.contains(key))
      root->fail(key, "is not given"_text, "give it above, or in all levels of one factor"_text);
  if (taken.contains("sessions") && taken.contains("days"))
    root->fail("days", "sessions are given too"_text, "select by sessions or by days"_text);
  read_analyses(*root, study);
  if (auto done = root->finish(); !done) return done.error();
  return study;
}

std::vector<StudyCondition> conditions_of(const Study& study) {
  std::vector<StudyCondition> conditions{{"", study.common}};
  for (const auto& factor : study.factors) {
    std::vector<StudyCondition> next;
    for (const auto& before : conditions)
      for (const auto& level : factor.levels)
        next.push_back({before.name + (before.name.empty() ? "" : ", ") + level.name,
                        together(before.selection, level.selection)});
    conditions = std::move(next);
  }
  return conditions;
}

}  // namespace isograsp::reports
