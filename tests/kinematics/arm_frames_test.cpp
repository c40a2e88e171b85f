// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinematics/arm_frames.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "kinematics/pose_series.hpp"
#include "tests/kinematics/support.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"

namespace isograsp::arm_frames_test {
namespace {

using namespace isograsp::test;

const Vec3 kLost = Vec3::Constant(kMissing);

std::vector<FramePose> solve(const Rig& rig, const MarkerRows& rows, std::size_t row) {
  auto frames = must(ArmFrames::compile(rig, rows.markers));
  std::vector<FramePose> solved(frames.frames());
  frames.solve(rows.p_W[row], solved);
  return solved;
}

TEST(ArmFrames, AgreeWithAnIndependentArmOfFifteenMarkers) {
  const Rig rig = golden_rig("kurillo15.toml");
  const MarkerRows rows = golden_markers("session_a_markers.csv");
  auto frames = must(ArmFrames::compile(rig, rows.markers));
  std::vector<FramePose> solved(frames.frames());
  const auto expected = golden_table(golden("session_a_poses_expected.csv"));
  std::size_t next = 0;
  for (std::size_t r = 0; r < rows.t_s.size() && next < expected.size(); ++r) {
    frames.solve(rows.p_W[r], solved);
    if (std::abs(rows.t_s[r] - number_in(expected[next], "t_s")) > 1e-9) continue;
    for (std::size_t f = 0; f < solved.size(); ++f) {
      const std::string& name = rig.frames[f].name;
      const Pose X_W = pose_in(expected[next], name);
      EXPECT_EQ(name_of(solved[f], rig.frames[f]), expected[next].at(name + "_state"));
      EXPECT_EQ(solved[f].used, number_in(expected[next], name + "_used"));
      ASSERT_EQ(is_missing(X_W), is_missing(solved[f].X_W));
      if (is_missing(X_W)) continue;
      EXPECT_WITHIN((solved[f].X_W.p - X_W.p).norm(), 0.0, kGoldenPosition_m);
      EXPECT_WITHIN(angle_between(solved[f].X_W.q, X_W.q), 0.0, kGoldenAngle_rad);
    }
    ++next;
  }
  EXPECT_EQ(next, expected.size());
}

TEST(ArmFrames, ALostPointTakesOnlyTheFramesThatNeedItWithIt) {
  const Rig rig = golden_rig("kurillo15.toml");
  MarkerRows rows = golden_markers("session_a_markers.csv");
  auto& row = rows.p_W[0];
  row[3] = kLost;  // EL, the elbow: elbow and forearm
  const auto solved = solve(rig, rows, 0);
  EXPECT_TRUE(has_pose(solved[0].state));
  EXPECT_EQ(solved[1].state, FrameState::missing);
  EXPECT_EQ(solved[1].used, 0);
  EXPECT_EQ(solved[2].state, FrameState::missing);
  EXPECT_EQ(solved[2].used, 2);
  EXPECT_TRUE(std::isnan(solved[2].residual_m));
  EXPECT_TRUE(has_pose(solved[3].state));
}

TEST(ArmFrames, DirectionsWithinFiveDegreesGiveNoFrame) {
  const auto tilted = [](double degrees) {
    const double angle = degrees * 3.14159265358979323846 / 180.0;
    return attitude_from_axes(Vec3(2, 0, 0), 0, 3.0 * Vec3(std::cos(angle), std::sin(angle), 0), 1);
  };
  EXPECT_FALSE(tilted(0.0));
  EXPECT_FALSE(tilted(4.999));
  EXPECT_FALSE(tilted(175.001));
  ASSERT_TRUE(tilted(5.001));
  EXPECT_WITHIN(angle_between(*tilted(5.001), Quat::Identity()), 0.0, 1e-14);
  EXPECT_FALSE(attitude_from_axes(Vec3::Zero(), 0, Vec3(0, 1, 0), 1));
}

TEST(ArmFrames, AxesAreRightHandedForEveryPairOfThem) {
  const Vec3 u(0.3, -0.4, 1.2);
  const Vec3 v(1.0, 0.2, 0.1);
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      if (a == b) continue;
      const Mat3 R = attitude_from_axes(u, a, v, b)->toRotationMatrix();
      EXPECT_WITHIN(R.determinant(), 1.0, 1e-14);
      EXPECT_WITHIN((R.col(a) - u.normalized()).norm(), 0.0, 1e-14);
      EXPECT_GT(R.col(b).dot(v), 0.0) << a << b;
      EXPECT_WITHIN(R.col(3 - a - b).dot(v), 0.0, 1e-14);
    }
}

/// Poses of the links of a rig in one row.
std::vector<Pose> links_of(const Rig& rig, const MarkerRows& rows, std::size_t row) {
  const auto solved = solve(rig, rows, row);
  std::vector<Pose> links;
  for (const RigLink& link : rig.links) {
    if (link.parent == kWorld) continue;
    links.push_back(
        compose(inverse(solved[*rig.frame(link.parent)].X_W), solved[*rig.frame(link.child)].X_W));
  }
  return links;
}

TEST(ArmFrames, MovingTheWholeArmLeavesItsLinksUnchanged) {
  const Rig rig = golden_rig("kurillo15.toml");
  const MarkerRows rows = golden_markers("session_a_markers.csv");
  const auto links = links_of(rig, rows, 0);
  constexpr double kRounding = 1e-12;  // of metres over centimetres
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    const Pose X_W = random_pose(random);
    MarkerRows moved = rows;
    for (Vec3& p : moved.p_W[0]) p = X_W.p + X_W.q * p;
    const auto others = links_of(rig, moved, 0);
    for (std::size_t l = 0; l < links.size(); ++l) {
      EXPECT_WITHIN((links[l].p - others[l].p).norm(), 0.0, kRounding);
      EXPECT_WITHIN(angle_between(links[l].q, others[l].q), 0.0, kRounding);
    }
  }
}

