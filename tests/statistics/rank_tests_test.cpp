// SPDX-License-Identifier: GPL-3.0-or-later
// Tests on ranks and box plots: laws first, then values of an independent program and of print.
#include "statistics/rank_tests.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "core/ties.hpp"
#include "statistics/box_plot.hpp"
#include "statistics/robust_trend.hpp"
#include "tests/statistics/subject_tables.hpp"
#include "tests/support/within.hpp"

namespace isograsp::statistics::rank_tests_test {
namespace {

using test::null_table;

constexpr double kRounding = 1e-12;  // of sums of some ten numbers near 1

double number(const Computed& computed) {
  EXPECT_TRUE(computed.value) << english(computed.reason);
  return computed.value.value_or(std::numeric_limits<double>::quiet_NaN());
}

std::vector<double> mid_ranks(const std::vector<double>& values) {
  return isograsp::mid_ranks(values, tie_width(values));
}
SignedRank signed_rank(const std::vector<double>& differences, int comparisons = 1,
                       double confidence = 0.95) {
  return statistics::signed_rank(differences, tie_width(differences), comparisons, confidence);
}

/// Counts all sign patterns one by one.
std::vector<double> enumerated(const std::vector<double>& ranks) {
  const double all = std::accumulate(ranks.begin(), ranks.end(), 0.0);
  std::vector<double> shares(static_cast<std::size_t>(std::lround(2.0 * all)) + 1, 0.0);
  const unsigned patterns = 1U << ranks.size();
  for (unsigned pattern = 0; pattern < patterns; ++pattern) {
    double w = 0.0;
    for (std::size_t i = 0; i < ranks.size(); ++i)
      if ((pattern >> i) & 1U) w += ranks[i];
    shares[static_cast<std::size_t>(std::lround(2.0 * w))] += 1.0 / patterns;
  }
  return shares;
}

TEST(SignedRankDistribution, EqualsTheEnumerationOfAllSignPatternsWithAndWithoutTies) {
  for (const std::vector<double>& values : {std::vector<double>{1},
                                            {1, 2, 3},
                                            {1, 2, 3, 4, 5, 6, 7, 8},
                                            {1, 1, 2, 5, 5, 5, 7, 8},
                                            {3, 3, 3, 3}}) {
    const auto ranks = mid_ranks(values);
    EXPECT_EQ(signed_rank_distribution(ranks), enumerated(ranks));
  }
}

TEST(SignedRankDistribution, SumsToOneAndIsSymmetricUpToTheMostPairs) {
  for (std::size_t n = 1; n <= kMostExactPairs; ++n) {
    std::vector<double> ranks(n);
    std::iota(ranks.begin(), ranks.end(), 1.0);
    const auto shares = signed_rank_distribution(ranks);
    ASSERT_EQ(shares.size(), n * (n + 1) + 1);
    EXPECT_EQ(std::accumulate(shares.begin(), shares.end(), 0.0), 1.0);
    for (std::size_t s = 0; s < shares.size(); ++s)
      ASSERT_EQ(shares[s], shares[shares.size() - 1 - s]);
  }
}

TEST(SignedRank, IsExactlyTheShareOfPatternsThatAreNoLessExtreme) {
  Random random(4);
  for (int repeat = 0; repeat < 50; ++repeat) {
    std::vector<double> differences(8);
    for (double& value : differences) value = std::round(3.0 * random.gaussian()) + 0.5;
    const auto test = signed_rank(differences);
    std::vector<double> sizes;
    for (const double value : differences) sizes.push_back(std::abs(value));
    const auto shares = enumerated(mid_ranks(sizes));
    const double w = std::min(number(test.w_plus), number(test.w_minus));
    double tail = 0.0;
    for (std::size_t s = 0; s <= static_cast<std::size_t>(std::lround(2.0 * w)); ++s)
      tail += shares[s];
    EXPECT_TRUE(test.exact);
    EXPECT_WITHIN(number(test.p), std::min(1.0, 2.0 * tail), kRounding);
  }
}

TEST(SignedRank, KnowsNoUnitNorOrderAndTurnsItsSign) {
  const std::vector<double> differences{0.3, -1.2, 2.5, 0.9, 0.9, -0.3, 4.0, 0.0, 1.7};
  const auto before = signed_rank(differences);
  EXPECT_EQ(before.zeros, 1);
  EXPECT_TRUE(before.ties);
  std::vector<double> negative(differences.rbegin(), differences.rend());
  for (double& value : negative) value *= -4.0;
  const auto after = signed_rank(negative);
  EXPECT_EQ(number(after.p), number(before.p));
  EXPECT_EQ(number(after.w_plus), number(before.w_minus));
  EXPECT_WITHIN(number(after.r), -number(before.r), kRounding);
  EXPECT_WITHIN(number(after.rank_biserial), -number(before.rank_biserial), kRounding);
  EXPECT_WITHIN(number(after.pseudo_median), -4.0 * number(before.pseudo_median), kRounding);
  EXPECT_WITHIN(number(after.low), -4.0 * number(before.high), kRounding);
}

TEST(SignedRank, ExactAndNormalMeetWhereOneEndsAndTheOtherBegins) {
  Random random(6);
  std::vector<double> differences;
  for (std::size_t i = 0; i < kMostExactPairs; ++i) differences.push_back(0.3 + random.gaussian());
  const auto exact = signed_rank(differences);
  ASSERT_TRUE(exact.exact);
  const double z = (std::abs(number(exact.w_plus) - number(exact.w_minus)) / 2.0 - 0.5) /
                   std::sqrt(50.0 * 51.0 * 101.0 / 24.0);
  const double normal = std::erfc(z / std::sqrt(2.0));
  constexpr double kApproximation = 0.01;  // relative, for n = 50 and p near 0.05
  EXPECT_WITHIN(number(exact.p) / normal, 1.0, kApproximation);
  differences.push_back(0.7);
  EXPECT_FALSE(signed_rank(differences).exact);
}

TEST(SignedRank, IntervalHoldsNoZeroExactlyWherePIsBelowItsLevel) {
  Random random(8);
  int outside = 0;
  for (int repeat = 0; repeat < 300; ++repeat) {
    std::vector<double> differences(9);
    for (double& value : differences) value = 0.8 + random.gaussian();
    const auto test = signed_rank(differences);
    const bool without_zero = number(test.low) > 0.0 || number(test.high) < 0.0;
    EXPECT_EQ(without_zero, number(test.p) <= 0.05);
    outside += without_zero ? 1 : 0;
  }
  EXPECT_GT(outside, 50);
  EXPECT_LT(outside, 250);
}

TEST(Ranks, AreNotBrokenByTheLastBit) {
  // Differences 3, -3, 3, 4, 5, 1, as they come from sums in another order.
  const double three = 0.3 * 10.0;
  SubjectTable table(7, 2);
  table << 12.0, 9.0, 9.0, 12.000000000000002, 0.1 + 0.2 + 2.7, 0.0, 14.0, 10.0, 7.0, 2.0, 5.0,
      5.000000000000001, 8.0, 7.0;
  SubjectTable plain(7, 2);
  plain << 12, 9, 9, 12, 3, 0, 14, 10, 7, 2, 5, 5, 8, 7;
  ASSERT_NE(table(1, 1), 12.0);
  ASSERT_EQ(three, 3.0);
  const auto broken = signed_rank_pairs(table).at(0);
  const auto whole = signed_rank_pairs(plain).at(0);
  EXPECT_EQ(broken.zeros, 1) << "5 and 5 and a bit";
  EXPECT_TRUE(broken.ties);
  EXPECT_EQ(number(broken.w_plus), number(whole.w_plus));
  EXPECT_EQ(number(broken.p), number(whole.p));
  EXPECT_EQ(number(broken.z), number(whole.z));
  const auto turned_a_bit = friedman(table);
  EXPECT_EQ(number(turned_a_bit.p), number(friedman(plain).p));
  EXPECT_EQ(mid_ranks({12.0, 12.000000000000002, 11.0}), (std::vector<double>{2.5, 2.5, 1.0}));
  EXPECT_EQ(mid_ranks({12.0, 12.0000001, 11.0}), (std::vector<double>{2.0, 3.0, 1.0}));
}

TEST(SignedRank, OneBitOfOneValueIsWorthNoP) {
  // A change of 12 that was stored as 12 and a bit: in three ways of ten people.
  const double bit = 12.000000000000002;
  for (const std::array<double, 10>& changes :
       {std::array<double, 10>{12, 18, 5, 7, -5, 3, -bit, 14, 12, -7},
        std::array<double, 10>{12, 12, 18, -9, 7, 9, 14, -7, 3, -bit},
        std::array<double, 10>{-bit, -12, -12, -5, 7, 3, 5, -3, -12, 3}}) {
    SubjectTable table = SubjectTable::Zero(10, 2);
    for (std::size_t i = 0; i < changes.size(); ++i)
      table(static_cast<Eigen::Index>(i), 0) = changes[i];
    const auto test = signed_rank_pairs(table).at(0);
    EXPECT_TRUE(test.exact);
    EXPECT_EQ(number(test.p), 194.0 / 1024.0) << "0.189";
    // Without ties the bit has a rank of its own: 0.221.
    EXPECT_EQ(number(statistics::signed_rank(changes, 0.0).p), 226.0 / 1024.0);
  }
}

/// `value` or one of the two numbers beside it.
double nudged(double value, Random& random) {
  const double side = random.uniform();
  constexpr double kThird = 1.0 / 3.0;
  if (side < kThird) return value;
  return std::nextafter(value, side < 2.0 * kThird ? -HUGE_VAL : HUGE_VAL);
}

TEST(Ranks, NoFigureOfRanksTurnsOnTheLastBitOfAnyValue) {
  Random random(92);
  constexpr int kTables = 300;
  int tied = 0;
  for (int draw = 0; draw < kTables; ++draw) {
    const Eigen::Index people = 5 + draw % 8;
    const Eigen::Index conditions = 2 + draw % 3;
    SubjectTable plain(people, conditions);
    for (double& value : plain.reshaped()) value = std::floor(12.0 * random.uniform()) / 10.0;
    SubjectTable bits = plain;
    for (double& value : bits.reshaped()) value = nudged(value, random);
    const auto before = signed_rank_pairs(plain);
    const auto after = signed_rank_pairs(bits);
    for (std::size_t pair = 0; pair < before.size(); ++pair) {
      tied += before[pair].ties ? 1 : 0;
      EXPECT_EQ(before[pair].zeros, after[pair].zeros);
      EXPECT_EQ(before[pair].ties, after[pair].ties);
      for (const auto figure : {&SignedRank::p, &SignedRank::w_plus, &SignedRank::z, &SignedRank::r,
                                &SignedRank::rank_biserial})
        EXPECT_EQ((before[pair].*figure).value, (after[pair].*figure).value) << draw;
    }
    const auto of_all = friedman(plain);
    EXPECT_EQ(of_all.p.value, friedman(bits).p.value) << draw;
    EXPECT_EQ(of_all.mean_ranks, friedman(bits).mean_ranks);
    std::vector<CensoredDay> days;
    std::vector<CensoredDay> other_days;
    for (Eigen::Index row = 0; row < people; ++row) {
      const double x = std::floor(5.0 * random.uniform()) / 7.0;
      const bool came = random.uniform() < 0.8;
      days.push_back({x, came ? std::optional(plain(row, 0)) : std::nullopt, 1, 1});
      other_days.push_back(
          {nudged(x, random), came ? std::optional(bits(row, 0)) : std::nullopt, 1, 1});
    }
    const auto trend = rank_trend(days, {200});
    const auto other_trend = rank_trend(other_days, {200});
    ASSERT_EQ(trend.has_value(), other_trend.has_value());
    if (trend) {
      EXPECT_EQ(trend->tau.value, other_trend->tau.value);
      EXPECT_EQ(trend->tau.low, other_trend->tau.low);
      EXPECT_EQ(trend->tau.high, other_trend->tau.high);
    }
    const auto outside = [](const SubjectTable& table) {
      return box_plot({table.data(), static_cast<std::size_t>(table.size())})->outside.size();
    };
    EXPECT_EQ(outside(plain), outside(bits));
  }
  EXPECT_GT(tied, kTables / 2);
}

TEST(BoxPlot, AValueAtTheEndOfTheWhiskerIsNotOutsideForItsLastBit) {
  // Quartiles 1 and 2: the whisker ends at 3.5.
  const std::vector<double> values{1, 1, 1.5, 2, 3.5000000000000004};
  EXPECT_TRUE(box_plot(values)->outside.empty());
  EXPECT_EQ(box_plot(std::vector{1.0, 1.0, 1.5, 2.0, 3.51})->outside.size(), 1u);
}

TEST(Ranks, OfVerySmallAndVeryLargeValuesAreThoseOfOrdinaryOnes) {
  Random random(12);
  SubjectTable table = null_table(random, 9, 2);
  table.array() += 0.4;
  for (const double unit : {1e-300, 1e160, 1e300}) {
    const auto one = signed_rank_pairs(unit * table).at(0);
    EXPECT_EQ(number(one.p), number(signed_rank_pairs(table).at(0).p)) << unit;
    EXPECT_EQ(number(friedman(unit * table).p), number(friedman(table).p)) << unit;
    EXPECT_WITHIN(number(one.pseudo_median) / unit,
                  number(signed_rank_pairs(table).at(0).pseudo_median), 1e-9);
  }
  SubjectTable largest(6, 2);
  largest.col(0).setConstant(std::numeric_limits<double>::max());
  largest.col(1).setConstant(std::numeric_limits<double>::lowest());
  EXPECT_FALSE(signed_rank_pairs(largest).at(0).p.value);
  EXPECT_NE(english(signed_rank_pairs(largest).at(0).p.reason).find("too large"),
            std::string::npos);
}

TEST(SignedRank, UndefinedSaysWhy) {
  const auto zeros = signed_rank(std::vector<double>(5, 0.0));
  EXPECT_EQ(english(zeros.p.reason), "all differences are zero");
  EXPECT_FALSE(zeros.p.value || zeros.r.value || zeros.rank_biserial.value);
  EXPECT_EQ(zeros.pseudo_median.value, 0.0);
  // The smallest possible two-sided p of five pairs is 2 / 32.
  const auto five = signed_rank(std::vector<double>{1, 2, 3, 4, 5});
  EXPECT_EQ(five.p.value, 0.0625);
  EXPECT_FALSE(five.low.value);
  EXPECT_NE(english(five.low.reason), "");
  auto hole = SubjectTable(3, 2);
  hole.setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(english(signed_rank_pairs(hole).at(0).p.reason), "a value is missing");
  EXPECT_EQ(english(friedman(hole).p.reason), "a value is missing");
  EXPECT_NE(english(friedman(SubjectTable::Constant(4, 3, 1.0)).chi2.reason), "");
}

TEST(SignedRank, OfNullDataIsRejectedNoMoreOftenThanItsLevel) {
  Random random(31);
  constexpr int kTables = 4000;
  const std::array<double, 3> levels{0.01, 0.05, 0.2};
  std::array<int, 3> rejected{};
  for (int i = 0; i < kTables; ++i) {
    std::vector<double> differences(10);
    for (double& value : differences) value = random.gaussian();
    const double p = number(signed_rank(differences).p);
    for (std::size_t level = 0; level < levels.size(); ++level)
      rejected[level] += p <= levels[level] ? 1 : 0;
  }
  for (std::size_t level = 0; level < levels.size(); ++level) {
    // Three standard errors of a share.
    const double error = 3.0 * std::sqrt(levels[level] * kTables);
    EXPECT_LT(rejected[level], levels[level] * kTables + error);
    EXPECT_GT(rejected[level], 0.7 * levels[level] * kTables - error);  // steps of 1/512
  }
}

TEST(Friedman, OfTwoConditionsIsTheSignTest) {
  Random random(12);
  const auto table = null_table(random, 15, 2);
  const auto plus = static_cast<double>((table.col(0).array() > table.col(1).array()).count());
  const auto test = friedman(table);
  EXPECT_WITHIN(number(test.chi2), (2.0 * plus - 15.0) * (2.0 * plus - 15.0) / 15.0, kRounding);
}

TEST(Friedman, KnowsOnlyTheOrderWithinEachSubject) {
  Random random(13);
  const auto table = null_table(random, 9, 4);
  const auto before = friedman(table);
  SubjectTable other = test::turned(table).array().exp();
  for (Eigen::Index row = 0; row < other.rows(); ++row)
    other.row(row) *= static_cast<double>(row + 1);
  EXPECT_WITHIN(number(friedman(other).chi2), number(before.chi2), kRounding);
  EXPECT_WITHIN(number(friedman(other).kendall_w), number(before.kendall_w), kRounding);
}

TEST(Friedman, AgreementIsCompleteOrNone) {
  SubjectTable same(5, 3);
  same.rowwise() = Eigen::RowVector3d(1.0, 5.0, 2.0);
  EXPECT_WITHIN(number(friedman(same).kendall_w), 1.0, kRounding);
  SubjectTable square(3, 3);
  square << 1, 2, 3, 2, 3, 1, 3, 1, 2;
  EXPECT_WITHIN(number(friedman(square).kendall_w), 0.0, kRounding);
  EXPECT_WITHIN(number(friedman(square).p), 1.0, kRounding);
}

TEST(Friedman, PValuesOfNullDataAreNearlyUniform) {
  Random random(19);
  constexpr int kTables = 2000;
  int rejected = 0;
  for (int i = 0; i < kTables; ++i)
    rejected += number(friedman(null_table(random, 15, 4)).p) <= 0.05 ? 1 : 0;
  // Chi-squared is an approximation on few ranks: it rejects a little less than its level.
  EXPECT_GT(rejected, 0.035 * kTables);
  EXPECT_LT(rejected, 0.065 * kTables);
}

TEST(Golden, FriedmanAgreesWithAnIndependentProgram) {
  SubjectTable table(6, 3);  // set "oneway" of tests/data/golden/stats_data.csv
  table << 45, 50, 55, 42, 42, 45, 36, 41, 43, 39, 35, 40, 51, 55, 59, 44, 49, 56;
  EXPECT_WITHIN(number(friedman(table).chi2), 10.17391304347826087, kRounding);
  EXPECT_WITHIN(number(friedman(table).p), 6.176790235910902342e-3, kRounding);
}

TEST(Published, HollanderAndWolfe) {
  // Nonparametric statistical methods, 1973: depression scale of nine patients before and after a
  // tranquillizer (T+ = 40, p = 2 x 0.020; estimate 0.46); Friedman of 22 runners and three ways
  // of rounding first base (S' = 11.1, p = 0.004).
  const std::vector<double> before{1.83, 0.50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30};
  const std::vector<double> after{0.878, 0.647, 0.598, 2.05, 1.06, 1.29, 1.06, 3.14, 1.29};
  std::vector<double> differences;
  for (std::size_t i = 0; i < before.size(); ++i) differences.push_back(before[i] - after[i]);
  const auto test = signed_rank(differences);
  EXPECT_EQ(test.w_plus.value, 40.0);
  EXPECT_EQ(test.p.value, 20.0 / 512.0);
  constexpr double kPrinted = 0.005;
  EXPECT_WITHIN(number(test.pseudo_median), 0.46, kPrinted);
  SubjectTable runners(22, 3);
  runners << 5.40, 5.50, 5.55, 5.85, 5.70, 5.75, 5.20, 5.60, 5.50, 5.55, 5.50, 5.40, 5.90, 5.85,
      5.70, 5.45, 5.55, 5.60, 5.40, 5.40, 5.35, 5.45, 5.50, 5.35, 5.25, 5.15, 5.00, 5.85, 5.80,
      5.70, 5.25, 5.20, 5.10, 5.65, 5.55, 5.45, 5.60, 5.35, 5.45, 5.05, 5.00, 4.95, 5.50, 5.50,
      5.40, 5.45, 5.55, 5.50, 5.55, 5.55, 5.35, 5.45, 5.50, 5.55, 5.50, 5.45, 5.25, 5.65, 5.60,
      5.40, 5.70, 5.65, 5.55, 6.30, 6.30, 6.25;
  EXPECT_WITHIN(number(friedman(runners).chi2), 11.1429, 0.00005);
  EXPECT_WITHIN(number(friedman(runners).p), 0.003805, 0.0000005);
}

TEST(BoxPlot, QuartilesLieWhereTheRuleSays) {
  const auto box = box_plot(std::vector<double>{4, 1, 2, 3});
  EXPECT_EQ(box->lower_quartile, 1.75);
  EXPECT_EQ(box->median, 2.5);
  EXPECT_EQ(box->upper_quartile, 3.25);
  EXPECT_EQ(box->lower_whisker, 1.0);
  EXPECT_EQ(box->upper_whisker, 4.0);
}

TEST(BoxPlot, WhiskersEndAtValuesAndWhatLiesBeyondIsListed) {
  const auto box = box_plot(std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 14.0, 14.1, -7.0});
  // Quartiles 2.5 and 7.5: one and a half boxes reach from -5 to 15.
  EXPECT_EQ(box->lower_quartile, 2.5);
  EXPECT_EQ(box->upper_quartile, 7.5);
  EXPECT_EQ(box->lower_whisker, 1.0);
  EXPECT_EQ(box->upper_whisker, 14.1);
  EXPECT_EQ(box->outside, std::vector<double>{-7.0});
  EXPECT_FALSE(box_plot(std::vector<double>{}));
  EXPECT_EQ(box_plot(std::vector<double>{3.0})->lower_whisker, 3.0);
}

}  // namespace
}  // namespace isograsp::statistics::rank_tests_test
