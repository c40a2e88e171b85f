// SPDX-License-Identifier: GPL-3.0-or-later
// A person in software before a tracker of hands: what they see and do, what the tracker makes of
// it, and placements with the world of contacts around them.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "hand_world/placement_run.hpp"
#include "kinematics/attitude.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"
#include "tests/virtual_hand/support.hpp"
#include "virtual_patient/hand/grip_shapes.hpp"
#include "virtual_patient/hand/seen_hand.hpp"
#include "virtual_patient/hand/virtual_grasper.hpp"

namespace isograsp::grasper_test {
namespace {

using namespace isograsp::test;
using namespace isograsp::virtual_patient;
using hand_world::AssistanceLevel;
using hand_world::PlacementResult;
using hand_world::PlacementRun;

constexpr double kPicture_s = 0.01;

virtual_hand::HandModel model() {
  return golden_hand("hand_default");
}
GraspTraits person(const char* name) {
  return grasp_traits(name).value();
}
/// Nothing that the tracker adds.
GraspTraits exact(GraspTraits traits) {
  traits.tracker_m = traits.wander_m = traits.lost_share = traits.size_error = 0.0;
  return traits;
}

double skin_gap(const HandFrame& hand) {
  const auto& digits = model().digits;
  return (hand.joints[joint_of(Digit::index, 3)] - hand.joints[joint_of(Digit::thumb, 3)]).norm() -
         digits[0].radii_m[2] - digits[1].radii_m[2];
}

Stimulus asked(Cue cue) {
  Stimulus picture;
  picture.cue = cue;
  return picture;
}
Stimulus object_at(const Pose& X_WO, const Pose& X_WT) {
  Stimulus picture = asked(Cue::move);
  picture.object_shown = picture.pose_target_shown = true;
  picture.virtual_object = ShownObject{ShownObject::Shape::box, {0.02, 0.02, 0.15}, false};
  picture.X_WO = X_WO;
  picture.X_WT = X_WT;
  return picture;
}
const Pose kLying{{0.0, 0.01, 0.0}, Quat(0.7071067811865476, 0.0, 0.7071067811865476, 0.0)};
const Pose kLifted{{0.1, 0.15, 0.0}, kLying.q};

/// Frames of `seconds` in front of one picture.
std::vector<HandFrame> watch(VirtualGrasper& grasper, const Stimulus& picture, double seconds,
                             double from_s = 0.0) {
  std::vector<HandFrame> frames;
  for (int k = 0; k * kPicture_s < seconds; ++k) {
    grasper.see(picture);
    frames.push_back(grasper.at(from_s + k * kPicture_s));
  }
  return frames;
}

TEST(VirtualGrasper, FingersCloseOnWhatIsNotThereNoFurtherThanTheirSkins) {
  GraspTraits strong = exact(person("healthy"));
  strong.squeeze_m = 0.03;
  VirtualGrasper grasper(model(), strong, 1);
  Stimulus picture = object_at(kLying, kLifted);
  picture.virtual_object->size_m = {0.01, 0.01, 0.02};
  double least_m = 1.0;
  for (const HandFrame& hand : every(watch(grasper, picture, 6.0)))
    least_m = std::min(least_m, skin_gap(hand));
  constexpr double kPosture_m = 0.001;  // tips are found to so much
  EXPECT_WITHIN(least_m, 0.0, kPosture_m);
}

TEST(VirtualGrasper, TheSameSeedGivesTheSameHandAndAnotherSeedAnother) {
  VirtualGrasper a(model(), person("paretic"), 4), b(model(), person("paretic"), 4),
      c(model(), person("paretic"), 5);
  const auto frames_a = watch(a, object_at(kLying, kLifted), 4.0);
  const auto frames_b = watch(b, object_at(kLying, kLifted), 4.0);
  const auto frames_c = watch(c, object_at(kLying, kLifted), 4.0);
  AtLeast different(100);
  for (std::size_t k = 0; k < frames_a.size(); ++k) {
    EXPECT_EQ(frames_a[k].tracked, frames_b[k].tracked);
    if (!frames_a[k].tracked) continue;
    EXPECT_EQ(frames_a[k].joints, frames_b[k].joints);
    if (frames_a[k].joints != frames_c[k].joints) ++different;
  }
}

TEST(VirtualGrasper, ALeftPersonIsTheReflectionOfTheRightOne) {
  VirtualGrasper right(model(), person("healthy"), 2, Hand::right);
  VirtualGrasper left(model(), person("healthy"), 2, Hand::left);
  const auto frames = watch(right, object_at(kLying, kLifted), 5.0);
  const auto other = watch(left, object_at(mirrored(kLying), mirrored(kLifted)), 5.0);
  constexpr double kRounding_m = 1e-9;
  AtLeast seen(300);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    EXPECT_EQ(other[k].side, Hand::left);
    if (!frames[k].tracked) continue;
    ++seen;
    for (std::size_t j = 0; j < kHandJointCount; ++j)
      EXPECT_WITHIN((mirrored(other[k].joints[j]) - frames[k].joints[j]).norm(), 0.0, kRounding_m);
  }
}

TEST(VirtualGrasper, SeesAndMovesWithoutAllocation) {
  VirtualGrasper grasper(model(), person("healthy"), 1);
  const Stimulus picture = object_at(kLying, kLifted);
  const auto before = allocations();
  for (int k = 0; k < 1500; ++k) {
    grasper.see(picture);
    static_cast<void>(grasper.at(k * kPicture_s));
  }
  EXPECT_EQ(allocations(), before);
}

TEST(VirtualGrasper, MovesOnlyAfterItHasSeenTheObject) {
  const GraspTraits traits = exact(person("healthy"));
  VirtualGrasper grasper(model(), traits, 1);
  const auto rest = watch(grasper, asked(Cue::relax), 2.0);
  const auto moving = watch(grasper, object_at(kLying, kLifted), 3.0, 2.0);
  const Vec3 at_rest = rest.back().joints[kWristJoint];
  const double late_s = traits.visual_delay_s + traits.reaction_s + traits.tracker_delay_s;
  constexpr double kMoved_m = 0.001;
  AtLeast moved(1);
  for (std::size_t k = 0; k < moving.size(); ++k) {
    const double way_m = (moving[k].joints[kWristJoint] - at_rest).norm();
    if (static_cast<double>(k) * kPicture_s < late_s) {
      EXPECT_WITHIN(way_m, 0.0, 1e-9) << k;
    }
    if (way_m > kMoved_m) ++moved;
  }
}

TEST(VirtualGrasper, OpensAndClosesWhereThatIsAskedFor) {
  for (const char* name : {"healthy", "paretic"}) {
    VirtualGrasper grasper(model(), exact(person(name)), 1);
    double now_s = 0.0;
    const auto after = [&](Cue cue) {
      const auto frames = watch(grasper, asked(cue), 5.0, now_s);
      now_s += 5.0;
      return skin_gap(frames.back());
    };
    constexpr double kNear_m = 0.003;
    static_cast<void>(after(Cue::relax));
    for (int k = 0; k < 3; ++k) {
      EXPECT_WITHIN(after(Cue::open), grasper.opening_m(), kNear_m) << name;
      EXPECT_WITHIN(after(Cue::close), 0.0, kNear_m) << name;
    }
  }
  EXPECT_LT(VirtualGrasper(model(), person("paretic"), 1).opening_m(),
            VirtualGrasper(model(), person("healthy"), 1).opening_m());
}

TEST(VirtualGrasper, APareticPersonIsSlowerAndOpensLess) {
  const auto reaches_s = [](const char* name) {
    VirtualGrasper grasper(model(), exact(person(name)), 1);
    const auto frames = watch(grasper, object_at(kLying, kLifted), 20.0);
    const auto there = std::find_if(frames.begin(), frames.end(), [](const HandFrame& frame) {
      return (frame.joints[joint_of(Digit::index, 3)] - kLying.p).norm() < 0.03;
    });
    return static_cast<double>(there - frames.begin()) * kPicture_s;
  };
  EXPECT_GT(reaches_s("paretic"), 1.5 * reaches_s("healthy"));
}

TEST(GripShapes, TheSkinIsAsFarApartAsItIsToBe) {
  for (const char* name : {"hand_default", "hand_small_left", "hand_large"})
    for (const Grip grip : {Grip::pinch, Grip::tripod}) {
      virtual_hand::HandModel hand = golden_hand(name);
      hand.side = Hand::right;
      const GripShapes shapes(hand, grip);
      EXPECT_GT(shapes.widest_m(), 0.08) << name << ": the widest object of the study";
      for (double gap_m = 0.0; gap_m <= shapes.widest_m(); gap_m += 0.0125) {
        const auto space = virtual_hand::hand_in_space(hand, {Pose(), shapes.at(gap_m).angles});
        const Vec3 way = space.digit(Digit::index).joints[3] - space.digit(Digit::thumb).joints[3];
        const double radii_m =
            hand.digit(Digit::index).radii_m[2] + hand.digit(Digit::thumb).radii_m[2];
        const double along_m = way.dot(GripShapes::q_PG() * Vec3::UnitX());
        constexpr double kMiss_m = 0.004;  // two tips, each within 2 mm
        EXPECT_WITHIN(along_m - radii_m, gap_m, kMiss_m) << name << " " << gap_m;
      }
    }
}

TEST(SeenHand, IsLostForTheShareAndAsLongAsItIsToBe) {
  const GraspTraits traits = person("healthy");
  SeenHand tracker(traits, 7);
  std::array<Vec3, kHandJointCount> joints;
  joints.fill(Vec3::Zero());
  constexpr int kFrames = 200000;
  int lost = 0;
  int on_end = 0;
  double longest_s = 0.0;
  Vec3 sum2 = Vec3::Zero();
  for (int k = 0; k < kFrames; ++k) {
    const HandFrame frame = tracker.look(joints, kPicture_s);
    on_end = frame.tracked ? 0 : on_end + 1;
    lost += frame.tracked ? 0 : 1;
    longest_s = std::max(longest_s, on_end * kPicture_s);
    if (frame.tracked) sum2 += frame.joints[joint_of(Digit::index, 3)].cwiseAbs2();
  }
  constexpr double kShare = 0.003;
  EXPECT_WITHIN(static_cast<double>(lost) / kFrames, traits.lost_share, kShare);
  EXPECT_LE(longest_s, traits.lost_most_s + 2.0 * kPicture_s);
  // Palm and digit wander independently, each joint has its noise.
  const double wanted_m = std::sqrt(2.0 * traits.wander_m * traits.wander_m +
                                    3.0 * traits.tracker_m * traits.tracker_m);
  EXPECT_WITHIN(std::sqrt(sum2.sum() / (kFrames - lost)), wanted_m, 0.1 * wanted_m);
}

TEST(SeenHand, TakesPeopleForLargerOrSmallerByAFewPerCent) {
  double least = 1.0;
  double most = 1.0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const double size = SeenHand(person("healthy"), seed).size();
    least = std::min(least, size);
    most = std::max(most, size);
  }
  EXPECT_GE(least, 0.95);
  EXPECT_LE(most, 1.05);
  EXPECT_LT(least, 0.97);
  EXPECT_GT(most, 1.03);
}

