// SPDX-License-Identifier: GPL-3.0-or-later
// Repeated-measures ANOVA: laws first, then values of an independent program and of print.
#include "statistics/anova.hpp"

#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/statistics/subject_tables.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::statistics::anova_test {
namespace {

using test::null_table;

// Sums over some ten values, each rounded; p values amplify F's error by their logarithm.
constexpr double kRounding = 1e-11;

double number(const Computed& computed) {
  EXPECT_TRUE(computed.value) << english(computed.reason);
  return computed.value.value_or(std::numeric_limits<double>::quiet_NaN());
}
#define EXPECT_CLOSE(actual, expected) \
  EXPECT_WITHIN(number(actual), expected, kRounding* std::max(1.0, std::abs(expected)))

/// A seeded table with an effect.
SubjectTable example(Eigen::Index subjects = 9, Eigen::Index conditions = 4) {
  Random random(5);
  SubjectTable table = null_table(random, subjects, conditions);
  for (Eigen::Index column = 0; column < conditions; ++column)
    table.col(column).array() += 0.5 * static_cast<double>(column * column);
  return table;
}

using Golden = std::map<std::string, double>;
Golden golden_values() {
  std::ifstream file(ISOGRASP_SOURCE_DIR "/tests/data/golden/stats_golden.csv");
  Golden values;
  std::string test;
  std::string quantity;
  std::string value;
  std::getline(file, test);
  while (std::getline(file, test, ',') && std::getline(file, quantity, ',') &&
         std::getline(file, value))
    values[test + "." + quantity] = std::stod(value);
  EXPECT_GE(values.size(), 30U);
  return values;
}

/// The column is mode * `dimensions` + dimension.
SubjectTable golden_table(const std::string& set, Eigen::Index subjects, Eigen::Index modes,
                          Eigen::Index dimensions) {
  SubjectTable table = SubjectTable::Constant(subjects, modes * dimensions,
                                              std::numeric_limits<double>::quiet_NaN());
  std::ifstream file(ISOGRASP_SOURCE_DIR "/tests/data/golden/stats_data.csv");
  std::string line;
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    std::string name;
    std::getline(fields, name, ',');
    if (name != set) continue;
    int subject = 0;
    int mode = 0;
    int dimension = 0;
    double value = 0.0;
    char comma = 0;
    fields >> subject >> comma >> mode >> comma >> dimension >> comma >> value;
    table(subject, mode * dimensions + dimension) = value;
  }
  EXPECT_TRUE(table.allFinite());
  return table;
}

TEST(OneWayAnova, OfTwoConditionsIsTheSquareOfThePairedT) {
  const auto table = example(9, 2);
  const auto anova = one_way_anova(table);
  const auto pair = bonferroni_pairs(table).at(0);
  EXPECT_CLOSE(anova.effect.f, number(pair.t) * number(pair.t));
  EXPECT_CLOSE(anova.effect.p, number(pair.p));
  EXPECT_CLOSE(pair.p_bonferroni, number(pair.p));
  EXPECT_EQ(anova.effect.sphericity.epsilon.value, 1.0);
  EXPECT_FALSE(anova.effect.sphericity.mauchly_w.value);
}

TEST(OneWayAnova, SumsOfSquaresAddUpToTheWhole) {
  const auto table = example();
  const auto anova = one_way_anova(table);
  const double whole = (table.array() - table.mean()).matrix().squaredNorm();
  EXPECT_WITHIN(anova.effect.sum_of_squares + anova.effect.error_sum_of_squares +
                    anova.subjects_sum_of_squares,
                whole, kRounding * whole);
  EXPECT_CLOSE(anova.effect.generalised_eta2, anova.effect.sum_of_squares / whole);
}

