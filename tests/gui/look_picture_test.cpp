// SPDX-License-Identifier: GPL-3.0-or-later
// Looks of training on the patient's screen: everything stands where it stands without one, and
// between trials a circle counts down.
#include <cmath>

#include "core/csv.hpp"
#include "gui/patient_screen/patient_canvas.hpp"
#include "gui/training_looks/object_forms.hpp"
#include "qt_test.hpp"
#include "tests/support/every.hpp"

namespace isograsp::gui::test::look_picture_test {
namespace {

using tasks::Look;

class LookPicture : public QtTest {};

std::shared_ptr<const tasks::TaskSpec> training(const char* file, double level, Look look) {
  const std::string path = std::string(ISOGRASP_SOURCE_DIR "/library/tasks/") + file;
  const auto spec = *tasks::parse_task(*read_text(path), path);
  return std::make_shared<tasks::TaskSpec>(*tasks::at_level(spec, level, look));
}

PatientFacts following(double level, Look look) {
  PatientFacts facts;
  facts.session_open = true;
  facts.arrived = true;
  facts.stage = session::Stage::trial;
  facts.task = training("grip_sine_training.toml", level, look);
  TargetPreview preview;
  preview.period_s = 0.01;
  preview.ahead_s = 3.0;
  preview.axis = {0.0, 10.0};
  for (int k = 0; k < 1500; ++k) preview.target_N.push_back(5.0 + 3.0 * std::sin(0.0126 * k));
  facts.preview = std::make_shared<TargetPreview>(preview);
  facts.stimulus.cue = facts.stimulus.page_cue = Cue::follow;
  facts.stimulus.progress.task_time_s = 4.2;
  facts.stimulus.progress.duration_s = 20.0;
  facts.stimulus.force_target_shown = true;
  facts.stimulus.target_force_N = *preview.at(4.2, 4.2);
  facts.stimulus.shown_force_N = facts.stimulus.target_force_N + 0.1;
  return facts;
}

QImage painted_page(const PatientPicture& picture, const QSize& size = {1280, 720}) {
  QImage image(size, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  paint_page(painter, QRectF(QPointF(0, 0), QSizeF(size)), picture);
  return image;
}

void keep(const QImage& image, const std::string& name) {
  const auto folder = qEnvironmentVariable("ISOGRASP_TEST_PICTURES");
  if (folder.isEmpty()) return;
  QDir().mkpath(folder);
  image.save(folder + "/" + QString::fromStdString(name) + ".png");
}

TEST_F(LookPicture, MovesNothingThatAPersonAnswersTo) {
  const PatientPicture plain = picture_for(following(0.5, Look::plain));
  ASSERT_EQ(plain.page, PatientPicture::Page::tracking);
  ASSERT_TRUE(plain.on_target);
  for (const Look look : {Look::river, Look::balloon}) {
    const PatientPicture dressed = picture_for(following(0.5, look));
    EXPECT_EQ(dressed.look, look);
    EXPECT_EQ(dressed.page, plain.page);
    EXPECT_EQ(dressed.headline, plain.headline);
    EXPECT_EQ(dressed.detail, plain.detail);
    EXPECT_EQ(dressed.force_N, plain.force_N);
    EXPECT_EQ(dressed.target_N, plain.target_N);
    EXPECT_EQ(dressed.on_target, plain.on_target);
    EXPECT_EQ(dressed.task_time_s, plain.task_time_s);
    EXPECT_EQ(dressed.axis.least_N, plain.axis.least_N);
    EXPECT_EQ(dressed.axis.most_N, plain.axis.most_N);
    EXPECT_EQ(dressed.gain_deg_per_N, plain.gain_deg_per_N);
  }
}

TEST_F(LookPicture, ChangesTheFieldAndNothingBesideIt) {
  for (const QSize size : {QSize(1280, 720), QSize(640, 480)})
    for (const bool calm : {false, true}) {
      PatientFacts facts = following(0.5, Look::plain);
      facts.calm = calm;
      const QImage plain = painted_page(picture_for(facts), size);
      for (const double level : {0.1, 0.5, 0.9})
        for (const Look look : {Look::river, Look::balloon}) {
          facts.task = training("grip_sine_training.toml", level, look);
          const QImage dressed = painted_page(picture_for(facts), size);
          const int top = static_cast<int>(0.30 * size.height()) - 1;
          const int bottom = static_cast<int>(std::ceil(0.90 * size.height())) + 1;
          EXPECT_EQ(plain.copy(0, 0, size.width(), top), dressed.copy(0, 0, size.width(), top));
          EXPECT_EQ(plain.copy(0, bottom, size.width(), size.height() - bottom),
                    dressed.copy(0, bottom, size.width(), size.height() - bottom));
          EXPECT_NE(plain, dressed);
          keep(dressed, std::string("look_") + std::string(name_of(look)) + "_" +
                            std::to_string(static_cast<int>(10.0 * level)));
        }
    }
}

TEST_F(LookPicture, IsTheSameForTheSameStimulus) {
  for (const Look look : {Look::plain, Look::river, Look::balloon}) {
    const auto picture = picture_for(following(0.5, look));
    const QImage first = painted_page(picture);
    (void)painted_page(picture_for(following(0.9, look)), {640, 480});  // in between another one
    EXPECT_EQ(painted_page(picture), first);
  }
}

TEST_F(LookPicture, OnACalmScreenTheLandscapeStandsStill) {
  for (const Look look : {Look::river, Look::balloon}) {
    PatientFacts facts = following(0.5, look);
    facts.calm = true;
    facts.stimulus.force_shown = false;  // no mark
    const QImage before = painted_page(picture_for(facts));
    facts.stimulus.progress.task_time_s += 0.02;
    const QImage after = painted_page(picture_for(facts));
    const QRect field(700, 217, 500, 420);  // of the future, where the target does not come nearer
    EXPECT_EQ(before.copy(field.adjusted(0, 0, -300, 0)),
              after.copy(field.adjusted(0, 0, -300, 0)));
  }
}

PatientFacts resting(double left_s, bool trains) {
  PatientFacts facts;
  facts.session_open = true;
  facts.arrived = true;
  facts.just_completed = true;
  facts.rest_left_s = left_s;
  facts.trains = trains;
  return facts;
}

TEST_F(LookPicture, ARestCountsDownAndItsCircleBreathesInTrainingOnly) {
  const auto none = picture_for(resting(0.0, true));
  EXPECT_FALSE(none.rest_left_s);
  const auto assessment = picture_for(resting(15.0, false));
  EXPECT_EQ(assessment.rest_left_s, 15.0);
  EXPECT_EQ(assessment.breath, 0.0);
  const auto wide = picture_for(resting(15.0, true));
  EXPECT_NEAR(wide.breath, 1.0, 1e-12);
  EXPECT_NEAR(picture_for(resting(20.0, true)).breath, 0.0, 1e-12);
  EXPECT_NE(painted_page(wide), painted_page(assessment));
  EXPECT_NE(painted_page(picture_for(resting(14.0, false))), painted_page(assessment));
  keep(painted_page(wide), "rest_training");
  keep(painted_page(assessment), "rest_assessment");
  auto calm = resting(15.0, true);
  calm.calm = true;
  EXPECT_EQ(picture_for(calm).breath, 0.0);
}

TEST_F(LookPicture, ARestNeverHidesATrialOrAFault) {
  PatientFacts facts = following(0.5, Look::plain);
  facts.rest_left_s = 10.0;
  EXPECT_FALSE(picture_for(facts).rest_left_s);
}

TEST_F(LookPicture, RoundFormsAreForWhatShowsNoTurnAboutTheirAxis) {
  const auto scene_named = [](const std::string& name) {
    const std::string path = ISOGRASP_SOURCE_DIR "/library/scenes/" + name + ".toml";
    return *parse_scene(*read_text(path), path);
  };
  for (const Look look : {Look::cup, Look::lantern}) {
    EXPECT_TRUE(object_forms::has_form(look, scene_named("planar_block")));
    EXPECT_FALSE(object_forms::has_form(look, scene_named("free_block")));
    EXPECT_FALSE(object_forms::has_form(look, scene_named("knob")));
  }
  EXPECT_FALSE(object_forms::has_form(Look::plain, scene_named("planar_block")));
}

PatientPicture two_hands(Look look) {
  PatientPicture picture;
  picture.page = PatientPicture::Page::two_hands;
  picture.look = look;
  picture.two_hands.emplace();
  return picture;
}

TEST_F(LookPicture, OfTwoHandsClothesBoxAndTray) {
  for (const Look look : {Look::plain, Look::crate}) {
    PatientPicture picture = two_hands(look);
    CarryPicture carry;
    carry.size_m = Vec3(0.20, 0.16, 0.1);
    carry.p_W = Vec3(-0.15, 0.05, 0.0);
    carry.half_size_m = Vec3(0.12, 0.12, 0.1);
    carry.of.left.p_W = Vec3(-0.25, 0.05, 0.0);
    carry.of.right.p_W = Vec3(-0.05, 0.05, 0.0);
    carry.of.left.bubble_W = carry.of.left.p_W;
    carry.of.right.bubble_W = carry.of.right.p_W;
    carry.held = true;
    carry.target_shown = true;
    carry.target_W = Vec3(0.2, -0.05, 0.0);
    carry.tolerance_m = 0.02;
    carry.low_W = Vec3(-0.4, -0.25, 0.0);
    carry.high_W = Vec3(0.4, 0.25, 0.0);
    picture.two_hands->carry = carry;
    keep(painted_page(picture), std::string("carry_") + std::string(name_of(look)));
    PatientPicture plain = picture;
    plain.look = Look::plain;
    EXPECT_EQ(painted_page(picture) == painted_page(plain), look == Look::plain);
  }
  for (const Look look : {Look::plain, Look::tea_tray}) {
    PatientPicture picture = two_hands(look);
    TrayPicture tray;
    tray.size_m = Vec3(0.4, 0.02, 0.2);
    tray.p_W = Vec3(0.0, 0.08, 0.0);
    tray.angle_rad = 0.06;
    tray.rest_y_m = 0.0;
    tray.target_shown = true;
    tray.target_y_m = 0.1;
    tray.band_m = 0.02;
    tray.of.left = {Vec3(-0.2, 0.07, 0.0), true, false};
    tray.of.right = {Vec3(0.2, 0.09, 0.0), true, false};
    picture.two_hands->tray = tray;
    keep(painted_page(picture), std::string("tray_") + std::string(name_of(look)));
  }
}

}  // namespace
}  // namespace isograsp::gui::test::look_picture_test
