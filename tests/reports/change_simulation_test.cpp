// SPDX-License-Identifier: GPL-3.0-or-later
// How often a verdict is wrong, over many pools and seeds that nothing was tuned on. The figures of
// docs/change.md are those that are computed here (ISOGRASP_WRITE_DOCS=1 writes them).
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "tests/reports/simulated_courses.hpp"
#include "tests/support/doc_table.hpp"

namespace isograsp::reports::change_simulation_test {
namespace {

using test::kSimulated;
using test::Outcomes;
using test::Outlying;
using test::Share;
using test::simulate;
using test::Simulation;

// The clinical rule: at most 6 % of stable courses confirmed, at least 80 % of true changes.
constexpr double kMostFalse = 0.06;
constexpr double kLeastFound = 0.80;

#ifdef __SANITIZE_ADDRESS__
constexpr int kFamilies = 2;  // the same code, but too few courses for any figure
#else
constexpr int kFamilies = 20;
#endif
constexpr bool kPrecise = kFamilies == 20;
// Largest standard errors of the shares that are compared with a limit: ten courses have one pool,
// so they are larger than those of as many single courses.
struct Errors {
  double alarms;
  double found;
};
constexpr Errors kErrors{0.0015, 0.003};
constexpr Errors kErrorsWithOutlying{0.003, 0.01};
/// No family of 1,500 lies so many of its own standard errors from the mean of all but by chance
/// (once in ten times for all of them together).
constexpr double kFarthestFamily = 4.5;
/// A processor's mathematics may round a course over a limit.
constexpr double kOneCourseInAThousand = 0.1;  // percentage points

double percent(const Share& share) {
  return 100.0 * share.of_courses;
}

/// Parameter: index into kSimulated.
class ChangeSimulation : public testing::TestWithParam<int> {
 protected:
  [[nodiscard]] Simulation simulation(int people, const Outlying& outlying = {}) const {
    Simulation one{measure_};
    one.people = people;
    one.outlying = outlying;
    one.families = kFamilies;
    return one;
  }
  /// After the baseline by 2 MDC to the better; a lag that grows has worsened.
  [[nodiscard]] Outcomes changed(Simulation one) const {
    const double direction = measure_.better == tasks::Better::lower ? -1.0 : 1.0;
    one.change = [direction](int assessment, double mdc) {
      return assessment < 2 ? 0.0 : direction * 2.0 * mdc;
    };
    return simulate(one);
  }
  [[nodiscard]] bool lag() const { return measure_.better == tasks::Better::near_zero; }
  void expect_in_docs(const std::string& row, const std::vector<double>& numbers) const {
    const auto figures = test::figures(numbers);
    RecordProperty(row, figures);
    test::expect_figures("change.md", row, measure_.name, figures, kOneCourseInAThousand);
  }
  /// Alarms, findings and pools of one row of the first table.
  void expect_row(const Simulation& stable, const Simulation& change, const std::string& row,
                  const Errors& errors) const {
    const auto alarms = simulate(stable);
    const auto findings = changed(change);
    const Share& found = lag() ? findings.worsened_at_end : findings.improved_at_end;
    const Share& wrong = lag() ? findings.improved : findings.worsened;
    if (!kPrecise) return;
    expect_in_docs(row, {percent(alarms.confirmed), percent(found), percent(alarms.useless)});
    EXPECT_LE(alarms.confirmed.of_courses, kMostFalse) << row;
    EXPECT_GE(found.of_courses, kLeastFound) << row;
    EXPECT_LE(wrong.of_courses, kMostFalse / 2.0) << row;
    EXPECT_LE(alarms.confirmed.standard_error, errors.alarms) << row;
    EXPECT_LE(found.standard_error, errors.found) << row;
    EXPECT_LE(alarms.confirmed.farthest_family, kFarthestFamily) << row;
    EXPECT_LE(found.farthest_family, kFarthestFamily) << row;
  }

