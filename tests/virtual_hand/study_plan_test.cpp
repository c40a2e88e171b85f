// SPDX-License-Identifier: GPL-3.0-or-later
// The plan of the study: balanced for every seed, repeatable, and about objects that stand on
// something.
#include "virtual_hand/study_plan.hpp"

#include <map>
#include <set>

#include <gtest/gtest.h>

#include "tests/support/every.hpp"

namespace isograsp::virtual_hand::study_plan_test {
namespace {

TEST(StudyPlan, IsBalancedForEverySeed) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto plan = study_plan(seed);
    ASSERT_EQ(plan.size(), 24u);
    std::map<std::pair<std::size_t, bool>, std::multiset<std::size_t>> targets;
    std::set<std::size_t> objects;
    for (std::size_t i = 0; i < plan.size(); ++i) {
      const StudyTest& test = plan[i];
      EXPECT_EQ(test.object, plan[i / 4 * 4].object) << "the four tests of an object in a row";
      objects.insert(test.object);
      targets[{test.object, test.assistance}].insert(test.targets.begin(), test.targets.end());
      int left = 0;
      for (const std::size_t target : test.targets) left += target < 3 ? 1 : 0;
      EXPECT_TRUE(left == 1 || left == 2) << "both sides in each test";
    }
    EXPECT_EQ(objects.size(), kStudyObjects);
    ASSERT_EQ(targets.size(), 2 * kStudyObjects);
    for (const auto& [what, which] : targets)
      EXPECT_EQ(which, (std::multiset<std::size_t>{0, 1, 2, 3, 4, 5}))
          << "every target once with and once without";
  }
}

TEST(StudyPlan, OrdersDifferWithTheSeedAndNoOrderIsPreferred) {
  std::map<std::size_t, int> first;
  int assisted_first = 0;
  constexpr int kSeeds = 1200;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const auto plan = study_plan(seed);
    ++first[plan.front().object];
    assisted_first += plan.front().assistance ? 1 : 0;
  }
  // Five standard deviations of a binomial count.
  for (const auto& [object, count] : first) EXPECT_NEAR(count, kSeeds / 6.0, 65.0) << object;
  EXPECT_NEAR(assisted_first, kSeeds / 2.0, 87.0);
}

TEST(StudyPlan, TargetsOfBothSidesAreReflectionsOfEachOther) {
  for (const SizeClass size : {SizeClass::small, SizeClass::flat, SizeClass::slim}) {
    const auto& targets = targets_of(size);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_LT(targets[i].p_W.x(), 0.0);
      const Vec3 across(-1.0, 1.0, 1.0);
      EXPECT_EQ(targets[i].p_W.cwiseProduct(across), targets[i + 3].p_W);
      const double along = targets[i].axis_W.cwiseProduct(across).dot(targets[i + 3].axis_W);
      EXPECT_NEAR(std::abs(along), 1.0, 1e-12);
    }
  }
}

TEST(StudyObjects, WeighWhatTheirVolumeDoes) {
  constexpr double kRounding = 1e-12;
  EXPECT_NEAR(study_objects()[0].mass_kg, 0.002, kRounding);
  EXPECT_NEAR(study_objects()[2].mass_kg, 0.064, kRounding);
  EXPECT_NEAR(study_objects()[4].mass_kg, 0.060, kRounding);
  for (std::size_t i = 0; i < kStudyObjects; i += 2)
    EXPECT_NEAR(study_objects()[i + 1].mass_kg / study_objects()[i].mass_kg, 0.7853981633974483,
                kRounding);
}

}  // namespace
}  // namespace isograsp::virtual_hand::study_plan_test