TEST(OneWayAnova, KnowsNeitherUnitNorOriginNorTheOrderOfSubjectsAndConditions) {
  const auto table = example();
  const auto before = one_way_anova(table).effect;
  SubjectTable reversed = table.rowwise().reverse();
  SubjectTable moved = -3.7 * table;
  moved.array() += 20.0;
  for (const SubjectTable& other : {reversed, moved, test::turned(table)}) {
    const auto after = one_way_anova(other).effect;
    EXPECT_CLOSE(after.f, number(before.f));
    EXPECT_CLOSE(after.corrected_p, number(before.corrected_p));
    EXPECT_CLOSE(after.sphericity.epsilon, number(before.sphericity.epsilon));
    EXPECT_CLOSE(after.sphericity.mauchly_p, number(before.sphericity.mauchly_p));
    EXPECT_CLOSE(after.partial_eta2, number(before.partial_eta2));
    EXPECT_CLOSE(after.generalised_eta2, number(before.generalised_eta2));
  }
}

TEST(OneWayAnova, DoesNotSeeTheLevelsOfSubjectsInItsF) {
  auto table = example();
  const double before = number(one_way_anova(table).effect.f);
  for (Eigen::Index row = 0; row < table.rows(); ++row)
    table.row(row).array() += 5.0 * static_cast<double>(row);
  EXPECT_CLOSE(one_way_anova(table).effect.f, before);
}

TEST(Sphericity, EpsilonLiesBetweenOneOverTheDegreesOfFreedomAndOne) {
  Random random(11);
  for (int k = 3; k <= 6; ++k)
    for (int repeat = 0; repeat < 50; ++repeat) {
      const auto table = null_table(random, k == 6 ? 4 : 8, k);
      const auto effect = one_way_anova(table).effect;
      const double epsilon = number(effect.sphericity.epsilon);
      EXPECT_GE(epsilon, 1.0 / (k - 1));
      EXPECT_LE(epsilon, 1.0);
      EXPECT_GE(number(effect.sphericity.epsilon_huynh_feldt), epsilon);
      EXPECT_LE(number(effect.sphericity.epsilon_huynh_feldt), 1.0);
      EXPECT_CLOSE(effect.corrected_df, epsilon * (k - 1));
    }
}

TEST(Sphericity, EpsilonIsAtItsBoundsForOneDifferenceAndForEqualVariances) {
  // Subjects differ in one contrast only.
  Random random(2);
  SubjectTable one(8, 4);
  for (Eigen::Index row = 0; row < 8; ++row) {
    const double own = random.gaussian();
    one.row(row) << own, -own, 0.0, 0.0;
  }
  one.col(0).array() += 1.0;
  const auto worst = one_way_anova(one).effect.sphericity;
  EXPECT_CLOSE(worst.epsilon, 1.0 / 3.0);
  EXPECT_FALSE(worst.mauchly_p.value);
  EXPECT_NE(english(worst.mauchly_p.reason), "");
  // Each subject has one condition more than the others: covariances are equal.
  SubjectTable equal = SubjectTable::Identity(4, 4);
  equal.row(0).array() += 1.0;
  const auto best = one_way_anova(equal).effect.sphericity;
  EXPECT_CLOSE(best.epsilon, 1.0);
  EXPECT_CLOSE(best.mauchly_w, 1.0);
  EXPECT_CLOSE(best.mauchly_p, 1.0);
}

TEST(Sphericity, OfThreeConditionsEpsilonAndMauchlyTellTheSame) {
  Random random(3);
  for (int repeat = 0; repeat < 20; ++repeat) {
    const auto sphericity = one_way_anova(null_table(random, 7, 3)).effect.sphericity;
    EXPECT_CLOSE(sphericity.epsilon, 1.0 / (2.0 - number(sphericity.mauchly_w)));
  }
}

