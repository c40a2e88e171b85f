// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/demonstration.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "session/library/library.hpp"
#include "tasks/kinds/force/force_tracking.hpp"
#include "tests/support/every.hpp"
#include "tests/support/platform_tasks.hpp"

namespace isograsp::session::demonstration_test {
namespace {

const std::string kLibrary = std::string(ISOGRASP_SOURCE_DIR) + "/library";

tasks::TaskSpec task(const std::string& name) {
  return load_task(find_in_library(kLibrary, "tasks", name).value()).value();
}

TEST(Demonstration, OfEveryTaskOfTheLibraryIsDoneByAHealthyHand) {
  for (const tasks::TaskSpec& spec : test::every(test::platform_tasks(kLibrary))) {
    const auto shown = demonstrate(spec, {.hand = Hand::left}, kLibrary);
    ASSERT_TRUE(shown.ok()) << spec.name << ": " << shown.error().message();
    EXPECT_GT(static_cast<double>(shown->frames.size()) * shown->period_s, 2.0) << spec.name;
    EXPECT_LE(static_cast<double>(shown->frames.size()) * shown->period_s, kLongestDemonstration_s)
        << spec.name;
    EXPECT_EQ(shown->scene != nullptr, !spec.scene().empty()) << spec.name;
  }
}

/// Tasks of the library for an arm that a screen can show.
std::vector<tasks::TaskSpec> arm_tasks() {
  std::vector<tasks::TaskSpec> specs;
  for (const char* name : {"arm_familiarisation", "arm_follow", "arm_follow_half", "arm_own_range",
                           "arm_range_deviation", "arm_range_flexion", "arm_range_forearm",
                           "arm_screw", "arm_screw_half", "arm_wrist"})
    specs.push_back(task(name));
  return specs;
}

/// What was measured of a patient's forearm.
DemonstrationFor patient(Hand hand) {
  constexpr double kLeast_rad = -0.5;
  constexpr double kLargest_rad = 0.4;
  return {.hand = hand, .ranges = {{"forearm", 2, kLeast_rad, kLargest_rad}}};
}

TEST(Demonstration, OfEveryTaskOfAnArmIsDoneByAHealthyArm) {
  for (const Hand hand : {Hand::right, Hand::left})
    for (const tasks::TaskSpec& spec : test::every(arm_tasks())) {
      EXPECT_TRUE(why_not_shown(spec).empty()) << spec.name;
      const auto shown = demonstrate(spec, patient(hand), kLibrary);
      ASSERT_TRUE(shown.ok()) << spec.name << ": " << shown.error().message();
      ASSERT_TRUE(shown->arm.has_value()) << spec.name;
      EXPECT_FALSE(shown->arm->object_m.empty()) << "the object can be drawn";
      EXPECT_TRUE(shown->frames.empty()) << "no forces";
      const double lasts_s = static_cast<double>(shown->size()) * shown->period_s;
      EXPECT_GT(lasts_s, 5.0) << spec.name;
      EXPECT_LE(lasts_s, kLongestDemonstration_s) << spec.name;
      for (const ArmSnapshot& frame : test::every(shown->arm_frames)) {
        ASSERT_EQ(frame.stage, Stage::trial) << spec.name << ": a pause is no part of it";
        ASSERT_TRUE(frame.start_p_WO.allFinite()) << spec.name << ": the middle of the picture";
      }
      const ArmSnapshot& last = shown->arm_frames.back();
      if (spec.kind->name == "pose_matching") {
        EXPECT_GE(last.task.targets_reached, 3) << spec.name;
      } else if (spec.kind->name == "active_range") {
        constexpr double kHealthy_rad = 0.5;  // the smallest, of a wrist that tilts
        EXPECT_GT(last.angle.largest_rad - last.angle.least_rad, kHealthy_rad) << spec.name;
      }
    }
}

TEST(Demonstration, AnArmKeepsItsObjectOnAReferenceThatMoves) {
  const auto shown = demonstrate(task("arm_follow"), {}, kLibrary).value();
  double error_m = 0.0;
  int followed = 0;
  for (const ArmSnapshot& frame : shown.arm_frames) {
    if (frame.task.phase != tasks::Phase::active || !frame.special.arm().reference_shown) continue;
    error_m += (frame.last_X_WO.p - frame.special.arm().X_WR.p).norm();
    ++followed;
  }
  ASSERT_GT(followed, 1000);
  EXPECT_LT(error_m / followed, 0.02);
}

TEST(Demonstration, OfAnArmIsTheSameEachTime) {
  const auto shown = demonstrate(task("arm_screw"), {}, kLibrary).value();
  const auto again = demonstrate(task("arm_screw"), {}, kLibrary).value();
  ASSERT_EQ(shown.arm_frames.size(), again.arm_frames.size());
  for (std::size_t k = 0; k < shown.arm_frames.size(); ++k)
    EXPECT_EQ(shown.arm_frames[k].last_X_WO.p, again.arm_frames[k].last_X_WO.p);
}

TEST(Demonstration, ATaskWithinTheOwnRangeIsShownWithThePatientsRangeAndNotBeforeItIsKnown) {
  const auto unknown = demonstrate(task("arm_own_range"), {}, kLibrary);
  ASSERT_FALSE(unknown.ok());
  EXPECT_NE(unknown.error().message().find("has not been measured"), std::string::npos)
      << unknown.error().message();
  const auto farthest_rad = [&](double largest_rad) {
    DemonstrationFor whom;
    whom.ranges = {{"forearm", 2, -largest_rad, largest_rad}};
    const auto shown = demonstrate(task("arm_own_range"), whom, kLibrary).value();
    double most_rad = 0.0;
    for (const ArmSnapshot& frame : shown.arm_frames)
      if (frame.special.arm().reference_shown)
        most_rad = std::max(most_rad, angle_between(shown.arm_frames.front().last_X_WO.q,
                                                    frame.special.arm().X_WR.q));
    return most_rad;
  };
  EXPECT_LT(farthest_rad(0.4), farthest_rad(0.8));
}

TEST(Demonstration, OfEveryTaskOfATrackedHandIsDoneByAHealthyHand) {
  for (const Hand hand : {Hand::right, Hand::left})
    for (const char* name : {"hand_opening", "virtual_place", "virtual_place_first"}) {
      const tasks::TaskSpec spec = task(name);
      EXPECT_TRUE(why_not_shown(spec).empty()) << name;
      const auto shown = demonstrate(spec, {.hand = hand}, kLibrary);
      ASSERT_TRUE(shown.ok()) << name << ": " << shown.error().message();
      EXPECT_TRUE(shown->frames.empty() && shown->arm_frames.empty()) << name;
      const double lasts_s = static_cast<double>(shown->size()) * shown->period_s;
      EXPECT_GT(lasts_s, 5.0) << name;
      EXPECT_LE(lasts_s, kLongestOfHand_s) << name;
      for (const HandSnapshot& frame : test::every(shown->hand_frames))
        ASSERT_EQ(frame.stage, Stage::trial) << name << ": a pause is no part of it";
      const HandSnapshot& last = shown->hand_frames.back();
      EXPECT_TRUE(last.seen_hand.has_value()) << name;
      EXPECT_GE(last.task.targets_reached, 1) << name << ": what is asked is seen done";
    }
}

TEST(Demonstration, OfAThingThatNoScreenShowsThereIsNone) {
  const auto drinking = task("arm_drinking");
  EXPECT_FALSE(why_not_shown(drinking).empty());
  EXPECT_FALSE(demonstrate(drinking, {}, kLibrary).ok());
  EXPECT_TRUE(why_not_shown(task("grip_sine")).empty());
}

TEST(Demonstration, TheTargetsAreThoseOfThePatient) {
  tasks::ForceReferences references;
  references.maximum_N[{}] = 7.0;
  const auto highest_N = [](const Demonstration& shown) {
    double most_N = 0.0;
    for (const Snapshot& frame : shown.frames)
      most_N = std::max(most_N, frame.special.force().target_force_N);
    return most_N;
  };
  const tasks::TaskSpec spec = task("grip_sine");
  const double of_patient_N = highest_N(*demonstrate(spec, {.references = references}, kLibrary));
  const auto& tracking = spec.kind.as<tasks::ForceTrackingSpec>();
  EXPECT_NEAR(of_patient_N, tracking.most * 7.0, 0.01);
  EXPECT_GT(highest_N(*demonstrate(spec, {}, kLibrary)), of_patient_N);
}

TEST(Demonstration, TheForceFollowsTheTargetAndTheSameIsShownEachTime) {
  const auto shown = demonstrate(task("grip_sine"), {}, kLibrary).value();
  const auto again = demonstrate(task("grip_sine"), {}, kLibrary).value();
  ASSERT_EQ(shown.frames.size(), again.frames.size());
  double error_N = 0.0;
  int active = 0;
  for (std::size_t k = 0; k < shown.frames.size(); ++k) {
    EXPECT_EQ(shown.frames[k].grip_N, again.frames[k].grip_N);
    if (shown.frames[k].task.phase != tasks::Phase::active) continue;
    error_N += std::abs(shown.frames[k].special.force().actual_force_N -
                        shown.frames[k].special.force().target_force_N);
    ++active;
  }
  ASSERT_GT(active, 1000);
  EXPECT_LT(error_N / active, 0.5) << "of targets up to 6 N";
}

}  // namespace
}  // namespace isograsp::session::demonstration_test
