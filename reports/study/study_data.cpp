// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/study_data.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <set>

#include "core/mean.hpp"
#include "exports/export_source.hpp"
#include "reports/findings/comparable.hpp"
#include "reports/findings/patient_records.hpp"
#include "reports/findings/renewed.hpp"
#include "tasks/reasons/reasons.hpp"

namespace isograsp::reports {

namespace {

std::string subject_name(std::size_t number) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "S%02zu", number);
  return text.data();
}

/// A person of the study.
struct Subject {
  PatientRecords records;
  std::vector<std::vector<const StoredTrial*>> chosen;  ///< for each condition
};

bool is_hand(StudyHand wanted, std::optional<Hand> hand, const storage::PatientProfile& profile) {
  switch (wanted) {
    case StudyHand::right: return hand == Hand::right;
    case StudyHand::left: return hand == Hand::left;
    case StudyHand::both: return !hand;
    case StudyHand::affected:
    case StudyHand::other: break;
  }
  if (profile.affected != storage::Side::right && profile.affected != storage::Side::left)
    return false;
  const Hand affected = profile.affected == storage::Side::right ? Hand::right : Hand::left;
  return hand && (*hand == affected) == (wanted == StudyHand::affected);
}

bool selects_session(const TrialSelection& selection, const ReportSession& session,
                     const storage::PatientProfile& profile) {
  if (!selection.sessions.empty() && std::find(selection.sessions.begin(), selection.sessions.end(),
                                               session.number) == selection.sessions.end())
    return false;
  const double day = std::round(session.day);  // assessments are on days, not at hours
  if (selection.days && (day < selection.days->from || day > selection.days->to)) return false;
  return is_hand(*selection.hand, session.hand, profile);
}

bool follows_success(const std::string& task_text) {
  const auto spec = tasks::parse_task(task_text, "stored task");
  return spec && spec->difficulty && spec->difficulty->chosen;
}

/// Counts what is left out, by reason.
class LeftOut {
 public:
  void add(const Text& why) {
    auto& [words, count] = count_[english(why)];
    words = why;
    ++count;
  }
  [[nodiscard]] std::vector<Text> words() const {
    std::vector<Text> all;
    for (const auto& [in_english, of] : count_)
      all.push_back(of.second == 1 ? "1 trial: %1"_text(of.first)
                                   : "%1 trials: %2"_text(of.second, of.first));
    return all;
  }

 private:
  std::map<std::string, std::pair<Text, int>> count_;  ///< by the reason in English
};

/// Fills `chosen` of one person, and `missing` with why a condition has no trial.
void choose(const Study& study, const std::vector<StudyCondition>& conditions, Subject& subject,
            std::vector<StudyCell>& cells, LeftOut& left_out) {
  std::map<std::string, bool> by_success;
  subject.chosen.resize(conditions.size());
  for (std::size_t c = 0; c < conditions.size(); ++c) {
    const auto& selection = conditions[c].selection;
    const auto& profile = subject.records.profile;
    const Text no_session = "no such session"_text;
    Text why = no_session;
    const bool side_is_asked =
        *selection.hand == StudyHand::affected || *selection.hand == StudyHand::other;
    if (side_is_asked && profile.affected != storage::Side::right &&
        profile.affected != storage::Side::left)
      why = "no single affected side is told"_text;
    for (const auto& trial : subject.records.trials) {
      const auto& session = subject.records.shown[trial.session];
      if (!selects_session(selection, session, profile)) continue;
      if (session.source != study.source) {
        why = "other source of forces"_text;
        continue;
      }
      if (trial.trial.task_name != *selection.task) {
        if (why == no_session) why = "no such task in the session"_text;
        continue;
      }
      if (!(study.practice ? is_own_work(trial.trial) : counts(trial.trial))) {
        why = "practice, helped or not completed"_text;
        left_out.add(why);
        continue;
      }
      auto [known, fresh] = by_success.try_emplace(trial.trial.task_text, false);
      if (fresh) known->second = follows_success(trial.trial.task_text);
      if (known->second) {
        why = "the level of the task follows success"_text;
        left_out.add(why);
        continue;
      }
      subject.chosen[c].push_back(&trial);
    }
    if (subject.chosen[c].empty()) cells[c].reason = why;
  }
}

