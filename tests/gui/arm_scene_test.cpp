// SPDX-License-Identifier: GPL-3.0-or-later
// The patient's three-dimensional picture of an arm's object, drawn by OpenGL: needs a display.
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <cmath>
#include <functional>
#include <numbers>

#include "gui/patient_screen/object_scene.hpp"
#include "gui/picture/arm_space.hpp"
#include "qt_test.hpp"

namespace isograsp::gui::test::arm_scene_test {
namespace {

const QSize kSize(640, 360);

class ArmScene : public QtTest {
 protected:
  ArmScene() {
    session::ArmSetup setup;
    setup.object_m = {Vec3(-0.03, -0.02, -0.04), Vec3(0.03, 0.02, 0.04)};
    picture_.page = PatientPicture::Page::object;
    picture_.in_space = picture_.object_shown = true;
    picture_.scene = ArmSpace(setup, Hand::right).box();
  }

  /// Where pictures are asked for.
  static void keep(const QImage& image, const char* name) {
    const auto folder = qEnvironmentVariable("ISOGRASP_TEST_PICTURES");
    if (folder.isEmpty()) return;
    QDir().mkpath(folder);
    EXPECT_TRUE(image.save(folder + "/" + name + ".png"));
  }
  QImage drawn() {
    QSurfaceFormat format;
    format.setVersion(2, 1);
    format.setProfile(QSurfaceFormat::CompatibilityProfile);
    format.setDepthBufferSize(24);
    QOpenGLContext context;
    context.setFormat(format);
    QOffscreenSurface surface;
    surface.setFormat(format);
    surface.create();
    EXPECT_TRUE(context.create() && context.makeCurrent(&surface));
    QOpenGLFramebufferObject buffer(kSize, QOpenGLFramebufferObject::CombinedDepthStencil);
    EXPECT_TRUE(buffer.bind());
    ObjectScene scene;
    scene.show(picture_);
    scene.draw(QRect(QPoint(0, 0), kSize));
    return buffer.toImage();
  }
  /// Points of the picture that fit.
  static int count(const QImage& image, const std::function<bool(int, int, int)>& fits) {
    int found = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const QRgb c = image.pixel(x, y);
        found += fits(qRed(c), qGreen(c), qBlue(c));
      }
    return found;
  }
  static bool is_blue(int r, int g, int b) { return b > r + 40 && b > g + 20; }
  static bool is_green(int r, int g, int b) { return g > r + 40 && g > b + 20; }
  static bool is_yellow(int r, int g, int b) { return r > 190 && g > 160 && b < 120; }

  PatientPicture picture_;
};

constexpr int kSome = 600;  // points: the object covers thousands, its edges some hundreds

TEST_F(ArmScene, TheObjectTurnsGreenOnItsTargetAndPaleOutOfSight) {
  if (QGuiApplication::platformName() != "xcb") GTEST_SKIP() << "needs a display";
  const QImage seen = drawn();
  EXPECT_GT(count(seen, is_blue), kSome);
  EXPECT_LT(count(seen, is_green), kSome);
  picture_.matched = true;
  const QImage matched = drawn();
  EXPECT_GT(count(matched, is_green), kSome);
  EXPECT_LT(count(matched, is_blue), kSome);
  picture_.matched = false;
  picture_.unseen = true;
  const QImage pale = drawn();
  keep(pale, "arm_unseen");
  EXPECT_LT(count(pale, is_blue), kSome);
  EXPECT_LT(count(pale, is_green), kSome);
  picture_.object_shown = false;
  EXPECT_NE(drawn(), pale) << "pale is not gone";
}

TEST_F(ArmScene, TheTargetHasBrightCornersAndIsSeenThrough) {
  if (QGuiApplication::platformName() != "xcb") GTEST_SKIP() << "needs a display";
  const int without = count(drawn(), is_yellow);
  picture_.target_shown = true;
  picture_.X_WT.p = Vec3(0.15, 0.0, 0.0);
  EXPECT_GT(count(drawn(), is_yellow), without + 40);
  picture_.X_WT.p = Vec3(0.0, 0.0, 0.06);  // in front of the object
  const QImage through = drawn();
  keep(through, "arm_behind_target");
  picture_.object_shown = false;
  const QImage empty = drawn();
  int changed = 0;
  const QRect inside(kSize.width() / 2 - 15, kSize.height() / 2 - 10, 30, 30);
  for (int y = inside.top(); y <= inside.bottom(); ++y)
    for (int x = inside.left(); x <= inside.right(); ++x)
      changed += through.pixel(x, y) != empty.pixel(x, y);
  EXPECT_GT(changed, inside.width() * inside.height() / 2) << "the object behind it is seen";
}

TEST_F(ArmScene, WhatMovesRightUpAndAwayMovesSoInThePicture) {
  if (QGuiApplication::platformName() != "xcb") GTEST_SKIP() << "needs a display";
  constexpr double kMostOff_rad = 15.0 * std::numbers::pi / 180.0;
  ObjectScene scene;
  scene.show(picture_);
  for (const Vec3& from : {Vec3(0.0, 0.0, 0.0), Vec3(0.15, 0.1, -0.1), Vec3(-0.15, -0.1, 0.1)}) {
    const auto moved = [&](const Vec3& way) {
      return scene.project(from + way, kSize) - scene.project(from, kSize);
    };
    const QPointF right = moved({0.05, 0.0, 0.0});
    const QPointF up = moved({0.0, 0.05, 0.0});
    EXPECT_LT(std::abs(std::atan2(-right.y(), right.x())), kMostOff_rad);
    EXPECT_LT(std::abs(std::atan2(up.x(), -up.y())), kMostOff_rad);
    const auto width_at = [&](double z) {
      return scene.project(from + Vec3(0.05, 0.0, z), kSize).x() -
             scene.project(from + Vec3(0.0, 0.0, z), kSize).x();
    };
    EXPECT_LT(width_at(-0.2), width_at(0.0)) << "what is away is smaller";
    EXPECT_LT(moved({0.0, 0.0, -0.1}).y(), 0.0) << "and higher: it is looked at from above";
  }
}

}  // namespace
}  // namespace isograsp::gui::test::arm_scene_test
