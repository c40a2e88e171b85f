// SPDX-License-Identifier: GPL-3.0-or-later
// What cameras get to see of the arm.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"
#include "tests/virtual_patient/arm_play.hpp"
#include "virtual_patient/arm/reference_postures.hpp"
#include "virtual_patient/arm/seen_markers.hpp"

namespace isograsp::virtual_patient::arm_markers_test {
namespace {

using namespace isograsp::test;

/// Which marker of the arm has this name.
std::size_t marker(const VirtualArm& arm, std::string_view label) {
  const auto labels = arm.labels();
  return static_cast<std::size_t>(std::find(labels.begin(), labels.end(), label) - labels.begin());
}

/// A screen whose target jumps every two seconds.
Stimulus restless(int picture) {
  Stimulus screen;
  screen.cue = Cue::move;
  screen.object_shown = screen.pose_target_shown = true;
  screen.X_WO.p = Vec3(0.001 * (picture % 7), 0.0, 0.0);
  const double turn = picture / 200 % 2 == 0 ? 0.8 : -0.8;
  screen.X_WT.q = Quat(Eigen::AngleAxisd(turn, Vec3(1.0, 2.0, 3.0).normalized()));
  screen.X_WT.p = Vec3(0.02 * turn, 0.03, 0.0);
  return screen;
}

TEST(ArmMarkers, AreNamedAsInTheRigOfFifteenAndOneOnTheTrunk) {
  const VirtualArm arm(*arm_traits("healthy"), 1);
  const auto labels = arm.labels();
  EXPECT_EQ(std::vector<std::string>(labels.begin(), labels.end()),
            (std::vector<std::string>{"B1", "B2", "B3", "EL", "F1", "F2", "W", "D1", "D2", "O1",
                                      "O2", "O3", "O4", "O5", "O6", "T1"}));
  EXPECT_TRUE(must(ArmFrames::compile(shipped_rig("kurillo15"), labels)).absent().empty());
  EXPECT_TRUE(must(ArmFrames::compile(shipped_rig("kurillo15_trunk"), labels)).absent().empty());
}

TEST(ArmMarkers, TheSameSeedShowsTheSameBitsAndAnotherDoesNot) {
  VirtualArm one(*arm_traits("paretic"), 3), same(*arm_traits("paretic"), 3),
      other(*arm_traits("paretic"), 4);
  std::vector<Vec3> a(kArmMarkers), b(kArmMarkers), c(kArmMarkers);
  bool differs = false;
  for (int k = 0; k < 1500; ++k) {
    const Stimulus screen = restless(k);
    one.markers(kPicture_s * k, a);
    same.markers(kPicture_s * k, b);
    other.markers(kPicture_s * k, c);
    for (auto* arm : {&one, &same, &other}) arm->see(screen);
    for (std::size_t m = 0; m < kArmMarkers; ++m) {
      ASSERT_EQ(std::memcmp(a[m].data(), b[m].data(), sizeof(Vec3)), 0) << k;
      differs = differs || std::memcmp(a[m].data(), c[m].data(), sizeof(Vec3)) != 0;
    }
  }
  EXPECT_TRUE(differs);
}

TEST(ArmMarkers, OnAnotherDayTheSamePersonHasOtherMarkersAndAnotherForm) {
  const ArmTraits traits = *arm_traits("paretic");
  VirtualArm one(traits, 3, Hand::right, 1), same(traits, 3, Hand::right, 1),
      later(traits, 3, Hand::right, 2);
  EXPECT_EQ(one.person(), same.person());
  EXPECT_EQ(one.body().forearm_m, later.body().forearm_m);
  EXPECT_NE(one.person().supination_rad, later.person().supination_rad);
  EXPECT_EQ(one.body().markers[4].p_S, same.body().markers[4].p_S);
  EXPECT_NE(one.body().markers[4].p_S, later.body().markers[4].p_S);
}

TEST(ArmMarkers, NoneIsAllocatedForAndNoneIsHalfSeen) {
  VirtualArm arm(*arm_traits("paretic"), 5);
  std::vector<Vec3> p_W(kArmMarkers);
  AtLeast lost(1);
  const auto before = allocations();
  for (int k = 0; k < 3000; ++k) {
    arm.markers(kPicture_s * k, p_W);
    arm.see(restless(k));
    for (const Vec3& p : p_W) {
      const bool missing = std::isnan(p.x()) && std::isnan(p.y()) && std::isnan(p.z());
      ASSERT_TRUE(missing || p.allFinite());
      if (missing) ++lost;
    }
  }
  EXPECT_EQ(allocations(), before);
}

TEST(ArmMarkers, AreAsUnsteadyAsCameraAndSkinTogether) {
  ArmTraits traits = *arm_traits("healthy");
  traits.wander_rad = traits.tremor_rad = traits.loss_per_s = 0.0;
  VirtualArm arm(traits, 2);
  std::vector<Vec3> p_W(kArmMarkers);
  std::array<Vec3, kArmMarkers> sum, squares;
  sum.fill(Vec3::Zero());
  squares.fill(Vec3::Zero());
  constexpr int kRows = 60000;  // ten minutes
  for (int k = 0; k < kRows; ++k) {
    arm.markers(kPicture_s * k, p_W);
    for (std::size_t m = 0; m < kArmMarkers; ++m) {
      sum[m] += p_W[m];
      squares[m] += p_W[m].cwiseProduct(p_W[m]);
    }
  }
  const auto sd_m = [&](std::string_view label) {
    const std::size_t m = marker(arm, label);
    const Vec3 mean = sum[m] / kRows;
    return std::sqrt((squares[m] / kRows - mean.cwiseProduct(mean)).mean());
  };
  const double skin_m = std::hypot(traits.skin_m, traits.camera_m);
  // Three axes of 600 s / (2 · 0.4 s) independent values: an SD to 2.1 %, three times that.
  constexpr double kSd = 0.065;
  EXPECT_WITHIN(sd_m("O1"), traits.camera_m, kSd * traits.camera_m);
  EXPECT_WITHIN(sd_m("B1"), traits.camera_m, kSd * traits.camera_m);
  EXPECT_WITHIN(sd_m("F1"), skin_m, kSd * skin_m);
  EXPECT_WITHIN(sd_m("T1"), skin_m, kSd * skin_m);
}

TEST(ArmMarkers, AreLostAsOftenAsTheTraitSaysAndMoreOftenAtAGrazingAngle) {
  ArmTraits traits = exact(*arm_traits("healthy"));
  traits.loss_per_s = 0.5;
  VirtualArm arm(traits, 3);
  std::vector<Vec3> p_W(kArmMarkers);
  std::array<int, kArmMarkers> lost{};
  std::array<bool, kArmMarkers> before{};
  constexpr int kRows = 60000;
  for (int k = 0; k < kRows; ++k) {
    arm.markers(kPicture_s * k, p_W);
    for (std::size_t m = 0; m < kArmMarkers; ++m) {
      const bool now = is_missing(p_W[m]);
      lost[m] += now && !before[m] ? 1 : 0;
      before[m] = now;
    }
  }
  // 600 s · 0.5/s at most three times as often where it faces them less, and three roots either
  // way.
  const int facing = lost[marker(arm, "D1")];
  EXPECT_GT(facing, 250);
  EXPECT_LT(facing, 3 * 350);
  // O5 points down and to the palm, away from all cameras but one.
  EXPECT_GT(lost[marker(arm, "O5")], 4 * facing);
}

TEST(ArmMarkers, GoOutOfSightTogetherWhereTheHandTurnsAway) {
  ArmTraits traits = exact(*arm_traits("healthy"));
  traits.view_rad = 1.5;
  SeenMarkers cameras(traits, 1);
  const ArmBody body = average_arm();
  const auto unseen = [&](double pronation_rad) {
    Joints q = body.rest;
    q[joint::pronation] = pronation_rad;
    std::array<Vec3, kArmMarkers> p_W;
    cameras.look(body, body.poses_W(q), kPicture_s, p_W);
    std::string labels;
    for (std::size_t m = 0; m < kArmMarkers; ++m)
      if (is_missing(p_W[m]) && body.markers[m].on_skin)
        labels += std::string(body.markers[m].label) + " ";
    return labels;
  };
  for (const double pronation_rad : {-0.7, -0.2, 0.35, 0.8, 1.2})
    EXPECT_EQ(unseen(pronation_rad), "") << pronation_rad;
  EXPECT_EQ(unseen(-1.9), "F1 F2 W D1 D2 ");
}

TEST(ArmMarkers, OfALeftArmAreTheReflectionOfThoseOfTheRightWithTheSameObject) {
  const ArmTraits traits = exact(*arm_traits("healthy"));
  VirtualArm right(traits, 6), left(traits, 6, Hand::left);
  std::vector<Vec3> a(kArmMarkers), b(kArmMarkers);
  auto right_frames = must(ArmFrames::compile(shipped_rig("kurillo15"), right.labels()));
  auto left_frames = must(ArmFrames::compile(mirrored(shipped_rig("kurillo15")), left.labels()));
  std::vector<FramePose> one(right_frames.frames()), other(left_frames.frames());
  for (int k = 0; k < 1200; ++k) {
    right.markers(kPicture_s * k, a);
    left.markers(kPicture_s * k, b);
    right.see(restless(k));
    left.see(restless(k));
    for (std::size_t m = 0; m < kArmMarkers; ++m)
      if (right.labels()[m].front() != 'O') {
        ASSERT_EQ(b[m], mirrored(a[m])) << k;
      }
    for (Vec3& p : b) p = mirrored(p);
    right_frames.solve(a, one);
    left_frames.solve(b, other);
    for (std::size_t f = 0; f < one.size(); ++f) {
      ASSERT_TRUE(has_pose(one[f].state) && has_pose(other[f].state));
      constexpr double kFit =
          1e-9;  // of the object, whose markers are others in the reflected world
      ASSERT_WITHIN((one[f].X_W.p - other[f].X_W.p).norm(), 0.0, kFit);
      ASSERT_WITHIN(angle_between(one[f].X_W.q, other[f].X_W.q), 0.0, kFit);
      ASSERT_LT(other[f].residual_m, kFit) << "the object is the same object for both hands";
    }
  }
}

TEST(ArmMarkers, FitTheRigWithTheNoiseOfTheCameras) {
  PlayedArm played(*arm_traits("healthy"), 8);
  played.show(Cue::relax, 0.1);
  const Pose start = played.X_WO();
  AtLeast rows(500);
  for (const double turn : {0.6, -0.6, 0.0}) {
    Pose target = start;
    target.q = Quat(Eigen::AngleAxisd(turn, Vec3::UnitZ())) * target.q;
    for (int k = 0; k < 300; ++k) {
      played.aim(target, kPicture_s);
      for (std::size_t f = 0; f < played.poses.size(); ++f) {
        const FramePose& pose = played.poses[f];
        ASSERT_NE(pose.state, FrameState::residual);
        ASSERT_NE(pose.state, FrameState::collinear);
        ASSERT_NE(pose.state, FrameState::rejected);
        if (pose.state != FrameState::ok) continue;
        // Six markers of 0.15 mm in three axes: a root mean square of 0.26 mm, at most four times
        // it.
        ASSERT_LT(pose.residual_m, 0.001);
        ++rows;
      }
    }
  }
}

}  // namespace
}  // namespace isograsp::virtual_patient::arm_markers_test
