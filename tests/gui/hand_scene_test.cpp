// SPDX-License-Identifier: GPL-3.0-or-later
// The patient's three-dimensional picture of a tracked hand, drawn by OpenGL: needs a display.
#include "gui/patient_screen/hand_scene.hpp"

#include <QElapsedTimer>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QPainter>
#include <QSignalSpy>
#include <cmath>
#include <functional>
#include <numbers>

#include "gui/patient_screen/hand_footer.hpp"
#include "gui/patient_screen/patient_canvas.hpp"
#include "gui/presenter/patient_facts.hpp"
#include "gui/trial_pages/replay_window.hpp"
#include "hand_stage.hpp"
#include "qt_test.hpp"

namespace isograsp::gui::test::hand_scene_test {
namespace {

using virtual_hand::DigitState;

const QSize kScreen(1280, 720);

PatientFacts facts_of(const session::HandSnapshot& now, const tasks::TaskSpec& task,
                      Hand side = Hand::right) {
  PatientFacts facts = patient_facts(now);
  facts.session_open = true;
  facts.simulated = true;
  facts.hand = side;
  facts.task = std::make_shared<tasks::TaskSpec>(task);
  return facts;
}

class HandSceneDrawn : public QtTest {
 protected:
  void SetUp() override {
    if (QGuiApplication::platformName() != "xcb") GTEST_SKIP() << "needs a display";
    QSurfaceFormat format;
    format.setVersion(2, 1);
    format.setProfile(QSurfaceFormat::CompatibilityProfile);
    format.setDepthBufferSize(24);
    context_.setFormat(format);
    surface_.setFormat(format);
    surface_.create();
    ASSERT_TRUE(context_.create() && context_.makeCurrent(&surface_));
    scene_ = std::make_unique<HandScene>();
  }
  void TearDown() override {
    scene_.reset();
    context_.doneCurrent();
  }

  /// The hand alone.
  QImage drawn(const HandPicture& picture, const QSize& size = kScreen) {
    QOpenGLFramebufferObjectFormat format;
    format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
    format.setSamples(4);  // as where a graphics card draws
    QOpenGLFramebufferObject buffer(size, format);
    EXPECT_TRUE(buffer.bind());
    scene_->show(picture);
    scene_->draw(QRect(QPoint(0, 0), size));
    return buffer.toImage().convertToFormat(QImage::Format_RGB32);
  }
  /// As it stands on the screen; kept where pictures are asked for.
  QImage screen(const PatientPicture& picture, const char* name) {
    QImage whole(kScreen, QImage::Format_RGB32);
    QPainter painter(&whole);
    const QRectF area(whole.rect());
    const QRect part = hand_area(area).toRect();
    painter.drawImage(part.topLeft(), drawn(*picture.tracked_hand, part.size()));
    const auto project = [&](const Vec3& p_W) {
      return scene_->project(p_W, part.size()) + part.topLeft();
    };
    if (picture.hold_fraction > 0.0)
      paint_hold_ring(painter, project(picture.ring_W) + QPointF(0.0, 104.0), 32.0,
                      picture.hold_fraction);
    if (picture.matched) paint_check(painter, project(picture.X_WO.p) + QPointF(0.0, 104.0), 35.0);
    paint_banner(painter, area, picture);
    paint_footer(painter, area, picture);
    painter.end();
    const auto folder = qEnvironmentVariable("ISOGRASP_TEST_PICTURES");
    if (folder.isEmpty()) return whole;
    QDir().mkpath(folder);
    EXPECT_TRUE(whole.save(folder + "/" + name + ".png"));
    return whole;
  }
  static int count(const QImage& image, const std::function<bool(int, int, int)>& fits) {
    int found = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const QRgb c = image.pixel(x, y);
        found += fits(qRed(c), qGreen(c), qBlue(c));
      }
    return found;
  }
  static bool is_blue(int r, int g, int b) { return b > r + 50 && b > g + 40; }
  static bool is_purple(int r, int g, int b) { return b > g + 40 && r > g + 25; }
  static bool is_orange(int r, int g, int b) { return r > g + 70 && r > b + 90; }
  static bool is_green(int r, int g, int b) { return g > r + 30 && g > b + 15; }
  static bool is_yellow(int r, int g, int b) { return r > 150 && g > 115 && b < 80; }
  static bool is_skin(int r, int g, int b) {
    return r > 90 && r > g + 20 && g > b + 10 && r < g + 75;
  }

