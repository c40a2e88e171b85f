// SPDX-License-Identifier: GPL-3.0-or-later
// Force closure: golden table, sharp thresholds, laws, exact tests against linear programs and
// hull.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "grasp_model/grasp.hpp"
#include "tests/grasp_model/grasps.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::closure_test {
namespace {

using test::kAllRows;
using test::kPlanarRows;
using test::RandomGrasps;
using test::with_friction;

constexpr auto kFrictionless = ContactModel::frictionless;
constexpr auto kPoint = ContactModel::point;
constexpr auto kSoft = ContactModel::soft;
constexpr auto kBonded = ContactModel::bonded;

struct Kind {
  std::vector<ContactModel> models;
  bool in_plane = false;
  [[nodiscard]] const std::vector<Eigen::Index>& rows() const {
    return in_plane ? kPlanarRows : kAllRows;
  }
};
const std::vector<Kind> kExactKinds{{{kPoint, kPoint, kPoint}},
                                    {{kSoft, kSoft}},
                                    {{kSoft, kPoint}},
                                    {{kSoft, kPoint, kFrictionless}},
                                    {{kPoint, kPoint, kPoint}, true},
                                    {{kPoint, kSoft}, true},
                                    {{kPoint, kPoint, kFrictionless}, true}};
const std::vector<Kind> kRoundKinds{{{kSoft, kSoft, kSoft}},
                                    {{kPoint, kPoint, kSoft}},
                                    {{kPoint, kPoint, kPoint, kPoint}},
                                    {{kSoft, kPoint, kPoint, kFrictionless}}};

std::vector<Kind> all_kinds() {
  std::vector<Kind> kinds = kExactKinds;
  kinds.insert(kinds.end(), kRoundKinds.begin(), kRoundKinds.end());
  return kinds;
}

/// Within this share of its threshold friction a grasp may be answered either way by a method that
/// works to a tolerance: 1e-8 of the total force moves a threshold by less than 1e-5 of itself.
constexpr double kAway = 1e-5;
bool away_from_threshold(const std::vector<Contact>& contacts, const Kind& kind) {
  return force_closure(with_friction(contacts, 1.0 - kAway), kind.rows()) ==
         force_closure(with_friction(contacts, 1.0 + kAway), kind.rows());
}

TEST(ForceClosure, AgreesWithTheGoldenCases) {
  const auto cases = test::golden_grasps();
  const auto rows = test::golden("force_closure.csv");
  ASSERT_GE(rows.size(), 63u);
  int closed = 0;
  for (const auto& row : test::every(rows)) {
    auto contacts = cases.at(row.text("case") + " " + row.text("type")).contacts;
    for (auto& contact : contacts) {
      contact.friction = row["mu"];
      contact.torsion_m = row["gamma_m"];
    }
    const bool expected = row["force_closure"] == 1.0;
    closed += expected ? 1 : 0;
    for (const bool answer :
         {force_closure(contacts, kAllRows), force_closure_by_cuts(contacts, kAllRows)})
      EXPECT_EQ(answer, expected) << row.text("case") << ' ' << row.text("type") << " mu "
                                  << row["mu"] << " margin " << row["margin_lp"];
  }
  EXPECT_GT(closed, 10);
}

TEST(ForceClosure, ExactTestsAndLinearProgramsNeverDisagree) {
  constexpr int kGrasps = 1500;
  RandomGrasps random(1);
  for (const auto& kind : kExactKinds) {
    int near = 0;
    int closed = 0;
    for (int i = 0; i < kGrasps; ++i) {
      const auto contacts = random.grasp(kind.models, kind.in_plane);
      const auto exact = exact_force_closure(contacts, kind.rows());
      ASSERT_TRUE(exact.has_value());
      closed += *exact ? 1 : 0;
      if (force_closure_by_cuts(contacts, kind.rows()) == *exact) continue;
      EXPECT_FALSE(away_from_threshold(contacts, kind)) << i;
      ++near;
    }
    EXPECT_LE(near, 2) << "of " << kGrasps << " grasps of " << kind.models.size();
    EXPECT_GT(closed, kGrasps / 20);
  }
}

TEST(ForceClosure, ExactTestsExistWhereTheyAreDocumented) {
  RandomGrasps random(2);
  for (const auto& kind : kExactKinds)
    EXPECT_TRUE(exact_force_closure(random.grasp(kind.models, kind.in_plane), kind.rows()));
  for (const auto& kind : kRoundKinds)
    EXPECT_FALSE(exact_force_closure(random.grasp(kind.models), kind.rows()));
}

TEST(ForceClosure, HullsOfPyramidsInsideAndOutsideTheConesAgree) {
  // Qhull as the witness: a pyramid inside the cone that closes proves closure, a pyramid around
  // the cone that does not disproves it.
  constexpr int kEdges = 12;
  const auto closes = [](const std::vector<Contact>& contacts, double widening) {
    Eigen::MatrixXd wrenches(6, static_cast<Eigen::Index>(contacts.size()) * kEdges);
    Eigen::Index column = 0;
    for (const auto& contact : contacts)
      for (int edge = 0; edge < kEdges; ++edge) {
        const double angle = 2.0 * std::numbers::pi * edge / kEdges;
        const double mu = widening * contact.friction;
        const Vec3 f(mu * std::cos(angle), mu * std::sin(angle), 1.0);
        Vec6 w = contact_columns(contact) * f;
        w.tail<3>() /= 0.03;
        wrenches.col(column++) = w;
      }
    return *epsilon_quality(wrenches) > 1e-9;  // Qhull's own rounding
  };
  RandomGrasps random(3);
  int proven = 0;
  int disproven = 0;
  for (int i = 0; i < 60; ++i) {
    const auto contacts = with_friction(random.grasp({kPoint, kPoint, kPoint}), 3.0);
    const bool answer = force_closure(contacts, kAllRows);
    if (closes(contacts, 1.0)) {
      EXPECT_TRUE(answer) << i;
      ++proven;
    }
    if (!closes(contacts, 1.0 / std::cos(std::numbers::pi / kEdges))) {
      EXPECT_FALSE(answer) << i;
      ++disproven;
    }
  }
  EXPECT_GT(proven, 10);
  EXPECT_GT(disproven, 10);
}

TEST(ForceClosure, ThumbAgainstIndexNeedsFrictionAboveTheSlopeOfTheirLine) {
  // 12.5 mm aside on 65 mm across: mu > 0.1923; in the plane two point contacts suffice.
  constexpr double kSlope = 12.5 / 65.0;
  for (const double side : {-1e-9, 1e-9}) {
    const std::vector<Contact> contacts{
        test::contact_at({-0.0325, 0, 0}, Vec3::UnitX(), kPoint, kSlope + side),
        test::contact_at({0.0325, 0.0125, 0}, -Vec3::UnitX(), kPoint, kSlope + side)};
    EXPECT_EQ(force_closure(contacts, kPlanarRows), side > 0.0);
    EXPECT_FALSE(force_closure(contacts, kAllRows));  // they cannot resist a turn about their line
    auto soft = contacts;
    for (auto& contact : soft) {
      contact.model = kSoft;
      contact.torsion_m = 0.004;
    }
    EXPECT_EQ(force_closure(soft, kAllRows), side > 0.0);
  }
}

TEST(ForceClosure, ThreeLeaningFingersNeedFrictionAboveTheirLean) {
  // 120 degrees apart, normals out of the plane of contacts by b: mu > tan b.
  constexpr double kLean = 0.3;
  for (const double side : {-1e-9, 1e-9}) {
    std::vector<Contact> contacts;
    for (int i = 0; i < 3; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / 3.0;
      const Vec3 out(std::cos(angle), std::sin(angle), 0.0);
      contacts.push_back(test::contact_at(0.03 * out,
                                          Vec3(0, 0, std::sin(kLean)) - std::cos(kLean) * out,
                                          kPoint, std::tan(kLean) + side));
    }
    EXPECT_EQ(force_closure(contacts, kAllRows), side > 0.0);
  }
}

TEST(ForceClosure, OfTwoSoftFingersHoldsIfTheirLineIsInsideBothCones) {
  // And only if, where the normals stand in one plane with the line.
  const auto line_inside = [](const std::vector<Contact>& contacts) {
    const Vec3 line = (contacts[1].p_OC - contacts[0].p_OC).normalized();
    return line.dot(contacts[0].R_OC.col(2)) > std::cos(std::atan(contacts[0].friction)) &&
           -line.dot(contacts[1].R_OC.col(2)) > std::cos(std::atan(contacts[1].friction));
  };
  RandomGrasps random(4);
  int inside = 0;
  for (int i = 0; i < 1000; ++i) {
    auto contacts = random.grasp({kSoft, kSoft});
    inside += line_inside(contacts) ? 1 : 0;
    EXPECT_TRUE(force_closure(contacts, kAllRows) || !line_inside(contacts)) << i;
    for (auto& contact : contacts) {
      contact.p_OC.z() = 0.0;
      contact.R_OC = random.frame(Vec3(contact.R_OC(0, 2), contact.R_OC(1, 2), 0.0).normalized());
    }
    EXPECT_EQ(force_closure(contacts, kAllRows), line_inside(contacts)) << i;
  }
  EXPECT_GT(inside, 50);
}

TEST(ForceClosure, OfTwistedSoftFingersReachesBeyondTheirLine) {
  // Torsion of both carries the moment of forces beside the line, which may then stand up to
  // 0.5 % of mu outside both cones: the rule of the line is sufficient, not necessary.
  constexpr double kLean = 0.4;
  const auto closes = [](double share, bool (*test)(const std::vector<Contact>&,
                                                    const std::vector<Eigen::Index>&)) {
    const double mu = share * std::tan(kLean);
    return test(
        {test::contact_at({-0.03, 0, 0}, {std::cos(kLean), std::sin(kLean), 0}, kSoft, mu, 0.006),
         test::contact_at({0.03, 0, 0}, {-std::cos(kLean), 0, std::sin(kLean)}, kSoft, mu, 0.006)},
        kAllRows);
  };
  for (const auto test : {&force_closure, &force_closure_by_cuts}) {
    EXPECT_FALSE(closes(0.99502, test));
    EXPECT_TRUE(closes(0.99504, test));
  }
}

TEST(ForceClosure, DoesNotDependOnFrameUnitOrOrder) {
  RandomGrasps random(5);
  test::AtLeast compared(100);
  for (const auto& kind : test::every(all_kinds()))
    for (int i = 0; i < 60; ++i) {
      auto contacts = random.grasp(kind.models, kind.in_plane);
      if (!away_from_threshold(contacts, kind)) continue;
      const bool closed = force_closure(contacts, kind.rows());
      auto turned = contacts;
      const Mat3 R =
          kind.in_plane ? Eigen::AngleAxisd(random.uniform(-3, 3), Vec3::UnitZ()).toRotationMatrix()
                        : random.rotation();
      for (auto& contact : turned) {
        contact.p_OC = R * contact.p_OC;
        contact.R_OC = R * contact.R_OC;
      }
      EXPECT_EQ(force_closure(turned, kind.rows()), closed) << i;
      ++compared;
      auto moved = contacts;
      for (auto& contact : moved) contact.p_OC += Vec3(0.02, -0.01, 0.03);
      EXPECT_EQ(force_closure(moved, kind.rows()), closed) << i;
      for (const double unit : {1e-3, 1e3}) {
        auto scaled = contacts;
        for (auto& contact : scaled) {
          contact.p_OC *= unit;
          contact.torsion_m *= unit;
        }
        EXPECT_EQ(force_closure(scaled, kind.rows()), closed) << i;
      }
      std::rotate(contacts.begin(), contacts.begin() + 1, contacts.end());
      EXPECT_EQ(force_closure(contacts, kind.rows()), closed) << i;
      std::swap(contacts.front(), contacts.back());
      EXPECT_EQ(force_closure(contacts, kind.rows()), closed) << i;
    }
}

TEST(ForceClosure, MoreFrictionOrOneMoreContactNeverLosesIt) {
  RandomGrasps random(6);
  int closed = 0;
  for (const auto& kind : test::every(all_kinds()))
    for (int i = 0; i < 80; ++i) {
      auto contacts = random.grasp(kind.models, kind.in_plane);
      if (!away_from_threshold(contacts, kind) || !force_closure(contacts, kind.rows())) continue;
      ++closed;
      for (const double factor : {1.1, 3.0, 1e3, 1e9, 1e12})
        EXPECT_TRUE(force_closure(with_friction(contacts, factor), kind.rows())) << factor;
      for (const auto model : {kFrictionless, kPoint, kSoft, kBonded}) {
        auto more = contacts;
        more.push_back(random.contact(model, kind.in_plane));
        EXPECT_TRUE(force_closure(more, kind.rows())) << i;
      }
    }
  EXPECT_GT(closed, 100);
}

TEST(ForceClosure, IsRefusedWhereTheMapLosesRank) {
  const auto at = [](double x, double y, const Vec3& normal, ContactModel model) {
    return test::contact_at({x, y, 0}, normal, model, 5.0, 0.01);
  };
  const Vec3 right = Vec3::UnitX();
  const Vec3 up = Vec3::UnitY();
  // Collinear points: nothing resists a turn about their line.
  EXPECT_FALSE(force_closure({at(-0.03, 0, right, kPoint), at(0.03, 0, -right, kPoint)}, kAllRows));
  EXPECT_FALSE(force_closure(
      {at(-0.03, 0, right, kPoint), at(0.01, 0, up, kPoint), at(0.03, 0, -right, kPoint)},
      kAllRows));
  // Coincident ones: nothing but their torsion resists a turn.
  for (const auto model : {kPoint, kSoft})
    EXPECT_FALSE(force_closure({at(0, 0, right, model), at(0, 0, -right, model)}, kAllRows));
  // All on one side: full rank, but nothing opposes.
  EXPECT_FALSE(force_closure({at(-0.03, 0, right, kPoint), at(-0.03, 0.02, right, kPoint),
                              test::contact_at({-0.03, 0.01, 0.02}, right, kPoint, 0.9)},
                             kAllRows));
}

TEST(ForceClosure, NeedsMoreThanOneFingerOrNoFriction) {
  RandomGrasps random(7);
  for (const auto& rows : {kAllRows, kPlanarRows}) {
    for (const auto model : {kFrictionless, kPoint, kSoft})
      EXPECT_FALSE(force_closure({random.contact(model)}, rows));
    EXPECT_TRUE(force_closure({random.contact(kBonded)}, rows));
    EXPECT_FALSE(force_closure({}, rows));
    for (int i = 0; i < 50; ++i)
      EXPECT_FALSE(
          force_closure(with_friction(random.grasp({kPoint, kPoint, kSoft}), 0.0), kAllRows));
  }
}

TEST(ForceClosure, OfFrictionlessFingersIsFormClosure) {
  // Four frictionless fingers hold a shape in the plane if their lines do not meet in one point.
  const auto hold = [](double aside) {
    const Vec3 x = Vec3::UnitX();
    const Vec3 y = Vec3::UnitY();
    return std::vector<Contact>{test::contact_at({-1, aside, 0}, x, kFrictionless, 0),
                                test::contact_at({1, -aside, 0}, -x, kFrictionless, 0),
                                test::contact_at({aside, 1, 0}, -y, kFrictionless, 0),
                                test::contact_at({-aside, -1, 0}, y, kFrictionless, 0)};
  };
  EXPECT_FALSE(force_closure(hold(0.0), kPlanarRows));
  EXPECT_FALSE(force_closure(hold(0.2), kPlanarRows));  // each pair turns it the same way
  auto held = hold(0.2);
  held[2].p_OC.x() = -0.2;
  held[3].p_OC.x() = 0.2;
  EXPECT_TRUE(force_closure(held, kPlanarRows));
  EXPECT_FALSE(force_closure(held, kAllRows));
}

TEST(ForceClosure, TreatsNoFrictionAndNoTorsionAsTheSimplerContact) {
  RandomGrasps random(8);
  int closed = 0;
  for (int i = 0; i < 200; ++i) {
    auto points = random.grasp({kPoint, kPoint, kPoint});
    auto soft = points;
    for (auto& contact : soft) {
      contact.model = kSoft;
      contact.torsion_m = 0.0;
    }
    EXPECT_EQ(force_closure(soft, kAllRows), force_closure(points, kAllRows));
    closed += force_closure(points, kAllRows) ? 1 : 0;
  }
  EXPECT_GT(closed, 20);
}

TEST(EpsilonQuality, OfACubeIsTheDistanceOfItsSides) {
  Eigen::MatrixXd corners(3, 8);
  for (int i = 0; i < 8; ++i)
    corners.col(i) << (i & 1 ? 1.5 : -1.0), (i & 2 ? 2.0 : -2.0), (i & 4 ? 0.25 : -3.0);
  constexpr double kHull = 1e-14;  // Qhull's planes of numbers of the order of 1
  EXPECT_WITHIN(*epsilon_quality(corners), 0.25, kHull);
  EXPECT_EQ(*epsilon_quality(corners.colwise() + Vec3(1.0, 0, 0)), 0.0);  // on the border
  EXPECT_EQ(*epsilon_quality(corners.colwise() + Vec3(9.0, 0, 0)), 0.0);  // outside
  Eigen::MatrixXd flat = corners;
  flat.row(2).setZero();
  EXPECT_EQ(*epsilon_quality(flat), 0.0);
  EXPECT_EQ(*epsilon_quality(corners.leftCols(3)), 0.0);
}

}  // namespace
}  // namespace isograsp::closure_test
