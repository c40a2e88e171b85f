// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinematics/rigid_body.hpp"

#include <array>
#include <utility>

#include <gtest/gtest.h>

#include "kinematics/arm_frames.hpp"
#include "tests/kinematics/support.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"

namespace isograsp::rigid_body_test {
namespace {

using namespace isograsp::test;

constexpr double kLimit_m = 0.002;
const std::vector<Vec3> kPrism{{0.03, 0.02, 0.04},   {-0.03, 0.02, 0.04},  {0.03, -0.02, 0.04},
                               {-0.03, 0.02, -0.04}, {0.03, -0.02, -0.04}, {-0.03, -0.02, -0.035}};
/// Exact positions: rounding of metres, over the size of the body for angles.
constexpr double kExact_m = 1e-14;
constexpr double kExact_rad = 1e-12;

std::vector<Vec3> seen_from(const std::vector<Vec3>& body, const Pose& X_WB) {
  std::vector<Vec3> p_W;
  for (const Vec3& p : body) p_W.push_back(X_WB.p + X_WB.q * p);
  return p_W;
}
const Vec3 kLost = Vec3::Constant(kMissing);

TEST(RigidBody, AgreesWithIndependentReferencesOfFortyDigits) {
  for (const std::string body : {"triad", "planar", "prism", "needle"}) {
    const Rig rig = golden_rig("kabsch_" + body + "_rig.toml");
    const MarkerRows rows = golden_markers("kabsch_" + body + ".csv");
    auto frames = must(ArmFrames::compile(rig, rows.markers));
    const auto expected = golden_table(golden("kabsch_" + body + "_expected.csv"));
    ASSERT_EQ(expected.size(), rows.p_W.size());
    std::array<FramePose, 1> solved;
    for (std::size_t r = 0; r < expected.size(); ++r) {
      frames.solve(rows.p_W[r], solved);
      const std::string where = body + " row " + std::to_string(r);
      EXPECT_EQ(name_of(solved[0], rig.frames[0]), expected[r].at("body_state")) << where;
      EXPECT_EQ(solved[0].used, number_in(expected[r], "body_used")) << where;
      const double residual_m = number_in(expected[r], "body_residual_m");
      ASSERT_EQ(std::isnan(solved[0].residual_m), std::isnan(residual_m)) << where;
      if (!std::isnan(residual_m)) {
        EXPECT_WITHIN(solved[0].residual_m, residual_m, kGoldenPosition_m) << where;
      }
      const Pose X_WB = pose_in(expected[r], "body");
      ASSERT_EQ(is_missing(solved[0].X_W), is_missing(X_WB)) << where;
      if (is_missing(X_WB)) continue;
      EXPECT_WITHIN((solved[0].X_W.p - X_WB.p).norm(), 0.0,
                    kGoldenPosition_m * std::max(1.0, X_WB.p.norm()))
          << where;
      EXPECT_WITHIN(angle_between(solved[0].X_W.q, X_WB.q), 0.0, kGoldenAngle_rad) << where;
    }
  }
}

TEST(RigidBody, ExactMarkersGiveTheirPoseWhateverItIs) {
  const RigidBody body(kPrism, kLimit_m);
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Pose X_WB = random_pose(random);
    const BodyFit fit = body.fit(seen_from(kPrism, X_WB));
    ASSERT_EQ(fit.state, FrameState::ok);
    EXPECT_WITHIN((fit.X_WB.p - X_WB.p).norm(), 0.0, kExact_m);
    EXPECT_WITHIN(angle_between(fit.X_WB.q, X_WB.q), 0.0, kExact_rad);
  }
}

TEST(RigidBody, TurnsThroughHalfATurnWithoutAJump) {
  const RigidBody body(kPrism, kLimit_m);
  constexpr double kPi = 3.14159265358979323846;
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0.6, 0, 0.8)})
    for (const double angle : {kPi - 1e-9, kPi, kPi + 1e-9, kPi / 2.0, 1e-9}) {
      const Quat q(Eigen::AngleAxisd(angle, axis));
      const BodyFit fit = body.fit(seen_from(kPrism, {Vec3(1, 2, 3), q}));
      EXPECT_WITHIN(angle_between(fit.X_WB.q, q), 0.0, kExact_rad);
    }
}

TEST(RigidBody, TwoMarkersAreFewAndALineHasNoAttitude) {
  const RigidBody body(kPrism, kLimit_m);
  auto p_W = seen_from(kPrism, Pose());
  for (std::size_t k = 2; k < p_W.size(); ++k) p_W[k] = kLost;
  const BodyFit two = body.fit(p_W);
  EXPECT_EQ(two.state, FrameState::few);
  EXPECT_EQ(two.used, 2);
  EXPECT_TRUE(std::isnan(two.residual_m));
  const std::vector<Vec3> line{{0, 0, 0}, {0.05, 0.0005, 0}, {0.1, 0, 0.0005}};
  const BodyFit needle = RigidBody(line, kLimit_m).fit(line);
  EXPECT_EQ(needle.state, FrameState::collinear);
  EXPECT_TRUE(is_missing(needle.X_WB));
  const std::vector<Vec3> heap(4, Vec3(1, 1, 1));
  EXPECT_EQ(RigidBody(heap, kLimit_m).fit(heap).state, FrameState::collinear);
}

