// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinematics/movement.hpp"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "kinematics/bands.hpp"
#include "kinematics/tables/event_csv.hpp"
#include "kinematics/tables/pose_csv.hpp"
#include "tests/kinematics/support.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::movement_test {
namespace {

using namespace isograsp::test;

constexpr double kExact = 1e-12;

TEST(Movement, MeasuresAgreeWithAnIndependentScore) {
  const Rig rig = golden_rig("kurillo15.toml");
  const auto scores =
      must(score_movements(rig, must(read_poses(golden("session_a_poses.csv"))),
                           must(read_pose_targets(golden("session_a_events.csv")))));
  std::map<std::string, Measure> found;
  for (const auto& [movement, measure] : movement_measures(rig, scores))
    found[std::to_string(movement) + measure.name + measure.channel] = measure;
  const auto expected = golden_table(golden("session_a_score_expected.csv"));
  EXPECT_EQ(found.size(), expected.size());
  constexpr double kScore = 1e-7;
  for (const Fields& row : test::every(expected)) {
    const auto at = found.find(row.at("movement") + row.at("name") + row.at("channel"));
    ASSERT_NE(at, found.end()) << row.at("name");
    const double value = number_in(row, "value");
    ASSERT_EQ(at->second.value.has_value(), !std::isnan(value)) << at->first;
    EXPECT_EQ(at->second.reason, row.at("reason")) << at->first;
    if (at->second.value) {
      EXPECT_WITHIN(*at->second.value, value, kScore) << at->first;
    }
  }
}

/// A link that turns about z from 0 to `whole_rad` in one second at 100 Hz, evenly.
struct Turn {
  std::vector<double> t_s;
  std::vector<Pose> X_L;
};
Turn even_turn(double whole_rad, double pitch_rad = 0.0) {
  Turn turn;
  for (int k = 0; k <= 100; ++k) {
    turn.t_s.push_back(k * 0.01);
    turn.X_L.push_back(
        {Vec3::Zero(), Quat(Eigen::AngleAxisd(whole_rad * k / 100.0, Vec3::UnitZ())) *
                           Quat(Eigen::AngleAxisd(pitch_rad, Vec3::UnitY()))});
  }
  return turn;
}
const PoseTarget kTarget{"screw", 0.0, 1.0, Pose()};

TEST(Movement, AnEvenTurnPassesEachShareAtThatShareOfItsTime) {
  const Turn turn = even_turn(2.0);
  const auto link = measure_link(turn.t_s, turn.X_L, RigLink(), kTarget);
  EXPECT_WITHIN(*link.rotation.value, 2.0, kExact);
  EXPECT_WITHIN(*link.t10.value, 0.1, kExact);
  EXPECT_WITHIN(*link.t63.value, 1.0 - std::exp(-1.0), kExact);
  EXPECT_WITHIN(*link.t63_rpy.value, 1.0 - std::exp(-1.0), kExact);
  EXPECT_EQ(link.angle.front(), 0.0);
  EXPECT_WITHIN(link.angle.back(), 1.0, kExact);
}

TEST(Movement, YawPastHalfATurnIsNotBroken) {
  Turn turn = even_turn(2.0);
  for (Pose& X_L : turn.X_L) X_L.q = Quat(Eigen::AngleAxisd(2.5, Vec3::UnitZ())) * X_L.q;
  const auto link = measure_link(turn.t_s, turn.X_L, RigLink(), kTarget);
  EXPECT_WITHIN(*link.rotation_rpy.value, 2.0, kExact) << "from 2.5 to 4.5 rad";
}

TEST(Movement, TheShareAlongTheAxisIsNegativeAfterAWrongStart) {
  Turn turn = even_turn(1.0);
  for (std::size_t k = 1; k < 20; ++k) turn.X_L[k].q = Quat(Eigen::AngleAxisd(-0.2, Vec3::UnitZ()));
  const auto link = measure_link(turn.t_s, turn.X_L, RigLink(), kTarget);
  EXPECT_WITHIN(link.axis[5], -0.2, kExact);
  EXPECT_WITHIN(link.angle[5], 0.2, kExact);
}

TEST(Movement, SaysWhyThereIsNoValueInTheOrderOfItsReasons) {
  const auto reason_of = [](const Turn& turn, const PoseTarget& target) {
    return english(measure_link(turn.t_s, turn.X_L, RigLink(), target).reason);
  };
  const auto lost = [](int from, int to) {
    Turn turn = even_turn(1.0);
    for (int k = from; k < to; ++k) turn.X_L[static_cast<std::size_t>(k)] = missing_pose();
    return turn;
  };
  EXPECT_EQ(reason_of(lost(0, 101), {"a", 0.0, std::nullopt, Pose()}), "not reached");
  EXPECT_EQ(reason_of(lost(0, 101), kTarget), "no valid sample at the cue");
  EXPECT_EQ(reason_of(lost(0, 5), kTarget), "") << "50 ms";
  EXPECT_EQ(reason_of(lost(0, 6), kTarget), "no valid sample at the cue");
  EXPECT_EQ(reason_of(lost(95, 101), kTarget), "no valid sample at the match");
  EXPECT_EQ(reason_of(lost(40, 49), kTarget), "") << "100 ms";
  EXPECT_EQ(reason_of(lost(40, 50), kTarget), "gap");
  const Turn little = even_turn(0.08);  // 4.6 degrees
  const auto link = measure_link(little.t_s, little.X_L, RigLink(), kTarget);
  EXPECT_WITHIN(*link.rotation.value, 0.08, kExact);
  EXPECT_EQ(english(link.t10.reason), "too little rotation");
  const Turn steep = even_turn(1.0, 1.56);
  EXPECT_EQ(english(measure_link(steep.t_s, steep.X_L, RigLink(), kTarget).t63_rpy.reason),
            "gimbal lock");
}

TEST(Movement, BandsOfEqualMovementsHaveNoSpread) {
  Rig rig;
  rig.frames = {{"object", PointsFrame()}};
  rig.links = {{"object", "world", "object", AngleSequence::rpy, std::nullopt}};
  rig.score = {"object", "object", "object"};
  PoseSeries series;
  series.frames = {"object"};
  series.X_W.resize(1);
  std::vector<PoseTarget> targets;
  for (int m = 0; m < 3; ++m) {
    const Turn turn = even_turn(1.0);
    for (std::size_t k = 0; k < turn.t_s.size(); ++k) {
      series.t_s.push_back(2.0 * m + turn.t_s[k]);
      Pose pose = turn.X_L[k];
      pose.p.x() = 0.1 * turn.t_s[k];
      series.X_W[0].push_back(pose);
    }
    targets.push_back({"screw", 2.0 * m, 2.0 * m + 1.0, Pose()});
  }
  const auto scores = must(score_movements(rig, series, targets));
  const auto band = must(movement_bands(rig, series, scores));
  test::AtLeast seen(50);
  for (const BandPoint& point : test::every(band)) {
    EXPECT_EQ(point.n, 3);
    EXPECT_WITHIN(*point.sd, 0.0, kExact);
    // An even movement is at 10 % of its way where tau is 0.
    const double way = point.tau + 0.1;
    const bool turning = point.channel == "yaw_rad" || point.channel == "object_r";
    const double expected = point.channel == "x_m" ? 0.1 * way : turning ? way : 0.0;
    EXPECT_WITHIN(point.mean, expected, kExact) << point.channel;
    ++seen;
  }
}

TEST(Movement, ARigWithoutScoreIsRefused) {
  const auto scores = score_movements(golden_rig("links_rig.toml"), PoseSeries(), {});
  ASSERT_FALSE(scores);
  EXPECT_NE(scores.error().message().find("[score]"), std::string::npos);
}

}  // namespace
}  // namespace isograsp::movement_test
