// SPDX-License-Identifier: GPL-3.0-or-later
// What is not in the stimulus is not in the patient's picture, whatever task of the library runs:
// values that stand behind a switch that is off change nothing.
#include <QImage>
#include <QPainter>
#include <functional>

#include <gtest/gtest.h>

#include "gui/patient_screen/patient_canvas.hpp"
#include "gui/picture/patient_picture.hpp"
#include "gui/presenter/patient_facts.hpp"
#include "qt_test.hpp"
#include "session/demonstration.hpp"
#include "session/library/library.hpp"
#include "tests/support/every.hpp"
#include "tests/support/platform_tasks.hpp"

namespace isograsp::gui::stimulus_picture_test {
namespace {

const std::string kLibrary = ISOGRASP_SOURCE_DIR "/library";
constexpr std::size_t kEvery = 50;  // frames of half a second: each part of a task is met
constexpr double kFar_N = 321.0;

QImage painted(const PatientPicture& picture) {
  QImage image(640, 360, QImage::Format_RGB32);
  QPainter painter(&image);
  paint_page(painter, QRectF(image.rect()), picture);
  return image;
}

/// Calls `look` with the facts of some frames of each task of the library.
void in_every_task(const std::function<void(PatientFacts, const std::string&)>& look) {
  gui::test::application();
  for (const tasks::TaskSpec& spec :
       isograsp::test::every(isograsp::test::platform_tasks(kLibrary))) {
    const auto shown = session::demonstrate(spec, {}, kLibrary).value();
    const auto preview =
        std::make_shared<TargetPreview>(preview_target(*shown.task, shown.context));
    for (std::size_t k = 0; k < shown.frames.size(); k += kEvery) {
      PatientFacts facts = patient_facts(shown.frames[k]);
      facts.session_open = true;
      facts.task = shown.task;
      facts.scene = shown.scene;
      facts.preview = preview;
      facts.viewing = {0.3, 0.7};
      look(facts, spec.name);
    }
  }
}

void expect_same(const PatientPicture& a, const PatientPicture& b, const std::string& of) {
  EXPECT_EQ(a.headline, b.headline) << of;
  EXPECT_EQ(a.detail, b.detail) << of;
  EXPECT_EQ(a.page, b.page) << of;
  EXPECT_EQ(a.axis.least_N, b.axis.least_N) << of;
  EXPECT_EQ(a.axis.most_N, b.axis.most_N) << of;
  EXPECT_EQ(a.gain_deg_per_N, b.gain_deg_per_N) << of;
  EXPECT_EQ(a.on_target, b.on_target) << of;
  if (a.page != PatientPicture::Page::object) {
    EXPECT_EQ(painted(a), painted(b)) << of;
  }
}

TEST(StimulusPicture, WithoutTheOwnForceThereIsNoneOnAnyPage) {
  isograsp::test::AtLeast changed(50);
  in_every_task([&](PatientFacts facts, const std::string& of) {
    const PatientPicture with = picture_for(facts);
    if (with.page == PatientPicture::Page::object) return;  // it has no force
    facts.stimulus.force_shown = false;
    facts.stimulus.shown_force_N = 0.0;
    facts.stimulus.digit_force_C.fill(Vec3::Zero());
    const PatientPicture without = picture_for(facts);
    EXPECT_FALSE(without.force_shown) << of;
    EXPECT_EQ(without.force_N, 0.0) << of;
    EXPECT_FALSE(without.gain_deg_per_N) << of;
    facts.stimulus.shown_force_N = kFar_N;
    facts.stimulus.digit_force_C.fill(Vec3(0.0, 0.0, kFar_N));
    expect_same(picture_for(facts), without, of);
    if (with.force_N != without.force_N) ++changed;
  });
}

TEST(StimulusPicture, WithoutATargetThereIsNoneOnAnyPage) {
  isograsp::test::AtLeast changed(50);
  in_every_task([&](PatientFacts facts, const std::string& of) {
    const PatientPicture with = picture_for(facts);
    facts.stimulus.force_target_shown = facts.stimulus.pose_target_shown = false;
    facts.stimulus.target_force_N = 0.0;
    facts.stimulus.X_WT = facts.stimulus.X_WO;
    const PatientPicture without = picture_for(facts);
    EXPECT_FALSE(without.line_shown) << of;
    EXPECT_FALSE(without.target_shown) << of;
    EXPECT_FALSE(without.on_target) << of;
    EXPECT_EQ(without.hold_fraction, 0.0) << of;
    facts.stimulus.target_force_N = kFar_N;
    facts.stimulus.progress.hold_fraction = 0.5;
    expect_same(picture_for(facts), without, of);
    if (with.line_shown || with.target_shown) ++changed;
  });
}

TEST(StimulusPicture, WithoutAnObjectThereIsNone) {
  isograsp::test::AtLeast changed(50);
  in_every_task([&](PatientFacts facts, const std::string& of) {
    if (picture_for(facts).page != PatientPicture::Page::object) return;
    facts.stimulus.object_shown = false;
    const PatientPicture without = picture_for(facts);
    EXPECT_NE(without.page, PatientPicture::Page::object) << of;
    EXPECT_EQ(without.scene, nullptr) << of;
    for (const FingerPicture& finger : without.fingers) EXPECT_FALSE(finger.shown) << of;
    ++changed;
  });
}

}  // namespace
}  // namespace isograsp::gui::stimulus_picture_test
