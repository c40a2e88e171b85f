// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "kinematics/pose_series.hpp"
#include "kinematics/tables/pose_csv.hpp"
#include "tests/kinematics/support.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::links_test {
namespace {

using namespace isograsp::test;

TEST(Links, AgreeWithIndependentReferencesAlsoAtBothLocks) {
  const Rig rig = golden_rig("links_rig.toml");
  const PoseSeries series = must(read_poses(golden("links_poses.csv")));
  const auto expected = golden_table(golden("links_expected.csv"));
  ASSERT_EQ(expected.size(), series.t_s.size());
  for (const RigLink& link : test::every(rig.links)) {
    const auto poses = must(link_poses(series, link.parent, link.child));
    for (std::size_t r = 0; r < expected.size(); ++r) {
      const std::string where = link.name + " row " + std::to_string(r);
      const Pose X_L = pose_in(expected[r], link.name);
      ASSERT_EQ(is_missing(poses[r]), is_missing(X_L)) << where;
      if (is_missing(X_L)) continue;
      EXPECT_WITHIN((poses[r].p - X_L.p).norm(), 0.0, kGoldenPosition_m) << where;
      EXPECT_WITHIN(angle_between(poses[r].q, X_L.q), 0.0, kGoldenAngle_rad) << where;
      const Vec3 angles = link_angles(poses[r].q, link);
      const double cosine = std::abs(std::cos(number_in(expected[r], link.name + "_a2_rad")));
      constexpr double kLeastCosine = 1e-3;  // nearer to the lock the outer angles lose digits
      if (cosine < kLeastCosine) continue;
      for (int a = 0; a < 3; ++a) {
        const double reference =
            number_in(expected[r], link.name + "_a" + std::to_string(a + 1) + "_rad");
        EXPECT_WITHIN(std::remainder(angles[a] - reference, 2.0 * M_PI), 0.0,
                      kGoldenAngle_rad / cosine)
            << where;
      }
    }
  }
}

TEST(Links, AFrameThatIsNotThereIsNamed) {
  const PoseSeries series = must(read_poses(golden("links_poses.csv")));
  const auto poses = link_poses(series, "elbow", "foot");
  ASSERT_FALSE(poses);
  EXPECT_NE(poses.error().message().find("'foot'"), std::string::npos);
}

}  // namespace
}  // namespace isograsp::links_test