TEST(ArmFrames, TheOrderOfColumnsDoesNotCount) {
  const Rig rig = golden_rig("kurillo15.toml");
  const MarkerRows rows = golden_markers("session_a_markers.csv");
  MarkerRows other = rows;
  std::reverse(other.markers.begin(), other.markers.end());
  for (auto& row : other.p_W) std::reverse(row.begin(), row.end());
  const auto solved = solve(rig, rows, 10);
  const auto again = solve(rig, other, 10);
  for (std::size_t f = 0; f < solved.size(); ++f) {
    EXPECT_EQ(solved[f].X_W.p, again[f].X_W.p);
    EXPECT_EQ(solved[f].X_W.q.coeffs(), again[f].X_W.q.coeffs());
  }
}

TEST(ArmFrames, ALeftArmIsTheMirrorImageOfARightOne) {
  const Rig rig = golden_rig("kurillo15.toml");
  const MarkerRows rows = golden_markers("session_a_markers.csv");
  // What cameras would see of a left arm that does the same: rig and markers reflected.
  const Rig left = mirrored(rig);
  MarkerRows image = rows;
  for (auto& row : image.p_W)
    for (Vec3& p : row) p = mirrored(p);
  const auto right_poses = must(poses_of(rig, rows, Hand::right));
  const auto left_poses = must(poses_of(left, image, Hand::left));
  for (std::size_t f = 0; f < right_poses.size(); ++f)
    for (std::size_t r = 0; r < rows.t_s.size(); r += 50) {
      if (is_missing(right_poses[f][r])) continue;
      EXPECT_EQ(right_poses[f][r].p, left_poses[f][r].p);
      EXPECT_EQ(right_poses[f][r].q.coeffs(), left_poses[f][r].q.coeffs());
    }
}

TEST(ArmFrames, WhateverIsSeenAPoseIsWholeOrMissing) {
  const Rig rig = golden_rig("kurillo15.toml");
  const MarkerRows rows = golden_markers("session_a_markers.csv");
  auto frames = must(ArmFrames::compile(rig, rows.markers));
  std::vector<FramePose> solved(frames.frames());
  Random random(7);
  int with_pose = 0;
  const auto before = allocations();
  std::vector<Vec3> seen = rows.p_W[0];
  const auto own = allocations() - before;
  for (int i = 0; i < 100'000; ++i) {
    const double lost = random.uniform();
    for (std::size_t k = 0; k < seen.size(); ++k)
      seen[k] = random.uniform() < lost ? kLost : rows.p_W[static_cast<std::size_t>(i) % 400][k];
    frames.solve(seen, solved);
    for (const FramePose& pose : solved) {
      const bool whole = pose.X_W.p.allFinite() && pose.X_W.q.coeffs().allFinite();
      ASSERT_EQ(whole, has_pose(pose.state));
      ASSERT_TRUE(whole || is_missing(pose.X_W));
      if (whole) {
        ASSERT_LT(std::abs(pose.X_W.q.norm() - 1.0), 1e-12);
      }
      with_pose += whole ? 1 : 0;
    }
  }
  EXPECT_EQ(allocations() - before, own) << "a row allocates";
  EXPECT_GT(with_pose, 10'000);
}

TEST(ArmFrames, MarkersThatARecordingDoesNotHaveAreNeverSeen) {
  const Rig rig = golden_rig("kurillo15.toml");
  MarkerRows rows = golden_markers("session_a_markers.csv");
  rows.markers.back() = "X9";  // was O6
  const auto frames = must(ArmFrames::compile(rig, rows.markers));
  EXPECT_EQ(frames.absent(), std::vector<std::string>{"O6"});
  EXPECT_EQ(solve(rig, rows, 0).back().used, 4) << "one of six is hidden in this row";
  for (std::string& marker : rows.markers) marker += "_other";
  EXPECT_FALSE(ArmFrames::compile(rig, rows.markers));
}

}  // namespace
}  // namespace isograsp::arm_frames_test
