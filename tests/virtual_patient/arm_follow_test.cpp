// SPDX-License-Identifier: GPL-3.0-or-later
// The arm before a screen that asks for something that lasts: a reference that moves, a joint that
// is turned as far as it goes.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "kinematics/reference_path.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"
#include "tests/virtual_patient/arm_play.hpp"

namespace isograsp::virtual_patient::arm_follow_test {
namespace {

using namespace isograsp::test;

constexpr double kDegrees = 180.0 / std::numbers::pi;

/// How far the object was from a reference that turned a light bulb to and fro, root mean square.
struct Followed {
  double angle_rad = 0.0;
  double way_m = 0.0;
  double reference_rad = 0.0;  ///< how far the reference itself was from where it began
};
Followed follow(const ArmTraits& traits, std::uint64_t seed, double leg_s, double way) {
  PlayedArm played(traits, seed);
  const Postures library = part_of_the_way(shipped_postures("screw"), way);
  played.show(Cue::relax, 1.0);
  const StartPosture start = must(start_posture(played.series, library.chain));
  const std::vector<std::size_t> round{0, 1, 0, 2};
  const ReferencePath path(library, round, start, SizeScale::none, leg_s);
  Stimulus screen;
  screen.cue = Cue::move;
  screen.pose_target_shown = true;
  Followed followed;
  int rows = 0;
  for (int k = 0; k < static_cast<int>(8.0 * leg_s / kPicture_s); ++k) {
    played.look();
    screen.X_WT = path.at(kPicture_s * k);
    screen.object_shown = !is_missing(played.X_WO());
    if (screen.object_shown) {
      screen.X_WO = played.X_WO();
      followed.angle_rad += std::pow(angle_between(screen.X_WO.q, screen.X_WT.q), 2);
      followed.way_m += (screen.X_WO.p - screen.X_WT.p).squaredNorm();
      followed.reference_rad += std::pow(angle_between(path.at(0.0).q, screen.X_WT.q), 2);
      ++rows;
    }
    screen.t_s = played.t_s;
    played.arm.see(screen);
  }
  for (double* sum : {&followed.angle_rad, &followed.way_m, &followed.reference_rad})
    *sum = std::sqrt(*sum / rows);
  return followed;
}

TEST(ArmFollow, HealthyPeopleStayNearAReferenceThatMovesSlowly) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Followed followed = follow(*arm_traits("healthy"), seed, 4.0, 0.5);
    EXPECT_LT(followed.angle_rad, 0.35 * followed.reference_rad) << seed;
    EXPECT_LT(followed.way_m, 0.02) << seed;
  }
}

TEST(ArmFollow, PareticPeopleAreFurtherFromIt) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Followed healthy = follow(*arm_traits("healthy"), seed, 4.0, 0.5);
    const Followed paretic = follow(*arm_traits("paretic"), seed, 4.0, 0.5);
    EXPECT_GT(paretic.angle_rad, 1.3 * healthy.angle_rad) << seed;
  }
}

TEST(ArmFollow, WhatMovesFasterIsFollowedLessWell) {
  double last_rad = 0.0;
  for (const double leg_s : {6.0, 3.0, 1.5}) {
    double sum_rad = 0.0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed)
      sum_rad += follow(*arm_traits("healthy"), seed, leg_s, 0.5).angle_rad;
    EXPECT_GT(sum_rad, last_rad) << leg_s;
    last_rad = sum_rad;
  }
}

TEST(ArmFollow, SpeedNeverJumpsWhileItFollows) {
  ArmTraits traits = exact(*arm_traits("healthy"));
  traits.wander_rad = traits.tremor_rad = 0.0;
  PlayedArm played(traits, 2);
  played.show(Cue::relax, 1.0);
  const Pose begin = played.X_WO();
  Vec3 before = begin.p, before_that = begin.p;
  double largest_m_s2 = 0.0, furthest_rad = 0.0;
  for (int k = 0; k < 1500; ++k) {
    Pose target = begin;
    target.q = Quat(Eigen::AngleAxisd(0.5 * std::sin(0.015 * k), Vec3::UnitZ())) * begin.q;
    played.aim(target, kPicture_s);
    const Vec3 now = played.X_WO().p;
    furthest_rad = std::max(furthest_rad, angle_between(played.X_WO().q, begin.q));
    largest_m_s2 = std::max(largest_m_s2,
                            (now - 2.0 * before + before_that).norm() / (kPicture_s * kPicture_s));
    before_that = before;
    before = now;
  }
  EXPECT_GT(furthest_rad, 0.35);
  // A jump of 1 cm/s would be 1 m/s² alone; three movements with least jerk at a time of 2 cm in
  // 0.27 s each would be 5.8 · 0.02 / 0.27² = 1.6 m/s² each.
  EXPECT_LT(largest_m_s2, 5.0);
}

/// Least and largest angle of a link, as the rig sees it, while it is asked for.
struct Reached {
  double least_deg = 0.0;
  double largest_deg = 0.0;
  [[nodiscard]] double range_deg() const { return largest_deg - least_deg; }
};
Reached reached(const ArmTraits& traits, std::uint64_t seed, LinkAngle asked,
                Hand hand = Hand::right) {
  PlayedArm played(traits, seed, hand);
  played.show(Cue::relax, 1.0);
  Stimulus screen;
  screen.cue = Cue::move;
  screen.turn = asked;
  const std::size_t begin = played.series.t_s.size();
  played.show(screen, 15.0);
  const RigLink& link = played.rig.links[index_of(asked.link)];
  const auto& parent = played.series.X_W[*played.rig.frame(link.parent)];
  const auto& child = played.series.X_W[*played.rig.frame(link.child)];
  double least = std::numeric_limits<double>::infinity();
  double largest = -least;
  for (std::size_t row = begin; row < parent.size(); ++row) {
    if (is_missing(parent[row]) || is_missing(child[row])) continue;
    const double angle =
        link_angles(parent[row].q.conjugate() * child[row].q, link)[asked.angle - 1];
    least = std::min(least, angle);
    largest = std::max(largest, angle);
  }
  return {kDegrees * least, kDegrees * largest};
}

