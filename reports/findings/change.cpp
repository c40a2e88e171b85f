// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/findings/change.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include <boost/math/distributions/students_t.hpp>

#include "core/mean.hpp"
#include "core/ties.hpp"
#include "statistics/robust_variance.hpp"

namespace isograsp::reports {

namespace {

constexpr double square(double x) {
  return x * x;
}

// People differ in how much they vary from day to day: a coefficient of variation of 10 to 20 %,
// all equally likely (assumed; the virtual patients are made so). Their variances then scatter
// about the mean one; this is the variance of variance / mean variance:
//   E[cv^2] = (b^3 - a^3) / (3 (b - a)),  E[cv^4] = (b^5 - a^5) / (5 (b - a)),
//   E[cv^4] / E[cv^2]^2 - 1 = 0.139.
constexpr double kLeastCv = 0.10;
constexpr double kMostCv = 0.20;
constexpr double power(double x, int n) {
  return n == 0 ? 1.0 : x * power(x, n - 1);
}
constexpr double moment(int n) {
  return (power(kMostCv, n + 1) - power(kLeastCv, n + 1)) / ((n + 1) * (kMostCv - kLeastCv));
}
constexpr double kSpreadOfVariances = moment(4) / square(moment(2)) - 1.0;
/// Of the robust variance; that of the plain mean of squares is 1. By its variance it would be 0.8;
/// with ten people the false alarms ask for this (docs/change.md).
constexpr double kEfficiency = 0.7;

/// Two days of one person.
struct Pair {
  const AssessmentDay* first;
  const AssessmentDay* second;
};
using People = std::map<std::int64_t, std::vector<Pair>>;

/// Pairs without a common day, from the oldest on: no day counts twice.
People people_of(std::span<const StableDays> stable) {
  People people;
  for (const auto& one : stable)
    for (std::size_t i = 0; i + 1 < one.days.size(); ++i) {
      const AssessmentDay& first = one.days[i];
      const AssessmentDay& second = one.days[i + 1];
      const auto gap_days = std::lround(second.day - first.day);
      if (gap_days < kLeastPairGap_days || gap_days > kMostPairGap_days) continue;
      if (!day_mean(first) || !day_mean(second)) continue;
      people[one.person].push_back({&first, &second});
      ++i;
    }
  return people;
}

/// Errors on one scale, x = value or x = log(value).
struct Errors {
  statistics::RobustSd day_mean;  ///< of a day's mean about the person's own level
  statistics::RobustSd trial;     ///< of a trial about the mean of its day; 0: no day has two
  double trial_share = 0.0;  ///< of the variance of trials in that of day_mean: mean of 1 / trials
};

double on_scale(double value, ErrorScale scale) {
  return scale == ErrorScale::logarithmic ? std::log(value) : value;
}

double difference_of_pair(const Pair& pair, ErrorScale scale) {
  return on_scale(*day_mean(*pair.first), scale) - on_scale(*day_mean(*pair.second), scale);
}

/// All pairs of the trials of a day. Weights such that the mean of their halved squares over all
/// days is the pooled variance about the means of the days.
void add_trial_pairs(const AssessmentDay& day, ErrorScale scale,
                     std::vector<statistics::PairDifference>& all) {
  const double weight = 2.0 / static_cast<double>(day.trials.size());
  for (std::size_t i = 0; i < day.trials.size(); ++i)
    for (std::size_t j = i + 1; j < day.trials.size(); ++j)
      all.push_back({on_scale(day.trials[i], scale) - on_scale(day.trials[j], scale), weight});
}

/// Differences that are rounding: of values on the linear scale by their size, of logarithms by 1.
double no_difference(const People& people, ErrorScale scale) {
  if (scale == ErrorScale::logarithmic) return kTied;
  std::vector<double> values;
  for (const auto& [person, pairs] : people)
    for (const Pair& pair : pairs)
      for (const AssessmentDay* day : {pair.first, pair.second})
        values.insert(values.end(), day->trials.begin(), day->trials.end());
  return tie_width(values);
}

/// Every person weighs 1 in the days, every degree of freedom in the trials.
Errors errors_of(const People& people, ErrorScale scale) {
  std::vector<statistics::PairDifference> days;
  std::vector<statistics::PairDifference> trials;
  Errors errors;
  for (const auto& [person, pairs] : people) {
    const double weight = 1.0 / static_cast<double>(pairs.size());
    for (const Pair& pair : pairs) {
      days.push_back({difference_of_pair(pair, scale), weight});
      for (const AssessmentDay* day : {pair.first, pair.second}) {
        add_trial_pairs(*day, scale, trials);
        errors.trial_share += weight * 0.5 / static_cast<double>(day->trials.size());
      }
    }
  }
  errors.trial_share /= static_cast<double>(people.size());
  const double tied = no_difference(people, scale);
  errors.day_mean = statistics::robust_sd(days, statistics::kUnequalVariances, tied);
  if (!trials.empty()) errors.trial = statistics::robust_sd(trials, statistics::kOneVariance, tied);
  return errors;
}

bool is_positive(const Pair& pair) {
  const auto positive = [](double value) { return value > 0.0; };
  return std::all_of(pair.first->trials.begin(), pair.first->trials.end(), positive) &&
         std::all_of(pair.second->trials.begin(), pair.second->trials.end(), positive);
}

/// The scale that is usual for the measure, unless the other is much more likely: ten pairs say too
/// little about it, and the one that happens to give the smaller error would be chosen too often.
/// Box and Cox (1964) compare the likelihoods of transformed values through the Jacobian:
/// logarithms are (s_linear / (geometric mean * s_log))^people times as likely as the values
/// themselves. Pairs that lie far outside on the usual scale do not count.
ErrorScale scale_of(const People& people, ErrorScale usual) {
  constexpr double kMuchMoreLikely = 20.0;
  double all = 0.0;
  double without_logarithm = 0.0;
  for (const auto& [person, pairs] : people)
    for (const Pair& pair : pairs) {
      all += 1.0;
      without_logarithm += is_positive(pair) ? 0.0 : 1.0;
    }
  if (without_logarithm > kMostWithoutLogarithm * all) return ErrorScale::linear;
  const double limit =
      statistics::kKeptSds * std::numbers::sqrt2 * errors_of(people, usual).day_mean.sd;
  std::vector<std::pair<const Pair*, double>> heard;  // with its weight
  double weights = 0.0;
  double logarithms = 0.0;
  for (const auto& [person, pairs] : people)
    for (const Pair& pair : pairs) {
      if (!is_positive(pair) || std::abs(difference_of_pair(pair, usual)) > limit) continue;
      const double weight = 1.0 / static_cast<double>(pairs.size());
      heard.emplace_back(&pair, weight);
      weights += weight;
      logarithms +=
          weight * (std::log(*day_mean(*pair.first)) + std::log(*day_mean(*pair.second))) / 2.0;
    }
  const double geometric_mean = std::exp(logarithms / weights);
  double linear = 0.0;  // relative to the geometric mean
  double logarithmic = 0.0;
  for (const auto& [pair, weight] : heard) {
    linear += weight * square(difference_of_pair(*pair, ErrorScale::linear) / geometric_mean);
    logarithmic += weight * square(difference_of_pair(*pair, ErrorScale::logarithmic));
  }
  const double evidence = std::log(linear / logarithmic) * weights / 2.0;  // for logarithms
  if (evidence > std::log(kMuchMoreLikely)) return ErrorScale::logarithmic;
  if (evidence < -std::log(kMuchMoreLikely)) return ErrorScale::linear;
  return usual;
}

/// For a person outside the pool, whose own variance is not the pool's mean one. With v the spread
/// of variances among people, a person's estimate from k pairs has the relative variance
/// v + 2 (1 + v) / (e k), the mean of n people's 1/n^2 of their sum, and the person judged brings
/// v. Satterthwaite (1946): a mean square of relative variance w has 2 / w degrees of freedom. e:
/// efficiency of the robust variance (change_simulation_test.cpp).
double degrees_of_freedom(const People& people) {
  const double v = kSpreadOfVariances;
  double sum = 0.0;
  for (const auto& [person, pairs] : people)
    sum += v + 2.0 * (1.0 + v) / (kEfficiency * static_cast<double>(pairs.size()));
  return 2.0 / (v + sum / square(static_cast<double>(people.size())));
}

/// Days that do not have the same number of trials: as many as would give the same variance,
/// days^2 / sum(1 / trials); never more than there are.
Averaged averaged(std::span<const AssessmentDay> days) {
  double inverse = 0.0;
  for (const auto& day : days) inverse += 1.0 / static_cast<double>(day.trials.size());
  return {static_cast<int>(days.size()), square(static_cast<double>(days.size())) / inverse};
}

/// Limits of the changes that are not larger than measurement error.
struct Limits {
  double down;
  double up;
};
/// @pre baseline > 0 on a logarithmic scale
Limits limits_about(double baseline, const MeasurementError& error, Averaged before,
                    Averaged after) {
  const double mdc = mdc95(error, before, after);
  if (error.scale == ErrorScale::linear) return {-mdc, mdc};
  return {baseline * std::expm1(-mdc), baseline * std::expm1(mdc)};
}

ChangeJudgement not_judged(ChangeJudgement judgement, WhyNotJudged why) {
  judgement.why = why;
  return judgement;
}

}  // namespace

std::optional<double> day_mean(const AssessmentDay& day) {
  if (day.failed || day.trials.empty()) return std::nullopt;
  return arithmetic_mean(day.trials);
}

double mean_of(std::span<const AssessmentDay> days) {
  std::vector<double> means;
  for (const auto& day : days) means.push_back(*day_mean(day));
  return arithmetic_mean(means);
}

std::optional<double> difference_of(double a, double b) {
  const double difference = a - b;
  return std::isfinite(difference) ? std::optional(difference) : std::nullopt;
}

Baseline baseline_of(std::span<const AssessmentDay> days) {
  Baseline base;
  while (base.end < days.size() && base.days.size() < kBaselineDays) {
    const AssessmentDay& day = days[base.end++];
    if (day_mean(day)) base.days.push_back(day);
  }
  return base;
}

StablePool pool_of(std::span<const StableDays> stable, ErrorScale usual) {
  const People people = people_of(stable);
  StablePool pool;
  pool.people = static_cast<int>(people.size());
  for (const auto& [person, pairs] : people) pool.pairs += static_cast<int>(pairs.size());
  if (pool.people < kLeastPeople) return pool;
  MeasurementError error;
  error.scale = scale_of(people, usual);
  const Errors errors = errors_of(people, error.scale);
  pool.left_out = errors.day_mean.left_out;
  if (!(errors.day_mean.sd > 0.0)) return pool;
  error.trial_sd = errors.trial.sd;
  // What the trials leave over; none, if the days differ by no more than their trials explain.
  const double of_days = errors.day_mean.sd;
  const double of_trials = errors.trial.sd * std::sqrt(errors.trial_share);
  if (of_days > of_trials)
    error.day_sd = std::sqrt(of_days - of_trials) * std::sqrt(of_days + of_trials);
  error.df = degrees_of_freedom(people);
  constexpr double kTwoSided95 = 0.975;
  error.t975 = quantile(boost::math::students_t(error.df), kTwoSided95);
  pool.error = error;
  return pool;
}

double mdc95(const MeasurementError& error, Averaged before, Averaged after) {
  assert(before.days > 0 && after.days > 0 && before.trials > 0.0 && after.trials > 0.0);
  return error.t975 *
         std::hypot(error.day_sd * std::sqrt(1.0 / before.days + 1.0 / after.days),
                    error.trial_sd * std::sqrt(1.0 / before.trials + 1.0 / after.trials));
}

ChangeJudgement judge_change(std::span<const AssessmentDay> days, const StablePool& pool,
                             tasks::Better better) {
  ChangeJudgement judgement;
  if (better == tasks::Better::unknown) return not_judged(judgement, WhyNotJudged::no_direction);
  const Baseline base = baseline_of(days);
  if (base.days.size() < kBaselineDays)
    return not_judged(judgement, base.days.size() < days.size() ? WhyNotJudged::baseline_failed
                                                                : WhyNotJudged::baseline_too_short);
  judgement.baseline = mean_of(base.days);
  const auto after = days.subspan(base.end);
  if (after.empty()) return not_judged(judgement, WhyNotJudged::nothing_after);
  judgement.last = day_mean(after.back());
  if (!judgement.last) return not_judged(judgement, WhyNotJudged::last_failed);

  const auto on_axis = [better](double value) {
    return better == tasks::Better::near_zero ? std::abs(value) : value;
  };
  const double baseline = on_axis(*judgement.baseline);
  judgement.change = difference_of(on_axis(*judgement.last), baseline);
  if (pool.people < kLeastPeople) return not_judged(judgement, WhyNotJudged::too_few_people);
  if (!pool.error) return not_judged(judgement, WhyNotJudged::no_variation);
  if (pool.error->scale == ErrorScale::logarithmic && baseline <= 0.0)
    return not_judged(judgement, WhyNotJudged::not_positive);

  /// -1, 0 or 1: smaller, not larger than measurement error, larger. Without a mean: nothing. A
  /// value that is not positive lies below every limit of a logarithmic scale.
  const auto exceeds = [&](const AssessmentDay& day) -> std::optional<int> {
    const auto mean = day_mean(day);
    if (!mean) return std::nullopt;
    const Limits limits =
        limits_about(baseline, *pool.error, averaged(base.days), averaged({&day, 1}));
    const double change = on_axis(*mean) - baseline;
    return change > limits.up ? 1 : change < limits.down ? -1 : 0;
  };
  const Limits limits =
      limits_about(baseline, *pool.error, averaged(base.days), averaged(after.last(1)));
  judgement.mdc_down = limits.down;
  judgement.mdc_up = limits.up;
  judgement.none_to_zero = baseline + limits.down <= 0.0;
  const auto last = exceeds(after.back());
  judgement.verdict = Verdict::within_error;
  if (*last == 0) return judgement;
  judgement.verdict =
      (*last > 0) == (better == tasks::Better::higher) ? Verdict::improved : Verdict::worsened;
  judgement.confirmed = after.size() > 1 && exceeds(after[after.size() - 2]) == last;
  return judgement;
}

}  // namespace isograsp::reports
