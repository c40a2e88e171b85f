// SPDX-License-Identifier: GPL-3.0-or-later
// The arm as a chain of rigid segments, and the postures that bring its object somewhere.
#include <gtest/gtest.h>

#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"
#include "tests/virtual_patient/arm_play.hpp"
#include "virtual_patient/arm/reach.hpp"
#include "virtual_patient/arm/reference_postures.hpp"
#include "virtual_patient/traits.hpp"

namespace isograsp::virtual_patient::arm_body_test {
namespace {

using namespace isograsp::test;

/// Sums of a few rotations of lengths below 1 m.
constexpr double kExact = 1e-12;

Joints random_posture(const ArmBody& body, Random& random) {
  Joints q;
  for (int k = 0; k < kJoints; ++k)
    q[k] = body.least[k] + random.uniform() * (body.most[k] - body.least[k]);
  return q;
}

std::vector<Vec3> markers_at(const ArmBody& body, const Joints& q) {
  const ArmPoses X_W = body.poses_W(q);
  std::vector<Vec3> p_W;
  for (const ArmMarker& marker : body.markers) {
    const Pose& X_WS = X_W[index_of(marker.segment)];
    p_W.push_back(X_WS.p + X_WS.q * marker.p_S);
  }
  return p_W;
}

ArmBody person(std::uint64_t seed, Hand hand = Hand::right) {
  Random placing(seed, 201);
  return {drawn(*arm_traits("healthy"), seed), placing, hand};
}

TEST(ArmBody, MarkersOfOneSegmentKeepTheirDistancesInEveryPosture) {
  Random random(1);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const ArmBody body = person(seed);
    const auto before = markers_at(body, body.rest);
    for (int trial = 0; trial < 200; ++trial) {
      const auto now = markers_at(body, random_posture(body, random));
      for (std::size_t a = 0; a < kArmMarkers; ++a)
        for (std::size_t b = 0; b < a; ++b) {
          if (body.markers[a].segment != body.markers[b].segment) continue;
          ASSERT_WITHIN((now[a] - now[b]).norm(), (before[a] - before[b]).norm(), kExact)
              << body.markers[a].label << " " << body.markers[b].label;
        }
    }
  }
}

TEST(ArmBody, NeighbouringSegmentsStayTogetherAndTheBraceStaysWhereItIs) {
  Random random(2);
  const ArmBody body = person(1);
  const ArmPoses start = body.poses_W(body.rest);
  for (int trial = 0; trial < 500; ++trial) {
    const ArmPoses X_W = body.poses_W(random_posture(body, random));
    const auto at = [&X_W](Segment segment) { return X_W[index_of(segment)].p; };
    ASSERT_EQ(at(Segment::brace), start[index_of(Segment::brace)].p);
    ASSERT_WITHIN((at(Segment::forearm) - at(Segment::elbow)).norm(), 0.0, kExact);
    ASSERT_WITHIN((at(Segment::hand) - at(Segment::elbow)).norm(), body.forearm_m, kExact);
  }
}

TEST(ArmBody, TheJacobianIsTheDerivative) {
  Random random(3);
  const ArmBody body = person(2);
  constexpr double kStep = 1e-6;
  constexpr double kDerivative = 1e-8;  // third derivatives of order 1, times the step squared
  for (int trial = 0; trial < 50; ++trial) {
    const Joints q = random_posture(body, random);
    const ArmJacobian J = body.jacobian_B(q);
    for (int k = 0; k < kJoints; ++k) {
      Joints above = q, below = q;
      above[k] += kStep;
      below[k] -= kStep;
      const Pose a = body.poses_B(above)[index_of(Segment::object)];
      const Pose b = body.poses_B(below)[index_of(Segment::object)];
      Vec6 column;
      column << a.p - b.p, rotation_vector(a.q * b.q.conjugate());
      ASSERT_WITHIN((column / (2.0 * kStep) - J.col(k)).norm(), 0.0, kDerivative) << k;
    }
  }
}

TEST(ArmBody, ItsAnglesAreThoseThatTheRigMeasures) {
  const Rig rig = shipped_rig("kurillo15");
  const ArmBody body = average_arm();
  const RigLink& EF = rig.links[*rig.link("EF")];
  const RigLink& FD = rig.links[*rig.link("FD")];
  const auto angles = [&](const Joints& q, const RigLink& link) {
    const auto X_W = must(measured_frames(rig, body, q));
    return link_angles(
        compose(inverse(X_W[*rig.frame(link.parent)]), X_W[*rig.frame(link.child)]).q, link);
  };
  const Joints rest = body.rest;
  EXPECT_WITHIN(angles(rest, EF).z(), rest[joint::pronation], 1e-9);
  // The wrist's marker lies 12 mm above its axis, the knuckles 75 mm away: markers show less than
  // the joint turns. A tenth of it, and 0.02 rad for the different heights of the markers.
  constexpr double kLess = 0.1;
  constexpr double kHeights_rad = 0.02;
  for (const double turn : {-0.3, 0.2, 0.5}) {
    Joints q = rest;
    q[joint::pronation] += turn;
    EXPECT_WITHIN(angles(q, EF).z() - angles(rest, EF).z(), turn, 1e-9) << "pronation is positive";
    q = rest;
    q[joint::flexion] += turn;
    EXPECT_WITHIN(angles(q, FD).x() - angles(rest, FD).x(), turn,
                  kLess * std::abs(turn) + kHeights_rad)
        << "flexion is positive";
    q = rest;
    q[joint::ulnar] += turn;
    EXPECT_WITHIN(angles(q, FD).y() - angles(rest, FD).y(), turn,
                  kLess * std::abs(turn) + kHeights_rad)
        << "ulnar deviation is positive";
  }
}

TEST(ArmBody, TheRigHasEveryMarkerAndMeasuresEveryFrameInEveryPosture) {
  Random random(4);
  for (const auto* name : {"kurillo15", "kurillo15_trunk"}) {
    const Rig rig = shipped_rig(name);
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const ArmBody body = person(seed);
      for (int trial = 0; trial < 100; ++trial)
        for (const Pose& X_W :
             every(must(measured_frames(rig, body, random_posture(body, random)))))
          ASSERT_FALSE(is_missing(X_W)) << name;
    }
  }
}

