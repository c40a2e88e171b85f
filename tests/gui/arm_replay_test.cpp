// SPDX-License-Identifier: GPL-3.0-or-later
// A stored trial of an arm is shown again as it was recorded: object, reference, markers and the
// angles of its links; nothing between rows, nothing of what was not seen, and no force.
#include "gui/trial_pages/arm_replay.hpp"

#include <QComboBox>
#include <QSlider>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/files.hpp"
#include "gui/arm_pages/arm_views.hpp"
#include "gui/trial_pages/trial_view.hpp"
#include "kinematics/attitude.hpp"
#include "qt_test.hpp"
#include "short_library.hpp"
#include "storage/access/open_store.hpp"
#include "tests/session/whole_session.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/within.hpp"

namespace isograsp::gui::test::arm_replay_test {
namespace {

using isograsp::test::must;

/// Trials of a session of a simulated arm, by the kinds of their tasks.
class ArmTrialReplay : public QtTest {
 protected:
  std::map<std::string, std::shared_ptr<const LoadedTrial>> measured(const char* seed) {
    const std::string library = make_arm_library(folder_);
    const std::string database = folder_.path(std::string("clinic_") + seed + ".db");
    isograsp::test::run_whole({database, "A-1",
                               std::string("sim://arm?patient=healthy&seed=") + seed,
                               library + "/protocols/arm_assessment.toml", library});
    const auto store = must(storage::open_store(database, storage::OpenMode::read_only));
    const auto session = must(store->recent_sessions(1)).at(0);
    std::map<std::string, std::shared_ptr<const LoadedTrial>> trials;
    for (const auto& trial : must(store->trials(session.id))) {
      auto loaded =
          std::make_shared<LoadedTrial>(must(load_trial(*store, session, trial, library)));
      trials.emplace(loaded->task->kind->name, std::move(loaded));
    }
    return trials;
  }
  TemporaryFolder folder_;
};

std::size_t column(const Signals& signals, const Column& of) {
  return signals.find(of).value();
}

TEST_F(ArmTrialReplay, ShowsEveryRowAsItWasRecordedAndNothingBetweenTwo) {
  const auto trial = measured("7").at("pose_matching");
  ASSERT_NE(trial->arm, nullptr) << trial->why_no_picture.toStdString();
  EXPECT_TRUE(trial->why_no_picture.isEmpty());
  ASSERT_TRUE(trial->arm->has_object());
  const Signals& signals = trial->replay.signals();
  const auto t_s = signals.column(columns::t_s);
  const auto& object = columns::segment_pose[index_of(ArmSegment::object)];
  const auto x_m = signals.column(column(signals, object.position[0]));
  const auto turn_rad =
      signals.column(column(signals, columns::link_angle[index_of(ArmLink::forearm)][2]));
  int seen = 0;
  int unseen = 0;
  int with_reference = 0;
  for (std::size_t row = 0; row + 1 < t_s.size(); ++row) {
    for (const double share : {0.0, 0.6}) {
      const double now_s = t_s[row] + share * (t_s[row + 1] - t_s[row]);
      const auto now = trial->arm->at(trial->replay, trial->replay.at(now_s));
      const FramePose& shown = now.segment(ArmSegment::object);
      ASSERT_EQ(has_pose(shown.state), std::isfinite(x_m[row])) << row;
      if (!has_pose(shown.state)) {
        unseen += 1;
        EXPECT_TRUE(is_missing(shown.X_W)) << row;
        continue;
      }
      EXPECT_EQ(shown.X_W.p.x(), x_m[row]) << row;
      EXPECT_EQ(now.last_X_WO.p.x(), x_m[row]) << row;
      const double shown_rad = now.link_angles[index_of(ArmLink::forearm)].z();
      EXPECT_TRUE(shown_rad == turn_rad[row] || std::isnan(turn_rad[row])) << row;
      with_reference += now.special.arm().reference_shown ? 1 : 0;
      seen += 1;
    }
  }
  EXPECT_GT(seen, 200);
  EXPECT_GT(with_reference, 200);
  const auto end = trial->arm->at(trial->replay, trial->replay.at(trial->replay.end_s()));
  EXPECT_EQ(end.marker_count, 16U) << "those of the rig with the marker on the breastbone";
  EXPECT_EQ(unseen % 2, 0);
}

TEST_F(ArmTrialReplay, ThePatientsPictureIsDrawnAgainWithTheMatchOfTheTarget) {
  const auto trial = measured("7").at("pose_matching");
  int matched = 0;
  int shown = 0;
  const double step_s = 10.0 * trial->replay.period_s();
  for (double t_s = trial->replay.begin_s(); t_s < trial->replay.end_s(); t_s += step_s) {
    const auto picture = picture_at(*trial, trial->replay.at(t_s));
    if (picture.page != PatientPicture::Page::object) continue;
    EXPECT_TRUE(picture.in_space);
    for (const auto& finger : isograsp::test::every(picture.fingers))
      EXPECT_FALSE(finger.shown) << "nothing fakes a finger that presses";
    EXPECT_FALSE(picture.force_shown);
    shown += picture.object_shown && picture.target_shown ? 1 : 0;
    matched += picture.matched ? 1 : 0;
  }
  EXPECT_GT(shown, 10);
  EXPECT_GT(matched, 1) << "its targets were reached";
}

TEST_F(ArmTrialReplay, TheViewHasThreeSidesAnglesOverTimeAndNoForces) {
  const auto trials = measured("8");
  TrialView view;
  view.resize(1100, 640);
  view.show();
  for (const char* kind : {"active_range", "pose_matching"}) {
    view.show_trial(trials.at(kind));
    EXPECT_TRUE(widget_called<ArmViews>("trial_arm", view).isVisible()) << kind;
    auto& set = widget_called<QComboBox>("trial_curves", view);
    QStringList sets;
    for (int i = 0; i < set.count(); ++i) sets << set.itemText(i);
    EXPECT_EQ(sets, (QStringList{"Angles of the forearm", "Angles of the wrist",
                                 "Angles of the fingers", "Any recorded channel …"}))
        << kind;
    auto& slider = widget_called<QSlider>("trial_slider", view);
    slider.setValue(slider.maximum() / 2);
    EXPECT_TRUE(widget_called<QLabel>("trial_reading", view).text().contains("°")) << kind;
    for (const auto& fact : isograsp::test::every(trials.at(kind)->facts))
      for (const char* word : {"Zero", "Maximum force", "Sensors"})
        EXPECT_FALSE(fact.what.contains(word)) << fact.what.toStdString();
    keep_picture(view, QStringLiteral("arm_replay_%1").arg(kind));
  }
}

/// Rows of one marker and an object on a line.
Signals rows_with(const std::vector<double>& x_m, double gap_s = 0.0) {
  std::vector<std::string> names{"t_s", "marker_O1_x_m", "marker_O1_y_m", "marker_O1_z_m"};
  const auto& object = columns::segment_pose[index_of(ArmSegment::object)];
  for (const auto& of : object.position) names.emplace_back(std::string(of));
  for (const auto& of : object.attitude) names.emplace_back(std::string(of));
  names.emplace_back(std::string(object.state));
  Signals signals(names);
  for (std::size_t row = 0; row < x_m.size(); ++row) {
    const double x = x_m[row];
    const bool seen = std::isfinite(x);
    const double t_s = 0.01 * static_cast<double>(row) + (row >= 2 ? gap_s : 0.0);
    const auto value = [&](double v) { return seen ? v : kMissing; };
    signals.append_row(std::array{t_s, x, value(0.0), value(0.0), x, value(0.0), value(0.0),
                                  value(1.0), value(0.0), value(0.0), value(0.0),
                                  seen ? 0.0 : 5.0});
  }
  return signals;
}

ArmReplay replay_of(const TrialReplay& replay, Hand hand = Hand::right) {
  storage::SessionRecord session;
  session.hand = hand;
  session.calibration =
      must(read_text(std::string(ISOGRASP_SOURCE_DIR) + "/library/rigs/kurillo15.toml"));
  return must(ArmReplay::make(session, replay));
}

TEST(ArmReplay, WhatWasNotSeenIsNotDrawnAndTheObjectStaysPaleWhereItWas) {
  const auto replay = must(TrialReplay::make(rows_with({0.1, 0.2, kMissing, kMissing, 0.5})));
  const ArmReplay arm = replay_of(replay);
  const auto now = arm.at(replay, replay.at(0.03));
  EXPECT_FALSE(has_pose(now.segment(ArmSegment::object).state));
  EXPECT_FALSE(now.markers_W[0].allFinite());
  EXPECT_EQ(now.last_X_WO.p.x(), 0.2);
  EXPECT_WITHIN(now.unseen_s, 0.02, 1e-12);
  const auto path = arm.path(replay, 0.0);
  EXPECT_EQ(std::count_if(path.begin(), path.end(), [](const Vec3& p) { return !p.allFinite(); }),
            1)
      << "no line joins what was seen before and after";
}

TEST(ArmReplay, InAGapThereIsNothing) {
  const auto replay = must(TrialReplay::make(rows_with({0.1, 0.2, 0.3, 0.4}, 0.5)));
  const ArmReplay arm = replay_of(replay);
  const auto in_gap = arm.at(replay, replay.at(0.3));
  EXPECT_FALSE(has_pose(in_gap.segment(ArmSegment::object).state));
  EXPECT_FALSE(in_gap.markers_W[0].allFinite());
  EXPECT_GT(in_gap.unseen_s, 0.2);
}

TEST(ArmReplay, AnObjectThatMovesRightBeforeTheCamerasMovesRightOfALeftArmToo) {
  for (const Hand hand : {Hand::right, Hand::left}) {
    // As stored: of a left arm in the mirror.
    const double sign = hand == Hand::left ? -1.0 : 1.0;
    const auto replay = must(TrialReplay::make(rows_with({0.1 * sign, 0.2 * sign, 0.3 * sign})));
    const auto path = replay_of(replay, hand).path(replay, 0.0);
    ASSERT_EQ(path.size(), 3U);
    EXPECT_WITHIN(path[2].x() - path[0].x(), 0.2, 1e-12) << name_of(hand);
  }
}

TEST(ArmReplay, ARigThatCannotBeReadIsSaidAndNothingElseIsDrawn) {
  const auto replay = must(TrialReplay::make(rows_with({0.1, 0.2})));
  storage::SessionRecord session;
  session.calibration = "thumb; 12 counts";
  EXPECT_FALSE(ArmReplay::make(session, replay).ok());
  EXPECT_FALSE(ArmReplay::is_of_arm(must(TrialReplay::make([] {
    Signals forces({"t_s", "thumb_fz_N"});
    forces.append_row(std::array{0.0, 1.0});
    return forces;
  }()))));
}

}  // namespace
}  // namespace isograsp::gui::test::arm_replay_test
