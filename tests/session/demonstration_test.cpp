// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/demonstration.hpp"

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
    const auto shown = demonstrate(spec, {}, Hand::left, kLibrary);
    ASSERT_TRUE(shown.ok()) << spec.name << ": " << shown.error().message();
    EXPECT_GT(static_cast<double>(shown->frames.size()) * shown->period_s, 2.0) << spec.name;
    EXPECT_LE(static_cast<double>(shown->frames.size()) * shown->period_s, kLongestDemonstration_s)
        << spec.name;
    EXPECT_EQ(shown->scene != nullptr, !spec.scene().empty()) << spec.name;
  }
}

TEST(Demonstration, WhatAHandOnThePlatformCannotDoIsRefused) {
  EXPECT_FALSE(demonstrate(task("arm_screw"), {}, Hand::right, kLibrary));
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
  const double of_patient_N = highest_N(*demonstrate(spec, references, Hand::right, kLibrary));
  const auto& tracking = spec.kind.as<tasks::ForceTrackingSpec>();
  EXPECT_NEAR(of_patient_N, tracking.most * 7.0, 0.01);
  EXPECT_GT(highest_N(*demonstrate(spec, {}, Hand::right, kLibrary)), of_patient_N);
}

TEST(Demonstration, TheForceFollowsTheTargetAndTheSameIsShownEachTime) {
  const auto shown = demonstrate(task("grip_sine"), {}, Hand::right, kLibrary).value();
  const auto again = demonstrate(task("grip_sine"), {}, Hand::right, kLibrary).value();
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