TEST(TwoWayAnova, OfTwoByTwoLevelsIsThreeTTests) {
  const auto table = example(8, 4);
  const auto anova = two_way_anova(table, 2, 2);
  SubjectTable pair(8, 2);
  const auto t_of = [&pair] { return number(bonferroni_pairs(pair).at(0).t); };
  pair << table.col(0) + table.col(1), table.col(2) + table.col(3);
  EXPECT_CLOSE(anova.a.f, t_of() * t_of());
  pair << table.col(0) + table.col(2), table.col(1) + table.col(3);
  EXPECT_CLOSE(anova.b.f, t_of() * t_of());
  pair << table.col(0) + table.col(3), table.col(1) + table.col(2);
  EXPECT_CLOSE(anova.interaction.f, t_of() * t_of());
}

TEST(TwoWayAnova, SumsOfSquaresAddUpToTheWholeAndFactorsMayChangePlaces) {
  const auto table = example(7, 6);
  const auto anova = two_way_anova(table, 2, 3);
  const double whole = (table.array() - table.mean()).matrix().squaredNorm();
  double parts = anova.subjects_sum_of_squares;
  for (const auto* effect : {&anova.a, &anova.b, &anova.interaction})
    parts += effect->sum_of_squares + effect->error_sum_of_squares;
  EXPECT_WITHIN(parts, whole, kRounding * whole);
  SubjectTable other(7, 6);
  for (Eigen::Index a = 0; a < 2; ++a)
    for (Eigen::Index b = 0; b < 3; ++b) other.col(b * 2 + a) = table.col(a * 3 + b);
  const auto swapped = two_way_anova(other, 3, 2);
  EXPECT_CLOSE(swapped.b.f, number(anova.a.f));
  EXPECT_CLOSE(swapped.a.corrected_p, number(anova.b.corrected_p));
  EXPECT_CLOSE(swapped.interaction.f, number(anova.interaction.f));
  EXPECT_CLOSE(swapped.interaction.sphericity.epsilon,
               number(anova.interaction.sphericity.epsilon));
  EXPECT_CLOSE(swapped.a.generalised_eta2, number(anova.b.generalised_eta2));
}

TEST(TwoWayAnova, MainEffectIsTheOneWayAnalysisOfMeansOverTheOtherFactor) {
  const auto table = example(7, 6);
  const auto anova = two_way_anova(table, 2, 3);
  SubjectTable means(7, 3);
  for (Eigen::Index b = 0; b < 3; ++b) means.col(b) = (table.col(b) + table.col(3 + b)) / 2.0;
  const auto one = one_way_anova(means).effect;
  EXPECT_CLOSE(anova.b.f, number(one.f));
  EXPECT_CLOSE(anova.b.corrected_p, number(one.corrected_p));
}

TEST(NullData, GivesUniformP) {
  Random random(17);
  std::vector<double> p_one;
  std::vector<double> p_interaction;
  std::vector<double> p_mauchly3;
  std::vector<double> p_mauchly4;
  constexpr int kTables = 2000;
  for (int i = 0; i < kTables; ++i) {
    const auto four = one_way_anova(null_table(random, 12, 4)).effect;
    p_one.push_back(number(four.p));
    p_mauchly4.push_back(number(four.sphericity.mauchly_p));
    p_mauchly3.push_back(
        number(one_way_anova(null_table(random, 12, 3)).effect.sphericity.mauchly_p));
    p_interaction.push_back(number(two_way_anova(null_table(random, 8, 6), 2, 3).interaction.p));
  }
  EXPECT_LT(test::distance_from_uniform(p_one), test::kLargestDistance);
  EXPECT_LT(test::distance_from_uniform(p_interaction), test::kLargestDistance);
  EXPECT_LT(test::distance_from_uniform(p_mauchly3), test::kLargestDistance);
  EXPECT_LT(test::distance_from_uniform(p_mauchly4), test::kLargestDistance);
}

TEST(NullData, WithoutSphericityIsRejectedTooOftenUnlessCorrected) {
  Random random(23);
  int plain = 0;
  int corrected = 0;
  constexpr int kTables = 4000;
  constexpr double kAlpha = 0.05;
  for (int i = 0; i < kTables; ++i) {
    auto table = null_table(random, 10, 4);
    table.col(3) *= 5.0;
    const auto effect = one_way_anova(table).effect;
    plain += number(effect.p) < kAlpha ? 1 : 0;
    corrected += number(effect.corrected_p) < kAlpha ? 1 : 0;
  }
  // Four standard errors of a share of 5 % among 4000 are 1.4 %.
  EXPECT_GT(plain, 0.064 * kTables);
  EXPECT_LT(corrected, 0.064 * kTables);
  EXPECT_GT(corrected, 0.03 * kTables);
}