TEST(ArmBody, TheShippedRigOfFifteenMarkersIsThatOfTheReferenceValues) {
  Rig shipped = shipped_rig("kurillo15");
  shipped.view.reset();
  EXPECT_EQ(rig_text(shipped),
            rig_text(must(parse_rig(source_text("tests/data/isotonic/kurillo15.toml"), "golden"))));
}

TEST(ArmBody, PeopleDifferInSizeAndTheSameSeedIsTheSamePerson) {
  const ArmTraits traits = *arm_traits("healthy");
  EXPECT_EQ(drawn(traits, 7), drawn(traits, 7));
  double least_m = 1.0, most_m = 0.0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const double length_m = drawn(traits, seed).forearm_m;
    least_m = std::min(least_m, length_m);
    most_m = std::max(most_m, length_m);
    for (const ArmTraitField& field : every(arm_trait_fields())) {
      const double value = drawn(traits, seed).*field.value;
      EXPECT_TRUE(value >= field.least && value <= field.most) << field.key;
    }
  }
  // Twenty normal values span more than two SD but for one draw in a thousand; and less than eight.
  EXPECT_GT(most_m - least_m, 2.0 * traits.size_cv * traits.forearm_m);
  EXPECT_LT(most_m - least_m, 8.0 * traits.size_cv * traits.forearm_m);
}

TEST(ArmTraits, EveryTraitHasARangeThatTheTwoPeopleAreIn) {
  // One number for each field, and nothing else in the struct.
  EXPECT_EQ(arm_trait_fields().size() * sizeof(double), sizeof(ArmTraits));
  for (const auto name : every(arm_names())) {
    const auto traits = arm_traits(name);
    ASSERT_TRUE(traits) << name;
    EXPECT_EQ(clamped(*traits), *traits) << name;
  }
  EXPECT_FALSE(arm_traits("nobody"));
}

