// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/findings/limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/mean.hpp"
#include "core/ties.hpp"
#include "reports/findings/comparable.hpp"
#include "reports/findings/patient_records.hpp"
#include "reports/findings/wording.hpp"
#include "tasks/facts/measure_words.hpp"

namespace isograsp::reports {

namespace {

constexpr std::size_t kDaysAveraged = 3;
constexpr double kRecent_days = 28.0;            ///< older days are not what the hand does now
constexpr double kOldestReference_days = 183.0;  ///< of the other hand: half of a year
constexpr std::size_t kDaysForOwnBest = 2;       ///< before the newest ones

// In a share smaller values count as these: they cannot be told apart, and nothing is divided by
// nothing. A value that is printed is never raised.
constexpr double kLeastForce_N = 0.1;  ///< within the drift of a zero and the rest of a finger
/// A finger cannot be laid on its support more exactly.
constexpr double kLeastAngle_rad = 5.0 * std::numbers::pi / 180.0;
constexpr double kLeastTime_s = 0.01;        ///< one frame at 100 Hz
constexpr double kLeastError_percent = 1.0;  ///< of the largest target

/// How a component is compared.
struct Candidate {
  const tasks::KindFacts* kind = nullptr;
  tasks::ComponentMeasure from;
  Comparison comparison = Comparison::larger;
  double least = 0.0;  ///< smaller days count as this in a share
};
Candidate candidate_of(const tasks::KindFacts& kind, const tasks::ComponentMeasure& from) {
  switch (from.component) {
    case Component::strength:
    case Component::opening: return {&kind, from, Comparison::larger, kLeastForce_N};
    case Component::release: return {&kind, from, Comparison::smaller, kLeastTime_s};
    case Component::control: return {&kind, from, Comparison::smaller, kLeastError_percent};
    case Component::individuation: return {&kind, from, Comparison::logarithm, 0.0};
    case Component::direction: return {&kind, from, Comparison::smaller, kLeastAngle_rad};
  }
  return {};
}
/// Where components are read from. The first one that was measured counts.
const std::vector<Candidate>& candidates() {
  static const auto all = [] {
    std::vector<Candidate> found;
    for (const tasks::KindFacts* kind : tasks::all_kinds())
      for (const auto& from : kind->components) found.push_back(candidate_of(*kind, from));
    std::stable_sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
      return a.from.rank < b.from.rank;
    });
    return found;
  }();
  return all;
}

/// What of `trial` the candidate is the mean of.
std::vector<const Measure*> meant(const StoredTrial& trial, const Candidate& candidate) {
  std::vector<const Measure*> all;
  for (const auto& measure : trial.measures)
    if (measure.name == candidate.from.measure && measure.value &&
        measure.channel.ends_with(candidate.from.channel))
      all.push_back(&measure);
  return all;
}

/// Nothing: `trial` has not the same channels in the same version and unit.
std::optional<double> value_of(const StoredTrial& trial, const StoredTrial& like,
                               const Candidate& candidate) {
  const auto same = [](const Measure* a, const Measure* b) {
    return a->channel == b->channel && a->version == b->version && a->unit == b->unit;
  };
  const auto ours = meant(trial, candidate);
  const auto theirs = meant(like, candidate);
  if (ours.empty() ||
      !std::is_permutation(ours.begin(), ours.end(), theirs.begin(), theirs.end(), same))
    return std::nullopt;
  std::vector<double> values;
  for (const Measure* measure : ours) values.push_back(*measure->value);
  return arithmetic_mean(values);
}

/// The days of trials that may be compared with `like`, oldest first.
std::vector<ComponentDay> days_of(const std::vector<const StoredTrial*>& trials,
                                  const StoredTrial& like, const Candidate& candidate,
                                  const std::vector<ReportSession>& sessions) {
  std::vector<ComponentDay> days;
  std::vector<double> values;  // of the newest of them
  for (const StoredTrial* trial : trials) {
    if (!counts(trial->trial) || !difference(*trial, like).empty()) continue;
    const auto value = value_of(*trial, like, candidate);
    if (!value) continue;
    const ReportSession& session = sessions[trial->session];
    if (days.empty() || days.back().day != session.day) {
      days.push_back({session.day, session.date, 0.0});
      values.clear();
    }
    values.push_back(*value);
    days.back().value = arithmetic_mean(values);
  }
  return days;
}

std::span<const ComponentDay> newest(std::span<const ComponentDay> days) {
  std::size_t first = days.size() - 1;
  while (first > 0 && days.size() - first < kDaysAveraged &&
         days.back().day - days[first - 1].day <= kRecent_days)
    --first;
  return days.subspan(first);
}

/// The first of the days that are tied best.
std::span<const ComponentDay>::iterator best_of(std::span<const ComponentDay> days, bool smaller) {
  std::vector<double> values;
  for (const auto& day : days) values.push_back(day.value);
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double best = smaller ? *least : *most;
  return std::find_if(days.begin(), days.end(), [&](const ComponentDay& day) {
    return are_tied(day.value, best, tie_width(values));
  });
}

