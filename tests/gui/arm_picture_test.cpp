// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn of an arm: where cameras see it, of a left arm, too; pale out of sight; what the
// therapist reads beside it.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/files.hpp"
#include "gui/look/marker_history.hpp"
#include "gui/patient_screen/patient_canvas.hpp"
#include "gui/picture/arm_space.hpp"
#include "gui/presenter/patient_facts.hpp"
#include "gui/rules/arm_live.hpp"
#include "gui/rules/picture_check.hpp"
#include "gui/rules/still_watch.hpp"
#include "qt_test.hpp"
#include "session/arm/start_posture.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/within.hpp"

namespace isograsp::gui::test::arm_picture_test {
namespace {

constexpr double kRounding_m = 1e-12;  // a metre through two rotations
constexpr double kPeriod_s = 0.01;

Pose somewhere(double angle_rad) {
  return {Vec3(0.4, -0.3, 2.1),
          Quat(Eigen::AngleAxisd(angle_rad, Vec3(1.0, -2.0, 0.5).normalized()))};
}

session::ArmSetup setup_with(const RigView& view, Hand hand) {
  session::ArmSetup setup;
  setup.view = view;
  setup.markers = {"O1", "O2"};
  setup.has_segment.fill(true);
  for (const Vec3& p : {Vec3(0.03, 0.02, 0.04), Vec3(-0.03, -0.02, -0.02), Vec3(0.01, 0.0, 0.0)})
    setup.object_m.push_back(hand == Hand::left ? mirrored(p) : p);
  return setup;
}

/// As the session gives it: of a left arm in its reflection.
Pose as_stored(const Pose& X_W, Hand hand) {
  return hand == Hand::left ? mirrored(X_W) : X_W;
}

TEST(ArmSpace, WhatMovesRightUpAndNearerIsDrawnSoWhateverTheCamerasCallIt) {
  for (const Hand hand : {Hand::right, Hand::left})
    for (const RigView& view : {RigView{"x", "y"}, RigView{"-y", "z"}, RigView{"z", "-x"}}) {
      const ArmSpace space(setup_with(view, hand), hand);
      const auto axis = [](const std::string& name) {
        Vec3 unit = Vec3::Zero();
        unit[name.back() - 'x'] = name.front() == '-' ? -1.0 : 1.0;
        return unit;
      };
      const Vec3 right = axis(view.right);
      const Vec3 up = axis(view.up);
      const Vec3 near = right.cross(up);
      const Vec3 centre = as_stored(somewhere(0.3), hand).p;
      for (const auto& [way, drawn] : {std::pair<Vec3, Vec3>{right, Vec3::UnitX()},
                                       {up, Vec3::UnitY()},
                                       {near, Vec3::UnitZ()}}) {
        const Pose moved{somewhere(0.3).p + 0.1 * way, Quat::Identity()};
        EXPECT_WITHIN((space.place(as_stored(moved, hand).p, centre) - 0.1 * drawn).norm(), 0.0,
                      kRounding_m)
            << name_of(hand) << view.right << view.up;
      }
    }
}

TEST(ArmSpace, ALeftArmIsDrawnWhereTheCamerasSeeItsMarkers) {
  for (const Hand hand : {Hand::right, Hand::left}) {
    const ArmSpace space(setup_with({"-z", "y"}, hand), hand);
    const Vec3 centre = as_stored(somewhere(1.0), hand).p;
    const Pose real = somewhere(-0.8);
    // Where the rig has the centre of the box, as cameras see it.
    const Vec3 p_OB(0.0, 0.0, 0.01);
    const Pose drawn = space.box_at(as_stored(real, hand), centre);
    for (const Vec3& corner : {Vec3(0.03, 0.02, 0.04), Vec3(-0.03, -0.02, -0.02)})
      EXPECT_WITHIN(
          (drawn.p + drawn.q * (corner - p_OB) - space.marker(real.p + real.q * corner, centre))
              .norm(),
          0.0, kRounding_m)
          << name_of(hand);
    EXPECT_WITHIN((space.box()->size_m - Vec3(0.06, 0.04, 0.06)).norm(), 0.0, kRounding_m);
  }
}

TEST(ArmSpace, AnObjectOfWhichTheRigSaysNothingHasASizeAndAFlatOneIsThickEnoughToBeSeen) {
  session::ArmSetup unknown = setup_with({}, Hand::right);
  unknown.object_m.clear();
  EXPECT_GT(ArmSpace(unknown, Hand::right).box()->size_m.minCoeff(), 0.0);
  session::ArmSetup flat = setup_with({}, Hand::right);
  for (Vec3& p : flat.object_m) p.y() = 0.0;
  EXPECT_GT(ArmSpace(flat, Hand::right).box()->size_m.y(), 0.0);
}

/// A frame in which all of an arm is seen, `turn_rad` of it in the wrist.
session::ArmSnapshot frame(std::int64_t number, double turn_rad = 0.0) {
  session::ArmSnapshot now;
  now.frames = number + 1;
  now.session_time_s = static_cast<double>(number) * kPeriod_s;
  now.picture = true;
  const Quat turned(Eigen::AngleAxisd(turn_rad, Vec3::UnitX()));
  for (std::size_t s = 0; s < kArmSegmentCount; ++s) {
    now.segments[s].state = FrameState::ok;
    now.segments[s].X_W = {Vec3(0.1 * static_cast<double>(s), 0.0, 0.0),
                           s >= index_of(ArmSegment::dorsum) ? turned : Quat::Identity()};
  }
  now.last_X_WO = now.segment(ArmSegment::object).X_W;
  now.marker_count = 2;
  now.markers_W[0] = now.markers_W[1] = Vec3(0.1, 0.2, 0.3);
  return now;
}

std::shared_ptr<const tasks::TaskSpec> task(const char* file) {
  const std::string path = std::string(ISOGRASP_SOURCE_DIR "/library/tasks/") + file;
  return std::make_shared<tasks::TaskSpec>(
      isograsp::test::must(tasks::parse_task(isograsp::test::must(read_text(path)), path)));
}

PatientFacts facts_of(const session::ArmSnapshot& now, const char* file) {
  PatientFacts facts = patient_facts(now);
  facts.session_open = true;
  facts.task = task(file);
  facts.arm = std::make_shared<ArmSpace>(setup_with({}, Hand::right), Hand::right);
  return facts;
}

session::ArmSnapshot in_trial() {
  session::ArmSnapshot now = frame(100);
  now.stage = session::Stage::trial;
  now.zeroed = true;
  now.start_p_WO = Vec3(0.4, 0.0, 0.0);
  now.task.cue = Cue::move;
  now.task.target_count = 4;
  now.task.target_index = 0;
  tasks::ArmView view;
  view.reference_shown = true;
  view.X_WR = {Vec3(0.6, 0.1, 0.0), Quat::Identity()};
  now.special.special = view;
  return now;
}

TEST(ArmPicture, TheObjectStandsFromItsTargetAsInTheRoomAndTurnsGreenThere) {
  session::ArmSnapshot now = in_trial();
  PatientPicture picture = picture_for(facts_of(now, "arm_screw.toml"));
  EXPECT_EQ(picture.page, PatientPicture::Page::object);
  EXPECT_TRUE(picture.object_shown && picture.target_shown && picture.in_space);
  EXPECT_FALSE(picture.matched || picture.unseen);
  const Vec3 way_W = std::get<tasks::ArmView>(now.special.special).X_WR.p - now.last_X_WO.p;
  EXPECT_WITHIN((picture.X_WT.p - picture.X_WO.p - way_W).norm(), 0.0, kRounding_m);
  const std::string asked = picture.headline;
  std::get<tasks::ArmView>(now.special.special).matched = true;
  now.task.targets_reached = 1;
  now.task.hold_fraction = 1.0;
  picture = picture_for(facts_of(now, "arm_screw.toml"));
  EXPECT_TRUE(picture.matched);
  EXPECT_EQ(picture.hold_fraction, 0.0) << "a tick is in its place";
  EXPECT_NE(picture.headline, asked);
  EXPECT_EQ(picture.targets_reached, 1);
}

TEST(ArmPicture, OutOfSightTheObjectStaysPaleAndThePatientIsToldWhatToDoNotThatThereIsAPause) {
  session::ArmSnapshot now = in_trial();
  now.segments[index_of(ArmSegment::object)] = {};
  now.unseen_s = 0.03;
  PatientPicture picture = picture_for(facts_of(now, "arm_screw.toml"));
  EXPECT_TRUE(picture.object_shown);
  EXPECT_FALSE(picture.unseen) << "for a moment its last pose stands in";
  now.unseen_s = 0.2;
  now.stage = session::Stage::paused;
  now.pause_cause = session::PauseCause::occluded;
  picture = picture_for(facts_of(now, "arm_screw.toml"));
  EXPECT_TRUE(picture.object_shown && picture.unseen);
  EXPECT_FALSE(picture.matched);
  EXPECT_EQ(picture.notice, PatientPicture::Notice::none);
  EXPECT_NE(picture.headline.find("cameras"), std::string::npos) << picture.headline;
  EXPECT_TRUE(picture.X_WO.p.allFinite());
  now.pause_cause = session::PauseCause::therapist;
  EXPECT_EQ(picture_for(facts_of(now, "arm_screw.toml")).notice, PatientPicture::Notice::pause);
  now.pause_cause = session::PauseCause::missing_samples;
  EXPECT_EQ(picture_for(facts_of(now, "arm_screw.toml")).notice, PatientPicture::Notice::fault);
}

TEST(ArmPicture, AnObjectThatLeftTheHandIsToBeTakenUpAgainAndIsNobodysFault) {
  session::ArmSnapshot now = in_trial();
  now.stage = session::Stage::paused;
  now.pause_cause = session::PauseCause::object_lost;
  const PatientPicture picture = picture_for(facts_of(now, "arm_screw.toml"));
  EXPECT_EQ(picture.notice, PatientPicture::Notice::none);
  EXPECT_TRUE(picture.object_shown);
  EXPECT_NE(picture.headline.find("in your hand again"), std::string::npos) << picture.headline;
}

TEST(ArmPicture, AnObjectThatWasNeverSeenIsNotDrawnAnywhere) {
  session::ArmSnapshot now = in_trial();
  now.segments[index_of(ArmSegment::object)] = {};
  now.last_X_WO = missing_pose();
  PatientPicture picture = picture_for(facts_of(now, "arm_screw.toml"));
  EXPECT_FALSE(picture.object_shown);
  std::get<tasks::ArmView>(now.special.special).reference_shown = false;
  picture = picture_for(facts_of(now, "arm_screw.toml"));
  EXPECT_EQ(picture.page, PatientPicture::Page::message);
  EXPECT_NE(picture.headline.find("cameras"), std::string::npos) << picture.headline;
}

QImage painted(const PatientPicture& picture) {
  QImage image(1280, 720, QImage::Format_RGB32);
  QPainter painter(&image);
  paint_page(painter, QRectF(image.rect()), picture);
  return image;
}

TEST(ArmPicture, AskedForSomethingThatIsNotDrawnThePatientReadsWhatToDo) {
  session::ArmSnapshot now = frame(0);
  now.stage = session::Stage::trial;
  now.segments = {};
  now.last_X_WO = missing_pose();
  const auto facts = facts_of(now, "arm_drinking.toml");
  const PatientPicture picture = picture_for(facts);
  EXPECT_EQ(picture.page, PatientPicture::Page::message);
  EXPECT_TRUE(picture.headline.starts_with("Take the glass")) << picture.headline;
}

TEST(ArmPicture, WhatMayRestIsTheArmInEveryPartOfASession) {
  const auto words_of = [](const PatientFacts& facts) {
    const PatientPicture picture = picture_for(facts);
    return picture.headline + "|" + picture.detail + "|" + picture.notice_words;
  };
  int told = 0;
  for (const bool completed : {false, true})
    for (const bool missed : {false, true})
      for (const bool fault : {false, true})
        for (const auto stage : {session::Stage::idle, session::Stage::paused}) {
          PatientFacts facts;
          facts.session_open = facts.arrived = true;
          facts.just_completed = completed;
          facts.just_missed = missed;
          facts.device_fault = fault;
          facts.stage = stage;
          facts.stimulus.cue = Cue::relax;
          EXPECT_EQ(words_of(facts).find("your arm"), std::string::npos) << words_of(facts);
          facts.arm = std::make_shared<ArmSpace>(setup_with({}, Hand::right), Hand::right);
          EXPECT_EQ(words_of(facts).find("your hand"), std::string::npos) << words_of(facts);
          told += words_of(facts).find("Relax your arm") != std::string::npos ? 1 : 0;
        }
  EXPECT_EQ(told, 16);
}

TEST(ArmPicture, TheRangeSoFarIsOnItsPageMirroredForALeftArm) {
  application();
  session::ArmSnapshot now = in_trial();
  now.special.special = tasks::ArmView{};
  now.angle = {true, true, 0.4, false, 0.0, 0.0};
  PatientFacts facts = facts_of(now, "arm_range_forearm.toml");
  const PatientPicture nothing_yet = picture_for(facts);
  EXPECT_EQ(nothing_yet.page, PatientPicture::Page::range);
  facts.stimulus.angle = {true, true, 0.4, true, -0.9, 1.2};
  const PatientPicture ranged = picture_for(facts);
  const QImage right = painted(ranged);
  EXPECT_NE(right, painted(nothing_yet));
  facts.hand = Hand::left;
  const QImage left = painted(picture_for(facts));
  EXPECT_NE(left, right);
  // Letters are not mirrored: the dial stands below them.
  const QRect dial(0, 260, 1280, 400);
  const QImage mirrored_left = left.copy(dial).mirrored(true, false);
  const QImage of_right = right.copy(dial);
  int differing = 0;
  for (int y = 0; y < dial.height(); y += 4)
    for (int x = 0; x < dial.width(); x += 4)
      differing += of_right.pixel(x, y) != mirrored_left.pixel(x, y);
  constexpr int kSmoothedEdges = 400;  // of 32 000 points looked at
  EXPECT_LT(differing, kSmoothedEdges);
  if (const auto folder = qEnvironmentVariable("ISOGRASP_TEST_PICTURES"); !folder.isEmpty()) {
    QDir().mkpath(folder);
    EXPECT_TRUE(right.save(folder + "/range_of_arm.png"));
  }
}

TEST(ArmLive, TheErrorIsThatOfTheRoomWithItsPartAlongTheLineOfSight) {
  const ArmSpace space(setup_with({"z", "y"}, Hand::right), Hand::right);  // x is away
  session::ArmSnapshot now = in_trial();
  auto& view = std::get<tasks::ArmView>(now.special.special);
  view.X_WR = {now.last_X_WO.p + Vec3(0.03, 0.04, 0.0),
               Quat(Eigen::AngleAxisd(0.5, Vec3::UnitY()))};
  const auto error = error_of(now, space);
  ASSERT_TRUE(error.has_value());
  EXPECT_WITHIN(error->distance_m, 0.05, kRounding_m);
  EXPECT_WITHIN(std::abs(error->depth_m), 0.03, kRounding_m);
  EXPECT_WITHIN(error->angle_rad, 0.5, kRounding_m);
  now.segments[index_of(ArmSegment::object)] = {};
  EXPECT_FALSE(error_of(now, space).has_value());
}

TEST(ArmLive, TurnsAreCountedFromTheTargetAndSharesAddUp) {
  LinkTurns turns;
  session::ArmSnapshot now = frame(0);
  now.trial_number = 1;
  now.task.target_index = 0;
  turns.add(now);
  EXPECT_FALSE(turns.turns()[0].share_percent.has_value()) << "nothing has turned yet";
  now = frame(1, 0.3);
  now.trial_number = 1;
  now.task.target_index = 0;
  turns.add(now);
  EXPECT_WITHIN(*turns.turns()[index_of(ArmLink::wrist)].angle_rad, 0.3, kRounding_m);
  EXPECT_WITHIN(*turns.turns()[index_of(ArmLink::wrist)].share_percent, 100.0, 1e-6);
  EXPECT_WITHIN(*turns.turns()[index_of(ArmLink::forearm)].angle_rad, 0.0, kRounding_m);
  now.task.target_index = 1;
  turns.add(now);
  EXPECT_WITHIN(*turns.turns()[index_of(ArmLink::wrist)].angle_rad, 0.0, kRounding_m);
}

TEST(StillWatch, IsContentWithExactlyWhatTheMeasurementTakes) {
  constexpr int kFrames = 110;
  for (const double wander_m : {0.0, 0.002, 0.004, 0.02}) {
    StillWatch watch;
    session::StartPostureCapture capture(kPeriod_s, 0.0);
    bool ended = false;
    for (int k = 0; k < kFrames; ++k) {
      session::ArmSnapshot now = frame(k);
      // The whole arm to and fro, so that its mean does not hide it.
      for (FramePose& segment : now.segments) segment.X_W.p.y() += k % 2 == 0 ? wander_m : 0.0;
      watch.add(now);
      std::array<Pose, session::kArmChain.size()> X_W;
      for (std::size_t i = 0; i < X_W.size(); ++i) X_W[i] = now.segment(session::kArmChain[i]).X_W;
      if (!ended) ended = capture.add(X_W);
    }
    ASSERT_TRUE(ended);
    EXPECT_EQ(watch.state() == StillWatch::State::still,
              capture.refusal() == session::StartPostureCapture::Refusal::none)
        << wander_m;
  }
}

TEST(StillWatch, NamesWhatIsNotInSightAndBeginsAnewAfterIt) {
  StillWatch watch;
  for (int k = 0; k < 110; ++k) watch.add(frame(k));
  EXPECT_EQ(watch.state(), StillWatch::State::still);
  session::ArmSnapshot hidden = frame(110);
  hidden.segments[index_of(ArmSegment::dorsum)].state = FrameState::missing;
  watch.add(hidden);
  EXPECT_EQ(watch.state(), StillWatch::State::unseen);
  EXPECT_EQ(watch.unseen(), (std::array<bool, 4>{false, false, true, false}));
  watch.add(frame(111));
  EXPECT_EQ(watch.state(), StillWatch::State::moving) << "a second has to pass again";
}

/// Moves the object of an arm before cameras with that view: three ways of 10 cm, on the axes of
/// the cameras, from rest to rest. Poses of a left arm are those of its reflection.
PictureCheck checked(const RigView& view, const std::array<Vec3, 3>& ways_W,
                     Hand hand = Hand::right) {
  const ArmSpace space(setup_with(view, hand), hand);
  PictureCheck check;
  check.begin();
  std::int64_t number = 0;
  Vec3 p_W(0.3, 0.2, 1.0);
  constexpr int kFrames = 60;  // of a rest, and of a way
  const auto show = [&] {
    const Vec3 reflected_W(hand == Hand::left ? -p_W.x() : p_W.x(), p_W.y(), p_W.z());
    check.add(space.place(reflected_W, Vec3::Zero()), 0.01 * static_cast<double>(number++));
  };
  for (const Vec3& way : ways_W) {
    for (int k = 0; k < kFrames; ++k) show();
    for (int k = 0; k < kFrames; ++k) {
      p_W += 0.13 / kFrames * way;
      show();
    }
  }
  return check;
}

TEST(PictureCheck, PassesWhereThePictureDoesTheSameAndShowsARigThatNamesOtherAxes) {
  const std::array<Vec3, 3> ways{Vec3::UnitX(), Vec3::UnitY(), Vec3(-Vec3::UnitZ())};
  const PictureCheck right_axes = checked({"x", "y"}, ways);
  EXPECT_TRUE(right_axes.over());
  EXPECT_TRUE(right_axes.good());
  for (const RigView& view : {RigView{"-x", "y"}, RigView{"z", "y"}, RigView{"x", "z"}}) {
    const PictureCheck other = checked(view, ways);
    EXPECT_TRUE(other.over()) << view.right << view.up;
    EXPECT_FALSE(other.good()) << view.right << view.up;
  }
  EXPECT_TRUE(checked({"x", "y"}, ways, Hand::left).good());
  EXPECT_FALSE(checked({"-x", "y"}, ways, Hand::left).good());
  const Vec3 slanted = Vec3(1.0, std::tan(0.2), 0.0).normalized();
  EXPECT_TRUE(checked({"x", "y"}, {slanted, ways[1], ways[2]}).good());
  const Vec3 too_slanted = Vec3(1.0, std::tan(0.35), 0.0).normalized();
  EXPECT_FALSE(checked({"x", "y"}, {too_slanted, ways[1], ways[2]}).good());
}

TEST(PictureCheck, AsksForNothingBeforeTheObjectRestsInSight) {
  PictureCheck check;
  check.begin();
  for (int k = 0; k < 200; ++k) check.add(std::nullopt, 0.01 * k);
  EXPECT_FALSE(check.asked().has_value()) << "it is not seen";
  for (int k = 200; k < 260; ++k) check.add(Vec3(0.1, 0.2, 0.3), 0.01 * k);
  EXPECT_EQ(check.asked(), PictureCheck::Way::right);
  check.stop();
  EXPECT_FALSE(check.running());
}

TEST(MarkerHistory, CountsWhatWasSeenOfTheLastSeconds) {
  MarkerHistory history(1.0);
  EXPECT_FALSE(history.marker_percent(0).has_value());
  for (int k = 0; k < 300; ++k) {
    session::ArmSnapshot now = frame(k);
    if (k >= 250 && k % 2 == 0) now.markers_W[1] = Vec3::Constant(kMissing);
    history.add(now);
    history.add(now);  // the same frame
  }
  EXPECT_EQ(history.marker_percent(0), 100.0);
  // Half of the last 50 of 100 frames, and one more at the edge.
  constexpr double kOneFrame_percent = 1.0;
  EXPECT_NEAR(*history.marker_percent(1), 75.0, kOneFrame_percent);
  EXPECT_EQ(history.segment_percent(ArmSegment::object), 100.0);
}

}  // namespace
}  // namespace isograsp::gui::test::arm_picture_test