TEST(ArmTraits, ARecoveryOfOneIsHealthyAndADayChangesRangesAndTempoTogether) {
  const ArmTraits paretic = *arm_traits("paretic");
  EXPECT_EQ(recovered(paretic, 0.0), paretic);
  for (const ArmTraitField& field : every(arm_trait_fields()))
    EXPECT_WITHIN(recovered(paretic, 1.0).*field.value, ArmTraits().*field.value, kExact)
        << field.key;
  const ArmTraits today = arm_on_day(paretic, day_seed(1, 3));
  EXPECT_EQ(today, arm_on_day(paretic, day_seed(1, 3)));
  EXPECT_WITHIN(today.supination_rad / paretic.supination_rad,
                today.flexion_rad / paretic.flexion_rad, kExact);
  EXPECT_NE(today.movement_s, paretic.movement_s);
  EXPECT_EQ(today.forearm_m, paretic.forearm_m);
  EXPECT_EQ(arm_on_day(ArmTraits(), 5), ArmTraits()) << "the healthy are the same every day";
}

TEST(ArmReach, WhatAPostureReachedIsReachedAgain) {
  Random random(5);
  // The ridge leaves a hundredth of the hardest way, that to the person: of at most 0.2 m.
  constexpr double kLeft_m = 2e-3;
  constexpr double kLeft_rad = 1e-2;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const ArmBody body = person(seed);
    const Reach reach(drawn(*arm_traits("healthy"), seed), body);
    for (int trial = 0; trial < 40; ++trial) {
      // Within half of the ranges: of the rest somebody else would have to be asked.
      const Joints q = body.rest + 0.5 * (random_posture(body, random) - body.rest);
      const Pose goal = body.poses_W(q)[index_of(Segment::object)];
      const Joints found = reach.posture_for(goal);
      const Pose X_WO = body.poses_W(found)[index_of(Segment::object)];
      EXPECT_WITHIN((X_WO.p - goal.p).norm(), 0.0, kLeft_m);
      EXPECT_WITHIN(angle_between(X_WO.q, goal.q), 0.0, kLeft_rad);
    }
  }
}

TEST(ArmReach, NoJointLeavesItsRangeWhereverTheTargetIs) {
  Random random(6);
  const ArmTraits traits = drawn(*arm_traits("paretic"), 1);
  Random placing(1, 201);
  const ArmBody body(traits, placing, Hand::right);
  const Reach reach(traits, body);
  for (int trial = 0; trial < 200; ++trial) {
    Pose goal = body.poses_W(random_posture(body, random))[index_of(Segment::object)];
    goal.p += Vec3(random.gaussian(), random.gaussian(), random.gaussian());
    const Joints q = reach.posture_for(goal);
    ASSERT_TRUE(q.allFinite());
    for (int k = 0; k < kJoints; ++k)
      ASSERT_TRUE(q[k] >= body.least[k] && q[k] <= body.most[k]) << k;
  }
}

TEST(ArmReach, ATurnAboutTheForearmIsSharedAsTheTraitsSay) {
  const ArmBody body = average_arm();
  for (const double fingers : {0.1, 0.35, 0.8}) {
    ArmTraits traits;
    traits.finger_share = fingers;
    const Reach reach(traits, body);
    Joints q = body.rest;
    const double whole_rad = -0.6;
    const double part = fingers / (fingers + traits.forearm_share);
    q[joint::pronation] += (1.0 - part) * whole_rad;
    q[joint::turn_z] += part * whole_rad;
    const Joints found = reach.posture_for(body.poses_W(q)[index_of(Segment::object)]);
    const double forearm_rad = found[joint::pronation] - body.rest[joint::pronation];
    // The object lies 3 cm beside the axis of the forearm, so that its place, too, asks something
    // of every joint.
    constexpr double kShare = 0.01;
    EXPECT_WITHIN(found[joint::turn_z] / (found[joint::turn_z] + forearm_rad), part, kShare);
  }
}

TEST(ArmReach, NothingIsAllocated) {
  const ArmBody body = person(1);
  const Reach reach(*arm_traits("healthy"), body);
  const Pose goal = body.poses_W(0.7 * body.rest)[index_of(Segment::object)];
  const auto before = allocations();
  const Joints q = reach.posture_for(goal);
  EXPECT_EQ(allocations(), before);
  EXPECT_TRUE(q.allFinite());
}

}  // namespace
}  // namespace isograsp::virtual_patient::arm_body_test
