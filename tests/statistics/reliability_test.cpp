// SPDX-License-Identifier: GPL-3.0-or-later
// ICC(2,1), SEM and MDC: laws, known variance components, values of print.
#include "statistics/reliability.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/statistics/subject_tables.hpp"
#include "tests/support/within.hpp"

namespace isograsp::statistics::reliability_test {
namespace {

constexpr double kRounding = 1e-11;

double number(const Computed& computed) {
  EXPECT_TRUE(computed.value) << english(computed.reason);
  return computed.value.value_or(std::numeric_limits<double>::quiet_NaN());
}

struct Components {
  double subjects;  ///< standard deviations
  double repeats;
  double error;
};

SubjectTable simulated(Random& random, const Components& sd, Eigen::Index subjects,
                       Eigen::Index repeats) {
  SubjectTable table(subjects, repeats);
  for (Eigen::Index row = 0; row < subjects; ++row)
    table.row(row).setConstant(10.0 + sd.subjects * random.gaussian());
  for (Eigen::Index column = 0; column < repeats; ++column)
    table.col(column).array() += sd.repeats * random.gaussian();
  for (double& value : table.reshaped()) value += sd.error * random.gaussian();
  return table;
}

TEST(Reliability, KnowsNeitherUnitNorOriginNorOrder) {
  Random random(3);
  const auto table = simulated(random, {2.0, 0.5, 1.0}, 10, 3);
  const auto before = reliability(table);
  SubjectTable other = -2.5 * test::turned(table).rowwise().reverse();
  other.array() += 7.0;
  const auto after = reliability(other);
  EXPECT_WITHIN(number(after.icc), number(before.icc), kRounding);
  EXPECT_WITHIN(number(after.low), number(before.low), kRounding);
  EXPECT_WITHIN(number(after.high), number(before.high), kRounding);
  EXPECT_WITHIN(number(after.sem), 2.5 * number(before.sem), kRounding);
}

TEST(Reliability, SemIsTheSpreadOfAllSourcesThatTheCoefficientLeaves) {
  Random random(4);
  const auto r = reliability(simulated(random, {2.0, 0.5, 1.0}, 12, 4));
  const double error = r.error_mean_square;
  const double repeats = (r.repeats_mean_square - error) / 12.0;
  const double subjects = (r.subjects_mean_square - error) / 4.0;
  const double whole_sd = std::sqrt(subjects + repeats + error);
  EXPECT_WITHIN(number(r.sem), whole_sd * std::sqrt(1.0 - number(r.icc)), kRounding);
  EXPECT_WITHIN(number(r.mdc95), 1.96 * std::numbers::sqrt2 * number(r.sem), kRounding);
}

TEST(Reliability, RepeatsThatDifferOnAverageCountAsDisagreement) {
  Random random(5);
  auto table = simulated(random, {2.0, 0.0, 0.5}, 12, 2);
  const double before = number(reliability(table).icc);
  table.col(1).array() += 3.0;
  EXPECT_LT(number(reliability(table).icc), before - 0.2);
}

TEST(Reliability, FindsKnownVarianceComponentsAndItsIntervalHoldsThem) {
  const Components sd{2.0, 0.7, 1.0};
  const double truth = 4.0 / (4.0 + 0.49 + 1.0);
  Random random(6);
  constexpr int kTables = 1000;
  double sum = 0.0;
  double squared_sem = 0.0;
  int held = 0;
  for (int i = 0; i < kTables; ++i) {
    const auto r = reliability(simulated(random, sd, 20, 5));
    sum += number(r.icc);
    squared_sem += number(r.sem) * number(r.sem);
    held += number(r.low) <= truth && truth <= number(r.high) ? 1 : 0;
  }
  // The mean of a ratio is a little below the ratio of means; SEM squared has no bias: three
  // standard errors of the mean of 1000 are 0.06.
  EXPECT_WITHIN(sum / kTables, truth, 0.02);
  EXPECT_WITHIN(squared_sem / kTables, 1.49, 0.06);
  EXPECT_GT(held, 0.93 * kTables);
  EXPECT_LT(held, 0.985 * kTables);
}

TEST(Reliability, PerfectAgreementIsOneAndEqualValuesAreUndefined) {
  SubjectTable table(4, 3);
  for (Eigen::Index row = 0; row < 4; ++row) table.row(row).setConstant(static_cast<double>(row));
  const auto perfect = reliability(table);
  EXPECT_EQ(perfect.icc.value, 1.0);
  EXPECT_EQ(perfect.sem.value, 0.0);
  EXPECT_FALSE(perfect.low.value);
  EXPECT_NE(english(perfect.low.reason), "");
  EXPECT_EQ(english(reliability(SubjectTable::Constant(4, 3, 0.1)).icc.reason),
            "all values are equal");
  EXPECT_EQ(english(reliability(SubjectTable::Random(1, 3)).sem.reason),
            "needs at least 2 subjects, has 1");
}

TEST(Published, ShroutAndFleissTable4) {
  // Psychological Bulletin 1979; 86: 420-428: six people, four judges; ICC(2,1) = .29.
  SubjectTable table(6, 4);
  table << 9, 2, 5, 8, 6, 1, 3, 2, 8, 4, 6, 8, 7, 1, 2, 6, 10, 5, 6, 9, 6, 2, 4, 7;
  const auto r = reliability(table);
  constexpr double kPrinted = 0.005;
  EXPECT_WITHIN(r.subjects_mean_square, 11.24, kPrinted);
  EXPECT_WITHIN(r.repeats_mean_square, 32.49, kPrinted);
  EXPECT_WITHIN(r.error_mean_square, 1.02, kPrinted);
  EXPECT_WITHIN(number(r.icc), 0.29, kPrinted);
  // Interval as printed for these data by the packages psych and irr of R: 0.019 to 0.761.
  EXPECT_WITHIN(number(r.low), 0.019, 0.0005);
  EXPECT_WITHIN(number(r.high), 0.761, 0.0005);
}

TEST(Reliability, OfValuesBeyondTheNumbersOfAComputerIsNotComputedAndSaysWhy) {
  Random random(3);
  const SubjectTable table = test::null_table(random, 8, 3);
  for (const double unit : {1e-300, 1e-90, 1e160, 1e300}) {
    const auto result = reliability(unit * table);
    EXPECT_FALSE(result.icc.value || result.sem.value || result.low.value) << unit;
    EXPECT_NE(english(result.sem.reason).find("squared"), std::string::npos)
        << english(result.sem.reason);
  }
  for (const double unit : {1e-55, 1e55})
    EXPECT_WITHIN(*reliability(unit * table).low.value, *reliability(table).low.value, 1e-9);
}

}  // namespace
}  // namespace isograsp::statistics::reliability_test
