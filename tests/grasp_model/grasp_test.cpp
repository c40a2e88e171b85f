// SPDX-License-Identifier: GPL-3.0-or-later
// Grasp map, criteria, opposition, grasp rule: golden tables and laws.
#include "grasp_model/grasp.hpp"

#include <cmath>
#include <map>

#include "tests/grasp_model/grasps.hpp"
#include "tests/grasp_model/support.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::grasp_test {
namespace {

using test::golden_grasps;
using test::kAllRows;
using test::kModels;
using test::kPlanarRows;

TEST(GraspMap, MatchesTheGoldenWrenchesAndSingularValues) {
  constexpr double kWrench = 2e-15;    // of the sum of the magnitudes that are added up
  constexpr double kSingular = 1e-15;  // of the largest; true zeros come out at most this large
  const auto cases = golden_grasps();
  std::map<std::string, int> compared;
  for (const auto& row : test::every(test::golden("grasp_results.csv"))) {
    const std::string name = row.text("case") + " " + row.text("type");
    const auto& contacts = cases.at(name).contacts;
    const auto& coordinates = cases.at(name).force_coordinates;
    ++compared[row.text("type")];
    const GraspMatrix G = grasp_map(contacts);
    ASSERT_EQ(G.cols(), static_cast<Eigen::Index>(row["cols"]));
    EXPECT_EQ(grasp_map_columns(contacts).size(), static_cast<std::size_t>(G.cols()));
    const Eigen::VectorXd f = Eigen::Map<const Eigen::VectorXd>(coordinates.data(), G.cols());
    const Vec6 F = G * f;
    const Vec6 magnitudes = G.cwiseAbs() * f.cwiseAbs();
    Vec6 reference;
    reference << row.vec3("Fx_N", "Fy_N", "Fz_N"), row.vec3("Tx_Nm", "Ty_Nm", "Tz_Nm");
    const double force = magnitudes.head<3>().maxCoeff();
    const double torque = magnitudes.tail<3>().maxCoeff();
    EXPECT_LE((F - reference).head<3>().cwiseAbs().maxCoeff(), kWrench * force) << name;
    EXPECT_LE((F - reference).tail<3>().cwiseAbs().maxCoeff(), kWrench * torque) << name;

    const auto rows = row.text("free_dofs") == "all" ? kAllRows : kPlanarRows;
    const Criteria c = criteria(contacts, rows, {row["L_m"], row["ell_m"]});
    ASSERT_EQ(c.singular_values.size(), rows.size());
    const double s1 = row["s1"];
    for (std::size_t i = 0; i < rows.size(); ++i)
      EXPECT_WITHIN(c.singular_values[i], row["s" + std::to_string(i + 1)], kSingular * s1) << name;
    const auto n = static_cast<double>(rows.size());
    EXPECT_WITHIN(c.G_det, row["Gdet"], n * kSingular * std::pow(s1, n)) << name;
    EXPECT_WITHIN(c.G_rat, row["Grat"], 2.0 * kSingular) << name;
    EXPECT_EQ(c.G_min, c.singular_values.back());
  }
  for (const auto& [type, model] : kModels) EXPECT_GE(compared[type], 10) << type;
}

TEST(GraspMap, IsDualToTheContactVelocities) {
  // Power: contact forces times contact velocities = wrench times body twist, v = G^T twist.
  const Scene scene =
      test::scene_file(std::string(ISOGRASP_SOURCE_DIR) + "/library/scenes/free_block.toml");
  const GraspMatrix G = grasp_map(scene.contacts);
  Vec6 twist;
  twist << 0.1, -0.2, 0.3, 1.0, 2.0, -3.0;
  Eigen::VectorXd f(G.cols());
  for (Eigen::Index i = 0; i < f.size(); ++i) f[i] = std::sin(1.0 + static_cast<double>(i));
  double contact_power = 0.0;
  Eigen::Index column = 0;
  for (const auto& contact : scene.contacts) {
    const Vec3 v_C =
        contact.R_OC.transpose() * (twist.head<3>() + Vec3(twist.tail<3>()).cross(contact.p_OC));
    const Vec3 w_C = contact.R_OC.transpose() * twist.tail<3>();
    contact_power += f.segment<3>(column).dot(v_C) + f[column + 3] * w_C.z();
    column += 4;
  }
  EXPECT_WITHIN(contact_power, (G * f).dot(twist), 1e-14);
}

TEST(GraspMap, TurningTheDeviceTurnsTheWrenchAndKeepsTheCriteria) {
  const auto plain =
      test::scene_of(test::block("free = []\nstiffness = [0,0,0,0,0,0]\ndamping = [0,0,0,0,0,0]"))
          .contacts;
  const Mat3 R = Eigen::AngleAxisd(0.7, Vec3(1, 2, -2).normalized()).toRotationMatrix();
  auto turned = plain;
  for (auto& contact : turned) {
    contact.p_OC = R * contact.p_OC;
    contact.R_OC = R * contact.R_OC;
  }
  const GraspMatrix a = grasp_map(plain);
  const GraspMatrix b = grasp_map(turned);
  EXPECT_LE((R * a.topRows<3>() - b.topRows<3>()).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_LE((R * a.bottomRows<3>() - b.bottomRows<3>()).cwiseAbs().maxCoeff(), 1e-16);
  const auto before = criteria(plain, kAllRows, default_scales(plain));
  const auto after = criteria(turned, kAllRows, default_scales(turned));
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_WITHIN(before.singular_values[i], after.singular_values[i], 1e-14);
  EXPECT_EQ(force_closure(plain, kAllRows), force_closure(turned, kAllRows));
}

TEST(GraspMap, CriteriaDoNotDependOnTheUnitOfLength) {
  auto metres =
      test::scene_of(test::block("free = []\nstiffness = [0,0,0,0,0,0]\ndamping = [0,0,0,0,0,0]"))
          .contacts;
  auto millimetres = metres;
  for (auto& contact : millimetres) contact.p_OC *= 1000.0;
  const auto a = criteria(metres, kAllRows, default_scales(metres));
  const auto b = criteria(millimetres, kAllRows, default_scales(millimetres));
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_WITHIN(a.singular_values[i], b.singular_values[i], 1e-14);
}

TEST(Opposition, NeedsMoreThan120Degrees) {
  Contact a;
  Contact b;
  for (const double degrees : {0.0, 90.0, 119.9, 120.1, 180.0}) {
    b.R_OC = Eigen::AngleAxisd(degrees * 3.14159265358979323846 / 180.0, Vec3::UnitX())
                 .toRotationMatrix();
    EXPECT_EQ(opposition({a, b}), degrees > 120.0);
  }
  EXPECT_FALSE(opposition({a}));
}

TEST(GraspRule, TruthTableOfTheDeviceForAllFingerSets) {
  // bit 0 thumb, 1 index, 2 middle: every set with the thumb and a finger opposes and closes.
  const std::array<bool, 8> with_thumb{false, false, false, true, false, true, false, true};
  for (const std::string rule : {"any", "opposition", "closure"}) {
    const Scene scene = test::scene_of(test::block(
        "free = [\"x\", \"y\", \"rz\"]\nstiffness = [0,0,0,0,0,0]\ndamping = [1,1,1,1,1,1]\n"
        "grasp_rule = \"" +
        rule + "\""));
    for (unsigned mask = 0; mask < 8; ++mask)
      EXPECT_EQ(grasp_rule_holds(scene, mask), rule == "any" || with_thumb[mask]) << rule << mask;
  }
}

}  // namespace
}  // namespace isograsp::grasp_test