TEST(RigidBody, AMarkerAstrayIsLeftOutAndNamedFromFiveMarkersOn) {
  const RigidBody body(kPrism, kLimit_m);
  for (std::size_t astray = 0; astray < kPrism.size(); ++astray) {
    auto p_W = seen_from(kPrism, Pose());
    p_W[astray].x() += 0.05;
    const BodyFit fit = body.fit(p_W);
    ASSERT_EQ(fit.state, FrameState::rejected) << astray;
    EXPECT_EQ(fit.rejected, astray);
    EXPECT_EQ(fit.used, 5);
    EXPECT_WITHIN(fit.X_WB.p.norm(), 0.0, kExact_m);
  }
  auto four = seen_from(kPrism, Pose());
  four[0] = four[1] = kLost;
  four[2].x() += 0.05;
  EXPECT_EQ(body.fit(four).state, FrameState::residual);
}

TEST(RigidBody, SwappedLabelsGiveNoPose) {
  const RigidBody body(kPrism, kLimit_m);
  auto p_W = seen_from(kPrism, {Vec3(1, 0, 0), Quat::Identity()});
  std::swap(p_W[0], p_W[3]);
  const BodyFit fit = body.fit(p_W);
  EXPECT_EQ(fit.state, FrameState::residual);
  EXPECT_TRUE(is_missing(fit.X_WB));
}

TEST(RigidBody, AFrozenMarkerOfAMovingBodyIsLeftOut) {
  const RigidBody body(kPrism, kLimit_m);
  auto p_W = seen_from(kPrism, {Vec3(0.02, 0, 0), Quat::Identity()});
  p_W[4] = kPrism[4];
  const BodyFit fit = body.fit(p_W);
  EXPECT_EQ(fit.state, FrameState::rejected);
  EXPECT_EQ(fit.rejected, 4U);
}

TEST(RigidBody, AMirroredBodyIsNeverFittedUnlessItIsFlat) {
  auto mirrored_prism = kPrism;
  for (Vec3& p : mirrored_prism) p = mirrored(p);
  EXPECT_EQ(RigidBody(kPrism, kLimit_m).fit(mirrored_prism).state, FrameState::residual);
  // A flat one fits its mirror image exactly: half a turn about an axis in its plane.
  const std::vector<Vec3> flat{
      {0.03, 0.02, 0}, {-0.03, 0.021, 0}, {-0.031, -0.02, 0}, {0.025, -0.024, 0}};
  auto mirrored_flat = flat;
  for (Vec3& p : mirrored_flat) p = mirrored(p);
  const BodyFit fit = RigidBody(flat, kLimit_m).fit(mirrored_flat);
  EXPECT_EQ(fit.state, FrameState::ok);
  EXPECT_WITHIN(angle_between(fit.X_WB.q, Quat(0, 0, 1, 0)), 0.0, kExact_rad);
}

TEST(RigidBody, TheOrderOfItsMarkersDoesNotCount) {
  Random random(2);
  const Pose X_WB = random_pose(random);
  auto p_W = seen_from(kPrism, X_WB);
  for (Vec3& p : p_W) p += random_vector(random, 1e-4);
  const BodyFit fit = RigidBody(kPrism, kLimit_m).fit(p_W);
  const std::array<std::size_t, 6> order{3, 5, 0, 2, 4, 1};
  std::vector<Vec3> points, positions;
  for (const std::size_t k : order) {
    points.push_back(kPrism[k]);
    positions.push_back(p_W[k]);
  }
  const BodyFit other = RigidBody(points, kLimit_m).fit(positions);
  EXPECT_WITHIN((fit.X_WB.p - other.X_WB.p).norm(), 0.0, kExact_m);
  EXPECT_WITHIN(angle_between(fit.X_WB.q, other.X_WB.q), 0.0, kExact_rad);
  EXPECT_WITHIN(fit.residual_m, other.residual_m, kExact_m);
}

TEST(RigidBody, FitsWithoutAllocating) {
  const RigidBody body(kPrism, kLimit_m);
  auto p_W = seen_from(kPrism, Pose());
  p_W[1].y() += 0.04;  // rejection is the longest way
  const auto before = allocations();
  const BodyFit fit = body.fit(p_W);
  EXPECT_EQ(allocations(), before);
  EXPECT_EQ(fit.state, FrameState::rejected);
}

TEST(LargestEigenvector, SolvesItsEquationAlsoWhereTwoValuesAreEqual) {
  Random random(3);
  constexpr double kResidual = 1e-13;  // of matrices of size 1 to 4
  for (int i = 0; i < 2000; ++i) {
    Mat4 n;
    for (Eigen::Index r = 0; r < 4; ++r)
      for (Eigen::Index c = 0; c <= r; ++c) n(r, c) = n(c, r) = 2.0 * random.uniform() - 1.0;
    const Vec4 v = largest_eigenvector(n);
    const double value = v.dot(n * v);
    EXPECT_WITHIN((n * v - value * v).norm(), 0.0, kResidual);
    EXPECT_WITHIN(v.norm(), 1.0, kResidual);
    for (Eigen::Index k = 0; k < 4; ++k) EXPECT_LE(n(k, k), value + kResidual);
  }
  for (const Vec4& values :
       {Vec4(1, 1, 0, 0), Vec4(2, 2, 2, -1), Vec4(1, 1, 1, 1), Vec4(0, 0, 0, 0)}) {
    const Mat4 n = values.asDiagonal();
    const Vec4 v = largest_eigenvector(n);
    EXPECT_WITHIN((n * v - values.maxCoeff() * v).norm(), 0.0, kResidual);
    EXPECT_WITHIN(v.norm(), 1.0, kResidual);
  }
}

}  // namespace
}  // namespace isograsp::rigid_body_test
