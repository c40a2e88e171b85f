// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinematics/measures/smoothness.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "kinematics/tables/event_csv.hpp"
#include "kinematics/tables/pose_csv.hpp"
#include "tests/kinematics/support.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::arm_smoothness_test {
namespace {

using namespace isograsp::test;

TEST(Smoothness, OfABellOfSpeedIsThatOfTheReferenceProgram) {
  std::vector<double> speed;
  for (int k = -100; k < 100; ++k) speed.push_back(std::exp(-5.0 * (k * 0.01) * (k * 0.01)));
  constexpr double kPrinted = 1e-5;  // digits of the reference
  EXPECT_WITHIN(*spectral_arc_length(speed, 0.01).value, -1.41403, kPrinted);
  EXPECT_WITHIN(*log_dimensionless_jerk(speed, 0.01).value, -5.81636, kPrinted);
  EXPECT_EQ(english(spectral_arc_length(std::vector<double>(9, 0.0), 0.01).reason),
            "nothing moved");
  EXPECT_EQ(english(log_dimensionless_jerk(std::vector<double>(2, 1.0), 0.01).reason),
            "fewer than three samples");
}

std::vector<double> tenths(std::size_t rows) {
  std::vector<double> t_s;
  for (std::size_t k = 0; k < rows; ++k) t_s.push_back(0.1 * static_cast<double>(k));
  return t_s;
}
std::vector<std::size_t> units_of(const std::vector<double>& speed) {
  return movement_units(tenths(speed.size()), speed);
}

TEST(MovementUnits, AreMaximaThatRise20MillimetresPerSecondAndStand150MillisecondsApart) {
  using Rows = std::vector<std::size_t>;
  EXPECT_EQ(units_of({0.0, 0.1, 0.2, 0.1, 0.0}), Rows{2});
  EXPECT_EQ(units_of({0.0, 0.2, 0.1, 0.05, 0.1, 0.0}), (Rows{1, 4})) << "300 ms";
  EXPECT_EQ(units_of({0.0, 0.02, 0.0}), Rows{1}) << "just enough";
  EXPECT_EQ(units_of({0.0, 0.019, 0.0}), Rows{}) << "not enough";
  EXPECT_EQ(units_of({0.1, 0.2, 0.19, 0.205, 0.1}), Rows{1}) << "a dip of less than 20 mm/s";
  EXPECT_EQ(units_of({0.0, 0.2, 0.0, 0.2, 0.0, 0.2, 0.0}), (Rows{1, 3, 5})) << "200 ms";
  EXPECT_EQ(units_of({0.0, 0.2, 0.2, 0.2, 0.0}), Rows{1}) << "the first row of a flat top";
  EXPECT_EQ(units_of({0.0, 0.1, 0.2}), Rows{}) << "still rising at the end";
  EXPECT_EQ(units_of({0.2, 0.1, 0.0}), Rows{}) << "falling from the start";
  EXPECT_EQ(units_of({}), Rows{});
  EXPECT_EQ(units_of({0.3}), Rows{});
  std::vector<double> t_s;
  std::vector<double> speed;
  for (int k = 0; k < 60; ++k) {
    t_s.push_back(0.01 * k);
    speed.push_back(k % 10 == 5 ? 0.3 : 0.0);  // every 100 ms
  }
  EXPECT_EQ(movement_units(t_s, speed), (Rows{5, 25, 45})) << "those too near do not count";
}

/// An object on one link that moves and turns `parts` times smoothly within two seconds, and stands
/// still for half a second before and behind.
struct Carried {
  explicit Carried(int parts) {
    rig.frames = {{"object", PointsFrame()}};
    rig.links = {{"turn", "world", "object", AngleSequence::rpy, std::nullopt}};
    rig.score = RigScore{"turn", "turn", "object"};
    series.frames = {"object"};
    series.X_W.resize(1);
    for (int k = 0; k <= 300; ++k) {
      series.t_s.push_back(k * 0.01);
      const double way = std::clamp((k - 50) / 200.0, 0.0, 1.0) * parts;
      const double within = way - std::floor(way);
      const double gone =
          std::floor(way) + within * within * within * (10.0 + within * (-15.0 + 6.0 * within));
      Pose pose;
      pose.p = Vec3(0.4 * gone / parts, 0.1, 0.0);
      pose.q = Quat(Eigen::AngleAxisd(gone / parts, Vec3::UnitZ()));
      series.X_W[0].push_back(pose);
    }
    targets = {{"there", 0.0, 2.5, Pose()}};
  }
  [[nodiscard]] std::map<std::string, Measure> measures() const {
    std::map<std::string, Measure> all;
    for (const auto& [movement, measure] : must(movement_smoothness(rig, series, targets)))
      all[measure.name + " " + measure.channel] = measure;
    return all;
  }
  Rig rig;
  PoseSeries series;
  std::vector<PoseTarget> targets;
};

TEST(ArmSmoothness, OneMinimumJerkMovementIsSmootherThanThree) {
  auto one = Carried(1).measures();
  auto three = Carried(3).measures();
  ASSERT_EQ(one.size(), 6U);
  EXPECT_EQ(one["movement_units position"].value, 1.0);
  EXPECT_EQ(three["movement_units position"].value, 3.0);
  constexpr double kFiltered_m_s = 0.02;  // a bell of two seconds loses that at its top
  EXPECT_WITHIN(*one["peak_speed position"].value, 1.875 * 0.4 / 2.0, kFiltered_m_s);
  for (const char* measure : {"sparc turn", "sparc position", "ldlj turn", "ldlj position"}) {
    ASSERT_TRUE(one[measure].value) << measure << one[measure].reason;
    EXPECT_GT(*one[measure].value, *three[measure].value + 0.1) << measure;
  }
  // Speed and angular speed have one shape here.
  constexpr double kShape = 1e-3;
  EXPECT_WITHIN(*one["sparc turn"].value, *one["sparc position"].value, kShape);
  constexpr double kMinimumJerkSparc = -1.41;
  EXPECT_WITHIN(*one["sparc turn"].value, kMinimumJerkSparc, 0.02);
}

TEST(ArmSmoothness, StandingStillBeforeTheMovementDoesNotCount) {
  Carried late(1);
  auto whole = late.measures();
  late.targets[0].cue_s = 0.4;
  auto at_once = late.measures();
  constexpr double kRounding = 1e-9;
  for (const char* measure : {"sparc turn", "ldlj turn", "ldlj position"})
    EXPECT_WITHIN(*whole[measure].value, *at_once[measure].value, kRounding) << measure;
}

TEST(ArmSmoothness, AgreesWithAnIndependentProgram) {
  const auto found = by_movement(must(movement_smoothness(
      golden_rig("kurillo15.toml"), must(read_poses(golden("session_a_poses.csv"))),
      must(read_pose_targets(golden("session_a_events.csv"))))));
  constexpr double kOtherProgram =
      1e-10;  // sums in another order, and a filter that remembers longer
  test::AtLeast compared(36);
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

TEST(ArmSmoothness, WhatHardlyMovesHasNoShape) {
  Carried little(1);
  for (Pose& pose : little.series.X_W[0]) {
    pose.p *= 0.02;  // 8 mm
    pose.q = Quat(Eigen::AngleAxisd(0.05 * rotation_vector(pose.q).norm(), Vec3::UnitZ()));
  }
  auto measures = little.measures();
  EXPECT_EQ(measures["sparc turn"].reason, "too little rotation");
  EXPECT_EQ(measures["ldlj position"].reason, "too short a way");
  EXPECT_TRUE(measures["peak_speed position"].value);
}

TEST(ArmSmoothness, SaysWhyThereIsNoValue) {
  const auto reason = [](const Carried& carried) {
    return carried.measures()["sparc turn"].reason;
  };
  Carried missed(1);
  missed.targets[0].matched_s.reset();
  EXPECT_EQ(reason(missed), "not reached");
  Carried hole(1);
  hole.series.X_W[0][120] = missing_pose();
  EXPECT_EQ(reason(hole), "gap") << "one row: the low-pass ends there";
  Carried dark(1);
  for (std::size_t k = 0; k < 20; ++k) dark.series.X_W[0][k] = missing_pose();
  EXPECT_EQ(reason(dark), "no valid sample at the cue");
  Carried slow(1);
  for (double& t_s : slow.series.t_s) t_s *= 4.0;
  slow.targets[0].matched_s = 10.0;
  EXPECT_EQ(reason(slow), "the rate is not 50 to 500 Hz");
  Rig unscored;
  EXPECT_FALSE(movement_smoothness(unscored, PoseSeries(), {}));
}

}  // namespace
}  // namespace isograsp::arm_smoothness_test
