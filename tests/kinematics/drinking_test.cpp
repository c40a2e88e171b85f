// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinematics/measures/drinking.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "kinematics/measures/zero_phase.hpp"
#include "tests/kinematics/support.hpp"
#include "tests/support/drinking_motion.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::drinking_test {
namespace {

using namespace isograsp::test;

constexpr double kPi = std::numbers::pi;

std::map<std::string, Measure> by_name(const DrinkingTask& task) {
  std::map<std::string, Measure> all;
  for (const Measure& measure : task.measures) all[measure.name + " " + measure.channel] = measure;
  return all;
}

/// A boundary lies on a row, and the low-pass rounds the feet of a bell of one second.
constexpr double kBoundary_s = 0.05;

TEST(DrinkingTask, ItsFivePhasesBeginWhereTheMarkersSay) {
  const auto task = drinking_task(healthy_drinking());
  ASSERT_TRUE(task.reason.empty()) << english(task.reason);
  // v / peak = 16 s^2 (1 - s)^2 of a minimum-jerk movement: 2 % at s = 0.0367; 15 and 10 mm/s of a
  // peak of 0.66 m/s at 0.039 and 0.031 of its way; the last 7.5 mm of 353 at 0.871.
  const double expected_s[] = {0.537, 1.839, 2.671, 4.129, 4.969, 6.263};
  for (std::size_t k = 0; k < task.phase_s.size(); ++k)
    EXPECT_WITHIN(task.phase_s[k], expected_s[k], kBoundary_s) << k;
  EXPECT_TRUE(std::is_sorted(task.phase_s.begin(), task.phase_s.end()));
}

TEST(DrinkingTask, PhasesAddUpAndAHealthyOneHasFourMovementUnits) {
  const auto task = drinking_task(healthy_drinking());
  auto measures = by_name(task);
  double sum_s = 0.0;
  for (const auto phase : test::every(kDrinkingPhases))
    sum_s += *measures["phase_time " + std::string(phase)].value;
  constexpr double kRounding_s = 1e-12;
  EXPECT_WITHIN(sum_s, *measures["total_movement_time task"].value, kRounding_s);
  EXPECT_EQ(measures["movement_units reaching_forward"].value, 2.0);
  EXPECT_EQ(measures["movement_units back_returning"].value, 2.0);
  EXPECT_EQ(measures["movement_units total"].value, 4.0);
  constexpr double kFiltered = 0.01;  // of a bell of one second
  EXPECT_WITHIN(*measures["peak_velocity reaching"].value, 1.875 * 0.3, kFiltered);
  const double half_s = 1.0 - task.phase_s[0];
  EXPECT_WITHIN(*measures["time_to_peak_velocity reaching"].value,
                100.0 * half_s / (task.phase_s[1] - task.phase_s[0]), 1.0);
  EXPECT_EQ(measures["time_to_peak_velocity reaching"].unit, "%");
  EXPECT_WITHIN(*measures["trunk_displacement trunk"].value, 0.04, 1e-3);
  EXPECT_WITHIN(*measures["reach trunk"].value, (kGlassPlace - Vec3(0.0, -0.16, 0.2)).norm(), 2e-3);
  EXPECT_WITHIN(*measures["elbow_extension reaching"].value, 150.0 * kPi / 180.0, 2e-3);
  EXPECT_WITHIN(*measures["elbow_extension_rate reaching"].value, 1.875 * 60.0 * kPi / 180.0, 0.05);
  EXPECT_EQ(measures.size(), 15U);
}

TEST(DrinkingTask, AHandThatStopsOnItsWayHasMoreUnits) {
  auto markers = healthy_drinking();
  for (std::size_t k = 0; k < markers.t_s.size(); ++k) {
    const double t_s = markers.t_s[k];
    // The same way in two halves, from 0.5 s and from 1.2 s.
    const double reach =
        0.5 * gone(2.0 * t_s, 2.0 * 0.5) + 0.5 * gone(2.0 * t_s, 2.0 * 1.2) - gone(t_s, 5.3);
    markers.hand[k] = kEdge + reach * (kGlassPlace - kEdge) + (markers.glass[k] - kGlassPlace);
  }
  auto measures = by_name(drinking_task(markers));
  EXPECT_EQ(measures["movement_units reaching_forward"].value, 3.0);
  EXPECT_EQ(measures["movement_units back_returning"].value, 2.0);
  EXPECT_EQ(measures["movement_units total"].value, 5.0);
}

TEST(DrinkingTask, AGlassThatIsJoggedIsNotLifted) {
  const auto plain = drinking_task(healthy_drinking());
  auto markers = healthy_drinking();
  for (std::size_t k = 0; k < markers.t_s.size(); ++k) {
    // 10 mm aside while it is grasped, and again while it is let go.
    markers.glass[k].x() +=
        0.01 * (gone(5.0 * markers.t_s[k], 5.0 * 1.25) - gone(5.0 * markers.t_s[k], 5.0 * 1.42)) +
        0.01 * (gone(5.0 * markers.t_s[k], 5.0 * 5.10) - gone(5.0 * markers.t_s[k], 5.0 * 5.35));
  }
  const auto jogged = drinking_task(markers);
  ASSERT_TRUE(jogged.reason.empty()) << english(jogged.reason);
  constexpr double kRounding_s = 0.021;  // the foot of one bell reaches into the other
  for (std::size_t k = 0; k < plain.phase_s.size(); ++k)
    EXPECT_WITHIN(jogged.phase_s[k], plain.phase_s[k], kRounding_s) << k;
}

TEST(DrinkingTask, WhatWasNotMeasuredIsSaidAndTheRestIsThere) {
  auto markers = healthy_drinking();
  markers.trunk.clear();
  markers.shoulder.clear();
  auto measures = by_name(drinking_task(markers));
  EXPECT_EQ(measures["trunk_displacement trunk"].reason, "trunk not measured");
  EXPECT_EQ(measures["reach trunk"].reason, "trunk not measured");
  EXPECT_EQ(measures["elbow_extension reaching"].reason, "shoulder, elbow and wrist are needed");
  EXPECT_TRUE(measures["total_movement_time task"].value);
  markers = healthy_drinking();
  for (std::size_t k = 300; k < 350; ++k) markers.face[k] = markers.trunk[k] = missing_pose().p;
  measures = by_name(drinking_task(markers));
  EXPECT_TRUE(measures["phase_time drinking"].value) << "the glass hides the face: no boundary";
  EXPECT_EQ(measures["trunk_displacement trunk"].reason, "gap");
  for (std::size_t k = 430; k < 440; ++k) markers.hand[k] = missing_pose().p;
  measures = by_name(drinking_task(markers));
  EXPECT_EQ(measures["movement_units back_returning"].reason, "gap");
  EXPECT_EQ(measures["movement_units total"].reason, "gap");
  EXPECT_EQ(measures["movement_units reaching_forward"].value, 2.0);
}

TEST(DrinkingTask, ARecordThatIsNotAWholeTaskSaysWhy) {
  const auto part = [](std::size_t first, std::size_t end) {
    const DrinkingMarkers whole = healthy_drinking();
    DrinkingMarkers cut;
    for (std::size_t k = first; k < end; ++k) {
      cut.t_s.push_back(whole.t_s[k]);
      cut.hand.push_back(whole.hand[k]);
      cut.glass.push_back(whole.glass[k]);
      cut.face.push_back(whole.face[k]);
    }
    return cut;
  };
  const auto reason = [](const DrinkingMarkers& markers) {
    const DrinkingTask task = drinking_task(markers);
    for (const Measure& measure : task.measures) EXPECT_FALSE(measure.value) << measure.name;
    return english(task.reason);
  };
  EXPECT_EQ(reason(part(0, 170)), "the glass was not lifted");
  EXPECT_EQ(reason(part(90, 701)), "the start is not in the record") << "the hand moves at once";
  EXPECT_EQ(reason(part(0, 590)), "the end is not in the record") << "it moves to the last";
  auto markers = healthy_drinking();
  std::fill(markers.face.begin(), markers.face.end(), missing_pose().p);
  markers.trunk.clear();
  EXPECT_EQ(reason(markers), "the face was not seen");
  markers = part(0, 701);
  for (std::size_t k = 260; k < 300; ++k) markers.face[k] = missing_pose().p;
  EXPECT_EQ(reason(markers), "gap") << "drinking began unseen";
  markers = part(0, 701);
  markers.glass[190] = missing_pose().p;
  EXPECT_EQ(reason(markers), "gap");
  std::fill(markers.glass.begin(), markers.glass.end(), missing_pose().p);
  EXPECT_EQ(reason(markers), "the glass was not seen");
  markers = part(0, 701);
  for (double& t_s : markers.t_s) t_s *= 4.0;
  EXPECT_EQ(reason(markers), "the rate is not 50 to 500 Hz");
}

TEST(DrinkingTask, IsTheSameWhereverTheCamerasStand) {
  Random random(1);
  const Pose X = random_pose(random);
  auto markers = healthy_drinking();
  const auto plain = drinking_task(markers);
  for (auto* part : {&markers.hand, &markers.glass, &markers.face, &markers.trunk,
                     &markers.shoulder, &markers.elbow, &markers.wrist})
    for (Vec3& p : *part) p = X.p + X.q * p;
  const auto moved = drinking_task(markers);
  constexpr double kExact = 1e-9;
  test::AtLeast compared(15);
  for (std::size_t k = 0; k < plain.measures.size(); ++k, ++compared)
    EXPECT_WITHIN(*moved.measures[k].value, *plain.measures[k].value, kExact)
        << plain.measures[k].name;
}

}  // namespace
}  // namespace isograsp::drinking_test
