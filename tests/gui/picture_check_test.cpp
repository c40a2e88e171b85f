// SPDX-License-Identifier: GPL-3.0-or-later
// Before live cameras no target is shown until the object has been seen to go on the screen where
// it was moved: cameras on a real port, the windows, and an object that somebody moves.
#include <QLabel>
#include <QPushButton>
#include <array>

#include "gui/session_pages/state_light.hpp"
#include "operator.hpp"
#include "short_library.hpp"
#include "storage/access/access.hpp"
#include "storage/access/open_store.hpp"
#include "storage/person/consent.hpp"
#include "tests/device/cameras/marker_servers.hpp"
#include "tests/device/hands/hand_trackers.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/scripted_hand.hpp"
#include "tests/support/temporary_folder.hpp"
#include "virtual_patient/arm/virtual_arm.hpp"

namespace isograsp::gui::test::picture_check_test {
namespace {

using isograsp::test::must;

constexpr double kRate_Hz = 100.0;
constexpr double kWay_m = 0.13;
constexpr double kFirstRest_s = 3.0;  // time enough to ask for the check at the start of a round
constexpr double kRest_s = 1.2;
constexpr double kMove_s = 0.6;

/// An arm that lies still while somebody moves its object along three ways, from rest to rest, and
/// back at once; again and again.
MarkerPlay moved_along(const std::array<Vec3, 3>& ways_W) {
  virtual_patient::VirtualArm arm(virtual_patient::ArmTraits{}, 7);
  MarkerPlay play;
  play.labels.assign(arm.labels().begin(), arm.labels().end());
  play.period_s = 1.0 / kRate_Hz;
  play.repeat = true;
  std::vector<Vec3> still_W(play.labels.size());
  arm.markers(0.0, still_W);
  Vec3 moved_W = Vec3::Zero();
  const auto show = [&](double for_s, const Vec3& step_W) {
    for (int k = 0; k < static_cast<int>(for_s * kRate_Hz); ++k) {
      moved_W += step_W;
      play.t_s.push_back(static_cast<double>(play.t_s.size()) / kRate_Hz);
      for (std::size_t m = 0; m < still_W.size(); ++m)
        play.p_W.push_back(play.labels[m].front() == 'O' ? still_W[m] + moved_W : still_W[m]);
    }
  };
  show(kFirstRest_s, Vec3::Zero());
  for (const Vec3& way_W : ways_W) {
    show(kMove_s, kWay_m / (kMove_s * kRate_Hz) * way_W);
    show(kRest_s, Vec3::Zero());
  }
  return play;
}

/// A hand that is moved in the same way, before a tracker.
HandPlay hand_along(const std::array<Vec3, 3>& ways_W) {
  const auto model = isograsp::test::usual_hand();
  std::vector<HandFrame> hands;
  Vec3 moved_W = Vec3::Zero();
  const auto show = [&](double for_s, const Vec3& step_W) {
    for (int k = 0; k < static_cast<int>(for_s * kRate_Hz); ++k) {
      moved_W += step_W;
      const double t_s = static_cast<double>(hands.size()) / kRate_Hz;
      auto pose = isograsp::test::hand_posture(1.0, t_s);  // the same picture twice is a fault
      pose.X_WP.p += moved_W;
      hands.push_back(isograsp::test::picture_of(model, pose));
      hands.back().t_s = t_s;
    }
  };
  show(kFirstRest_s, Vec3::Zero());
  for (const Vec3& way_W : ways_W) {
    show(kMove_s, kWay_m / (kMove_s * kRate_Hz) * way_W);
    show(kRest_s, Vec3::Zero());
  }
  HandPlay play = HandPlay::of(std::move(hands));
  play.repeat = true;
  return play;
}

class PictureCheckBars : public QtTest {
 protected:
  PictureCheckBars()
      : windows_(GuiConfig{folder_.path("clinic.db"), "", make_arm_library(folder_), "test"}) {
    windows_.show();
  }
  ~PictureCheckBars() override {
    windows_.presenter().connecting().end_session();
    EXPECT_TRUE(wait_until([&] { return !windows_.presenter().state().busy(); }));
  }

  const SessionState& state() { return windows_.presenter().state(); }
  const FlowView& view() { return windows_.presenter().flow().view(); }
  Vec3 moved_S() { return state().open->moved_on_screen().value_or(Vec3::Zero()); }