const Measure* measure_of(const StoredTrial& trial, const std::string& name,
                          const std::string& channel) {
  for (const auto& measure : trial.measures)
    if (measure.name == name && measure.channel == channel) return &measure;
  return nullptr;
}

/// Trials of one task that may be compared with `like`, and the people who have them.
struct Comparable {
  const StoredTrial* like;
  std::set<std::size_t> people;
  std::size_t trials = 0;
};

/// Of each task the trial with which the largest set of people may be compared.
std::map<std::string, const StoredTrial*> reference_trials(const std::vector<Subject>& subjects) {
  std::map<std::string, std::vector<Comparable>> sets;
  for (std::size_t person = 0; person < subjects.size(); ++person)
    for (const auto& chosen : subjects[person].chosen)
      for (const StoredTrial* trial : chosen) {
        auto& of_task = sets[trial->trial.task_name];
        auto set = std::find_if(of_task.begin(), of_task.end(), [trial](const Comparable& one) {
          return difference(*one.like, *trial).empty();
        });
        if (set == of_task.end()) set = of_task.insert(set, {trial, {}, 0});
        set->people.insert(person);
        ++set->trials;
      }
  std::map<std::string, const StoredTrial*> references;
  for (const auto& [task, of_task] : sets)
    references[task] = std::max_element(of_task.begin(), of_task.end(),
                                        [](const Comparable& a, const Comparable& b) {
                                          return std::pair(a.people.size(), a.trials) <
                                                 std::pair(b.people.size(), b.trials);
                                        })
                           ->like;
  return references;
}

/// Unit and version that all values must have.
struct Kind {
  std::string unit;
  int version = 0;
};

/// The value of one person in one condition.
class CellMaker {
 public:
  CellMaker(const Study& study, const std::map<std::string, const StoredTrial*>& references,
            LeftOut& left_out)
      : study_(study), references_(references), left_out_(left_out) {}

  [[nodiscard]] StudyCell make(const TrialSelection& selection,
                               const std::vector<const StoredTrial*>& trials) {
    const std::string channel = selection.channel.value_or("");
    const bool censored = tasks::words_of(study_.measure, channel).censored;
    StudyCell cell;
    std::map<std::size_t, std::vector<double>> values;  // by session
    for (const StoredTrial* trial : trials) {
      auto why = difference(*references_.at(trial->trial.task_name), *trial);
      const Measure* measure = measure_of(*trial, study_.measure, channel);
      if (why.empty() && measure == nullptr) why = "the trial has no such measure"_text;
      if (why.empty() && !same_kind(*measure)) why = "another version of the measure"_text;
      if (why.empty() && !measure->value) {
        why = tasks::reason_words(measure->reason);
        // A time that did not come is longer than all others: leaving it out would flatter.
        if (censored) return {{}, 0, 0, "a trial has no value: %1"_text(why)};
      }
      if (!why.empty()) {
        left_out_.add(why);
        cell.reason = why;
        continue;
      }
      values[trial->session].push_back(*measure->value);
      ++cell.trials;
    }
    if (values.empty()) return cell;
    cell.reason = {};
    cell.sessions = static_cast<int>(values.size());
    std::vector<double> means;
    for (const auto& [session, of_session] : values) means.push_back(arithmetic_mean(of_session));
    cell.value = arithmetic_mean(means);
    return cell;
  }

  [[nodiscard]] const std::optional<Kind>& kind() const { return kind_; }
  [[nodiscard]] bool units_differ() const { return units_differ_; }

 private:
  bool same_kind(const Measure& measure) {
    if (!kind_) kind_ = {measure.unit, measure.version};
    units_differ_ = units_differ_ || kind_->unit != measure.unit;
    return kind_->version == measure.version;
  }

  const Study& study_;
  const std::map<std::string, const StoredTrial*>& references_;
  LeftOut& left_out_;
  std::optional<Kind> kind_;
  bool units_differ_ = false;
};

