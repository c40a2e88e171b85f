// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "reports/comparable.hpp"
#include "reports/measure_words.hpp"
#include "reports/patient_records.hpp"
#include "reports/report_text.hpp"

namespace isograsp {

namespace {

constexpr std::size_t kRecentDays = 3;
constexpr double kRecent_days = 28.0;       ///< older days are not what the hand does now
constexpr std::size_t kDaysForOwnBest = 2;  ///< before the newest ones

/// A finger cannot be laid on its support more exactly; smaller direction errors count as this.
constexpr double kLeastAngle_rad = 5.0 * std::numbers::pi / 180.0;

/// Where a component is read from: a measure of a kind of task; the mean over these channels.
struct Candidate {
  Component component;
  std::string_view measure;
  std::string_view channel;  ///< its end ("_opening" fits every digit); empty: all
  Comparison comparison;
  bool (*fits)(const TaskSpec& spec);
  double least = 0.0;  ///< smaller values count as this
};
template <class Kind>
bool is_a(const TaskSpec& spec) {
  return std::holds_alternative<Kind>(spec.kind);
}
/// The first one that was measured counts.
constexpr std::array kCandidates{
    Candidate{Component::strength, "maximum_force", "grip", Comparison::larger, is_a<MaximumSpec>},
    Candidate{Component::strength, "maximum_force", "pinch", Comparison::larger, is_a<MaximumSpec>},
    Candidate{Component::opening, "maximum_force", "opening", Comparison::larger,
              is_a<MaximumSpec>},
    Candidate{Component::opening, "maximum_force", "_opening", Comparison::larger,
              is_a<DirectionalMaximaSpec>},
    Candidate{Component::release, "release_time_restricted", "", Comparison::smaller,
              is_a<GripReleaseSpec>},
    Candidate{Component::control, "relative_rmse", "force", Comparison::smaller,
              is_a<ForceTrackingSpec>},
    Candidate{Component::individuation, "individuation_index", "", Comparison::logarithm,
              is_a<IndividuationSpec>},
    Candidate{Component::direction, "direction_error", "", Comparison::smaller,
              is_a<ForceDirectionSpec>, kLeastAngle_rad},
    Candidate{Component::direction, "direction_error", "", Comparison::smaller,
              is_a<DirectionalMaximaSpec>, kLeastAngle_rad}};

bool is_meant(const Candidate& candidate, const Measure& measure) {
  return measure.name == candidate.measure && measure.value &&
         measure.channel.ends_with(candidate.channel);
}

std::optional<double> value_of(const StoredTrial& trial, const Candidate& candidate) {
  double sum = 0.0;
  int count = 0;
  for (const auto& measure : trial.measures)
    if (is_meant(candidate, measure)) sum += *measure.value, ++count;
  if (count == 0) return std::nullopt;
  const double mean = sum / count;
  return candidate.comparison == Comparison::smaller ? std::max(mean, candidate.least) : mean;
}

/// The days of trials that may be compared with `like`, oldest first.
std::vector<ComponentDay> days_of(const std::vector<const StoredTrial*>& trials,
                                  const StoredTrial& like, const Candidate& candidate,
                                  const std::vector<ReportSession>& sessions) {
  std::vector<ComponentDay> days;
  int count = 0;
  for (const StoredTrial* trial : trials) {
    if (!counts(trial->trial) || !difference(*trial, like).empty()) continue;
    const auto value = value_of(*trial, candidate);
    if (!value) continue;
    const ReportSession& session = sessions[trial->session];
    if (days.empty() || days.back().day != session.day) {
      days.push_back({session.day, session.date, 0.0});
      count = 0;
    }
    days.back().value += (*value - days.back().value) / ++count;
  }
  return days;
}

std::span<const ComponentDay> newest(const std::vector<ComponentDay>& days) {
  std::size_t first = days.size() - 1;
  while (first > 0 && days.size() - first < kRecentDays &&
         days.back().day - days[first - 1].day <= kRecent_days)
    --first;
  return std::span(days).subspan(first);
}

double mean_of(std::span<const ComponentDay> days) {
  double sum = 0.0;
  for (const auto& day : days) sum += day.value;
  return sum / static_cast<double>(days.size());
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
    for (const auto& candidate : kCandidates) {
      if (candidate.component != component) continue;
      std::optional<Measured> found;
      for (const auto& [task, trials] : tasks) {
        if (task.first != hand || !counts(trials.back()->trial)) continue;
        const StoredTrial& like = *trials.back();
        const auto spec = parse_task(like.trial.task_text, like.trial.task_name);
        if (!spec || spec->difficulty || !candidate.fits(*spec)) continue;
        Measured one{&candidate, &like, days_of(trials, like, candidate, sessions), {}};
        if (const auto both = tasks.find({other, task.second}); both != tasks.end())
          one.other = days_of(both->second, like, candidate, sessions);
        if (one.hand.empty() || one.other.empty() == with_other) continue;
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

std::string treatment_words(const TreatmentMark& mark) {
  std::string kind = mark.kind;
  std::replace(kind.begin(), kind.end(), '_', ' ');
  return format_date(mark.on_date) + ", " + kind;
}

/// The newest mark that lies between two assessments.
std::string since_treatment(std::span<const TreatmentMark> marks,
                            const std::vector<ComponentDay>& days, double now,
                            const std::string& unit) {
  for (auto mark = marks.rbegin(); mark != marks.rend(); ++mark) {
    const auto after = std::find_if(days.begin(), days.end(), [&](const ComponentDay& day) {
      return day.date >= mark->on_date;
    });
    if (after == days.begin() || after == days.end()) continue;
    return treatment_words(*mark) + ": " + format_value((after - 1)->value, unit) + " before, " +
           format_value(now, unit) + " now";
  }
  return "";
}

std::string counted_days(std::size_t days) {
  return std::to_string(days) + (days == 1 ? " day" : " days");
}

ComponentResult judged(const Measured& one, Hand other, bool compare_hands) {
  const Candidate& candidate = *one.candidate;
  ComponentResult result;
  result.component = candidate.component;
  result.task = one.like->trial.task_name;
  const auto measure = std::find_if(one.like->measures.begin(), one.like->measures.end(),
                                    [&](const Measure& m) { return m.name == candidate.measure; });
  result.unit = measure->unit;
  result.measure = words_for(measure->name, candidate.channel.starts_with("_") ? std::string_view{}
                                                                               : candidate.channel)
                       .title;
  const auto now = newest(one.hand);
  result.value = mean_of(now);
  std::span<const ComponentDay> reference;
  if (compare_hands && !one.other.empty()) {
    reference = newest(one.other);
    result.reference_basis =
        std::string(name_of(other)) + " hand, " + counted_days(reference.size());
  } else {
    const auto before = std::span(one.hand).first(one.hand.size() - now.size());
    if (before.size() < kDaysForOwnBest) {
      result.reason = compare_hands
                          ? "the " + std::string(name_of(other)) + " hand has not done this task"
                          : "too few days for an own best";
      return result;
    }
    const auto best = std::max_element(before.begin(), before.end(), [&](auto& a, auto& b) {
      return logarithm(a.value, candidate.comparison) < logarithm(b.value, candidate.comparison);
    });
    reference = {&*best, 1};
    result.reference_basis = "own best day, " + format_date(best->date);
  }
  result.reference = mean_of(reference);
  if (*result.reference <= 0.0 && candidate.comparison != Comparison::logarithm) {
    result.reason = "the reference is not positive";
    return result;
  }
  result.share = share_of(now, reference, candidate.comparison);
  result.standing = result.share->high < 1.0  ? Standing::below
                    : result.share->low < 1.0 ? Standing::not_clear
                                              : Standing::as_good;
  return result;
}

}  // namespace

std::string_view name_of(Component component) noexcept {
  constexpr std::array<std::string_view, kComponentCount> kNames{
      "strength", "opening", "release", "control", "individuation", "direction"};
  return kNames[static_cast<std::size_t>(component)];
}

std::string_view training_for(Component component) noexcept {
  constexpr std::array<std::string_view, kComponentCount> kTasks{
      "Steadiness",          "Open on cue",        "Let go, short",
      "Grip training, sine", "Index finger, sine", "Force direction"};
  return kTasks[static_cast<std::size_t>(component)];
}

Share share_of(std::span<const ComponentDay> hand, std::span<const ComponentDay> reference,
               Comparison comparison) {
  const auto positive = [](const ComponentDay& day) { return day.value > 0.0; };
  if (comparison != Comparison::logarithm && !std::all_of(hand.begin(), hand.end(), positive))
    return {};
  const Logarithms ours = logarithms(hand, comparison);
  const Logarithms theirs = logarithms(reference, comparison);
  const double log_share = ours.mean - theirs.mean;
  constexpr double kNormal975 = 1.959964;
  const double half = kNormal975 * std::sqrt(ours.variance + theirs.variance);
  return {std::exp(log_share), std::exp(log_share - half), std::exp(log_share + half)};
}

LimitsOfHand limits_of(const PatientRecords& records, std::span<const TreatmentMark> marks) {
  LimitsOfHand limits;
  if (records.sessions.empty()) return limits;
  const auto& affected = records.profile.affected;
  limits.other_hand = affected == Side::right || affected == Side::left;
  limits.hand = records.sessions.back().hand;
  if (limits.other_hand) limits.hand = affected == Side::right ? Hand::right : Hand::left;
  const Hand other = limits.hand == Hand::right ? Hand::left : Hand::right;
  const auto tasks = sort_by_task(records);
  for (std::size_t i = 0; i < kComponentCount; ++i) {
    const auto component = static_cast<Component>(i);
    const auto one = measured(tasks, component, limits.hand, records.shown);
    if (!one) {
      auto& result = limits.components.emplace_back();
      result.component = component;
      result.reason = "not assessed";
      continue;
    }
    auto& result = limits.components.emplace_back(judged(*one, other, limits.other_hand));
    result.treatment = since_treatment(marks, one->hand, *result.value, result.unit);
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

}  // namespace isograsp
