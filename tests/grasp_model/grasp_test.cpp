// SPDX-License-Identifier: GPL-3.0-or-later
// Grasp map, criteria, force closure, opposition: golden tables and laws.
#include "grasp_model/grasp.hpp"

#include <cmath>
#include <map>

#include "tests/grasp_model/support.hpp"

namespace isograsp {
namespace {

using test::kEpsilon;

const std::map<std::string, ContactModel> kModels{
    {"FL", ContactModel::frictionless}, {"PCWF", ContactModel::point}, {"SF", ContactModel::soft}};
const std::vector<Eigen::Index> kAllRows{0, 1, 2, 3, 4, 5};
const std::vector<Eigen::Index> kPlanarRows{0, 1, 5};

struct Case {
  std::vector<Contact> contacts;
  std::vector<double> force_coordinates;
};

/// By "case type".
std::map<std::string, Case> golden_grasps() {
  std::map<std::string, Case> cases;
  for (const auto& row : test::golden("grasp_contacts.csv")) {
    const auto model = kModels.find(row.text("type"));
    if (model == kModels.end()) continue;  // bonded contacts are not part of the scenes
    Contact contact;
    contact.finger = kFingers[static_cast<std::size_t>(row["i"])];
    contact.p_OC = row.vec3("px_m", "py_m", "pz_m");
    contact.R_OC = Quat(row["qw"], row["qx"], row["qy"], row["qz"]).normalized().toRotationMatrix();
    contact.model = model->second;
    auto& one = cases[row.text("case") + " " + row.text("type")];
    one.contacts.push_back(contact);
    const int coordinates = contact.model == ContactModel::frictionless ? 1
                            : contact.model == ContactModel::point      ? 3
                                                                        : 4;
    for (int i = 0; i < coordinates; ++i)
      one.force_coordinates.push_back(row["f" + std::to_string(i)]);
  }
  return cases;
}

TEST(GraspMap, MatchesTheGoldenWrenchesAndSingularValues) {
  const auto cases = golden_grasps();
  int compared = 0;
  for (const auto& row : test::golden("grasp_results.csv")) {
    const auto found = cases.find(row.text("case") + " " + row.text("type"));
    if (found == cases.end()) continue;
    ++compared;
    const auto& contacts = found->second.contacts;
    const auto& f = found->second.force_coordinates;
    const GraspMatrix G = grasp_map(contacts);
    ASSERT_EQ(G.cols(), static_cast<Eigen::Index>(row["cols"]));
    const Vec6 F = G * Eigen::Map<const Eigen::VectorXd>(f.data(), G.cols());
    Vec6 reference;
    reference << row.vec3("Fx_N", "Fy_N", "Fz_N"), row.vec3("Tx_Nm", "Ty_Nm", "Tz_Nm");
    // 2e-15 of the sum of what is added up.
    const Vec6 sum =
        G.cwiseAbs() * Eigen::Map<const Eigen::VectorXd>(f.data(), G.cols()).cwiseAbs();
    for (Eigen::Index i = 0; i < 6; ++i)
      EXPECT_LE(std::abs(F[i] - reference[i]), 2e-15 * (sum[i] + sum.maxCoeff() * 1e-1))
          << found->first << i;

    const auto rows = row.text("free_dofs") == "all" ? kAllRows : kPlanarRows;
    const Criteria c = criteria(contacts, rows, {row["L_m"], row["ell_m"]});
    const double s1 = row["s1"];
    for (std::size_t i = 0; i < 6; ++i) {
      const double value = i < c.singular_values.size() ? c.singular_values[i] : 0.0;
      // 1e-15 for the values; what is below the zero test is shown as 0.
      EXPECT_NEAR(value, row["s" + std::to_string(i + 1)], 2e-15 * s1) << found->first;
    }
    EXPECT_NEAR(c.G_det, row["Gdet"], 1e-13 * std::pow(s1, static_cast<double>(rows.size())));
    EXPECT_NEAR(c.G_rat, row["Grat"], 1e-14);
  }
  EXPECT_GT(compared, 30);
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
  EXPECT_NEAR(contact_power, (G * f).dot(twist), 1e-14);
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
    EXPECT_NEAR(before.singular_values[i], after.singular_values[i], 1e-14);
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
    EXPECT_NEAR(a.singular_values[i], b.singular_values[i], 1e-14);
}

TEST(ForceClosure, AgreesWithTheGoldenCases) {
  const auto cases = golden_grasps();
  const auto rows = test::golden("force_closure.csv");
  ASSERT_GT(rows.size(), 60u);
  int closed = 0;
  for (const auto& row : rows) {
    auto contacts = cases.at(row.text("case") + " " + row.text("type")).contacts;
    for (auto& contact : contacts) {
      contact.friction = row["mu"];
      contact.torsion_m = row["gamma_m"];
    }
    const bool expected = row["force_closure"] == 1.0;
    closed += expected ? 1 : 0;
    EXPECT_EQ(force_closure(contacts, kAllRows), expected)
        << row.text("case") << ' ' << row.text("type") << " mu " << row["mu"] << " margin "
        << row["margin_lp"];
  }
  EXPECT_GT(closed, 10);
}

TEST(ForceClosure, ThumbAgainstIndexNeedsFrictionAboveTheSlopeOfTheirLine) {
  // 12.5 mm aside on 65 mm across: mu > 0.1923; in the plane two point contacts suffice.
  auto contacts =
      test::scene_of(test::block("free = []\nstiffness = [0,0,0,0,0,0]\ndamping = [0,0,0,0,0,0]"))
          .contacts;
  contacts.pop_back();
  for (const double side : {-1e-6, 1e-6}) {
    for (auto& contact : contacts) contact.friction = 12.5 / 65.0 + side;
    EXPECT_EQ(force_closure(contacts, kPlanarRows), side > 0.0);
    EXPECT_FALSE(force_closure(contacts, kAllRows));  // they cannot resist a turn about their line
  }
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
}  // namespace isograsp