/// A trial that counts in two conditions would be compared with itself. Not if they have different
/// channels.
Result<void> check_once(const std::vector<StudyCondition>& conditions, const Subject& subject,
                        const std::string& name, const std::string& file) {
  std::map<std::pair<const StoredTrial*, std::string>, std::size_t> seen;
  for (std::size_t c = 0; c < conditions.size(); ++c)
    for (const StoredTrial* trial : subject.chosen[c]) {
      const auto [at, fresh] =
          seen.try_emplace({trial, conditions[c].selection.channel.value_or("")}, c);
      if (!fresh)
        return refused("a trial of %1 stands in \"%2\" and in \"%3\""_text(
                           name, conditions[at->second].name, conditions[c].name),
                       "let the levels select different sessions, days, hands or tasks"_text)
            .at(file)
            .about("factor");
    }
  return {};
}

}  // namespace

statistics::SubjectTable StudyGroupData::table() const {
  const auto columns = cells.empty() ? 0 : cells.front().size();
  statistics::SubjectTable values(static_cast<Eigen::Index>(cells.size()),
                                  static_cast<Eigen::Index>(columns));
  for (std::size_t row = 0; row < cells.size(); ++row)
    for (std::size_t column = 0; column < columns; ++column)
      values(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
          cells[row][column].value.value_or(std::numeric_limits<double>::quiet_NaN());
  return values;
}

Result<StudyData> gather_study(storage::SessionStore& store, const Study& study,
                               const std::string& file, const Progress& progress) {
  const auto conditions = conditions_of(study);
  std::vector<std::string> codes;
  StudyData data;
  for (const auto& group : study.groups) {
    auto& of_group = data.groups.emplace_back();
    of_group.name = group.name;
    for (const auto& code : group.patients) {
      codes.push_back(code);
      of_group.subjects.push_back(subject_name(codes.size()));
    }
    of_group.cells.assign(group.patients.size(), std::vector<StudyCell>(conditions.size()));
  }
  std::vector<Subject> subjects(codes.size());
  LeftOut left_out;
  std::size_t number = 0;
  for (auto& group : data.groups)
    for (std::size_t row = 0; row < group.subjects.size(); ++row, ++number) {
      if (!tell(progress, static_cast<double>(number) / static_cast<double>(codes.size()),
                "%1"_text(group.subjects[row])))
        return cancelled();
      auto records = read_patient(store, codes[number]);
      if (!records) return records.error();
      const auto released = store.may_be_used_for_research(records->patient.id);
      if (!released) return released.error();
      if (!*released) return exports::not_released(codes[number], file, "patients");
      Subject& subject = subjects[number];
      subject.records = *std::move(records);
      choose(study, conditions, subject, group.cells[row], left_out);
      if (auto done = check_once(conditions, subject, group.subjects[row], file); !done)
        return done.error();
    }
  const auto references = reference_trials(subjects);
  CellMaker maker(study, references, left_out);
  bool any = false;
  number = 0;
  for (auto& group : data.groups)
    for (auto& of_subject : group.cells) {
      const Subject& subject = subjects[number++];
      for (std::size_t c = 0; c < conditions.size(); ++c)
        if (!subject.chosen[c].empty()) {
          of_subject[c] = maker.make(conditions[c].selection, subject.chosen[c]);
          any = any || of_subject[c].value;
        }
    }
  if (!any)
    return refused("nobody has a value of \"%1\" in any condition"_text(study.measure),
                   "check task, hand, channel, sessions and source"_text)
        .at(file)
        .about("measure");
  if (maker.units_differ())
    return refused("the conditions have different units"_text,
                   "compare tasks and channels of one unit"_text)
        .at(file)
        .about("factor");
  data.unit = maker.kind()->unit;
  data.measure_version = maker.kind()->version;
  data.left_out = left_out.words();
  int results = 0;
  int trials = 0;
  for (const Subject& subject : subjects) {
    results += subject.records.renewed_results;
    trials += subject.records.renewed_trials;
  }
  data.renewed = renewal_words(results, trials);
  return data;
}

}  // namespace isograsp::reports