TEST(PlacementRun, APersonWhomTheTrackerSeesExactlyPlacesEveryObjectWithHelp) {
  for (const auto& object : every(virtual_hand::study_objects())) {
    VirtualGrasper grasper(model(), exact(person("healthy")), 1);
    PlacementRun run(model(), grasper);
    for (const std::size_t target : {std::size_t{0}, std::size_t{4}}) {
      const PlacementResult result =
          run.place(object, virtual_hand::targets_of(object.size)[target], AssistanceLevel::full);
      EXPECT_TRUE(result.score.completed) << object.name << " " << target;
      EXPECT_EQ(result.score.fails, 0) << object.name << " " << target;
      EXPECT_FALSE(result.helped) << object.name << " " << target;
      EXPECT_LE(result.held_open_s, 0.3) << object.name << " " << target;
    }
  }
}

TEST(PlacementRun, TheSamePersonGivesTheSameResult) {
  const auto once = [] {
    VirtualGrasper grasper(model(), person("healthy"), 3);
    PlacementRun run(model(), grasper);
    const auto& object = virtual_hand::study_objects()[4];
    return run.place(object, virtual_hand::targets_of(object.size)[1], AssistanceLevel::full);
  };
  const PlacementResult a = once();
  const PlacementResult b = once();
  EXPECT_EQ(a.score.hold_distance_m, b.score.hold_distance_m);
  EXPECT_EQ(a.score.manipulation_s, b.score.manipulation_s);
  EXPECT_EQ(a.release_s, b.release_s);
  EXPECT_EQ(a.residual_m_s, b.residual_m_s);
}

TEST(GraspTraits, AllPeopleAreWithinTheRangesOfTheirTraits) {
  for (const std::string_view name : every(grasper_names())) {
    const GraspTraits traits = grasp_traits(name).value();
    for (const GraspTraitField& field : every(grasp_trait_fields())) {
      EXPECT_GE(traits.*field.value, field.least) << name << " " << field.key;
      EXPECT_LE(traits.*field.value, field.most) << name << " " << field.key;
    }
  }
  EXPECT_FALSE(grasp_traits("nobody").has_value());
}

}  // namespace
}  // namespace isograsp::grasper_test
