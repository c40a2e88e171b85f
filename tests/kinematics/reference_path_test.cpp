// SPDX-License-Identifier: GPL-3.0-or-later
// A reference that moves from posture to posture, and the clock on which it moves.
#include "kinematics/reference_path.hpp"

#include <array>

#include <gtest/gtest.h>

#include "kinematics/sight_clock.hpp"
#include "kinematics/tables/pose_csv.hpp"
#include "tests/kinematics/support.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"

namespace isograsp::reference_path_test {
namespace {

using namespace isograsp::test;

constexpr double kLeg_s = 4.0;
constexpr double kSame = 1e-12;  // products of a few quaternions

struct Made {
  Postures library = must(parse_postures(must(read_text(golden("postures.toml"))), "postures"));
  StartPosture start =
      must(start_posture(must(read_poses(golden("adapt_start1.csv"))), library.chain));
  std::vector<std::size_t> round{0, 1, 2};
  [[nodiscard]] ReferencePath path(SizeScale scale = SizeScale::length) const {
    return {library, round, start, scale, kLeg_s};
  }
};

double apart(const Pose& a, const Pose& b) {
  return (a.p - b.p).norm() + angle_between(a.q, b.q);
}

TEST(ReferencePath, PassesThePosturesThatAreAdaptedToThisArmOneLegAfterTheOther) {
  const Made made;
  for (const SizeScale scale : {SizeScale::none, SizeScale::length})
    for (std::size_t k = 0; k < 7; ++k) {
      const Pose there = adapted(made.library, made.round[k % 3], made.start, scale);
      const double t_s = static_cast<double>(k) * kLeg_s;
      EXPECT_WITHIN(apart(made.path(scale).at(t_s), there), 0.0, kSame) << k;
      EXPECT_EQ(made.path(scale).leg(t_s + 0.5 * kLeg_s), static_cast<int>(k));
    }
}

TEST(ReferencePath, StandsWhereItBeginsUntilItBegins) {
  const Made made;
  EXPECT_EQ(apart(made.path().at(-2.0), made.path().at(0.0)), 0.0);
  EXPECT_EQ(made.path().leg(-2.0), 0);
}

TEST(ReferencePath, RestsInEveryPostureAndIsFastestHalfWay) {
  const Made made;
  const ReferencePath path = made.path();
  constexpr double kStep_s = 1e-3;
  const auto speed = [&](double t_s) {
    return apart(path.at(t_s - kStep_s), path.at(t_s + kStep_s)) / (2.0 * kStep_s);
  };
  for (std::size_t leg = 0; leg < 3; ++leg) {
    const double begins_s = static_cast<double>(leg) * kLeg_s;
    const double way = apart(path.at(begins_s), path.at(begins_s + kLeg_s));
    ASSERT_GT(way, 0.1);
    EXPECT_LT(speed(begins_s + kLeg_s), 1e-4 * way);
    // Least jerk: 15/8 of the mean speed; what links do together is a little longer or shorter.
    constexpr double kLinks = 0.2;
    EXPECT_WITHIN(speed(begins_s + 0.5 * kLeg_s) * kLeg_s / way, 15.0 / 8.0, kLinks);
  }
}

TEST(ReferencePath, OfOneLinkGoesHalfOfItsTurnInHalfOfItsTimeAboutOneAxis) {
  Postures library;
  library.chain = {"a", "b"};
  const Quat turned(Eigen::AngleAxisd(1.2, Vec3(1, 2, 3).normalized()));
  library.postures = {{"one", {Pose{Vec3(0.1, 0, 0), Quat::Identity()}}},
                      {"other", {Pose{Vec3(0.1, 0.2, 0), turned}}}};
  const StartPosture start{1, Pose(), library.postures[0].X_L};
  const std::array<std::size_t, 2> round{0, 1};
  const ReferencePath path(library, round, start, SizeScale::none, kLeg_s);
  for (const double u : {0.1, 0.25, 0.5, 0.9}) {
    const double s = u * u * u * (10.0 - 15.0 * u + 6.0 * u * u);
    const Pose there{Vec3(0.1, 0.2 * s, 0.0),
                     Quat(Eigen::AngleAxisd(1.2 * s, Vec3(1, 2, 3).normalized()))};
    EXPECT_WITHIN(apart(path.at(u * kLeg_s), there), 0.0, kSame);
    EXPECT_WITHIN(apart(path.at((2.0 - u) * kLeg_s), there), 0.0, kSame) << "the same way back";
  }
}

TEST(ReferencePath, IsReadWithoutAllocating) {
  const Made made;
  const ReferencePath path = made.path();
  const auto before = allocations();
  double sum = 0.0;
  for (int k = 0; k < 100; ++k) sum += path.at(0.1 * k).p.x();
  EXPECT_EQ(allocations(), before);
  EXPECT_FALSE(std::isnan(sum));
}

TEST(SightClock, RunsWithTheRecordWhileTheObjectIsSeen) {
  SightClock clock;
  EXPECT_EQ(clock.step(0.5, false), Sight::hidden);
  EXPECT_FALSE(clock.started());
  EXPECT_EQ(clock.elapsed_s(0.5), 0.0);
  EXPECT_EQ(clock.step(1.0, true), Sight::first);
  EXPECT_EQ(clock.step(1.25, true), Sight::again) << "more than 50 ms apart";
  EXPECT_EQ(clock.step(1.26, true), Sight::seen);
}

TEST(SightClock, CountsFiftyMillisecondsOfEveryGapAndNotMore) {
  constexpr double kStep_s = 0.01;
  constexpr double kSums = 1e-12;
  for (const int gap : {1, 4, 5, 6, 30}) {
    SightClock clock;
    int row = 0;
    for (; row < 100; ++row) clock.step(row * kStep_s, true);
    for (int k = 0; k < gap; ++k, ++row) {
      const Sight sight = clock.step(row * kStep_s, false);
      EXPECT_EQ(sight, k < 5 ? Sight::held : Sight::hidden) << gap << " " << k;
      EXPECT_WITHIN(clock.elapsed_s(row * kStep_s), 0.99 + std::min(0.05, (k + 1) * kStep_s),
                    kSums);
    }
    EXPECT_EQ(clock.step(row * kStep_s, true), gap < 5 ? Sight::seen : Sight::again) << gap;
    // From the last pose to the next one: the gap and one step.
    EXPECT_WITHIN(clock.pauses_s(), std::max(0.0, (gap + 1) * kStep_s - 0.05), kSums) << gap;
    EXPECT_WITHIN(clock.elapsed_s(row * kStep_s) + clock.pauses_s(), row * kStep_s, kSums);
  }
}

}  // namespace
}  // namespace isograsp::reference_path_test
