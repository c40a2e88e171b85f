// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinematics/calibration.hpp"

#include <gtest/gtest.h>

#include "tests/kinematics/support.hpp"
#include "tests/support/within.hpp"

namespace isograsp::calibration_test {
namespace {

using namespace isograsp::test;

constexpr double kExact = 1e-12;

/// Two bodies of four markers; the second one turns against the first by the zero of their link.
constexpr const char* kRig = R"(format = "isograsp-rig-1"
[[frame]]
name = "arm"
method = "cluster"
markers = ["A1", "A2", "A3", "A4"]
template_m = [[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.1]]
calibration = { origin = "A1", primary = { axis = "x", from = "A1", to = "A2" }, secondary = { axis = "y", from = "A1", to = "A3" } }
[[frame]]
name = "probe"
method = "cluster"
markers = ["P1", "P2", "P3", "P4"]
template_m = [[0, 0, 0.1], [0.05, 0, 0.1], [0, 0.05, 0.1], [0, 0, 0.2]]
[[link]]
name = "between"
parent = "arm"
child = "probe"
zero_quaternion_wxyz = [1, 0, 0, 0]
)";
const std::vector<Vec3> kArm{{0, 0, 0}, {0.08, 0, 0}, {0.01, 0.07, 0}, {0.02, -0.01, 0.06}};
const std::vector<Vec3> kProbe{{0, 0, 0.1}, {0.05, 0, 0.1}, {0, 0.05, 0.1}, {0, 0, 0.2}};

MarkerRows record(const Pose& X_AP, bool hide_one = false) {
  MarkerRows rows;
  rows.markers = {"A1", "A2", "A3", "A4", "P1", "P2", "P3", "P4"};
  Random random(9);
  for (int r = 0; r < 20; ++r) {
    rows.t_s.push_back(r * 0.01);
    const Pose X_WA = random_pose(random);
    const Pose X_WP = compose(X_WA, X_AP);
    std::vector<Vec3> p_W;
    for (const Vec3& p : kArm) p_W.push_back(X_WA.p + X_WA.q * p);
    for (const Vec3& p : kProbe) p_W.push_back(X_WP.p + X_WP.q * p);
    if (hide_one && r % 2 == 0) p_W[3] = Vec3::Constant(kMissing);
    rows.p_W.push_back(std::move(p_W));
  }
  return rows;
}

TEST(Calibration, TemplatesAndZerosAreThoseOfTheArmHeldStill) {
  const Rig rig = must(parse_rig(kRig, "rig.toml"));
  const Pose X_AP{Vec3(0.1, 0.2, 0.3), Quat(0.8, 0.6, 0, 0)};
  for (const bool hide_one : {false, true}) {
    const Rig measured = must(calibrated(rig, record(X_AP, hide_one), Hand::right));
    const auto& points = std::get<ClusterFrame>(measured.frames[0].method).template_m;
    for (std::size_t k = 0; k < kArm.size(); ++k)
      EXPECT_WITHIN((points[k] - kArm[k]).norm(), 0.0, kExact);
    EXPECT_WITHIN(angle_between(*measured.links[0].zero, X_AP.q), 0.0, kExact);
  }
}

TEST(Calibration, OfALeftArmKeepsWhatCamerasSeeInTemplatesAndReflectsZeros) {
  const Rig rig = must(parse_rig(kRig, "rig.toml"));
  const Pose X_AP{Vec3(0.1, 0.2, 0.3), Quat(0.8, 0, 0.6, 0)};
  const Rig left = must(calibrated(rig, record(X_AP), Hand::left));
  const auto& points = std::get<ClusterFrame>(left.frames[0].method).template_m;
  for (std::size_t k = 0; k < kArm.size(); ++k)
    EXPECT_WITHIN((points[k] - kArm[k]).norm(), 0.0, kExact);
  EXPECT_WITHIN(angle_between(*left.links[0].zero, mirrored(X_AP).q), 0.0, kExact);
}

TEST(Calibration, ALandmarkIsTheMeanOfThePointersTip) {
  Rig rig = must(calibrated(must(parse_rig(kRig, "rig.toml")), record(Pose()), Hand::right));
  const Pose X_AP{Vec3(0.01, -0.02, 0.3), Quat(0.8, 0.6, 0, 0)};
  const auto landmark = must(measure_landmark(rig, record(X_AP), "probe", "arm"));
  EXPECT_EQ(landmark.rows, 20U);
  EXPECT_WITHIN((landmark.position_m - X_AP.p).norm(), 0.0, kExact);
  EXPECT_WITHIN(landmark.sd_m.norm(), 0.0, kExact);
  const auto unknown = measure_landmark(rig, record(X_AP), "stick", "arm");
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().message().find("--probe"), std::string::npos);
}

TEST(Calibration, ARecordingThatNeverShowsAFrameIsRefused) {
  const Rig rig = must(parse_rig(kRig, "rig.toml"));
  MarkerRows rows = record(Pose());
  for (auto& row : rows.p_W) row[1] = Vec3::Constant(kMissing);
  const auto measured = calibrated(rig, rows, Hand::right);
  ASSERT_FALSE(measured);
  EXPECT_NE(measured.error().message().find("'arm'"), std::string::npos);
}

}  // namespace
}  // namespace isograsp::calibration_test
