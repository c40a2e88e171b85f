// SPDX-License-Identifier: GPL-3.0-or-later
// Coupling of links, least pinch force, scored placements.
#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/support/every.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/within.hpp"
#include "tests/virtual_hand/support.hpp"
#include "virtual_hand/pinch.hpp"
#include "virtual_hand/placement.hpp"
#include "virtual_hand/tracked_link.hpp"

namespace isograsp::forces_test {
namespace {

using namespace isograsp::test;
using namespace isograsp::virtual_hand;

LinkMotion motion_in(const Fields& row, const std::string& of) {
  return {{three_in(row, "x" + of + "_"), quaternion_in(row, "q" + of + "_")},
          three_in(row, "v" + of + "_"),
          three_in(row, "w" + of + "_")};
}

TEST(Coupling, WrenchesAreThoseOfTheOracle) {
  constexpr double kTable = 1e-12;
  for (const Fields& row : every(golden_table(hand_data("coupling.csv")))) {
    const LinkCoupling coupling{number_in(row, "K_N_m"),    number_in(row, "D_N_s_m"),
                                number_in(row, "F_max_N"),  number_in(row, "Kr_N_m_rad"),
                                number_in(row, "Dr_N_m_s"), number_in(row, "T_max_N_m")};
    const Wrench wrench = coupling_wrench(coupling, motion_in(row, ""), motion_in(row, "t"));
    EXPECT_WITHIN((wrench.force - three_in(row, "F", "_N")).norm(), 0.0, kTable);
    EXPECT_WITHIN((wrench.torque - three_in(row, "T", "_N_m")).norm(), 0.0, kTable);
  }
}

TEST(Coupling, NeverExceedsItsLimitsHoweverFarTheTrackedHandIs) {
  constexpr double kRounding = 1.0 + 1e-12;
  Random random(60);
  const LinkCoupling coupling;
  for (int k = 0; k < 10000; ++k) {
    const LinkMotion is{random_pose(random), random_vector(random, 10.0),
                        random_vector(random, 50.0)};
    LinkMotion tracked{random_pose(random), random_vector(random, 10.0),
                       random_vector(random, 50.0)};
    tracked.X_W.p *= 1000.0 * random.uniform();
    const Wrench wrench = coupling_wrench(coupling, is, tracked);
    ASSERT_LE(wrench.force.norm(), coupling.most_N * kRounding);
    ASSERT_LE(wrench.torque.norm(), coupling.most_N_m * kRounding);
  }
}

TEST(PinchForce, TheLeastIsThatOfTheOracleForTheExactDiskAndTheEllipsoid) {
  constexpr double kExact = 1e-9;  // the table
  for (const Fields& row : every(golden_table(hand_data("pinch_threshold.csv")))) {
    const LeastPinchForce least = least_pinch_force(
        {number_in(row, "mass_kg"), number_in(row, "gravity_m_s2"), number_in(row, "friction"),
         number_in(row, "patch_radius_m"), number_in(row, "offset_m")});
    const double exact_N = number_in(row, "least_normal_force_exact_N");
    const double ellipsoid_N = number_in(row, "least_normal_force_ellipsoid_N");
    EXPECT_WITHIN(least.exact_N, exact_N, kExact * exact_N);
    EXPECT_WITHIN(least.ellipsoid_N, ellipsoid_N, kExact * ellipsoid_N);
    EXPECT_GE(least.exact_N, least.ellipsoid_N * (1.0 - kExact)) << "the exact surface lies inside";
  }
}

std::map<std::string, std::vector<PlacementRow>> golden_placements() {
  std::map<std::string, std::vector<PlacementRow>> placements;
  for (const Fields& row : golden_table(hand_data("place_slips.csv")))
    placements[row.at("placement")].push_back(
        {number_in(row, "t_s"),
         row.at("held") == "1",
         row.at("supported") == "1",
         {three_in(row, "", "_m"), quaternion_in(row, "q")},
         {three_in(row, "target_", "_m"), quaternion_in(row, "target_q")}});
  return placements;
}

TEST(Placement, ScoresAreThoseOfTheOracle) {
  constexpr double kTable = 1e-12;
  const auto placements = golden_placements();
  for (const Fields& row : every(golden_table(hand_data("place_slips_measures.csv")))) {
    const PlacementScore score = score_placement(placements.at(row.at("placement")));
    EXPECT_EQ(score.completed, row.at("completed") == "1");
    EXPECT_EQ(score.fails, static_cast<int>(number_in(row, "fails")));
    if (!score.completed) continue;
    EXPECT_WITHIN(*score.manipulation_s, number_in(row, "manipulation_s"), kTable);
    EXPECT_WITHIN(*score.done_s, number_in(row, "done_s"), kTable);
    EXPECT_WITHIN(*score.hold_distance_m, number_in(row, "hold_distance_m"), kTable);
    EXPECT_WITHIN(*score.hold_axis_angle_rad, number_in(row, "hold_axis_angle_rad"), kTable);
    EXPECT_WITHIN(*score.hold_geodesic_rad, number_in(row, "hold_geodesic_rad"), kTable);
  }
}

/// Of times and angles of a few units.
constexpr double kRounding = 1e-12;

/// Held at the target from the first row on, 100 Hz.
std::vector<PlacementRow> held_at_target(int rows) {
  std::vector<PlacementRow> all;
  for (int k = 0; k < rows; ++k) all.push_back({0.01 * k, true, false, {}, {}});
  return all;
}

TEST(Placement, SettingItDownIsNoDropAndLettingItFallIsOne) {
  auto set_down = held_at_target(50);
  for (int k = 0; k < 100; ++k) set_down.push_back({0.5 + 0.01 * k, false, true, {}, {}});
  EXPECT_EQ(score_placement(set_down).fails, 0);

  const auto let_go = [](int unheld_rows, bool lands) {
    auto rows = held_at_target(50);
    for (int k = 0; k < unheld_rows; ++k) rows.push_back({0.5 + 0.01 * k, false, false, {}, {}});
    const double t_s = rows.back().t_s;
    rows.push_back({t_s + 0.01, !lands, lands, {}, {}});
    return score_placement(rows).fails;
  };
  EXPECT_EQ(let_go(10, false), 0) << "caught again within a quarter of a second";
  EXPECT_EQ(let_go(10, true), 1) << "fell on the table before";
  EXPECT_EQ(let_go(40, false), 1) << "was in the air for longer";
}

TEST(Placement, AHoldThatIsLeftBeginsAnew) {
  auto rows = held_at_target(300);
  EXPECT_EQ(*score_placement(rows).done_s, 1.0);
  rows[60].X_WO.p.x() = 0.016;  // beyond one and a half times 10 mm
  const PlacementScore again = score_placement(rows);
  EXPECT_WITHIN(*again.manipulation_s, 0.61, kRounding);
  rows[60].X_WO.p.x() = 0.014;
  EXPECT_EQ(*score_placement(rows).done_s, 1.0) << "a little farther is still there";
}

TEST(Placement, AnAxisHasNoDirection) {
  const Quat over(Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitX()));
  EXPECT_WITHIN(main_axis_angle(Quat::Identity(), over), 0.0, kRounding);
  const Quat turned(Eigen::AngleAxisd(0.3, Vec3::UnitY()));
  EXPECT_WITHIN(main_axis_angle(over, turned), 0.3, kRounding);
}

TEST(LostShare, APlacementWithMoreThanATenthLostIsNotScored) {
  LostShare share;
  EXPECT_FALSE(share.can_be_scored()) << "nothing was seen of it";
  for (int k = 0; k < 90; ++k) share.add(false);
  for (int k = 0; k < 10; ++k) share.add(true);
  EXPECT_TRUE(share.can_be_scored());
  share.add(true);
  EXPECT_FALSE(share.can_be_scored());
  share.begin();
  share.add(false);
  EXPECT_EQ(share.share(), 0.0);
}

}  // namespace
}  // namespace isograsp::forces_test
