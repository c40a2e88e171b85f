// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinematics/measures/coupling.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "kinematics/tables/event_csv.hpp"
#include "kinematics/tables/pose_csv.hpp"
#include "tests/kinematics/support.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::coupling_test {
namespace {

using namespace isograsp::test;

constexpr double kExact = 1e-12;

/// A forearm in the world, an object in the hand; each turns about its own z.
struct Chain {
  /// Angles [rad] at 100 Hz over one second.
  template <class Forearm, class Object>
  Chain(const Forearm& forearm, const Object& object) {
    rig.frames = {{"elbow", PointsFrame()}, {"forearm", PointsFrame()}, {"object", PointsFrame()}};
    rig.links = {{"EF", "elbow", "forearm", AngleSequence::rpy, std::nullopt},
                 {"FO", "forearm", "object", AngleSequence::rpy, std::nullopt},
                 {"object", "world", "object", AngleSequence::rpy, std::nullopt}};
    rig.score = RigScore{"EF", "object", "object"};
    series.frames = {"elbow", "forearm", "object"};
    series.X_W.resize(3);
    for (int k = 0; k <= 100; ++k) {
      const double when_s = k * 0.01;
      series.t_s.push_back(when_s);
      const Quat q_WF(Eigen::AngleAxisd(forearm(when_s), Vec3::UnitZ()));
      const Quat q_FO(Eigen::AngleAxisd(object(when_s), Vec3::UnitZ()));
      series.X_W[0].push_back(Pose());
      series.X_W[1].push_back({Vec3::Zero(), q_WF});
      series.X_W[2].push_back({Vec3::Zero(), q_WF * q_FO});
    }
    targets = {{"screw", 0.0, 1.0, Pose()}};
  }
  [[nodiscard]] MovementCoupling measured(std::vector<OwnRange> ranges = {}) const {
    const auto scores = must(score_movements(rig, series, targets));
    return must(movement_coupling(rig, series, scores, ranges)).at(0);
  }
  Rig rig;
  PoseSeries series;
  std::vector<PoseTarget> targets;
};

double even(double t_s) {
  return t_s;
}
/// Nothing until `from_s`, then evenly to 1 rad.
auto late(double from_s) {
  return [from_s](double t_s) { return std::max(0.0, (t_s - from_s) / (1.0 - from_s)); };
}

TEST(Coupling, WhatTurnsTogetherHasSlopeAndFitOneAndNoLead) {
  const auto of = Chain(even, even).measured();
  EXPECT_WITHIN(*of.slope.value, 1.0, kExact);
  EXPECT_WITHIN(*of.r_squared.value, 1.0, kExact);
  EXPECT_WITHIN(*of.lead.value, 0.0, kExact);
  EXPECT_WITHIN(*of.recognition_time.value, 0.1, kExact) << "a tenth of an even turn";
  EXPECT_WITHIN(*of.movement_time.value, 0.9, kExact);
}

TEST(Coupling, WhatFollowsLateFitsLessAndTheLeadSaysWhoWasFirst) {
  const auto fingers_late = Chain(even, late(0.5)).measured();
  EXPECT_LT(*fingers_late.r_squared.value, 0.9);
  EXPECT_WITHIN(*fingers_late.lead.value, 0.1 - 0.55, kExact);
  const auto forearm_late = Chain(late(0.5), even).measured();
  EXPECT_WITHIN(*forearm_late.lead.value, 0.55 - 0.1, kExact);
  EXPECT_WITHIN(*forearm_late.r_squared.value, *fingers_late.r_squared.value, kExact)
      << "a fit has no direction";
  EXPECT_GT(*fingers_late.slope.value * *forearm_late.slope.value, 0.0);
  EXPECT_WITHIN(*fingers_late.slope.value * *forearm_late.slope.value,
                *fingers_late.r_squared.value, kExact)
      << "the slopes of both regressions multiply to R^2";
}

TEST(Coupling, RowsThatOnlyOneLinkHasAreLeftOut) {
  Chain chain(even, late(0.2));
  const auto whole = chain.measured();
  for (std::size_t k = 40; k < 45; ++k) chain.series.X_W[2][k] = missing_pose();
  const auto part = chain.measured();
  ASSERT_TRUE(part.slope.value);
  EXPECT_NE(*part.slope.value, *whole.slope.value);
  constexpr double kFewRows = 0.01;
  EXPECT_WITHIN(*part.slope.value, *whole.slope.value, kFewRows);
}

TEST(Coupling, TheMarginIsToTheNearestOwnLimitAtTheCue) {
  Chain chain([](double t_s) { return 0.2 + t_s; }, even);
  const OwnRange yaw{"EF", 2, -1.0, 1.5};
  EXPECT_WITHIN(*chain.measured({yaw}).range_margin[0].value, 1.2, kExact) << "to -1";
  EXPECT_WITHIN(*chain.measured({{"EF", 2, -1.0, 0.5}}).range_margin[0].value, 0.3, kExact);
  EXPECT_WITHIN(*chain.measured({{"EF", 2, -1.0, 0.1}}).range_margin[0].value, -0.1, kExact)
      << "beyond it";
  EXPECT_WITHIN(*chain.measured({yaw, {"EF", 0, -0.05, 0.3}}).range_margin[0].value, 0.05, kExact)
      << "the nearest of its angles";
  EXPECT_EQ(english(chain.measured({yaw}).range_margin[1].reason), "own range not measured");
  const auto scores = must(score_movements(chain.rig, chain.series, chain.targets));
  const OwnRange foreign{"leg", 0, 0.0, 1.0};
  EXPECT_FALSE(movement_coupling(chain.rig, chain.series, scores, std::span(&foreign, 1)));
}

TEST(Coupling, ATimeThatDidNotComeIsNotZero) {
  Chain chain(even, even);
  chain.targets[0].matched_s.reset();
  const auto missed = chain.measured();
  for (const Valued* value : {&missed.slope, &missed.r_squared, &missed.lead,
                              &missed.recognition_time, &missed.movement_time}) {
    EXPECT_FALSE(value->value);
    EXPECT_EQ(english(value->reason), "not reached");
  }
  const auto still = Chain(even, [](double) { return 0.0; }).measured();
  EXPECT_EQ(english(still.slope.reason), "too little rotation");
  EXPECT_EQ(english(still.lead.reason), "too little rotation");
  EXPECT_TRUE(still.movement_time.value) << "the object turned with the forearm";
}

TEST(Coupling, AgreesWithAnIndependentProgram) {
  const Rig rig = golden_rig("kurillo15.toml");
  const auto series = must(read_poses(golden("session_a_poses.csv")));
  const auto scores =
      must(score_movements(rig, series, must(read_pose_targets(golden("session_a_events.csv")))));
  const auto found =
      by_movement(coupling_measures(rig, must(movement_coupling(rig, series, scores, {}))));
  constexpr double kOtherProgram = 1e-10;  // sums in another order
  test::AtLeast compared(15);
  for (const Fields& row : golden_table(golden("session_a_quality_expected.csv"))) {
    const auto at = found.find(row.at("movement") + " " + row.at("name") + " " + row.at("channel"));
    if (at == found.end()) continue;  // of the other measures
    ++compared;
    const double value = number_in(row, "value");
    ASSERT_EQ(at->second.value.has_value(), !std::isnan(value)) << at->first << at->second.reason;
    EXPECT_EQ(at->second.reason, row.at("reason")) << at->first;
    if (at->second.value) {
      EXPECT_WITHIN(*at->second.value, value, kOtherProgram) << at->first;
    }
  }
}

TEST(Coupling, MeasuresAreNamedByTheLinkToTheObject) {
  Chain chain(even, even);
  const auto scores = must(score_movements(chain.rig, chain.series, chain.targets));
  const auto coupling = must(movement_coupling(chain.rig, chain.series, scores, {}));
  std::map<std::string, std::string> unit;
  for (const auto& [movement, measure] : coupling_measures(chain.rig, coupling))
    unit[measure.name + " " + measure.channel] = measure.unit;
  EXPECT_EQ(unit, (std::map<std::string, std::string>{{"coupling_slope FO", ""},
                                                      {"coupling_r_squared FO", ""},
                                                      {"lead FO", "s"},
                                                      {"range_margin EF", "rad"},
                                                      {"range_margin FO", "rad"},
                                                      {"range_margin object", "rad"},
                                                      {"recognition_time task", "s"},
                                                      {"movement_time task", "s"}}));
  chain.rig.links[1].parent = std::string(kWorld);
  EXPECT_FALSE(link_to_object(chain.rig)) << "no link leads from a hand to it";
}

}  // namespace
}  // namespace isograsp::coupling_test
