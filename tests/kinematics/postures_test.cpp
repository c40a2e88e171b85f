// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinematics/postures.hpp"

#include <gtest/gtest.h>

#include "kinematics/tables/pose_csv.hpp"
#include "tests/kinematics/support.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::postures_test {
namespace {

using namespace isograsp::test;

Postures golden_postures() {
  return must(parse_postures(must(read_text(golden("postures.toml"))), "postures.toml"));
}

TEST(Postures, AdaptToOtherArmsAsIndependentReferencesDo) {
  const Postures library = golden_postures();
  for (const Fields& row : test::every(golden_table(golden("adapt_expected.csv")))) {
    const auto series = must(read_poses(golden("adapt_start" + row.at("subject") + ".csv")));
    const auto start = must(start_posture(series, library.chain));
    EXPECT_EQ(start.rows, number_in(row, "rows"));
    const auto scale = row.at("scale") == "length" ? SizeScale::length : SizeScale::none;
    for (std::size_t j = 0; j < library.postures.size(); ++j) {
      if (library.postures[j].name != row.at("posture")) continue;
      const Pose X_WO = adapted(library, j, start, scale);
      const Vec3 p(number_in(row, "x_m"), number_in(row, "y_m"), number_in(row, "z_m"));
      const Quat q(number_in(row, "qw"), number_in(row, "qx"), number_in(row, "qy"),
                   number_in(row, "qz"));
      EXPECT_WITHIN((X_WO.p - p).norm(), 0.0, kGoldenPosition_m);
      EXPECT_WITHIN(angle_between(X_WO.q, q), 0.0, kGoldenAngle_rad);
    }
  }
}

TEST(Postures, OfAnOwnRangeDifferInOneAngleOfOneLink) {
  Random random(12);
  constexpr double kRounding_rad = 1e-9;
  for (const AngleSequence sequence : {AngleSequence::rpy, AngleSequence::zxy})
    for (int i = 0; i < 50; ++i) {
      StartPosture start{1, random_pose(random), {}};
      for (int l = 0; l < 3; ++l) start.X_L.push_back(random_pose(random));
      const RigLink link{"EF", "E", "F", sequence, random_pose(random).q};
      for (int angle : {0, 2}) {  // the middle one has a lock
        const OwnRange range{"forearm", angle, -0.6, 1.1};
        const Postures own = own_range_postures(start, {"E", "F", "D", "O"}, 1, link, range);
        ASSERT_EQ(own.postures.size(), 3u);
        const Vec3 before = link_angles(start.X_L[1].q, link);
        for (const auto& [posture, end_rad] : {std::pair(&own.postures[1], range.min_rad),
                                               std::pair(&own.postures[2], range.max_rad)}) {
          const Vec3 angles = link_angles(posture->X_L[1].q, link);
          for (int a = 0; a < 3; ++a)
            EXPECT_WITHIN(angles[a], a == angle ? end_rad : before[a], kRounding_rad);
          EXPECT_EQ(posture->X_L[1].p, start.X_L[1].p);
          for (const std::size_t other : {0u, 2u})
            EXPECT_EQ(posture->X_L[other].q.coeffs(), start.X_L[other].q.coeffs());
        }
        // Nobody has to be adapted to himself.
        const Pose X_WO = adapted(own, 0, start, SizeScale::none);
        Pose chain = start.X_W;
        for (const Pose& X_L : start.X_L) chain = compose(chain, X_L);
        EXPECT_WITHIN((X_WO.p - chain.p).norm(), 0.0, kRounding_rad);
      }
    }
}

TEST(Postures, TheReferenceSubjectGetsHisOwnPosesBack) {
  Random random(8);
  constexpr double kIdentity = 1e-12;
  for (int i = 0; i < 200; ++i) {
    Postures library;
    library.chain = {"E", "F", "D", "O"};
    for (const char* name : {"initial", "screw"}) {
      Posture posture{name, {}};
      for (int l = 0; l < 3; ++l) posture.X_L.push_back(random_pose(random));
      library.postures.push_back(posture);
    }
    const StartPosture start{1, random_pose(random), library.postures.front().X_L};
    for (const auto scale : {SizeScale::none, SizeScale::length})
      for (std::size_t j = 0; j < 2; ++j) {
        Pose own = start.X_W;
        for (const Pose& X_L : library.postures[j].X_L) own = compose(own, X_L);
        const Pose back = adapted(library, j, start, scale);
        EXPECT_WITHIN((back.p - own.p).norm(), 0.0, kIdentity);
        EXPECT_WITHIN(angle_between(back.q, own.q), 0.0, kIdentity);
      }
  }
}

TEST(Postures, PartOfTheWayBeginsAtTheInitialOneAndEndsAtTheNamedOne) {
  const Postures library = golden_postures();
  constexpr double kRounding = 1e-12;
  const auto expect_same = [](const Pose& a, const Pose& b) {
    EXPECT_WITHIN((a.p - b.p).norm(), 0.0, kRounding);
    EXPECT_WITHIN(angle_between(a.q, b.q), 0.0, kRounding);
  };
  const Postures none = part_of_the_way(library, 0.0);
  const Postures half = part_of_the_way(library, 0.5);
  const Postures all = part_of_the_way(library, 1.0);
  for (std::size_t j = 0; j < library.postures.size(); ++j)
    for (std::size_t l = 0; l < library.postures[j].X_L.size(); ++l) {
      const Pose& initial = library.postures[0].X_L[l];
      expect_same(none.postures[j].X_L[l], initial);
      expect_same(all.postures[j].X_L[l], library.postures[j].X_L[l]);
      // Half of the way twice is the whole way: the change is one turn and one shift.
      const Pose change = compose(inverse(initial), half.postures[j].X_L[l]);
      EXPECT_WITHIN(2.0 * rotation_vector(change.q).norm(),
                    angle_between(initial.q, library.postures[j].X_L[l].q), kRounding);
    }
}

TEST(Postures, AStartPostureThatMovesSaysSo) {
  StartPostureMean mean(2);
  EXPECT_TRUE(is_missing(Vec3::Constant(mean.largest_sd_m())));
  Random random(3);
  std::vector<double> z_m;
  for (int k = 0; k < 200; ++k) {
    const double offset_m = 0.002 * random.gaussian();
    z_m.push_back(offset_m);
    mean.add(std::array{Pose{Vec3(5.0, 1.0, -2.0), Quat::Identity()},
                        Pose{Vec3(5.0, 1.1, -2.0 + offset_m), Quat::Identity()}});
    mean.add(std::array{Pose{Vec3(5.0, 1.0, -2.0), Quat::Identity()}, missing_pose()});
  }
  EXPECT_EQ(mean.rows(), 200u) << "a row without one of the frames does not count";
  double sum = 0.0, squares = 0.0;
  for (const double z : z_m) sum += z;
  for (const double z : z_m) squares += (z - sum / 200.0) * (z - sum / 200.0);
  constexpr double kRounding_m = 1e-9;
  EXPECT_WITHIN(mean.largest_sd_m(), std::sqrt(squares / 199.0), kRounding_m);
}

TEST(Postures, AreWrittenAsTheyWereRead) {
  const Postures library = golden_postures();
  const std::string text = postures_text(library);
  EXPECT_EQ(postures_text(must(parse_postures(text, "again.toml"))), text);
}

TEST(Postures, OfAnotherChainAreRefused) {
  const auto series = must(read_poses(golden("links_poses.csv")));
  const auto start = start_posture(series, {"elbow", "forearm", "hand", "object"});
  ASSERT_FALSE(start);
  EXPECT_NE(start.error().message().find("'hand'"), std::string::npos);
  const std::string head = "format = \"isograsp-postures-1\"\n";
  EXPECT_FALSE(parse_postures(head + "chain = [\"elbow\"]\n", "a.toml"));
  const auto wrong = parse_postures(
      head +
          "chain = [\"a\", \"b\", \"c\"]\n[[posture]]\nname = \"i\"\nlinks = [{ position_m = "
          "[0, 0, 0], quaternion_wxyz = [1, 0, 0, 0] }]\n",
      "a.toml");
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.error().message().find("1 links, the chain has 2"), std::string::npos);
}

TEST(Postures, AChainFollowsTheLinksOfARig) {
  EXPECT_EQ(chain_of(golden_rig("kurillo15.toml")),
            (std::vector<std::string>{"elbow", "forearm", "dorsum", "object"}));
}

}  // namespace
}  // namespace isograsp::postures_test