TEST(BonferroniPairs, IntervalHoldsNoZeroExactlyWherePIsBelowItsLevel) {
  Random random(29);
  constexpr double kConfidence = 0.9;
  int found = 0;
  for (int i = 0; i < 100; ++i) {
    auto table = null_table(random, 8, 3);
    table.col(1).array() += 1.2;
    for (const auto& pair : test::every(bonferroni_pairs(table, kConfidence))) {
      const bool outside = number(pair.low) > 0.0 || number(pair.high) < 0.0;
      EXPECT_EQ(outside, number(pair.p) * 3.0 < 1.0 - kConfidence);
      EXPECT_CLOSE(pair.d_z, number(pair.t) / std::sqrt(8.0));
      found += outside ? 1 : 0;
    }
  }
  EXPECT_GT(found, 20);
}

TEST(Undefined, SaysWhyAndIsNoNumber) {
  const auto reason_of = [](const SubjectTable& table) {
    const auto effect = one_way_anova(table).effect;
    EXPECT_FALSE(effect.f.value || effect.p.value || effect.corrected_p.value ||
                 effect.generalised_eta2.value);
    EXPECT_EQ(english(effect.f.reason), english(effect.sphericity.epsilon.reason));
    return english(effect.f.reason);
  };
  EXPECT_EQ(reason_of(SubjectTable::Random(1, 3)), "needs at least 2 subjects, has 1");
  EXPECT_EQ(reason_of(SubjectTable::Random(0, 3)), "needs at least 2 subjects, has 0");
  EXPECT_EQ(reason_of(SubjectTable::Random(5, 1)), "needs at least 2 conditions, has 1");
  auto hole = example();
  hole(2, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(reason_of(hole), "a value is missing");
  EXPECT_NE(reason_of(SubjectTable::Constant(5, 3, 0.1)).find("no error"), std::string::npos);
  // All subjects change by the same: rounding is no error.
  SubjectTable same(5, 3);
  for (Eigen::Index row = 0; row < 5; ++row)
    for (Eigen::Index column = 0; column < 3; ++column)
      same(row, column) = 0.1 * static_cast<double>(row) + 0.7 * static_cast<double>(column);
  EXPECT_NE(reason_of(same).find("no error"), std::string::npos);
  for (const auto& pair : test::every(bonferroni_pairs(same))) {
    EXPECT_TRUE(pair.mean_difference.value);
    EXPECT_FALSE(pair.t.value || pair.d_z.value || pair.low.value);
  }
  const auto few = one_way_anova(example(3, 4)).effect;
  EXPECT_TRUE(few.f.value);
  EXPECT_EQ(english(few.sphericity.mauchly_p.reason), "needs at least 4 subjects, has 3");
}

TEST(SubjectTable, IncompleteSubjectsAreLeftOutAndNamed) {
  auto table = example();
  table(2, 1) = table(7, 0) = std::numeric_limits<double>::quiet_NaN();
  const auto complete = complete_subjects(table);
  EXPECT_EQ(complete.incomplete, (std::vector<Eigen::Index>{2, 7}));
  EXPECT_EQ(complete.values.rows(), 7);
  EXPECT_EQ(complete.values.row(2), table.row(3));
}

TEST(Golden, OneWayAndPairsAgreeWithAnIndependentProgram) {
  auto golden = golden_values();
  const auto table = golden_table("oneway", 6, 1, 3);
  const auto effect = one_way_anova(table).effect;
  EXPECT_CLOSE(effect.f, golden["oneway_rm.F"]);
  EXPECT_EQ(effect.df, golden["oneway_rm.df1"]);
  EXPECT_EQ(effect.error_df, golden["oneway_rm.df2"]);
  EXPECT_CLOSE(effect.p, golden["oneway_rm.p"]);
  EXPECT_CLOSE(effect.sphericity.epsilon, golden["oneway_rm.gg_epsilon"]);
  EXPECT_CLOSE(effect.corrected_p, golden["oneway_rm.p_gg"]);
  for (const auto& pair : test::every(bonferroni_pairs(table))) {
    const auto name =
        "pair_" + std::to_string(pair.first) + "_" + std::to_string(pair.second) + ".";
    EXPECT_CLOSE(pair.t, golden[name + "t"]);
    EXPECT_CLOSE(pair.p, golden[name + "p_raw"]);
    EXPECT_CLOSE(pair.p_bonferroni, golden[name + "p_bonferroni"]);
  }
}

TEST(Golden, TwoWayAgreesWithAnIndependentProgram) {
  auto golden = golden_values();
  const auto anova = two_way_anova(golden_table("twoway", 5, 2, 3), 2, 3);
  const std::pair<const char*, const WithinEffect*> effects[] = {
      {"A", &anova.a}, {"B", &anova.b}, {"AB", &anova.interaction}};
  for (const auto& [name, effect] : effects) {
    const auto of = "twoway_rm_" + std::string(name) + ".";
    EXPECT_CLOSE(effect->f, golden[of + "F"]);
    EXPECT_EQ(effect->df, golden[of + "df1"]);
    EXPECT_EQ(effect->error_df, golden[of + "df2"]);
    EXPECT_CLOSE(effect->p, golden[of + "p"]);
  }
}

TEST(Published, SphericityOfTheSameDataAsPrintedByAnotherProgram) {
  // W 0.434, chi2(2) = 3.343, p = 0.188, Huynh-Feldt 0.760 (SPSS, Laerd Statistics).
  const auto sphericity = one_way_anova(golden_table("oneway", 6, 1, 3)).effect.sphericity;
  constexpr double kPrinted = 0.0005;  // three decimals
  EXPECT_WITHIN(number(sphericity.mauchly_w), 0.434, kPrinted);
  EXPECT_WITHIN(number(sphericity.mauchly_chi2), 3.343, kPrinted);
  EXPECT_EQ(sphericity.mauchly_df.value, 2.0);
  EXPECT_WITHIN(number(sphericity.mauchly_p), 0.188, kPrinted);
  EXPECT_WITHIN(number(sphericity.epsilon_huynh_feldt), 0.760, kPrinted);
}

TEST(Squares, OfValuesBeyondTheNumbersOfAComputerAreNotComputedAndSayWhy) {
  Random random(3);
  const SubjectTable table = test::null_table(random, 8, 3);
  EXPECT_TRUE(one_way_anova(table).effect.f.value);
  for (const double unit : {1e-300, 1e-170, 1e160, 1e300}) {
    const auto effect = one_way_anova(unit * table).effect;
    EXPECT_FALSE(effect.f.value || effect.p.value || effect.generalised_eta2.value) << unit;
    EXPECT_NE(english(effect.f.reason).find(unit < 1.0 ? "too small" : "too large"),
              std::string::npos)
        << english(effect.f.reason);
    EXPECT_FALSE(two_way_anova(unit * table.leftCols(2).replicate(1, 2), 2, 2).a.f.value);
    for (const auto& pair : test::every(bonferroni_pairs(unit * table))) {
      EXPECT_FALSE(pair.t.value || pair.sd.value) << unit;
      EXPECT_NE(english(pair.sd.reason).find("squared"), std::string::npos);
    }
  }
  for (const double unit : {1e-55, 1e55})
    EXPECT_WITHIN(*one_way_anova(unit * table).effect.p.value, *one_way_anova(table).effect.p.value,
                  1e-9);
}

}  // namespace
}  // namespace isograsp::statistics::anova_test
