// SPDX-License-Identifier: GPL-3.0-or-later
// Force closure without allocation against the house's own, which rests on other mathematics;
// limits from reachable grasps.
#include "virtual_hand/contact_maps.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "grasp_model/grasp.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"
#include "tests/virtual_hand/support.hpp"
#include "virtual_hand/reachable_grasps.hpp"
#include "virtual_hand/study_plan.hpp"
#include "virtual_hand/tip_reach.hpp"

namespace isograsp::contact_maps_test {
namespace {

using namespace isograsp::test;
using namespace isograsp::virtual_hand;

Vec3 any_direction(Random& random) {
  const double x = random.gaussian();
  const double y = random.gaussian();
  return Vec3(x, y, random.gaussian()).normalized();
}

/// Contacts on a ball, roughly into it.
std::vector<DigitContact> any_contacts(Random& random, std::size_t count) {
  constexpr double kRadius_m = 0.02;
  constexpr double kAskew = 0.6;
  std::vector<DigitContact> contacts;
  for (std::size_t k = 0; k < count; ++k) {
    DigitContact contact;
    contact.digit = static_cast<Digit>(k);
    const Vec3 out = any_direction(random);
    contact.p_OC = kRadius_m * out;
    const Vec3 normal = (kAskew * random.uniform() * any_direction(random) - out).normalized();
    const Vec3 tangent = normal.unitOrthogonal();
    contact.R_OC << tangent, normal.cross(tangent), normal;
    contacts.push_back(contact);
  }
  return contacts;
}

struct Maps {
  std::vector<ContactMaps> of;
  ContactSet set;
  explicit Maps(const std::vector<DigitContact>& contacts) {
    const HandModel hand = golden_hand("hand_default");
    HandPose pose;
    pose.angles = angles_at_ease();
    const HandInSpace space = hand_in_space(hand, pose);
    for (const DigitContact& contact : contacts) of.push_back(contact_maps(contact, space, Pose()));
    for (const ContactMaps& maps : of) set.contacts[set.count++] = &maps;
  }
};

bool house_closes(const std::vector<DigitContact>& contacts, const PadFriction& friction) {
  std::vector<Contact> all;
  for (const DigitContact& contact : contacts) {
    Contact one;
    one.p_OC = contact.p_OC;
    one.R_OC = contact.R_OC;
    one.model = ContactModel::soft;
    one.friction = friction.friction;
    one.torsion_m = friction.friction * friction.torsion_m();
    all.push_back(one);
  }
  return force_closure(all, {0, 1, 2, 3, 4, 5});
}

TEST(ContactMaps, ClosesWhereTheLinearProgramsOfTheHouseDo) {
  Random random(311);
  constexpr int kGrasps = 1500;
  // Nearer to the threshold than this either answer will do.
  constexpr double kNear = 1e-6;
  for (const std::size_t count : {std::size_t{2}, std::size_t{3}}) {
    AtLeast closed(100);
    AtLeast open(100);
    for (int k = 0; k < kGrasps; ++k) {
      const auto contacts = any_contacts(random, count);
      const PadFriction friction{0.2 + 1.2 * random.uniform(), 0.005};
      const Maps maps(contacts);
      const bool ours = closes(maps.set, friction);
      ++(ours ? closed : open);
      if (ours == house_closes(contacts, friction)) continue;
      const PadFriction less{friction.friction * (1.0 - kNear), friction.patch_radius_m};
      const PadFriction more{friction.friction * (1.0 + kNear), friction.patch_radius_m};
      EXPECT_FALSE(house_closes(contacts, less)) << count << " " << k;
      EXPECT_TRUE(house_closes(contacts, more)) << count << " " << k;
    }
  }
}

TEST(ContactMaps, MoreFrictionNeverOpensAGrasp) {
  Random random(312);
  AtLeast both(50);
  for (int k = 0; k < 300; ++k) {
    const Maps maps(any_contacts(random, 3));
    bool before = false;
    bool changes = false;
    for (double friction = 0.05; friction < 3.0; friction *= 1.1) {
      const bool now = closes(maps.set, {friction, 0.005});
      EXPECT_TRUE(now || !before) << k << " at " << friction;
      changes = changes || (now && !before);
      before = now;
    }
    if (changes) ++both;
  }
}

TEST(ContactMaps, TheBestGraspOfFiveDigitsIsFoundWithoutAllocation) {
  Random random(313);
  const HandModel hand = golden_hand("hand_default");
  HandPose pose;
  pose.angles = angles_at_ease();
  const HandInSpace space = hand_in_space(hand, pose);
  const double scale_m = hand_scale_m(hand);
  AtLeast feasible(10);
  for (int k = 0; k < 50; ++k) {
    const auto contacts = any_contacts(random, kDigitCount);
    const auto before = allocations();
    const GraspChoice choice =
        feasible_grasp(contacts, space, Pose(), scale_m, {}, {0.0, 0.0, 0.0, 0.0, 0.0, true});
    EXPECT_EQ(allocations(), before);
    if (choice.feasible) ++feasible;
  }
}

TEST(ReachableGrasps, AreTheSameForOneSeedAndReachTheObject) {
  const HandModel hand = golden_hand("hand_default");
  for (const auto& object : every(study_objects())) {
    const auto once = reachable_grasps(hand, object.shape, 2, 20, 5);
    const auto again = reachable_grasps(hand, object.shape, 2, 20, 5);
    EXPECT_EQ(once.size(), 20U) << object.name;
    ASSERT_EQ(once.size(), again.size());
    for (std::size_t k = 0; k < once.size(); ++k)
      EXPECT_EQ(once[k].G.least, again[k].G.least) << object.name;
  }
}

GraspCriteria made(double G_min, double H, bool closed) {
  GraspCriteria grasp;
  grasp.G.least = G_min;
  grasp.H.least = grasp.H.product = H;
  grasp.force_closure = closed;
  return grasp;
}

TEST(ReachableGrasps, LimitsPartThoseThatCloseFromThoseThatDoNot) {
  std::vector<GraspCriteria> grasps;
  for (int k = 0; k < 40; ++k) {
    grasps.push_back(made(0.5 + 0.01 * k, 1.0 + k, true));
    grasps.push_back(made(0.4 - 0.01 * k, 1.0 + k, false));
  }
  const Separation parts = separation_of(grasps);
  EXPECT_EQ(parts.closed, 40U);
  EXPECT_EQ(parts.open, 40U);
  EXPECT_EQ(parts.G_min, 1.0);
  EXPECT_EQ(parts.H_min, 0.5) << "the same for both tells nothing";
  const FoundLimits limits = limits_from(grasps);
  EXPECT_EQ(limits.G_min, 0.5);
  EXPECT_EQ(limits.H_min, 3.0) << "a twentieth of forty lie below";
  EXPECT_TRUE(std::isnan(separation_of(std::vector{made(1.0, 1.0, true)}).G_min));
  EXPECT_TRUE(std::isinf(limits_from(std::vector{made(1.0, 1.0, false)}).G_min));
}

TEST(TipReach, BringsTheTipWhereItCanAndStaysWithinTheLimits) {
  const HandModel hand = golden_hand("hand_default");
  Random random(314);
  constexpr double kThere_m = 1e-3;
  AtLeast reached(60);
  for (int k = 0; k < 100; ++k) {
    // A place where the tip has been.
    const auto digit = static_cast<Digit>(static_cast<int>(5.0 * random.uniform()));
    HandPose there;
    for (std::size_t a = 0; a < kAngleCount; ++a) {
      const AngleRange& limit = hand.digit(digit).limits[a];
      there.angles[index_of(digit)][a] =
          limit.least + (limit.most - limit.least) * random.uniform();
    }
    const Vec3 goal = hand_in_space(hand, there).digit(digit).joints[kLinkCount];
    HandPose pose;
    pose.angles = angles_at_ease();
    if (reach_with_tip(hand, pose, digit, goal, 40) < kThere_m) ++reached;
    for (std::size_t a = 0; a < kAngleCount; ++a) {
      EXPECT_GE(pose.angles[index_of(digit)][a], hand.digit(digit).limits[a].least);
      EXPECT_LE(pose.angles[index_of(digit)][a], hand.digit(digit).limits[a].most);
    }
  }
}

}  // namespace
}  // namespace isograsp::contact_maps_test
