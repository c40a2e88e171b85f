// SPDX-License-Identifier: GPL-3.0-or-later
// Grasp map, criteria, closure and epsilon against values that other people's programs gave: unit
// tests of two university courses, dex-net, SynGrasp. Skipped where the recordings are absent.
#include <fstream>
#include <map>

#include <Eigen/QR>
#include <nlohmann/json.hpp>

#include "grasp_model/contact.hpp"
#include "grasp_model/grasp.hpp"
#include "tests/grasp_model/grasps.hpp"
#include "tests/support/every.hpp"
#include "tests/support/recorded_data.hpp"
#include "tests/support/within.hpp"

namespace isograsp::grasp_oracles_test {
namespace {

using Json = nlohmann::json;
using test::kAllRows;
using test::kPlanarRows;

Json oracles(const std::string& name) {
  std::ifstream in(test::recorded_data() + "/grasp-oracles/" + name);
  return in ? Json::parse(in) : Json();
}

/// Of two or three components.
Vec3 vector_of(const Json& numbers) {
  Vec3 v = Vec3::Zero();
  for (std::size_t i = 0; i < numbers.size(); ++i)
    v[static_cast<Eigen::Index>(i)] = numbers[i].get<double>();
  return v;
}

Eigen::MatrixXd matrix_of(const Json& rows) {
  Eigen::MatrixXd m(static_cast<Eigen::Index>(rows.size()),
                    static_cast<Eigen::Index>(rows[0].size()));
  for (Eigen::Index r = 0; r < m.rows(); ++r)
    for (Eigen::Index c = 0; c < m.cols(); ++c)
      m(r, c) = rows[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)].get<double>();
  return m;
}

TEST(GraspOracles, ClosureAgreesWithTwoCourses) {
  const Json cases = oracles("closure_cases.json");
  if (cases.is_null()) GTEST_SKIP() << "no recorded oracles";
  std::map<std::string, int> compared;
  for (const auto& one : test::every(cases)) {
    const std::string kind = one["kind"];
    const auto& rows = one["dim"] == 2 ? kPlanarRows : kAllRows;
    std::vector<Contact> contacts;
    for (std::size_t i = 0; i < one["points"].size(); ++i)
      contacts.push_back(
          test::contact_at(vector_of(one["points"][i]), vector_of(one["normals"][i]),
                           kind == "form" ? ContactModel::frictionless : ContactModel::point,
                           kind == "form" ? 0.0 : one["mu"][i].get<double>()));
    ++compared[kind];
    if (kind == "form" || kind == "force") {
      EXPECT_EQ(force_closure(contacts, rows), one["expected"].get<bool>()) << one["id"];
      EXPECT_EQ(force_closure_by_cuts(contacts, rows), one["expected"].get<bool>()) << one["id"];
      continue;
    }
    // Given best forces: they balance the load and pass the clamp unchanged.
    ASSERT_EQ(kind, "min_max_force");
    Vec6 sum = Vec6::Zero();
    const double tolerance = one["tolerance"].get<double>();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      Wrench F_C;
      F_C.force = contacts[i].R_OC.transpose() * vector_of(one["expected_forces"][i]);
      const ContactForce clamped = clamp_to_friction(FrictionLimit(contacts[i]), F_C);
      const Vec3 passed(clamped.fx, clamped.fy, clamped.fz);
      EXPECT_LE((passed - F_C.force).norm(), tolerance) << one["id"];
      sum += contact_columns(contacts[i]) * F_C.force;
    }
    const Vec3 load = vector_of(one["external_wrench"]);  // Fx, Fy, Tz or the first half of six
    if (one["dim"] == 2)
      EXPECT_LE((Vec3(sum[0], sum[1], sum[5]) + load).norm(), tolerance) << one["id"];
    else
      EXPECT_LE((sum.head<3>() + load).norm(), tolerance) << one["id"];
  }
  EXPECT_GE(compared["form"], 2);
  EXPECT_GE(compared["force"], 9);
}

