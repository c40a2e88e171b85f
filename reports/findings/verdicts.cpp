// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/findings/verdicts.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "reports/findings/comparable.hpp"
#include "reports/findings/wording.hpp"
#include "tasks/facts/measure_words.hpp"

namespace isograsp::reports {

namespace {

constexpr std::size_t kDayLength = 10;  // of "2026-03-05"

std::string date_of(const std::string& utc) {
  return utc.substr(0, kDayLength);
}

Text why_words(WhyNotJudged why, int people) {
  switch (why) {
    case WhyNotJudged::judged: break;
    case WhyNotJudged::no_direction: return "more of it is neither better nor worse"_text;
    case WhyNotJudged::baseline_too_short: return "the baseline needs two assessment days"_text;
    case WhyNotJudged::baseline_failed:
      return "the baseline needs two days on which every trial has a value"_text;
    case WhyNotJudged::nothing_after: return "no assessment after the baseline"_text;
    case WhyNotJudged::last_failed: return "the last assessment has no value"_text;
    case WhyNotJudged::too_few_people: return "%1 of %2 stable people"_text(people, kLeastPeople);
    case WhyNotJudged::no_variation: return "stable people show no variation"_text;
    case WhyNotJudged::not_positive:
      return "the baseline is not positive, its error is a share"_text;
  }
  return {};
}

/// When the second assessment began: the first day after the baseline; empty: not yet.
std::string second_assessment_utc(const std::vector<AssessmentDay>& days,
                                  const std::vector<ReportSession>& sessions) {
  const Baseline base = baseline_of(days);
  if (base.days.size() < kBaselineDays || base.end == days.size()) return "";
  for (const auto& session : sessions)
    if (session.day == days[base.end].day) return session.started_utc;
  return "";
}

/// Why this patient's data cannot be judged, whatever the pool says; empty: they can.
Text obstacle(const VerdictContext& context, const storage::PrimaryMeasure& primary,
              const TaskSection& section, const std::vector<AssessmentDay>& days,
              const std::vector<ReportSession>& sessions) {
  if (context.part) return "only a part of the sessions is looked at"_text;
  if (section.spec && section.spec->difficulty && section.spec->difficulty->chosen)
    return "the level of its trials follows success"_text;
  const std::string second = second_assessment_utc(days, sessions);
  if (!second.empty() && primary.chosen_utc > second)  // ISO 8601 sorts as text
    return "chosen on %1, after the second assessment"_text(day_words(primary.chosen_utc));
  if (!hand_status(context.profile.affected, section.hand))
    return "the affected side is not known"_text;
  return {};
}

Result<ChangeVerdict> judge(const VerdictContext& context, const storage::PrimaryMeasure& primary,
                            const StoredTrial& like, const MeasureSeries& series,
                            const TaskSection& section,
                            const std::vector<ReportSession>& sessions) {
  ChangeVerdict verdict;
  verdict.chosen_by = primary.chosen_by;
  verdict.chosen_on = date_of(primary.chosen_utc);
  const auto days = assessment_days(series, sessions);
  verdict.reason = obstacle(context, primary, section, days, sessions);
  if (!verdict.reason.empty()) return verdict;
  const auto words = tasks::words_of(series.name, series.channel);
  const auto query = pool_query(like, series);
  auto values = renewed_values(context.renewal, query, context.store.stable_values(query));
  if (!values) return values.error();
  // A person's own variation is no part of what they are judged with, nor are arms that other rigs
  // and postures measured.
  const ArmConditions arm = conditions_of(like).arm;
  std::erase_if(*values, [&](const storage::PooledValue& value) {
    return value.patient_id == like.session_record->patient_id || conditions_of(value).arm != arm;
  });
  const auto stable =
      stable_days(*values, *hand_status(context.profile.affected, section.hand), words.censored);
  const auto pool =
      pool_of(stable, words.error_grows ? ErrorScale::logarithmic : ErrorScale::linear);
  verdict.people = pool.people;
  verdict.left_out = pool.left_out;
  verdict.change = judge_change(days, pool, words.better);
  verdict.fall_cannot_be_told = verdict.change.none_to_zero && !words.below_zero;
  verdict.reason = why_words(verdict.change.why, pool.people);
  return verdict;
}

}  // namespace

std::optional<HandStatus> hand_status(std::optional<storage::Side> affected,
                                      std::optional<Hand> hand) {
  if (!affected) return std::nullopt;
  switch (*affected) {
    case storage::Side::none: return HandStatus::healthy;
    case storage::Side::both: return HandStatus::affected;
    case storage::Side::right:
    case storage::Side::left: break;
  }
  if (!hand) return std::nullopt;
  const bool right = *affected == storage::Side::right;
  return (*hand == Hand::right) == right ? HandStatus::affected : HandStatus::other;
}

std::vector<StableDays> stable_days(std::span<const storage::PooledValue> values, HandStatus status,
                                    bool censored) {
  std::vector<StableDays> all;
  using Key = std::tuple<storage::RowId, storage::RowId, std::optional<Hand>>;
  struct Newest {
    std::size_t place = 0;  ///< in `all`
    const storage::PooledValue* value = nullptr;
    DayCounter counter;
  };
  std::map<Key, Newest> newest;
  for (const auto& value : values) {
    if (hand_status(value.affected, value.hand) != status) continue;
    auto& [place, last, counter] = newest[{value.patient_id, value.period_id, value.hand}];
    if (last == nullptr || !difference(conditions_of(*last), conditions_of(value)).empty()) {
      place = all.size();
      all.push_back({value.patient_id, {}});
    }
    last = &value;
    auto& days = all[place].days;
    const double day = counter.day_of(value.started_utc);
    if (days.empty() || days.back().day != day) days.push_back({day, {}, false});
    if (value.value)
      days.back().trials.push_back(*value.value);
    else
      days.back().failed = days.back().failed || censored;
  }
  for (auto& one : all)
    std::erase_if(one.days,
                  [](const AssessmentDay& day) { return day.trials.empty() && !day.failed; });
  return all;
}

Result<std::vector<storage::PooledValue>> renewed_values(
    Renewal& renewal, const storage::PoolQuery& query,
    Result<std::vector<storage::PooledValue>> values) {
  if (!values) return values;
  for (auto& value : *values)
    if (auto done = renewal.renew(value, query); !done) return done.error();
  std::erase_if(*values, [&](const storage::PooledValue& value) {
    return value.measure_version != query.measure_version;
  });
  return values;
}

const storage::PrimaryMeasure* primary_of(const VerdictContext& context, const TaskSection& section,
                                          const std::string& name, const std::string& channel) {
  for (const auto& primary : context.primaries)
    if (primary.task_name == section.task && primary.hand == section.hand &&
        primary.measure == name && primary.channel == channel)
      return &primary;
  return nullptr;
}

Result<void> judge_section(const VerdictContext& context, const StoredTrial& like,
                           const std::vector<ReportSession>& sessions, TaskSection& section) {
  for (auto& series : section.series) {
    const auto* primary = primary_of(context, section, series.name, series.channel);
    if (primary == nullptr) continue;
    auto verdict = judge(context, *primary, like, series, section, sessions);
    if (!verdict) return verdict.error();
    series.verdict = *std::move(verdict);
    series.key = true;
  }
  return {};
}

}  // namespace isograsp::reports