constexpr LinkAngle kForearm{ArmLink::forearm, 3};
constexpr LinkAngle kFlexion{ArmLink::wrist, 1};
constexpr LinkAngle kDeviation{ArmLink::wrist, 2};

TEST(ArmRange, OfHealthyPeopleIsThatOfHealthyMen) {
  // Boone, Azen 1979: pronation 76, supination 82; flexion 76, extension 75; radial 22, ulnar 36.
  constexpr std::pair<LinkAngle, double> kMen[] = {
      {kForearm, 76.0 + 82.0}, {kFlexion, 76.0 + 75.0}, {kDeviation, 22.0 + 36.0}};
  for (const auto& [asked, men_deg] : kMen)
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      // Markers beside an axis show a tenth less, those that turn away from all cameras are lost.
      EXPECT_GT(reached(*arm_traits("healthy"), seed, asked).range_deg(), 0.7 * men_deg) << seed;
      EXPECT_LT(reached(*arm_traits("healthy"), seed, asked).range_deg(), 1.1 * men_deg) << seed;
    }
}

TEST(ArmRange, OfPareticPeopleIsSmaller) {
  for (const LinkAngle asked : {kForearm, kFlexion, kDeviation})
    for (std::uint64_t seed = 1; seed <= 4; ++seed)
      EXPECT_LT(reached(*arm_traits("paretic"), seed, asked).range_deg(),
                0.85 * reached(*arm_traits("healthy"), seed, asked).range_deg())
          << seed;
}

TEST(ArmRange, OfALeftArmHasTheSignsOfARightOne) {
  const Reached right = reached(*arm_traits("healthy"), 3, kForearm);
  const Reached left = reached(*arm_traits("healthy"), 3, kForearm, Hand::left);
  constexpr double kNoise_deg = 3.0;  // the object is no mirror image, the forearm is
  EXPECT_WITHIN(left.least_deg, right.least_deg, kNoise_deg);
  EXPECT_WITHIN(left.largest_deg, right.largest_deg, kNoise_deg);
  EXPECT_LT(right.least_deg, -40.0) << "supination is negative";
  EXPECT_GT(right.largest_deg, 40.0);
}

TEST(ArmRange, WhoTurnsTheForearmWithTheShoulderIsNotTakenForAnAbleForearm) {
  ArmTraits lifting = *arm_traits("paretic");
  ArmTraits resting = lifting;
  resting.shoulder_share = 0.0;
  const auto elbow_m = [](const ArmTraits& traits) {
    PlayedArm played(traits, 3);
    played.show(Cue::relax, 1.0);
    Stimulus screen;
    screen.cue = Cue::move;
    screen.turn = kForearm;
    const std::size_t begin = played.series.t_s.size() - 1;
    played.show(screen, 15.0);
    const auto& elbow = played.series.X_W[*played.rig.frame("elbow")];
    double furthest_m = 0.0;
    for (std::size_t row = begin; row < elbow.size(); ++row)
      if (!is_missing(elbow[row]))
        furthest_m = std::max(furthest_m, (elbow[row].p - elbow[begin].p).norm());
    return furthest_m;
  };
  constexpr double kUpperArmMoved_m = 0.02;
  EXPECT_GT(elbow_m(lifting), kUpperArmMoved_m);
  EXPECT_LT(elbow_m(resting), kUpperArmMoved_m);
  EXPECT_LT(reached(resting, 3, kForearm).range_deg(), reached(lifting, 3, kForearm).range_deg());
}

TEST(ArmRange, NobodyTurnsBeforeTheScreenSaysSoAndAllStopWhenItSaysRelax) {
  PlayedArm played(*arm_traits("healthy"), 2);
  played.show(Cue::relax, 1.0);
  const Quat start = played.X_WO().q;
  Stimulus screen;
  screen.cue = Cue::move;
  screen.turn = kFlexion;
  screen.progress.getting_ready = true;
  constexpr double kStill_rad = 0.1;
  played.show(screen, 3.0);
  EXPECT_LT(angle_between(played.X_WO().q, start), kStill_rad);
  screen.progress.getting_ready = false;
  double furthest_rad = 0.0;
  for (int k = 0; k < 300; ++k) {
    played.show(screen, kPicture_s);
    if (!is_missing(played.X_WO()))
      furthest_rad = std::max(furthest_rad, angle_between(played.X_WO().q, start));
  }
  EXPECT_GT(furthest_rad, 5.0 * kStill_rad);
  played.show(Cue::relax, 4.0);
  EXPECT_LT(angle_between(played.X_WO().q, start), kStill_rad);
}

TEST(ArmRange, AnAngleThatNoJointTurnsAloneIsLeftAlone) {
  PlayedArm played(*arm_traits("healthy"), 2);
  played.show(Cue::relax, 1.0);
  const Quat start = played.X_WO().q;
  Stimulus screen;
  screen.cue = Cue::move;
  screen.turn = LinkAngle{ArmLink::wrist, 3};
  played.show(screen, 4.0);
  constexpr double kStill_rad = 0.1;
  EXPECT_LT(angle_between(played.X_WO().q, start), kStill_rad);
}

}  // namespace
}  // namespace isograsp::virtual_patient::arm_follow_test