  const test::SimulatedMeasure& measure_ = kSimulated[GetParam()];
};
INSTANTIATE_TEST_SUITE_P(Of, ChangeSimulation,
                         testing::Range(0, static_cast<int>(std::size(kSimulated))),
                         [](const auto& tested) { return kSimulated[tested.param].name; });

TEST_P(ChangeSimulation, StablePeopleAreSeldomConfirmedAsChangedAndTrueChangesAreFound) {
  constexpr int kFew = 15;  // people: fewer of them make pools that differ more
  for (const int people : {10, 11, 15, 20, 30, 50, 100}) {
    auto stable = simulation(people);
    stable.courses = people <= kFew ? 5000 : 2500;
    auto change = simulation(people);
    change.courses = 500;
    expect_row(stable, change, "none | " + std::to_string(people), kErrors);
  }
}

// One day in twenty of the pool lies far off: by three SDs, which nothing can tell from bad luck,
// to ten (a fifth of the force), and hundreds (a wrong unit).
constexpr double kOutlyingDays = 0.05;

TEST_P(ChangeSimulation, SoItIsWithOutlyingDaysInThePool) {
  for (const int size : {3, 5, 10, 300})
    for (const int people : {10, 11, 20, 50}) {
      auto stable = simulation(people, {kOutlyingDays, static_cast<double>(size)});
      stable.courses = 1000;
      auto change = stable;
      change.courses = 500;
      expect_row(stable, change, std::to_string(size) + " SD | " + std::to_string(people),
                 kErrorsWithOutlying);
    }
}

TEST_P(ChangeSimulation, PeopleWhoDeclineAreReportedAsWorsened) {
  for (const int people : {10, 20, 50}) {
    auto decline = simulation(people);
    decline.courses = 500;
    const double direction = measure_.better == tasks::Better::higher ? -1.0 : 1.0;
    // Evenly, to 2.5 MDC below in the last session.
    decline.change = [direction, &decline](int assessment, double mdc) {
      return direction * 2.5 * mdc * assessment / (decline.assessments - 1.0);
    };
    const auto outcomes = simulate(decline);
    if (!kPrecise) continue;
    expect_in_docs("decline, pool of " + std::to_string(people),
                   {percent(outcomes.worsened), percent(outcomes.improved)});
    EXPECT_GE(outcomes.worsened.of_courses, kLeastFound) << people;
    EXPECT_LE(outcomes.improved.of_courses, kMostFalse / 2.0) << people;
  }
}

TEST_P(ChangeSimulation, WithOneDegreeOfFreedomAPersonTheLimitWouldBeMissed) {
  auto ten = simulation(10);
  constexpr double kT975 = 2.228;  // at 10 degrees of freedom
  ten.t975 = kT975;
  const auto alarms = simulate(ten).confirmed;
  if (!kPrecise) return;
  expect_in_docs("alarms with df = 10, pool of 10", {percent(alarms)});
  EXPECT_GT(alarms.of_courses - 2.0 * alarms.standard_error, kMostFalse);
}

TEST_P(ChangeSimulation, WithThePlainMeanOfSquaresMostPoolsWouldBeSpoiltByOutlyingDays) {
  for (const int people : {10, 20, 50}) {
    auto ten_sd = simulation(people, {kOutlyingDays, 10.0});
    const double doubled = test::plain_sd_doubled(ten_sd);
    if (!kPrecise) continue;
    expect_in_docs("SD doubled by the plain mean, pool of " + std::to_string(people),
                   {100.0 * doubled});
    EXPECT_GT(doubled, 0.5) << people;
  }
}

TEST_P(ChangeSimulation, ManyAssessmentsAndPeopleWhoDifferMoreGiveMoreAlarms) {
  double before = 0.0;
  for (const int assessments : {10, 20, 30, 40}) {
    auto twenty = simulation(20);
    twenty.assessments = assessments;
    const auto outcomes = simulate(twenty);
    if (!kPrecise) continue;
    expect_in_docs("alarms in " + std::to_string(assessments) + " assessments, pool of 20",
                   {percent(outcomes.confirmed)});
    EXPECT_GT(outcomes.confirmed.of_courses, before) << assessments;
    before = outcomes.confirmed.of_courses;
    if (assessments == 20)
      expect_in_docs("possible at some time, pool of 20", {percent(outcomes.possible)});
  }
  auto unlike = simulation(20);
  unlike.least_cv = 0.05;
  unlike.most_cv = 0.25;
  const auto alarms = simulate(unlike).confirmed;
  if (kPrecise) expect_in_docs("alarms with CVs of 5 to 25 %, pool of 20", {percent(alarms)});
}

}  // namespace
}  // namespace isograsp::reports::change_simulation_test
