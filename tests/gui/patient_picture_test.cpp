// SPDX-License-Identifier: GPL-3.0-or-later
// What the patient sees: one instruction, fingers that follow force, faults in kind words.
#include "gui/picture/patient_picture.hpp"

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::gui::patient_picture_test {
namespace {

constexpr double kRounding_m = 1e-12;  // positions of centimetres through one rotation

std::shared_ptr<const Scene> planar_block() {
  const std::string path = ISOGRASP_SOURCE_DIR "/library/scenes/planar_block.toml";
  return std::make_shared<Scene>(*parse_scene(*read_text(path), path));
}

std::shared_ptr<const tasks::TaskSpec> task(const char* file) {
  const std::string path = std::string(ISOGRASP_SOURCE_DIR "/library/tasks/") + file;
  return std::make_shared<tasks::TaskSpec>(*tasks::parse_task(*read_text(path), path));
}

PatientFacts with_object() {
  PatientFacts facts;
  facts.session_open = true;
  facts.task = task("two_target.toml");
  facts.scene = planar_block();
  facts.arrived = true;
  facts.stage = session::Stage::trial;
  facts.stimulus.object_shown = true;
  facts.stimulus.pose_target_shown = true;
  facts.stimulus.progress.target_count = 5;
  facts.stimulus.progress.duration_s = 150.0;
  return facts;
}

TEST(PatientPicture, AFingerComesNearerWithForceAndTouchesOnContact) {
  PatientFacts facts = with_object();
  const Contact& thumb = *facts.scene->contact_of(Finger::thumb);
  double last_gap = 1.0;
  for (const double force : {0.0, 0.1, 0.3, 0.49}) {
    facts.stimulus.press_N[0] = force;
    const auto finger = picture_for(facts).fingers[0];
    const double gap = (thumb.p_OC - finger.tip_W).dot(finger.axis_W);
    EXPECT_LT(gap, last_gap);
    EXPECT_GT(gap, 0.0) << "never at the surface without contact";
    EXPECT_FALSE(finger.touching);
    last_gap = gap;
  }
  facts.stimulus.contact[0] = true;
  const auto finger = picture_for(facts).fingers[0];
  EXPECT_TRUE(finger.touching);
  EXPECT_WITHIN((finger.tip_W - thumb.p_OC).norm(), 0.0, kRounding_m);
}

TEST(PatientPicture, AFingerStaysOnItsContactWhileTheObjectMovesAndTurns) {
  PatientFacts facts = with_object();
  facts.stimulus.contact = {true, true, true};
  Pose& pose = facts.stimulus.X_WO;
  pose.p = Vec3(0.05, -0.03, 0.0);
  pose.q = Quat(Eigen::AngleAxisd(0.7, Vec3::UnitZ()));
  for (const auto& contact : test::every(facts.scene->contacts)) {
    const auto finger = picture_for(facts).fingers[index_of(contact.finger)];
    EXPECT_WITHIN((pose.q.conjugate() * (finger.tip_W - pose.p) - contact.p_OC).norm(), 0.0,
                  kRounding_m);
    EXPECT_WITHIN((pose.q.conjugate() * finger.axis_W - contact.R_OC.col(2)).norm(), 0.0,
                  kRounding_m);
  }
}

TEST(PatientPicture, WhatMovesIsShownWhereItIsNow) {
  PatientFacts facts = with_object();
  Stimulus& object = facts.stimulus;
  object.v_WO_W = Vec3(0.2, 0.0, -0.1);
  object.w_WO_W = Vec3(0.0, 0.0, 2.0);
  facts.stimulus.progress.task_time_s = 3.0;
  facts.ahead_s = 0.015;
  const auto picture = picture_for(facts);
  EXPECT_WITHIN((picture.X_WO.p - Vec3(0.003, 0.0, -0.0015)).norm(), 0.0, kRounding_m);
  const Quat turned(Eigen::AngleAxisd(0.03, Vec3::UnitZ()));
  EXPECT_WITHIN(picture.X_WO.q.angularDistance(turned), 0.0, 1e-7);  // acos near 1
  EXPECT_EQ(picture.task_time_s, 3.015);
  const Contact& thumb = *facts.scene->contact_of(Finger::thumb);
  facts.stimulus.contact[0] = true;
  EXPECT_WITHIN(
      (picture_for(facts).fingers[0].tip_W - (picture.X_WO.p + picture.X_WO.q * thumb.p_OC)).norm(),
      0.0, kRounding_m)
      << "fingers go with it";
}

TEST(PatientPicture, OnACalmScreenNoFingerApproaches) {
  PatientFacts facts = with_object();
  facts.calm = true;
  const auto away = picture_for(facts).fingers[0].tip_W;
  facts.stimulus.press_N[0] = 0.4;
  EXPECT_EQ(picture_for(facts).fingers[0].tip_W, away);
}

TEST(PatientPicture, TheRingOfAHoldStandsAtTheOutlineAndOnlyWhileTheBlockIsSeenThere) {
  PatientFacts facts = with_object();
  ShownProgress& progress = facts.stimulus.progress;
  progress.target_index = 1;  // it is to be held for a second
  progress.holding = true;
  progress.hold_fraction = 0.5;
  Pose& X_WT = facts.stimulus.X_WT;
  X_WT.p = Vec3(-0.08, -0.06, 0.0);
  Pose& block = facts.stimulus.X_WO;
  block.p = X_WT.p + Vec3(0.015, 0.0, 0.0);  // the task allows 20 mm
  auto picture = picture_for(facts);
  EXPECT_EQ(picture.hold_fraction, 0.5);
  EXPECT_EQ(picture.ring_W, X_WT.p) << "what is to be filled is the outline";
  facts.stimulus.v_WO_W = Vec3(0.5, 0.0, 0.0);
  facts.ahead_s = 0.02;  // seen 10 mm further on, outside
  EXPECT_EQ(picture_for(facts).hold_fraction, 0.0);
  facts.ahead_s = 0.0;
  block.q = Quat(Eigen::AngleAxisd(0.3, Vec3::UnitZ()));  // the task allows 15 degrees
  EXPECT_EQ(picture_for(facts).hold_fraction, 0.0);
}

TEST(PatientPicture, WhereTheBlockOnlyPassesThereIsNoRing) {
  PatientFacts facts = with_object();
  ShownProgress& progress = facts.stimulus.progress;
  progress.holding = true;
  progress.hold_fraction = 1.0;  // reached on entering
  progress.target_index = 0;
  EXPECT_EQ(picture_for(facts).hold_fraction, 0.0);
  progress.target_index = 1;
  EXPECT_EQ(picture_for(facts).hold_fraction, 1.0);
}

TEST(PatientPicture, TargetsThatWereNotReachedAreAGoodTryAndNoFailure) {
  PatientFacts facts = with_object();
  facts.stage = session::Stage::idle;
  facts.just_completed = true;
  EXPECT_EQ(picture_for(facts).sign, PatientPicture::Sign::good);
  EXPECT_FALSE(picture_for(facts).missed);
  facts.just_missed = true;
  EXPECT_TRUE(picture_for(facts).missed);
  EXPECT_EQ(picture_for(facts).headline, "Good try");
}

TEST(PatientPicture, AFaultIsNeverThePatientsFailure) {
  PatientFacts facts = with_object();
  facts.stage = session::Stage::paused;
  facts.pause_cause = session::PauseCause::missing_samples;
  const auto picture = picture_for(facts);
  EXPECT_EQ(picture.notice, PatientPicture::Notice::fault);
  EXPECT_NE(picture.notice_words.find("You did nothing wrong"), std::string::npos);
  EXPECT_EQ(picture.page, PatientPicture::Page::object) << "the picture stands still below";
}

TEST(PatientPicture, APauseOfTheTherapistIsAPause) {
  PatientFacts facts = with_object();
  facts.stage = session::Stage::paused;
  facts.pause_cause = session::PauseCause::therapist;
  EXPECT_EQ(picture_for(facts).notice, PatientPicture::Notice::pause);
}

TEST(PatientPicture, BeforeTheZeroTheHandStaysOut) {
  PatientFacts facts;
  facts.session_open = true;
  facts.arrived = true;
  EXPECT_EQ(picture_for(facts).sign, PatientPicture::Sign::hand_out);
  facts.stage = session::Stage::zeroing;
  EXPECT_EQ(picture_for(facts).sign, PatientPicture::Sign::hand_out);
  facts.stage = session::Stage::idle;
  facts.stimulus.cue = Cue::relax;
  EXPECT_EQ(picture_for(facts).sign, PatientPicture::Sign::wait);
}

TEST(PatientPicture, TellsASimulatedDeviceFromTheFirstSecond) {
  PatientFacts facts;
  facts.simulated = true;
  EXPECT_TRUE(picture_for(facts).simulated);
}

TEST(PatientPicture, SqueezeIsSaidOnlyWhenItIsTime) {
  PatientFacts facts;
  facts.session_open = true;
  facts.task = task("maximum_grip.toml");
  facts.arrived = true;
  facts.stage = session::Stage::trial;
  facts.stimulus.page_cue = Cue::relax;
  EXPECT_NE(picture_for(facts).page, PatientPicture::Page::effort);
  facts.stimulus.page_cue = Cue::squeeze;
  EXPECT_EQ(picture_for(facts).page, PatientPicture::Page::effort);
}

TEST(TargetPreview, IsExactlyWhatTheTaskWillShow) {
  const auto sine = task("grip_sine.toml");
  tasks::TaskContext context;
  context.references.maximum_N[{}] = 40.0;
  const auto preview = preview_target(*sine, context);
  auto trial = tasks::make_task(*sine, context);
  ASSERT_TRUE(trial.ok());
  const tasks::TaskInput pressing = tasks::ForceInput{};
  for (std::size_t k = 0; k < preview.target_N.size(); ++k) {
    const tasks::TaskView view = (*trial)->step(pressing);
    ASSERT_EQ(preview.target_N[k], view.force().target_force_N);
    const auto shown = preview.at(view.task_time_s, view.task_time_s);
    ASSERT_TRUE(shown.has_value()) << view.task_time_s;
    ASSERT_WITHIN(*shown, view.force().target_force_N, 1e-9)
        << "time over period may round to a neighbour: slope 12 N/s times 1e-12 s";
  }
  EXPECT_DOUBLE_EQ(preview.period_s * static_cast<double>(preview.target_N.size()),
                   sine->duration().worst_s);
  EXPECT_DOUBLE_EQ(preview.axis.most_N, 0.3 * 40.0);
  EXPECT_DOUBLE_EQ(preview.axis.least_N, 0.0);
}

TEST(TargetPreview, EndsAsFarAheadAsTheTaskAllows) {
  tasks::TaskContext context;
  context.references.maximum_N[{}] = 40.0;
  const auto preview = preview_target(*task("grip_sine.toml"), context);
  EXPECT_DOUBLE_EQ(preview.ahead_s, 4.0) << "the shipped sine keeps its picture";
  EXPECT_TRUE(preview.at(14.0, 10.0).has_value());
  EXPECT_FALSE(preview.at(14.1, 10.0).has_value());
  EXPECT_FALSE(preview.at(-0.1, 0.0).has_value()) << "nothing before the start";
  EXPECT_FALSE(preview.at(32.1, 32.0).has_value()) << "nothing after the end";
}

TEST(TargetPreview, IsEmptyWhereTheTargetIsNotAFunctionOfTime) {
  EXPECT_TRUE(preview_target(*task("two_target.toml"), {}).parts.empty());
  EXPECT_FALSE(preview_target(*task("resting_force.toml"), {}).has_target());
}

TEST(ForceAxis, HoldsEveryForceAndMoreForceIsAlwaysHigher) {
  for (const ForceAxis axis : {ForceAxis{0.0, 12.0}, ForceAxis{-4.0, 8.0}, ForceAxis{-6.0, 0.0}}) {
    double last = 0.0;
    for (double force_N = -500.0; force_N <= 500.0; force_N += 0.25) {
      const double share = axis.share(force_N);
      ASSERT_GT(share, last) << force_N;
      ASSERT_LT(share, 1.0) << force_N;
      last = share;
    }
    const double middle = axis.share(0.5 * (axis.least_N + axis.most_N));
    EXPECT_WITHIN(middle, 0.5 * (axis.share(axis.least_N) + axis.share(axis.most_N)), 1e-12)
        << "linear between the targets";
  }
}

TEST(ForceAxis, DoesNotBendSharplyWhereTheTargetsEnd) {
  const ForceAxis axis{-2.0, 10.0};
  constexpr double kStep_N = 1e-6;
  constexpr double kCurvature = 1e-5;  // one step's share of the slope's change
  for (const double end_N : {axis.least_N, axis.most_N}) {
    const double before = axis.share(end_N) - axis.share(end_N - kStep_N);
    const double after = axis.share(end_N + kStep_N) - axis.share(end_N);
    EXPECT_WITHIN(after / before, 1.0, kCurvature);
  }
}

}  // namespace
}  // namespace isograsp::gui::patient_picture_test
