// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_hand/grasp_criteria.hpp"

#include <gtest/gtest.h>

#include "kinematics/attitude.hpp"
#include "tests/support/every.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/within.hpp"
#include "tests/virtual_hand/support.hpp"

namespace isograsp::grasp_criteria_test {
namespace {

using namespace isograsp::test;
using namespace isograsp::virtual_hand;

struct GraspCase {
  HandModel hand;
  HandPose pose;
  Pose X_WO;
  std::vector<DigitContact> contacts;
  [[nodiscard]] std::vector<GraspCriteria> criteria() const {
    return criteria_of_sets(contacts, hand_in_space(hand, pose), X_WO, hand_scale_m(hand), {});
  }
};

std::map<std::string, GraspCase> golden_cases() {
  std::map<std::string, GraspCase> cases;
  for (const Fields& row : golden_table(hand_data("grasp_cases.csv")))
    cases[row.at("id")] = {
        golden_hand(row.at("hand")),
        {{three_in(row, "palm_", "_m"), quaternion_in(row, "palm_q")}, angles_in(row)},
        {three_in(row, "object_", "_m"), quaternion_in(row, "object_q")},
        {}};
  for (const Fields& row : golden_table(hand_data("grasp_contacts.csv"))) {
    DigitContact contact;
    contact.digit = static_cast<Digit>(
        std::find(kDigitNames.begin(), kDigitNames.end(), row.at("finger")) - kDigitNames.begin());
    contact.link = static_cast<std::size_t>(number_in(row, "link"));
    contact.p_OC = three_in(row, "p", "_m");
    const Vec3 n = three_in(row, "n");
    const Vec3 t = three_in(row, "t");
    contact.R_OC << t, n.cross(t), n;
    cases.at(row.at("id")).contacts.push_back(contact);
  }
  return cases;
}

/// Relative; the table is good to 1e-13, H is divided by the least singular value of G.
constexpr double kRelative = 1e-9;

TEST(GraspCriteria, AreThoseOfTheOracleOfFortyDigits) {
  const auto cases = golden_cases();
  AtLeast compared(100);
  std::map<std::string, std::vector<GraspCriteria>> computed;
  for (const auto& [id, one] : every(cases)) computed[id] = one.criteria();
  for (const Fields& row : every(golden_table(hand_data("grasp_criteria.csv")))) {
    const auto& sets = computed.at(row.at("id"));
    const auto set = std::find_if(sets.begin(), sets.end(), [&](const GraspCriteria& other) {
      return name_of(other.digits) == row.at("fingers");
    });
    ASSERT_NE(set, sets.end()) << row.at("fingers");
    const std::string where = row.at("id") + " " + row.at("fingers");
    const auto near = [&](double value, const std::string& column) {
      const double wanted = number_in(row, column);
      EXPECT_WITHIN(value, wanted, kRelative * std::abs(wanted)) << where << " " << column;
    };
    near(set->length_scale_m, "length_scale_m");
    near(set->G.least, "G_min");
    near(set->G.product, "G_det");
    near(set->H.least, "H_min");
    near(set->H.product, "H_det");
    near(set->G_raw.least, "raw_G_min");
    near(set->H_raw.least, "raw_H_min");
    near(set->H_raw.product, "raw_H_det");
    if (!row.at("force_closure").empty()) {
      EXPECT_EQ(set->force_closure, row.at("force_closure") == "1") << where;
    }
    ++compared;
  }
}

TEST(GraspCriteria, TheBestSetIsTheOneOfTheOracle) {
  const auto cases = golden_cases();
  for (const Fields& row : every(golden_table(hand_data("best_set.csv")))) {
    const GraspLimits limits{number_in(row, "G_min_2"), number_in(row, "H_min_2"),
                             number_in(row, "H_det_2"), number_in(row, "G_min_3"),
                             number_in(row, "H_det_3"), false};
    const auto best = best_grasp(cases.at(row.at("id")).criteria(), limits);
    EXPECT_EQ(name_of(best ? best->digits : 0), row.at("best")) << row.at("id") << row.at("set");
  }
}

TEST(GraspCriteria, DoNotDependOnWhereInTheWorldTheHandHoldsTheObject) {
  Random random(40);
  for (const auto& [id, one] : every(golden_cases())) {
    const Pose X_VW = random_pose(random);
    GraspCase moved = one;
    moved.pose.X_WP = compose(X_VW, one.pose.X_WP);
    moved.X_WO = compose(X_VW, one.X_WO);
    const auto here = one.criteria();
    const auto there = moved.criteria();
    for (std::size_t k = 0; k < here.size(); ++k) {
      EXPECT_WITHIN(there[k].G.least, here[k].G.least, kRelative * here[k].G.least) << id;
      EXPECT_WITHIN(there[k].H.product, here[k].H.product, kRelative * here[k].H.product) << id;
    }
  }
}

TEST(GraspCriteria, ALeftHandThatHoldsTheReflectedObjectHasTheSame) {
  for (const auto& [id, one] : every(golden_cases())) {
    GraspCase other = one;
    other.hand.side = one.hand.side == Hand::right ? Hand::left : Hand::right;
    other.pose.X_WP = mirrored(one.pose.X_WP);
    other.X_WO = mirrored(one.X_WO);
    for (DigitContact& contact : other.contacts) {
      contact.p_OC = mirrored(contact.p_OC);
      const Vec3 t = mirrored(Vec3(contact.R_OC.col(0)));
      const Vec3 n = mirrored(Vec3(contact.R_OC.col(2)));
      contact.R_OC << t, n.cross(t), n;
    }
    const auto here = one.criteria();
    const auto there = other.criteria();
    for (std::size_t k = 0; k < here.size(); ++k) {
      EXPECT_WITHIN(there[k].H.least, here[k].H.least, kRelative * here[k].H.least) << id;
      EXPECT_EQ(there[k].force_closure, here[k].force_closure) << id;
    }
  }
}

TEST(GraspCriteria, ContactsThatCannotHoldEveryWrenchAreWorthNothing) {
  GraspCase one = golden_cases().begin()->second;
  one.contacts.resize(2);
  one.contacts[1].p_OC = one.contacts[0].p_OC;  // both at one place: nothing turns about it
  const auto sets = one.criteria();
  ASSERT_EQ(sets.size(), 1u);
  EXPECT_EQ(sets[0].G.least, 0.0);
  EXPECT_EQ(sets[0].H.product, 0.0);
  EXPECT_FALSE(best_grasp(sets, {0.0, 0.0, 0.0, 0.0, 0.0, false}));
}

TEST(GraspCriteria, FeasibleAsksForForceClosureUnlessToldOtherwise) {
  AtLeast open(1);
  for (const auto& [id, one] : golden_cases()) {
    const auto sets = one.criteria();
    const auto by_source = best_grasp(sets, {0.0, 0.0, 0.0, 0.0, 0.0, false});
    const auto ours = best_grasp(sets, {});
    if (!by_source) continue;
    if (!ours) ++open;
    for (const GraspCriteria& set : sets) {
      EXPECT_TRUE(!ours || set.digits != ours->digits || set.force_closure) << id;
    }
  }
}

TEST(GraspCriteria, TheFeasibleGraspOfASessionIsTheBestOfAllSets) {
  AtLeast some(5);
  for (const auto& [id, one] : every(golden_cases()))
    for (const GraspLimits& limits :
         {GraspLimits{}, GraspLimits{0.1, 0.02, 1e-5, 0.2, 1e-4, true},
          GraspLimits{0.1, 0.02, 1e-5, 0.2, 1e-4, false}, GraspLimits{0.0, 0.0, 0.0, 9.0, 9.0}}) {
      const auto of_all = best_grasp(one.criteria(), limits);
      const auto at_once = feasible_grasp(one.contacts, hand_in_space(one.hand, one.pose), one.X_WO,
                                          hand_scale_m(one.hand), {}, limits);
      ASSERT_EQ(of_all.has_value(), at_once.feasible) << id;
      if (!of_all) continue;
      ++some;
      EXPECT_EQ(name_of(of_all->digits), name_of(at_once.digits)) << id;
      EXPECT_EQ(of_all->product, at_once.H_det * at_once.G_min) << id;
    }
}

}  // namespace
}  // namespace isograsp::grasp_criteria_test
