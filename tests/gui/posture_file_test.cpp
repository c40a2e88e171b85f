// SPDX-License-Identifier: GPL-3.0-or-later
// Files of postures without a window: how they change, how they are drawn, how a posture of the
// connected arm becomes one.
#include "gui/library/posture_file.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "core/files.hpp"
#include "core/random.hpp"
#include "gui/library_pages/posture_scene.hpp"
#include "gui/library_pages/posture_take.hpp"
#include "kinematics/posture_edit.hpp"
#include "session/arm/start_posture.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/within.hpp"

namespace isograsp::gui::test::posture_file_test {
namespace {

using isograsp::test::every;
using isograsp::test::must;

const std::string kLibrary = std::string(ISOGRASP_SOURCE_DIR) + "/library";
constexpr double kRounding = 1e-12;

PostureFile shipped(const std::string& name) {
  const auto path = kLibrary + "/postures/" + name + ".toml";
  return must(read_posture_file(must(read_text(path)), path));
}

TEST(PostureFile, IsWrittenAsItWasReadWithTheCommentsInItsHead) {
  for (const char* name : {"screw", "forearm_and_wrist"}) {
    const auto path = kLibrary + "/postures/" + name + ".toml";
    const auto text = must(read_text(path));
    EXPECT_EQ(posture_file_text(must(read_posture_file(text, path))), text) << name;
  }
  EXPECT_FALSE(read_posture_file("# nothing\n", "a.toml").ok());
}

TEST(PostureFile, EveryPostureHasANameOfItsOwnWhateverIsAdded) {
  Postures postures = shipped("screw").postures;
  for (int i = 0; i < 3; ++i) postures = with_added(postures, 1, postures.postures[1]);
  std::vector<std::string> names;
  for (const Posture& posture : postures.postures) names.push_back(posture.name);
  EXPECT_EQ(names, (std::vector<std::string>{"initial", "unscrew", "unscrew 4", "unscrew 3",
                                             "unscrew 2", "screw"}));
  EXPECT_TRUE(parse_postures(postures_text(postures), "a.toml").ok());
}

TEST(PostureFile, ANameThatIsEmptyOrAnothersIsRefused) {
  const Postures postures = shipped("screw").postures;
  EXPECT_FALSE(with_renamed(postures, 1, "").ok());
  EXPECT_FALSE(with_renamed(postures, 1, "screw").ok());
  EXPECT_TRUE(with_renamed(postures, 1, "unscrew").ok()) << "its own";
  EXPECT_EQ(must(with_renamed(postures, 1, "out")).postures[1].name, "out");
}

TEST(PostureFile, TheInitialPostureStays) {
  const Postures postures = shipped("screw").postures;
  EXPECT_FALSE(without(postures, 0).ok());
  const Postures fewer = must(without(postures, 1));
  ASSERT_EQ(fewer.postures.size(), 2U);
  EXPECT_EQ(fewer.postures[1].name, "screw");
}

TEST(PostureScene, DrawsTheObjectInTheSizeThatItsRigSays) {
  const Postures postures = shipped("screw").postures;
  const PostureScene scene(kLibrary, postures.chain);
  const auto rig = must(session::ArmRig::load("kurillo15", kLibrary, Hand::right, ""));
  const ArmSpace of_rig(session::setup_of(rig, {}), Hand::right);
  EXPECT_EQ(scene.space()->box()->size_m, of_rig.box()->size_m);
  const PostureScene unknown(kLibrary, {"a", "b"});
  EXPECT_GT(unknown.space()->box()->size_m.minCoeff(), 0.0) << "something is drawn all the same";
}

TEST(PostureScene, ThePatientSeesTheObjectAtTheStartAndThePostureAsItsTarget) {
  const Postures postures = shipped("screw").postures;
  const PostureScene scene(kLibrary, postures.chain);
  const auto start = scene.picture_of(postures, 0);
  EXPECT_TRUE(start.object_shown);
  EXPECT_FALSE(start.target_shown) << "it is there already";
  for (std::size_t j = 1; j < postures.postures.size(); ++j) {
    const auto picture = scene.picture_of(postures, j);
    EXPECT_EQ(picture.X_WO.p, start.X_WO.p);
    EXPECT_TRUE(picture.target_shown);
    // The target is as far turned from the object as the posture turns it.
    const auto object = [&](std::size_t k) {
      return scene.segments_W(postures.postures[k]).back();
    };
    EXPECT_WITHIN(angle_between(picture.X_WO.q, picture.X_WT.q),
                  angle_between(object(0).q, object(j).q), kRounding);
  }
}

TEST(PostureScene, TheArmIsThatOfTheChosenPostureAndTheDashedObjectThatOfTheInitialOne) {
  const Postures postures = shipped("forearm_and_wrist").postures;
  const PostureScene scene(kLibrary, postures.chain);
  const auto initial = scene.arm_in(postures, 0);
  for (std::size_t j = 1; j < postures.postures.size(); ++j) {
    const auto arm = scene.arm_in(postures, j);
    const auto X_W = scene.segments_W(postures.postures[j]);
    for (std::size_t k = 0; k < session::kArmChain.size(); ++k)
      EXPECT_EQ(arm.segment(session::kArmChain[k]).X_W.p, X_W[k].p);
    EXPECT_EQ(arm.special.arm().X_WR.p, initial.segment(ArmSegment::object).X_W.p);
  }
}

/// A frame of an arm whose object has moved by `off_m`.
session::ArmSnapshot frame_at(double t_s, double off_m, bool seen = true) {
  session::ArmSnapshot now;
  now.frames = 1;
  now.session_time_s = t_s;
  for (std::size_t k = 0; k < session::kArmChain.size(); ++k) {
    FramePose& segment = now.segments[index_of(session::kArmChain[k])];
    segment.state = seen ? FrameState::ok : FrameState::few;
    segment.X_W = {Vec3(0.0, 0.1 * static_cast<double>(k), k == 3 ? off_m : 0.0),
                   turn_about(EditAxis::z, 0.2 * static_cast<double>(k)).q};
  }
  return now;
}

constexpr double kPoll_s = 1.0 / 60.0;

TEST(PostureTake, IsTheMeanOfOneSecondInWhichTheArmWasStill) {
  PostureTake take;
  EXPECT_FALSE(take.add(frame_at(0.0, 0.0))) << "nobody asked";
  take.begin();
  constexpr double kAway_m = 0.001;
  double t_s = 5.0;
  int k = 0;
  while (take.running() && t_s < 20.0) {
    static_cast<void>(take.add(frame_at(t_s, k % 2 == 0 ? kAway_m : -kAway_m)));
    t_s += kPoll_s;
    ++k;
  }
  ASSERT_EQ(take.state(), PostureTake::State::taken);
  EXPECT_WITHIN(t_s - 5.0, 1.0, 2.0 * kPoll_s);
  const auto links = take.links();
  ASSERT_EQ(links.size(), 3U);
  for (const Pose& X_L : links) EXPECT_WITHIN(rotation_vector(X_L.q).norm(), 0.2, kRounding);
  EXPECT_WITHIN(links[0].p.norm(), 0.1, kRounding);
  constexpr double kOneRow = 0.02;  // SD of n - 1 rows, some sixty of them
  EXPECT_WITHIN(take.sd_m(), kAway_m, kOneRow * kAway_m);
}

TEST(PostureTake, AnArmThatMovesIsRefusedAndOneThatIsNotSeenIsWaitedForATime) {
  PostureTake take;
  take.begin();
  for (double t_s = 0.0; take.running() && t_s < 20.0; t_s += kPoll_s)
    static_cast<void>(take.add(frame_at(t_s, 0.05 * t_s)));
  EXPECT_EQ(take.state(), PostureTake::State::moved);
  EXPECT_GT(take.sd_m(), session::StartPostureLimits{}.largest_sd_m);
  take.begin();
  double t_s = 0.0;
  for (; take.running() && t_s < 20.0; t_s += kPoll_s)
    static_cast<void>(take.add(frame_at(t_s, 0.0, std::fmod(t_s, 0.9) > kPoll_s)));
  EXPECT_EQ(take.state(), PostureTake::State::not_seen) << "never for a second on end";
  EXPECT_WITHIN(t_s, session::StartPostureLimits{}.longest_s, 2.0 * kPoll_s);
}

}  // namespace
}  // namespace isograsp::gui::test::posture_file_test
