// SPDX-License-Identifier: GPL-3.0-or-later
// How often a verdict is wrong: courses of simulated people whose true change is known, judged with
// pools that were estimated from other simulated people. All seeds are fixed.
#include <cmath>
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "reports/change.hpp"

namespace isograsp {
namespace {

// The clinical rule: at most 6 % of stable courses confirmed, at least 80 % of true changes.
constexpr double kMostFalse = 0.06;
constexpr double kLeastFound = 0.80;
constexpr int kSessions = 20;

/// How one measure varies; CVs are standard deviations of its logarithm.
struct Kind {
  const char* name;
  Better better;
  double least_level;
  double most_level;
  double trial_cv;
  int trials;             ///< a day
  bool constant = false;  ///< the error does not grow with the mean: it is that of the middle level
};
/// Strengths, errors, single times; and a lag, whose error is the same for all.
constexpr Kind kKinds[] = {{"force", Better::higher, 2.0, 30.0, 0.06, 2},
                           {"error", Better::lower, 5.0, 40.0, 0.12, 2},
                           {"single", Better::higher, 0.5, 5.0, 0.0, 1},
                           {"lag", Better::near_zero, 0.2, 0.4, 0.06, 3, true}};

/// A person: a level, and how much it varies from day to day (CV 10 to 20 %).
struct Person {
  double level;
  double day_cv;
};
Person person_of(const Kind& kind, Random& random) {
  constexpr double kLeastCv = 0.10;
  constexpr double kMostCv = 0.20;
  const double level =
      kind.least_level * std::pow(kind.most_level / kind.least_level, random.uniform());
  return {level, std::lerp(kLeastCv, kMostCv, random.uniform())};
}

/// What is measured on one day. `shift`: true change, of the logarithm (of the measure itself
/// where the error is constant).
AssessmentDay measured(const Kind& kind, const Person& person, int day, double shift,
                       Random& random) {
  AssessmentDay one{static_cast<double>(day), {}, false};
  const double of_day = person.day_cv * random.gaussian();
  const double scale = std::sqrt(kind.least_level * kind.most_level);
  for (int trial = 0; trial < kind.trials; ++trial) {
    const double error = of_day + kind.trial_cv * random.gaussian();
    one.trials.push_back(kind.constant ? person.level + shift + scale * error
                                       : person.level * std::exp(shift + error));
  }
  return one;
}

StablePool simulated_pool(const Kind& kind, int people, Random& random) {
  constexpr int kGap_days = 3;
  std::vector<StableDays> stable;
  for (int number = 0; number < people; ++number) {
    const Person person = person_of(kind, random);
    stable.push_back(
        {number,
         {measured(kind, person, 0, 0.0, random), measured(kind, person, kGap_days, 0.0, random)}});
  }
  return pool_of(stable, kind.constant ? ErrorScale::linear : ErrorScale::logarithmic);
}

/// Smallest detectable change of this pool for the days of `kind`.
double mdc_of(const Kind& kind, const StablePool& pool) {
  const double trials = kind.trials;
  return mdc95(*pool.error, {2, 2.0 * trials}, {1, trials});
}

/// Which verdicts stood confirmed at any time of a course.
struct Outcome {
  bool possible = false;
  bool improved = false;
  bool worsened = false;
  bool improved_at_end = false;
  bool worsened_at_end = false;
};
template <class Shift>
Outcome course(const Kind& kind, const StablePool& pool, Shift shift, Random& random) {
  const Person person = person_of(kind, random);
  std::vector<AssessmentDay> days;
  Outcome outcome;
  for (int session = 0; session < kSessions; ++session) {
    days.push_back(measured(kind, person, 3 * session, shift(session), random));
    const auto judged = judge_change(days, pool, kind.better);
    const bool improved = judged.verdict == Verdict::improved;
    const bool worsened = judged.verdict == Verdict::worsened;
    outcome.possible = outcome.possible || improved || worsened;
    outcome.improved_at_end = improved && judged.confirmed;
    outcome.worsened_at_end = worsened && judged.confirmed;
    outcome.improved = outcome.improved || outcome.improved_at_end;
    outcome.worsened = outcome.worsened || outcome.worsened_at_end;
  }
  return outcome;
}

struct Shares {
  double possible = 0.0;
  double confirmed = 0.0;
  double improved = 0.0;
  double worsened = 0.0;
  double improved_at_end = 0.0;
  double worsened_at_end = 0.0;
};
/// Ten people are judged with each pool, so that a pool that came out too small counts. `t975`
/// replaces that of the pool.
template <class Shift>
Shares simulate(const Kind& kind, int people_in_pool, int courses, Shift shift, std::uint64_t seed,
                std::optional<double> t975 = {}) {
  constexpr int kPerPool = 10;
  Shares shares;
  for (int done = 0; done < courses; done += kPerPool) {
    Random random(seed, static_cast<std::uint64_t>(done));
    auto pool = simulated_pool(kind, people_in_pool, random);
    if (t975) pool.error->t975 = *t975;
    for (int i = 0; i < kPerPool; ++i) {
      const auto one = course(
          kind, pool, [&](int session) { return shift(session, mdc_of(kind, pool)); }, random);
      const double each = 1.0 / courses;
      shares.possible += one.possible ? each : 0.0;
      shares.confirmed += one.improved || one.worsened ? each : 0.0;
      shares.improved += one.improved ? each : 0.0;
      shares.worsened += one.worsened ? each : 0.0;
      shares.improved_at_end += one.improved_at_end ? each : 0.0;
      shares.worsened_at_end += one.worsened_at_end ? each : 0.0;
    }
  }
  return shares;
}

/// Parameter: index into kKinds.
class ChangeSimulation : public testing::TestWithParam<int> {
 protected:
  const Kind& kind_ = kKinds[GetParam()];
  void note(const std::string& what, const Shares& shares) const {
    RecordProperty(what, std::to_string(shares.confirmed));
    std::printf(
        "%-8s %-26s possible %5.1f %%  improved %5.1f %%  worsened %5.1f %%  at the end "
        "%5.1f %% and %5.1f %%\n",
        kind_.name, what.c_str(), 100.0 * shares.possible, 100.0 * shares.improved,
        100.0 * shares.worsened, 100.0 * shares.improved_at_end, 100.0 * shares.worsened_at_end);
  }
};
INSTANTIATE_TEST_SUITE_P(Of, ChangeSimulation,
                         testing::Range(0, static_cast<int>(std::size(kKinds))),
                         [](const auto& tested) { return kKinds[tested.param].name; });

constexpr auto kStable = [](int, double) { return 0.0; };

TEST_P(ChangeSimulation, AThousandStablePeopleAreConfirmedAsChangedInAtMostSixPercent) {
  for (const int people : {10, 20, 50}) {
    const auto shares = simulate(kind_, people, 1000, kStable, 5);
    note("stable, pool of " + std::to_string(people), shares);
    EXPECT_LE(shares.confirmed, kMostFalse) << "pool of " << people;
  }
}

TEST_P(ChangeSimulation, TheRateOfFalseAlarmsItselfIsBelowSixPercent) {
  constexpr int kCourses = 20000;  // two standard errors at 5 %: 0.3 %
  for (const int people : {10, 30}) {
    const auto shares = simulate(kind_, people, kCourses, kStable, 7);
    note("20000 stable, pool of " + std::to_string(people), shares);
    EXPECT_LE(shares.confirmed, kMostFalse) << "pool of " << people;
  }
}

TEST_P(ChangeSimulation, WithOneDegreeOfFreedomAPersonTheRateWouldBeMissed) {
  constexpr int kPeople = 10;
  constexpr double kT975 = 2.228;  // at 10 degrees of freedom
  const auto shares = simulate(kind_, kPeople, 20000, kStable, 7, kT975);
  note("the same, df = 10", shares);
  EXPECT_GT(shares.confirmed, kMostFalse);
}

TEST_P(ChangeSimulation, ATrueChangeOfTwiceTheMdcIsConfirmed) {
  const double direction = kind_.better == Better::higher ? 1.0 : -1.0;
  for (const int people : {10, 20, 50}) {
    // It comes with the first session after the baseline and stays.
    const auto change = [&](int session, double mdc) {
      return session < 2 ? 0.0 : (kind_.constant ? 2.0 : direction * 2.0) * mdc;
    };
    const auto shares = simulate(kind_, people, 1000, change, 11);
    note("2 MDC, pool of " + std::to_string(people), shares);
    // A lag that grows by 2 MDC has worsened.
    const double found = kind_.constant ? shares.worsened_at_end : shares.improved_at_end;
    const double wrong = kind_.constant ? shares.improved : shares.worsened;
    EXPECT_GE(found, kLeastFound) << "pool of " << people;
    EXPECT_LE(wrong, kMostFalse / 2.0) << "pool of " << people;
  }
}

TEST_P(ChangeSimulation, PeopleWhoDeclineAreReportedAsWorsened) {
  const double direction = kind_.better == Better::higher ? -1.0 : 1.0;
  for (const int people : {10, 20, 50}) {
    // Evenly, to 2.5 MDC below in the last session.
    const auto decline = [&](int session, double mdc) {
      return direction * 2.5 * mdc * session / (kSessions - 1.0);
    };
    const auto shares = simulate(kind_, people, 1000, decline, 13);
    note("decline, pool of " + std::to_string(people), shares);
    EXPECT_GE(shares.worsened, kLeastFound) << "pool of " << people;
    EXPECT_LE(shares.improved, kMostFalse / 2.0) << "pool of " << people;
  }
}

}  // namespace
}  // namespace isograsp