  /// As far as the first trial that the picture leads: the protocol's first is a range.
  void prepare(const isograsp::test::RunningServer& cameras) {
    operator_.prepare_person();
    windows_.presenter().choices().choose_device("qtm://" + cameras.address().text() +
                                                 "?rig=kurillo15_trunk");
    operator_.answer_screening();
    operator_.press("connect");
    ASSERT_TRUE(wait_until([&] { return view().may_zero; })) << view().sentence;
    auto& light = operator_.find<StateLight>("posture_light");
    ASSERT_TRUE(wait_until([&] { return light.mood() == Mood::ready; }));
    rest_S_ = moved_S();
    operator_.press("start_posture");
    ASSERT_TRUE(wait_until([&] { return view().may_begin; }))
        << view().sentence << "\nno picture leads a range: it needs none";
    operator_.press("skip");
    ASSERT_TRUE(wait_until([&] { return view().situation == Situation::check_picture; }))
        << view().sentence;
  }
  /// Asks for it when a round begins, and waits for its end.
  void check_picture(const char* button = "picture_check") {
    constexpr double kNear_m = 0.02;
    const auto at_start = [&] { return (moved_S() - rest_S_).norm() < kNear_m; };
    ASSERT_TRUE(wait_until([&] { return !at_start(); }));
    ASSERT_TRUE(wait_until(at_start));
    operator_.press(button);
    EXPECT_FALSE(view().may_begin);
    ASSERT_TRUE(wait_until([&] { return state().open->picture_check.over(); }))
        << words().toStdString();
  }
  /// "right_off_deg" and its like, as they are stored.
  std::size_t stored_ways() {
    std::size_t ways = 0;
    for (const auto& answer : isograsp::test::every(stored_answers()))
      if (answer.topic == "picture_check") ++ways;
    return ways;
  }
  QString words() { return operator_.find<QLabel>("picture_check_words").text(); }
  std::vector<storage::SessionAnswer> stored_answers() {
    const auto store =
        must(storage::open_store(folder_.path("clinic.db"), storage::OpenMode::read_only));
    return must(store->answers(must(store->recent_sessions(1)).at(0).id));
  }

  TemporaryFolder folder_;
  Windows windows_;
  Operator operator_{windows_};
  Vec3 rest_S_ = Vec3::Zero();
};

TEST_F(PictureCheckBars, ATargetUntilTheObjectHasGoneRightUpAndAway) {
  const auto cameras =
      isograsp::test::qtm_server(moved_along({Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitZ()}));
  ASSERT_NO_FATAL_FAILURE(prepare(*cameras));
  EXPECT_FALSE(view().may_start);
  EXPECT_EQ(view().press, NextPress::picture) << "it is the one thing to press";
  EXPECT_EQ(view().start_hint, "Check the picture first, in Live arm.");
  windows_.presenter().trials().start();  // F8
  EXPECT_FALSE(state().open->trial) << "nor by key";
  keep_picture(windows_.therapist(), "arm_picture_due");
  ASSERT_NO_FATAL_FAILURE(check_picture());
  EXPECT_TRUE(wait_until([&] { return words().startsWith(QStringLiteral("✓")); }));
  ASSERT_TRUE(wait_until([&] { return view().may_start; })) << view().sentence;
  operator_.press("start");
  ASSERT_TRUE(wait_until([&] { return state().snapshot().stage == session::Stage::trial; }));
  operator_.press("stop");
  operator_.finish_task();
  EXPECT_TRUE(wait_until([&] { return view().may_repeat; })) << "and once more";
  operator_.disconnect();
  EXPECT_EQ(stored_ways(), PictureCheck::kWays);
}

TEST_F(PictureCheckBars, EveryTargetWhereThePictureIsMirrored) {
  const auto cameras =
      isograsp::test::qtm_server(moved_along({-Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitZ()}));
  ASSERT_NO_FATAL_FAILURE(prepare(*cameras));
  ASSERT_NO_FATAL_FAILURE(check_picture());
  EXPECT_TRUE(wait_until([&] { return words().startsWith(QStringLiteral("✗")); }));
  EXPECT_FALSE(view().may_start);
  EXPECT_EQ(view().press, NextPress::picture) << "once more";
  keep_picture(windows_.therapist(), "arm_picture_mirrored");
  operator_.press("by_hand");
  operator_.choose_task("pose_matching");
  EXPECT_FALSE(view().may_start) << "nor beside the protocol";
  operator_.choose_task("active_range");
  EXPECT_TRUE(wait_until([&] { return view().may_start; })) << "no picture leads it";
}

TEST_F(PictureCheckBars, IsMadeOfALiveHandAsWellAndStored) {
  const auto tracker =
      isograsp::test::leap_tracker(hand_along({Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitZ()}));
  operator_.prepare_person();
  must(storage::add_consent(*must(storage::Access::open(folder_.path("clinic.db"))),
                            state().choices.patient,
                            {0, "2026-03-05", "treatment", "care", "given", "", "", ""}));
  windows_.presenter().choices().choose_device("leap://" + tracker->address().text());
  operator_.answer_screening();
  operator_.press("connect");
  ASSERT_TRUE(wait_until([&] { return view().may_zero; })) << view().sentence;
  rest_S_ = isograsp::test::hand_posture(1.0, 0.0).X_WP.p;
  ASSERT_NO_FATAL_FAILURE(check_picture("hand_picture_check"));
  EXPECT_TRUE(state().open->picture_check.good());
  auto& said = operator_.find<QLabel>("hand_picture_check_words");
  EXPECT_TRUE(wait_until([&] { return said.text().startsWith(QStringLiteral("✓")); }))
      << said.text().toStdString();
  keep_picture(windows_.therapist(), "hand_picture_checked");
  operator_.disconnect();
  EXPECT_EQ(stored_ways(), PictureCheck::kWays);
}

}  // namespace
}  // namespace isograsp::gui::test::picture_check_test