/// Of the values themselves, whatever their sign.
double mean_value(std::span<const ComponentDay> days) {
  std::vector<double> values;
  for (const auto& day : days) values.push_back(day.value);
  return arithmetic_mean(values);
}

/// The days as they count in a share: none is less than `candidate.least`.
std::vector<ComponentDay> raised(std::span<const ComponentDay> days, const Candidate& candidate) {
  std::vector<ComponentDay> all(days.begin(), days.end());
  if (candidate.comparison != Comparison::logarithm)
    for (auto& day : all) day.value = std::max(day.value, candidate.least);
  return all;
}

/// One component as it was measured in one task with both hands.
struct Measured {
  const Candidate* candidate = nullptr;
  const StoredTrial* like = nullptr;
  std::vector<ComponentDay> hand;
  std::vector<ComponentDay> other;
};

/// In the order of candidates; among tasks of one candidate those come first that the other hand
/// did as well, then the newest.
std::optional<Measured> measured(const TrialsOfTasks& tasks, Component component, Hand hand,
                                 const std::vector<ReportSession>& sessions) {
  const Hand other = hand == Hand::right ? Hand::left : Hand::right;
  for (const bool with_other : {true, false})
    for (const auto& candidate : candidates()) {
      if (candidate.from.component != component) continue;
      std::optional<Measured> found;
      for (const auto& [task, trials] : tasks) {
        if (task.first != hand || !counts(trials.back()->trial)) continue;
        const StoredTrial& like = *trials.back();
        const auto spec = tasks::parse_task(like.trial.task_text, like.trial.task_name);
        if (!spec || spec->difficulty || &*spec->kind != candidate.kind) continue;
        Measured one{&candidate, &like, days_of(trials, like, candidate, sessions), {}};
        if (const auto both = tasks.find({other, task.second}); both != tasks.end())
          one.other = days_of(both->second, like, candidate, sessions);
        if (one.hand.empty() || sessions.back().day - one.hand.back().day > kRecent_days) continue;
        if (!one.other.empty() &&
            one.hand.back().day - one.other.back().day > kOldestReference_days)
          one.other.clear();
        if (one.other.empty() == with_other) continue;
        if (!found || found->hand.back().day < one.hand.back().day) found = std::move(one);
      }
      if (found) return found;
    }
  return std::nullopt;
}

double logarithm(double value, Comparison comparison) {
  if (comparison == Comparison::logarithm) return value;
  return comparison == Comparison::larger ? std::log(value) : -std::log(value);
}

struct Logarithms {
  double mean = 0.0;
  double variance = 0.0;  ///< of the mean
};
Logarithms logarithms(std::span<const ComponentDay> days, Comparison comparison) {
  const auto n = static_cast<double>(days.size());
  double mean = 0.0;
  for (const auto& day : days) mean += logarithm(day.value, comparison) / n;
  double squares = 0.0;
  for (const auto& day : days)
    squares +=
        (logarithm(day.value, comparison) - mean) * (logarithm(day.value, comparison) - mean);
  const double sd = days.size() > 1 ? std::sqrt(squares / (n - 1.0)) : 0.0;
  const double used = std::max(sd, kLeastDaySd);
  return {mean, used * used / n};
}

Text kind_words(const storage::TreatmentMark& mark) {
  static constexpr std::array kKinds{"botulinum toxin"_text, "drug"_text, "orthosis"_text,
                                     "therapy"_text, "other"_text};
  const auto kind =
      std::find(storage::kTreatmentKinds.begin(), storage::kTreatmentKinds.end(), mark.kind);
  if (kind == storage::kTreatmentKinds.end()) return "%1"_text(mark.kind);
  return kKinds[static_cast<std::size_t>(kind - storage::kTreatmentKinds.begin())];
}

/// The newest mark that lies between two assessments, with the newest days on either side of it.
Text since_treatment(std::span<const storage::TreatmentMark> marks,
                     const std::vector<ComponentDay>& days, const std::string& unit) {
  for (auto mark = marks.rbegin(); mark != marks.rend(); ++mark) {
    const auto after = std::find_if(days.begin(), days.end(), [&](const ComponentDay& day) {
      return day.date >= mark->on_date;
    });
    if (after == days.begin() || after == days.end()) continue;
    const auto value = [&](auto from, auto to) {
      return value_number(mean_value(newest(std::span(from, to))), unit);
    };
    return "%1, %2: %3 before, %4 now"_text(day_words(mark->on_date), kind_words(*mark),
                                            value(days.begin(), after), value(after, days.end()));
  }
  return {};
}

Text hand_of_days(Hand hand, std::size_t days) {
  if (days == 1) return hand == Hand::right ? "right hand, 1 day"_text : "left hand, 1 day"_text;
  return (hand == Hand::right ? "right hand, %1 days"_text : "left hand, %1 days"_text)(days);
}

