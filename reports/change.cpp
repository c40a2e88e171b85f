// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/change.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <numeric>

#include <boost/math/distributions/students_t.hpp>

namespace isograsp {

namespace {

constexpr double square(double x) {
  return x * x;
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
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

/// Variances on one scale, x = value or x = log(value).
struct Variances {
  double day_mean = 0.0;     ///< of a day's mean about the person's own level
  double trial = 0.0;        ///< of a trial about the mean of its day; 0: no day has two
  double trial_share = 0.0;  ///< of `trial` in day_mean: the mean of 1 / trials of a day
};

/// A difference of two days with means a, b has the variance 2 s^2, so that (a - b)^2 / 2 estimates
/// s^2 with one degree of freedom; the mean of a person's pairs, then of the people.
Variances variances_of(const People& people, ErrorScale scale) {
  const auto on_scale = [&](double value) {
    return scale == ErrorScale::logarithmic ? std::log(value) : value;
  };
  Variances all;
  double trial_squares = 0.0;
  double trial_df = 0.0;
  for (const auto& [person, pairs] : people) {
    Variances one;
    for (const Pair& pair : pairs) {
      one.day_mean +=
          square(on_scale(*day_mean(*pair.first)) - on_scale(*day_mean(*pair.second))) / 2.0;
      for (const AssessmentDay* day : {pair.first, pair.second}) {
        std::vector<double> x;
        for (const double value : day->trials) x.push_back(on_scale(value));
        const double mean = mean_of(x);
        for (const double value : x) trial_squares += square(value - mean);
        trial_df += static_cast<double>(x.size()) - 1.0;
        one.trial_share += 0.5 / static_cast<double>(x.size());
      }
    }
    all.day_mean += one.day_mean / static_cast<double>(pairs.size());
    all.trial_share += one.trial_share / static_cast<double>(pairs.size());
  }
  all.day_mean /= static_cast<double>(people.size());
  all.trial_share /= static_cast<double>(people.size());
  if (trial_df > 0.0) all.trial = trial_squares / trial_df;
  return all;
}

/// The scale that is usual for the measure, unless the other is much more likely: ten pairs say too
/// little about it, and the one that happens to give the smaller error would be chosen too often.
/// Box and Cox (1964) compare the likelihoods of transformed values through the Jacobian:
/// logarithms are (s_linear / (geometric mean * s_log))^pairs times as likely as the values
/// themselves.
ErrorScale scale_of(const People& people, ErrorScale usual) {
  constexpr double kMuchMoreLikely = 20.0;
  double logarithms = 0.0;
  double count = 0.0;
  for (const auto& [person, pairs] : people)
    for (const Pair& pair : pairs)
      for (const AssessmentDay* day : {pair.first, pair.second}) {
        for (const double value : day->trials)
          if (value <= 0.0) return ErrorScale::linear;
        logarithms += std::log(*day_mean(*day));
        count += 1.0;
      }
  const double geometric_mean = std::exp(logarithms / count);
  const double linear = variances_of(people, ErrorScale::linear).day_mean;
  const double logarithmic = variances_of(people, ErrorScale::logarithmic).day_mean;
  const double evidence = std::log(linear / (square(geometric_mean) * logarithmic)) *
                          static_cast<double>(people.size()) / 2.0;  // for logarithms
  if (evidence > std::log(kMuchMoreLikely)) return ErrorScale::logarithmic;
  if (evidence < -std::log(kMuchMoreLikely)) return ErrorScale::linear;
  return usual;
}

/// For a person outside the pool, whose own variance is not the pool's mean one. With v the spread
/// of variances among people, a person's estimate from k pairs has the relative variance
/// v + 2 (1 + v) / k, the mean of n people's 1/n^2 of their sum, and the person judged brings v.
/// Satterthwaite (1946): a mean square of relative variance w has 2 / w degrees of freedom.
double degrees_of_freedom(const People& people) {
  const double v = kSpreadOfVariances;
  double sum = 0.0;
  for (const auto& [person, pairs] : people)
    sum += v + 2.0 * (1.0 + v) / static_cast<double>(pairs.size());
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

double mean_of(std::span<const AssessmentDay> days) {
  double sum = 0.0;
  for (const auto& day : days) sum += *day_mean(day);
  return sum / static_cast<double>(days.size());
}

ChangeJudgement not_judged(ChangeJudgement judgement, WhyNotJudged why) {
  judgement.why = why;
  return judgement;
}

}  // namespace

std::optional<double> day_mean(const AssessmentDay& day) {
  if (day.failed || day.trials.empty()) return std::nullopt;
  return mean_of(day.trials);
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
  const Variances variances = variances_of(people, error.scale);
  if (!(variances.day_mean > 0.0)) return pool;
  error.trial_sd = std::sqrt(variances.trial);
  // What the trials leave over; none, if the days differ by no more than their trials explain.
  error.day_sd =
      std::sqrt(std::max(0.0, variances.day_mean - variances.trial * variances.trial_share));
  error.df = degrees_of_freedom(people);
  constexpr double kTwoSided95 = 0.975;
  error.t975 = quantile(boost::math::students_t(error.df), kTwoSided95);
  pool.error = error;
  return pool;
}

double mdc95(const MeasurementError& error, Averaged before, Averaged after) {
  assert(before.days > 0 && after.days > 0 && before.trials > 0.0 && after.trials > 0.0);
  return error.t975 *
         std::sqrt(square(error.day_sd) * (1.0 / before.days + 1.0 / after.days) +
                   square(error.trial_sd) * (1.0 / before.trials + 1.0 / after.trials));
}

ChangeJudgement judge_change(std::span<const AssessmentDay> days, const StablePool& pool,
                             Better better) {
  ChangeJudgement judgement;
  if (better == Better::unknown) return not_judged(judgement, WhyNotJudged::no_direction);
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
    return better == Better::near_zero ? std::abs(value) : value;
  };
  const double baseline = on_axis(*judgement.baseline);
  judgement.change = on_axis(*judgement.last) - baseline;
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
  const auto last = exceeds(after.back());
  judgement.verdict = Verdict::within_error;
  if (*last == 0) return judgement;
  judgement.verdict =
      (*last > 0) == (better == Better::higher) ? Verdict::improved : Verdict::worsened;
  judgement.confirmed = after.size() > 1 && exceeds(after[after.size() - 2]) == last;
  return judgement;
}

}  // namespace isograsp
