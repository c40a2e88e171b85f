// SPDX-License-Identifier: GPL-3.0-or-later
// The guided check in the window: it hears what the session publishes, not every frame.
#include "gui/rules/guided_check.hpp"

#include <gtest/gtest.h>

#include "hand/anatomical_axes.hpp"

namespace isograsp::gui::guided_check_test {
namespace {

constexpr double kPeriod_s = 0.01;
constexpr int kFramesPerPoll = 2;

class GuidedCheckTest : public ::testing::Test {
 protected:
  /// Shows the forces for so long, poll by poll.
  void show(double duration_s) {
    const auto polls = static_cast<int>(duration_s / kPeriod_s) / kFramesPerPoll;
    for (int k = 0; k < polls; ++k) {
      snapshot_.frames += kFramesPerPoll;
      check_.look(snapshot_);
    }
  }
  Vec3& force(Finger finger) { return snapshot_.forces.wrench_C[index_of(finger)].force; }
  void let_go() {
    for (const Finger finger : kFingers) force(finger) = Vec3::Zero();
    show(0.5);
  }
  /// Does what is asked for with `hand`'s idea of where the wrist is.
  void press(const CheckStep& step, Hand hand) {
    constexpr double kPush_N = 8.0;
    Vec3& asked = force(step.finger);
    if (step.press == Press::up)
      asked.x() = kPush_N;
    else if (step.press == Press::toward_wrist)
      asked.y() = -distal_sign(step.finger, hand) * kPush_N;
    else
      asked.z() = kPush_N;
    show(1.0);
    let_go();
  }

  session::Snapshot snapshot_;
  GuidedCheck check_;
};

TEST_F(GuidedCheckTest, LeadsThroughNinePressesAndPasses) {
  for (const Hand hand : {Hand::right, Hand::left}) {
    check_.begin(kPeriod_s, hand, snapshot_.frames);
    EXPECT_EQ(check_.state(), GuidedCheck::State::empty);
    show(1.5);
    int presses = 0;
    while (check_.state() == GuidedCheck::State::pressing && presses < 20) {
      EXPECT_FALSE(check_.instruction().empty());
      press(check_.step(), hand);
      ++presses;
    }
    EXPECT_EQ(presses, 9);
    EXPECT_EQ(check_.state(), GuidedCheck::State::over);
    EXPECT_TRUE(check_.passed()) << english(check_.outcome());
  }
}

TEST_F(GuidedCheckTest, SaysWhatIsWrongAtItsEnd) {
  check_.begin(kPeriod_s, Hand::right, snapshot_.frames);
  show(1.5);
  while (check_.state() == GuidedCheck::State::pressing) press(check_.step(), Hand::left);
  EXPECT_FALSE(check_.passed());
  EXPECT_NE(english(check_.outcome()).find("opposite direction"), std::string::npos)
      << english(check_.outcome());
}

TEST_F(GuidedCheckTest, HearsNothingBeforeItBeginsAndAfterItWasStopped) {
  show(5.0);
  EXPECT_EQ(check_.state(), GuidedCheck::State::idle);
  check_.begin(kPeriod_s, Hand::right, snapshot_.frames);
  show(1.5);
  check_.stop();
  force(Finger::thumb).z() = 8.0;
  show(2.0);
  EXPECT_EQ(check_.state(), GuidedCheck::State::idle);
  EXPECT_TRUE(check_.results().empty());
}

TEST_F(GuidedCheckTest, FramesThatNobodyLookedAtCountForTheTimeTheyTook) {
  check_.begin(kPeriod_s, Hand::right, snapshot_.frames);
  snapshot_.frames += 150;  // the window stood still for a second and a half
  EXPECT_TRUE(check_.look(snapshot_));
  EXPECT_EQ(check_.state(), GuidedCheck::State::pressing);
}

}  // namespace
}  // namespace isograsp::gui::guided_check_test