ComponentResult judged(const Measured& one, Hand other, bool compare_hands) {
  const Candidate& candidate = *one.candidate;
  ComponentResult result;
  result.component = candidate.from.component;
  result.task = one.like->trial.task_name;
  const Measure& measure = *meant(*one.like, candidate).front();
  result.unit = measure.unit;
  const bool all_channels = candidate.from.channel.starts_with("_");
  result.measure =
      measure_title(measure.name, all_channels ? std::string_view{} : candidate.from.channel);
  const auto now = newest(one.hand);
  result.value = mean_value(now);
  std::span<const ComponentDay> reference;
  if (compare_hands && !one.other.empty()) {
    reference = newest(one.other);
    result.reference_basis = hand_of_days(other, reference.size());
  } else {
    const auto before = std::span(one.hand).first(one.hand.size() - now.size());
    if (before.size() < kDaysForOwnBest) {
      result.reason = !compare_hands         ? "too few days for an own best"_text
                      : other == Hand::right ? "the right hand has not done this task"_text
                                             : "the left hand has not done this task"_text;
      return result;
    }
    const auto best = best_of(before, candidate.comparison == Comparison::smaller);
    reference = {&*best, 1};
    result.reference_basis = "own best day, %1"_text(day_words(best->date));
  }
  result.reference = mean_value(reference);
  result.share =
      share_of(raised(now, candidate), raised(reference, candidate), candidate.comparison);
  result.standing = result.share->high < 1.0  ? Standing::below
                    : result.share->low < 1.0 ? Standing::not_clear
                                              : Standing::as_good;
  return result;
}

}  // namespace

Words words_of(Component component) noexcept {
  static constexpr std::array<Words, kComponentCount> kWords{
      "strength"_text, "opening"_text,       "release"_text,
      "control"_text,  "individuation"_text, "direction"_text};
  return kWords[static_cast<std::size_t>(component)];
}

std::string_view training_for(Component component) noexcept {
  constexpr std::array<std::string_view, kComponentCount> kTasks{
      "Steadiness",          "Open on cue",        "Let go, short",
      "Grip training, sine", "Index finger, sine", "Force direction"};
  return kTasks[static_cast<std::size_t>(component)];
}

Share share_of(std::span<const ComponentDay> hand, std::span<const ComponentDay> reference,
               Comparison comparison) {
  const Logarithms ours = logarithms(hand, comparison);
  const Logarithms theirs = logarithms(reference, comparison);
  const double log_share = ours.mean - theirs.mean;
  constexpr double kNormal975 = 1.959964;
  const double half = kNormal975 * std::sqrt(ours.variance + theirs.variance);
  return {std::exp(log_share), std::exp(log_share - half), std::exp(log_share + half)};
}

LimitsOfHand limits_of(const PatientRecords& records,
                       std::span<const storage::TreatmentMark> marks) {
  LimitsOfHand limits;
  if (records.sessions.empty()) return limits;
  const auto& affected = records.profile.affected;
  limits.other_hand = affected == storage::Side::right || affected == storage::Side::left;
  for (const auto& session : records.sessions) limits.hand = session.hand.value_or(limits.hand);
  if (limits.other_hand) limits.hand = affected == storage::Side::right ? Hand::right : Hand::left;
  const Hand other = limits.hand == Hand::right ? Hand::left : Hand::right;
  const auto tasks = sort_by_task(records);
  // An arm seen by markers says nothing of what a hand alone can do, nor do a tracker and both
  // hands together.
  const auto is_without_forces = [](const auto& task) {
    const storage::TrialRecord& trial = task.second.front()->trial;
    const auto spec = tasks::parse_task(trial.task_text, trial.task_name);
    constexpr std::array kOthers{kArm, kTrackedHand, kTwoPlatforms};
    return spec && std::find(kOthers.begin(), kOthers.end(), spec->apparatus()) != kOthers.end();
  };
  if (!tasks.empty() && std::all_of(tasks.begin(), tasks.end(), is_without_forces)) return limits;
  for (std::size_t i = 0; i < kComponentCount; ++i) {
    const auto component = static_cast<Component>(i);
    const auto one = measured(tasks, component, limits.hand, records.shown);
    if (!one) {
      auto& result = limits.components.emplace_back();
      result.component = component;
      result.reason = "not assessed"_text;
      continue;
    }
    auto& result = limits.components.emplace_back(judged(*one, other, limits.other_hand));
    result.treatment = since_treatment(marks, one->hand, result.unit);
  }
  return limits;
}

const ComponentResult* main_limit(const LimitsOfHand& limits) {
  const ComponentResult* main = nullptr;
  for (const auto& one : limits.components)
    if (one.standing == Standing::below &&
        (main == nullptr || one.share->share < main->share->share))
      main = &one;
  return main;
}

std::vector<const ComponentResult*> beside(const LimitsOfHand& limits,
                                           const ComponentResult& main) {
  std::vector<const ComponentResult*> others;
  for (const auto& one : limits.components)
    if (&one != &main && one.standing == Standing::below && one.share->low <= main.share->high)
      others.push_back(&one);
  return others;
}

}  // namespace isograsp::reports
