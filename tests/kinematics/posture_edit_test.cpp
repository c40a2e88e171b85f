// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of changing postures by hand.
#include "kinematics/posture_edit.hpp"

#include <numbers>

#include "tests/kinematics/support.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::posture_edit_test {
namespace {

using namespace isograsp::test;

/// Of a few products of unit quaternions and of lengths up to 2 m.
constexpr double kRounding = 1e-14;

Posture random_posture(Random& random) {
  Posture posture{"any", {}};
  for (int l = 0; l < 3; ++l) posture.X_L.push_back(random_pose(random));
  return posture;
}

void expect_same(const Posture& a, const Posture& b, double within = kRounding) {
  ASSERT_EQ(a.X_L.size(), b.X_L.size());
  for (std::size_t l = 0; l < a.X_L.size(); ++l) {
    EXPECT_WITHIN((a.X_L[l].p - b.X_L[l].p).norm(), 0.0, within);
    EXPECT_WITHIN(angle_between(a.X_L[l].q, b.X_L[l].q), 0.0, within);
  }
}

Pose end_of(const Posture& posture) {
  Pose X_WO;
  for (const Pose& X_L : posture.X_L) X_WO = compose(X_WO, X_L);
  return X_WO;
}

constexpr std::array kBoth{EditAxes::own, EditAxes::before};
constexpr std::array kAxes{EditAxis::x, EditAxis::y, EditAxis::z};

TEST(PostureEdit, ATurnAndAShiftAndTheSameBackAreNothing) {
  Random random(31);
  for (int i = 0; i < 100; ++i) {
    const Posture posture = random_posture(random);
    const double angle_rad = std::numbers::pi * (2.0 * random.uniform() - 1.0);
    const double way_m = 2.0 * random.uniform() - 1.0;
    for (const EditAxes axes : kBoth)
      for (const EditAxis axis : kAxes)
        for (std::size_t l = 0; l < 3; ++l) {
          const auto changed = [&](const Posture& from, const Pose& T) {
            return with_link_changed(from, l, T, axes);
          };
          expect_same(
              changed(changed(posture, turn_about(axis, angle_rad)), turn_about(axis, -angle_rad)),
              posture);
          expect_same(
              changed(changed(posture, shift_along(axis, way_m)), shift_along(axis, -way_m)),
              posture);
        }
  }
}

TEST(PostureEdit, OneLinkChangesByWhatWasAskedAndTheOthersStayAsTheyAre) {
  Random random(32);
  for (int i = 0; i < 100; ++i) {
    const Posture posture = random_posture(random);
    for (const EditAxes axes : kBoth)
      for (const EditAxis axis : kAxes)
        for (std::size_t l = 0; l < 3; ++l) {
          const Posture turned = with_link_changed(posture, l, turn_about(axis, 0.4), axes);
          const Posture moved = with_link_changed(posture, l, shift_along(axis, 0.03), axes);
          EXPECT_WITHIN(changes_from(posture, turned)[l].angle_rad, 0.4, kRounding);
          EXPECT_WITHIN(changes_from(posture, moved)[l].angle_rad, 0.0, kRounding);
          EXPECT_WITHIN(changes_from(posture, moved)[l].distance_m, 0.03, kRounding);
          if (axes == EditAxes::own) {
            EXPECT_EQ(turned.X_L[l].p, posture.X_L[l].p) << "about its own origin";
          }
          for (std::size_t other = 0; other < 3; ++other) {
            if (other == l) continue;
            EXPECT_EQ(turned.X_L[other].p, posture.X_L[other].p);
            EXPECT_EQ(turned.X_L[other].q.coeffs(), posture.X_L[other].q.coeffs());
          }
        }
  }
}

TEST(PostureEdit, TheAxesOfTheSegmentBeforeAreThoseOfTheLinkBeforeItself) {
  Random random(33);
  for (int i = 0; i < 100; ++i) {
    const Posture posture = random_posture(random);
    const Pose T{random_vector(random, 0.1), random_attitude(random)};
    for (std::size_t l = 1; l < 3; ++l) {
      // T between two links belongs to either of them.
      const Pose behind = end_of(with_link_changed(posture, l, T, EditAxes::before));
      const Pose in_front = end_of(with_link_changed(posture, l - 1, T, EditAxes::own));
      EXPECT_WITHIN((behind.p - in_front.p).norm(), 0.0, kRounding);
      EXPECT_WITHIN(angle_between(behind.q, in_front.q), 0.0, kRounding);
    }
  }
}

TEST(PostureEdit, LinksStayPosesAfterAnyNumberOfChanges) {
  Random random(34);
  Posture posture = random_posture(random);
  constexpr int kChanges = 10000;
  for (int i = 0; i < kChanges; ++i)
    posture = with_link_changed(std::move(posture), static_cast<std::size_t>(i) % 3,
                                {random_vector(random, 1e-3),
                                 turn_about(kAxes[static_cast<std::size_t>(i / 3) % 3], 0.1).q},
                                kBoth[static_cast<std::size_t>(i) % 2]);
  constexpr double kUnit = 1e-15;  // what a file takes as a unit quaternion
  for (const Pose& X_L : test::every(posture.X_L)) {
    EXPECT_TRUE(X_L.p.allFinite());
    EXPECT_WITHIN(X_L.q.norm(), 1.0, kUnit);
  }
}

TEST(PostureEdit, PartOfTheWayBeginsAtTheInitialOneAndEndsAtThePosture) {
  Random random(35);
  for (int i = 0; i < 100; ++i) {
    const Posture initial = random_posture(random);
    const Posture posture = random_posture(random);
    expect_same(part_of_the_way(initial, posture, 0.0), initial);
    expect_same(part_of_the_way(initial, posture, 1.0), posture);
    const auto whole = changes_from(initial, posture);
    for (const double way : {0.25, 0.5, 0.75}) {
      const auto part = changes_from(initial, part_of_the_way(initial, posture, way));
      for (std::size_t l = 0; l < 3; ++l) {
        EXPECT_WITHIN(part[l].angle_rad, way * whole[l].angle_rad, kRounding);
        EXPECT_WITHIN(part[l].distance_m, way * whole[l].distance_m, kRounding);
      }
    }
    EXPECT_EQ(part_of_the_way(initial, posture, 0.5).name, posture.name);
  }
}

TEST(PostureEdit, WhatIsWrittenIsReadBackToTheSameBits) {
  Random random(36);
  for (int i = 0; i < 100; ++i) {
    Postures library;
    library.chain = {"E", "F", "D", "O"};
    Posture initial = random_posture(random);
    Posture turned =
        with_link_changed(initial, 1, turn_about(EditAxis::y, random.uniform()), EditAxes::own);
    Posture half = part_of_the_way(initial, random_posture(random), 0.5);
    initial.name = "initial";
    turned.name = "turned \"a\"";
    half.name = "half";
    library.postures = {initial, turned, half};
    const Postures back = must(parse_postures(postures_text(library), "own.toml"));
    for (std::size_t j = 1; j < library.postures.size(); ++j)  // the initial one is as it was drawn
      for (std::size_t l = 0; l < 3; ++l) {
        EXPECT_EQ(back.postures[j].X_L[l].p, library.postures[j].X_L[l].p);
        EXPECT_EQ(back.postures[j].X_L[l].q.coeffs(), library.postures[j].X_L[l].q.coeffs());
      }
    EXPECT_EQ(back.postures[1].name, turned.name);
  }
}

}  // namespace
}  // namespace isograsp::posture_edit_test