  QOpenGLContext context_;
  QOffscreenSurface surface_;
  std::unique_ptr<HandScene> scene_;
};

constexpr int kSome = 60;  // points: the smallest part of the picture that is asked about has more

TEST_F(HandSceneDrawn, EachStateOfAPlacementLooksDifferent) {
  HandStage stage;
  stage.pass_entry();
  const tasks::TaskSpec task = HandStage::task("virtual_place_training.toml");
  const auto picture = [&] { return picture_for(facts_of(stage.now(), task)); };
  stage.begin(task);
  stage.run(1.0);
  const QImage rest = screen(picture(), "hand_rest");
  EXPECT_GT(count(rest, is_skin), 3000) << "a hand is a large part of the picture";
  EXPECT_LT(count(rest, is_orange), kSome);

  stage.run_to([](const auto& now) { return now.grasp.object_there; });
  stage.run(0.9);
  const QImage reaching = screen(picture(), "hand_reaching");
  EXPECT_GT(count(reaching, is_orange), kSome);
  EXPECT_GT(count(reaching, is_blue), kSome);

  stage.run_to([](const auto& now) {
    return std::any_of(now.grasp.digits.begin(), now.grasp.digits.end(),
                       [](const auto& digit) { return digit.state == DigitState::contact; });
  });
  screen(picture(), "hand_touching");
  stage.run_to([](const auto& now) {
    return !now.grasp.supported && now.grasp.held &&
           now.grasp.object.X_WO.p.y() > now.ground->table_m + 0.06;
  });
  const QImage lifted = screen(picture(), "hand_tied_and_lifted");
  EXPECT_GT(count(lifted, is_green), kSome);

  stage.hide(true);
  stage.run(0.5);
  const QImage lost = screen(picture(), "hand_lost");
  EXPECT_LT(count(lost, is_skin), count(lifted, is_skin) / 2) << "it is pale";
  stage.hide(false);

  stage.run_to(
      [](const auto& now) { return now.special.hand().at_target && now.task.hold_fraction > 0.5; });
  EXPECT_GT(count(screen(picture(), "hand_at_target"), is_blue), kSome);
  stage.run_to([](const auto& now) { return now.special.hand().let_go_asked; });
  const QImage done = screen(picture(), "hand_done");
  EXPECT_GT(count(done, is_purple), kSome);
  EXPECT_LT(count(lifted, is_purple), kSome);
}

/// In the page of the patient's trials.
TEST_F(HandSceneDrawn, AStoredTrialShowsTheHandAgainAndThePathOfTheObject) {
  HandStage stage;
  stage.pass_entry();
  const auto task =
      std::make_shared<tasks::TaskSpec>(HandStage::task("virtual_place_training.toml"));
  stage.begin(*task);
  stage.run_to([](const auto& now) { return now.special.hand().let_go_asked; });
  auto trial = std::make_shared<LoadedTrial>();
  trial->replay = isograsp::test::must(TrialReplay::make(stage.signals()));
  trial->task = task;
  trial->tracked = std::make_shared<const HandReplay>(trial->replay, stage.hand(), task.get());
  ASSERT_FALSE(trial->tracked->story().empty());
  const auto at = [&trial](double t_s) { return trial->replay.at(t_s); };
  ReplayWindow window;
  window.resize(560, 300);
  window.show();
  ASSERT_TRUE(wait_until([&] { return window.isExposed(); }));
  const auto picture = [&](double t_s, const char* name) {
    window.show_trial(trial);
    window.show_state(at(t_s));
    QSignalSpy drawn_now(&window, &QOpenGLWindow::frameSwapped);
    EXPECT_TRUE(wait_until([&] { return drawn_now.count() > 0; }));
    const QImage image = window.grabFramebuffer();
    const auto folder = qEnvironmentVariable("ISOGRASP_TEST_PICTURES");
    EXPECT_TRUE(folder.isEmpty() || image.save(folder + "/" + name + ".png"));
    return image;
  };
  const double tied_s = trial->tracked->story().front().t_s + 0.3;
  const QImage without = picture(tied_s, "hand_replay_drawn");
  EXPECT_GT(count(without, is_skin), 500);
  EXPECT_GT(count(without, is_orange), kSome / 4);
  trial->path = trial->replay.path(0.0005);
  const QImage with = picture(tied_s, "hand_replay_path");
  EXPECT_GT(count(with, is_blue), count(without, is_blue) + kSome) << "the path is drawn over it";
}

TEST_F(HandSceneDrawn, ALeftHandReachesForTheSameObjectAndItsThumbIsOnTheOtherSide) {
  HandStage stage(Hand::left);
  stage.pass_entry();
  const tasks::TaskSpec task = HandStage::task("virtual_place.toml");
  stage.begin(task);
  stage.run_to([](const auto& now) { return now.grasp.held && !now.grasp.supported; });
  stage.run(0.6);
  screen(picture_for(facts_of(stage.now(), task, Hand::left)), "hand_left");
}

TEST_F(HandSceneDrawn, TheEntryTestAndOpeningsShowTheHandAndHowFarItOpens) {
  HandStage stage;
  stage.begin_entry();
  stage.run(4.0);
  const tasks::TaskSpec task = HandStage::task("hand_opening.toml");
  const auto idle = [&] {
    PatientFacts facts = facts_of(stage.now(), task);
    facts.task.reset();
    facts.tracked->camera_on = true;
    return picture_for(facts);
  };
  screen(idle(), "hand_entry_rest");
  stage.run_to([](const auto& now) { return now.entry && now.entry->openings >= 1; });
  screen(idle(), "hand_entry_open");
  stage.run_to([](const auto& now) { return now.stage == session::Stage::idle; });
  screen(idle(), "hand_idle");
  stage.begin(task);
  stage.run_to([](const auto& now) { return now.task.cue == Cue::open; });
  stage.run(2.5);
  screen(picture_for(facts_of(stage.now(), task)), "hand_opening");
  stage.run_to([](const auto& now) { return now.task.cue == Cue::close; });
  stage.run(2.5);
  screen(picture_for(facts_of(stage.now(), task)), "hand_closing");
}

TEST_F(HandSceneDrawn, WhatMovesRightUpAndAwayMovesSoInThePicture) {
  constexpr double kMostOff_rad = 15.0 * std::numbers::pi / 180.0;
  HandPicture picture;
  picture.ground.table_m = 0.1;
  scene_->show(picture);
  for (const QSize& size : {QSize(1280, 520), QSize(640, 520), QSize(960, 780)})
    for (const Vec3& from : {Vec3(0.0, 0.15, 0.0), Vec3(0.14, 0.3, 0.0), Vec3(-0.14, 0.2, 0.1)}) {
      const auto moved = [&](const Vec3& way) {
        return scene_->project(from + way, size) - scene_->project(from, size);
      };
      const QPointF at = scene_->project(from, size);
      EXPECT_TRUE(QRectF(QPointF(0, 0), QSizeF(size)).contains(at)) << "all of it is seen";
      const QPointF right = moved({0.05, 0.0, 0.0});
      const QPointF up = moved({0.0, 0.05, 0.0});
      EXPECT_LT(std::abs(std::atan2(-right.y(), right.x())), kMostOff_rad);
      EXPECT_LT(std::abs(std::atan2(up.x(), -up.y())), kMostOff_rad);
      EXPECT_LT(moved({0.0, 0.0, -0.1}).y(), 0.0) << "what is away is higher …";
      const auto width_at = [&](double z) {
        return scene_->project(from + Vec3(0.05, 0.0, z), size).x() -
               scene_->project(from + Vec3(0.0, 0.0, z), size).x();
      };
      EXPECT_LT(width_at(-0.2), width_at(0.0)) << "… and smaller";
    }
}

TEST_F(HandSceneDrawn, TheSamePictureIsTheSameImageWhateverWasDrawnBefore) {
  HandStage stage;
  const HandPicture first = hand_picture(stage.now());
  const QImage once = drawn(first);
  HandPicture other = first;
  other.hand->X_WP.p.x() += 0.05;
  other.frozen = true;
  EXPECT_NE(drawn(other), once);
  EXPECT_EQ(drawn(first), once);
}

}  // namespace
}  // namespace isograsp::gui::test::hand_scene_test