TEST(GraspOracles, EpsilonAgreesWithDexNet) {
  const Json cases = oracles("epsilon_cases_dexnet.json");
  if (cases.is_null()) GTEST_SKIP() << "no recorded oracles";
  constexpr double kDexNet = 1e-6;     // what its own program promises
  constexpr double kHull = 1e-9;       // SciPy ran the same hull with joggled input
  constexpr double kSingular = 1e-14;  // of the largest
  int closed = 0;
  for (const auto& one : test::every(cases)) {
    const double mu = one["mu"].get<double>();
    const double length_m = 1.0 / one["torque_scaling"].get<double>();
    const auto edges = one["cone_edges"].get<std::size_t>();
    std::vector<Contact> contacts;
    for (std::size_t i = 0; i < one["contact_points"].size(); ++i)
      contacts.push_back(test::contact_at(vector_of(one["contact_points"][i]),
                                          vector_of(one["inward_normals"][i]), ContactModel::point,
                                          mu));
    const auto& forces = one["primitive_forces"];
    ASSERT_EQ(forces.size(), edges * contacts.size());
    Eigen::MatrixXd wrenches(6, static_cast<Eigen::Index>(forces.size()));
    for (std::size_t k = 0; k < forces.size(); ++k) {
      const Contact& contact = contacts[k / edges];
      wrenches.col(static_cast<Eigen::Index>(k)) =
          scaled_grasp_map({contact}, kAllRows, {length_m, 1.0}) *
          (contact.R_OC.transpose() * vector_of(forces[k]));
    }
    const auto epsilon = epsilon_quality(wrenches);
    ASSERT_TRUE(epsilon.ok()) << epsilon.error().message();
    const bool expected = one["lp_force_closure"].get<bool>();
    EXPECT_EQ(*epsilon > 0.0, expected) << one["name"];
    EXPECT_EQ(force_closure(contacts, kAllRows), expected) << one["name"];
    if (one.contains("dexnet_ferrari_canny_L1")) {
      EXPECT_WITHIN(*epsilon, one["dexnet_ferrari_canny_L1"].get<double>(), kDexNet) << one["name"];
      EXPECT_WITHIN(*epsilon, one["qhull_min_facet_offset"].get<double>(), kHull) << one["name"];
      ++closed;
    }
    const Criteria of_wrenches = criteria(wrenches);
    EXPECT_WITHIN(of_wrenches.G_min, one["dexnet_min_singular"].get<double>(),
                  kSingular * of_wrenches.singular_values.front());
    const auto& reference = one["G_point_contact_singular_values"];
    const Criteria of_map = criteria(contacts, kAllRows, {1.0, 1.0});
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_WITHIN(of_map.singular_values[i], reference[i].get<double>(),
                    kSingular * of_map.singular_values.front())
          << one["name"];
  }
  EXPECT_GE(closed, 3);
}

TEST(GraspOracles, MapsAndCriteriaAgreeWithSynGrasp) {
  const Json cases = oracles("syngrasp_cases.json");
  if (cases.is_null()) GTEST_SKIP() << "no recorded oracles";
  constexpr double kMap = 1e-15;    // of the largest entry: positions were subtracted
  constexpr double kValue = 1e-13;  // relative; of values that the printed digits determine
  int with_joints = 0;
  for (const auto& one : test::every(cases)) {
    const bool soft = one["contact_type"] == "soft_finger";
    const Vec3 centre = vector_of(one["object_center"]);
    std::vector<Contact> contacts;
    const Eigen::Index width = soft ? 4 : 3;
    const auto count = static_cast<Eigen::Index>(one["contact_points"].size());
    // SynGrasp has its forces in base axes, and all torsions behind all forces.
    Eigen::MatrixXd to_base = Eigen::MatrixXd::Zero(width * count, width * count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto k = static_cast<std::size_t>(i);
      contacts.push_back(test::contact_at(vector_of(one["contact_points"][k]) - centre,
                                          vector_of(one["inward_normals"][k]),
                                          soft ? ContactModel::soft : ContactModel::point, 1.0));
      to_base.block<3, 3>(width * i, 3 * i) = contacts.back().R_OC.transpose();
      if (soft) to_base(width * i + 3, 3 * count + i) = 1.0;
    }
    const Eigen::MatrixXd G = grasp_map(contacts) * to_base;
    const Eigen::MatrixXd reference = matrix_of(one["G"]);
    EXPECT_LE((G - reference).cwiseAbs().maxCoeff(), kMap * reference.cwiseAbs().maxCoeff());

    const Criteria c = criteria(contacts, kAllRows, {1.0, 1.0});
    EXPECT_EQ(c.rank, one["rank_G"].get<int>());
    const auto near = [](double value, const Json& expected, double scale) {
      EXPECT_WITHIN(value, expected.get<double>(), kValue * scale);
    };
    const double s1 = c.singular_values.front();
    for (std::size_t i = 0; i < 6; ++i) near(c.singular_values[i], one["singular_values_G"][i], s1);
    near(c.G_min, one["G_min"], s1);
    if (c.rank < 6) continue;
    near(c.G_det, one["G_det"], c.G_det / c.G_rat);
    near(c.G_rat, one["SGgraspIsotropyIndex"], 1.0);
    near(c.G_min, one["SGminSVG"], s1);

    // The same criteria of the hand-object map H = pinv(G') J.
    const Eigen::MatrixXd H =
        Eigen::MatrixXd(G.transpose()).completeOrthogonalDecomposition().solve(matrix_of(one["J"]));
    const Criteria h = criteria(H);
    const double conditioning = 1.0 / (c.G_rat * h.G_rat);
    near(h.G_min, one["SGdistSingularConfiguration"], h.G_min * conditioning);
    near(h.G_det, one["SGmanipEllipsoidVolume"], h.G_det * conditioning);
    near(1.0 / h.G_rat, one["SGunifTransf"], conditioning / h.G_rat);
    ++with_joints;
  }
  EXPECT_GE(with_joints, 12);
}

}  // namespace
}  // namespace isograsp::grasp_oracles_test
