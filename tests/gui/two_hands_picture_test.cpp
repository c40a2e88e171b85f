// SPDX-License-Identifier: GPL-3.0-or-later
// What a patient sees of two hands: each on its own side, told apart without colours, their sum
// where it is the goal, no number, and nothing that the stimulus does not hold.
#include "gui/picture/two_hands_picture.hpp"

#include <QRegularExpression>
#include <map>

#include "gui/patient_screen/patient_canvas.hpp"
#include "gui/presenter/patient_facts.hpp"
#include "qt_test.hpp"
#include "session/library/library.hpp"
#include "spoken.hpp"
#include "tests/support/every.hpp"
#include "tests/support/every_language.hpp"
#include "tests/support/must.hpp"

namespace isograsp::gui::test::two_hands_picture_test {
namespace {

using isograsp::test::every;
using isograsp::test::must;
using Page = PatientPicture::Page;

const std::string kLibrary = ISOGRASP_SOURCE_DIR "/library";
constexpr QSize kScreen(1280, 720);

/// The maxima of an affected left hand and of the other one.
tasks::TaskContext context() {
  tasks::TaskContext context;
  context.period_s = 0.01;
  context.seed = 2;  // the left hand begins with the maxima
  context.two_hands.of.left.maximum_N = 10.0;
  context.two_hands.of.right.maximum_N = 30.0;
  for (const Hand hand : kBothHands) context.two_hands.of[hand].resting_N = 0.5;
  context.two_hands.affected = Hand::left;
  return context;
}

tasks::TaskSpec task(const std::string& name) {
  return must(session::load_task(kLibrary + "/tasks/" + name + ".toml"));
}

/// Frames of a trial in which each hand presses so much; `every_s` apart.
std::vector<PatientFacts> frames(const std::string& name, OfHands<double> pressed_N,
                                 double every_s = 0.5) {
  const auto spec = std::make_shared<const tasks::TaskSpec>(task(name));
  const auto preview = std::make_shared<TargetPreview>(preview_target(*spec, context()));
  auto running = must(tasks::make_task(*spec, context()));
  tasks::TwoHandsInput input;
  for (const Hand hand : kBothHands) {
    input.wrench_C[hand][index_of(Finger::thumb)].force.z() = pressed_N[hand];
    input.wrench_C[hand][index_of(Finger::index)].force.z() = pressed_N[hand];
  }
  std::vector<PatientFacts> seen;
  for (int k = 0;; ++k) {
    const tasks::TaskView view = running->step(input);
    if (view.phase == tasks::Phase::done) return seen;
    if (k % static_cast<int>(every_s / context().period_s) != 0) continue;
    session::TwoPlatformsSnapshot now;
    now.frames = k + 1;
    now.stage = session::Stage::trial;
    now.task = view;
    now.special = view;
    PatientFacts facts = patient_facts(now);
    facts.session_open = true;
    facts.task = spec;
    facts.preview = preview;
    seen.push_back(facts);
  }
}

/// The frame in the middle of the work.
PatientFacts middle(const std::string& name, OfHands<double> pressed_N) {
  const auto all = frames(name, pressed_N);
  return all[all.size() * 6 / 10];
}

QImage painted(const PatientPicture& picture, const QRectF& area = QRectF(QPointF(), kScreen)) {
  QImage image(kScreen, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  paint_page(painter, area, picture);
  return image;
}

QRect difference(const QImage& a, const QImage& b) {
  QRect all;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      if (a.pixel(x, y) != b.pixel(x, y)) all |= QRect(x, y, 1, 1);
  return all;
}

void keep(const PatientPicture& picture, const QString& name,
          const QRectF& area = QRectF(QPointF(), kScreen)) {
  const auto folder = qEnvironmentVariable("ISOGRASP_TEST_PICTURES");
  if (folder.isEmpty()) return;
  QDir().mkpath(folder);
  EXPECT_TRUE(painted(picture, area).save(folder + "/" + name + ".png"));
}

const std::vector<std::string> kTasks{
    "two_hands_rest",  "two_hands_maximum",           "two_hands_sum",           "two_hands_each",
    "two_hands_turns", "two_hands_affected_works_25", "two_hands_other_works_50"};

class TwoHandsOnTheScreen : public QtTest {};

TEST_F(TwoHandsOnTheScreen, EachStandsOnItsSideAndItsForceMovesNothingOfTheOther) {
  PatientFacts facts = middle("two_hands_each", {2.0, 6.0});
  const PatientPicture picture = picture_for(facts);
  ASSERT_EQ(picture.page, Page::two_hands);
  ASSERT_TRUE(picture.two_hands);
  EXPECT_EQ(picture.two_hands->of.left.name, "Left hand");
  EXPECT_EQ(picture.two_hands->of.right.name, "Right hand");
  for (const Hand hand : kBothHands) {
    PatientFacts more = facts;
    more.stimulus.hands->of[hand].force_N += 1.0;
    const QRect moved = difference(painted(picture), painted(picture_for(more)));
    ASSERT_FALSE(moved.isEmpty());
    if (hand == Hand::left)
      EXPECT_LT(moved.right(), kScreen.width() / 2);
    else
      EXPECT_GT(moved.left(), kScreen.width() / 2);
  }
}

TEST_F(TwoHandsOnTheScreen, AreToldApartByShapeAsWellAsByColour) {
  PatientFacts facts = middle("two_hands_each", {2.0, 2.0});
  facts.stimulus.hands->of.right = facts.stimulus.hands->of.left;
  facts.preview = nullptr;  // the same scale
  const QImage grey = painted(picture_for(facts)).convertToFormat(QImage::Format_Grayscale8);
  // The bars: the same height, yet no mirror image of one another.
  const QRect bars(0, kScreen.height() * 29 / 100, kScreen.width(), kScreen.height() * 43 / 100);
  const QImage here = grey.copy(bars);
  constexpr int kClearly = 40;  // of 255: more than the difference of the two colours
  int differ = 0;
  for (int y = 0; y < here.height(); ++y)
    for (int x = 0; x < here.width() / 2; ++x)
      if (std::abs(qGray(here.pixel(x, y)) - qGray(here.pixel(here.width() - 1 - x, y))) > kClearly)
        ++differ;
  EXPECT_GT(differ, 500);
}

TEST_F(TwoHandsOnTheScreen, TheSumStandsBetweenThemWhereItIsTheGoalAndOnlyThere) {
  PatientFacts facts = middle("two_hands_sum", {2.0, 6.0});
  EXPECT_FALSE(picture_for(facts).two_hands->left_of_sum) << "the task shows their sum alone";
  facts.stimulus.hands->of.left.force_shown = facts.stimulus.hands->of.right.force_shown = true;
  facts.stimulus.hands->of.left.force_N = 2.0;
  facts.stimulus.hands->of.right.force_N = 6.0;
  const auto sum = picture_for(facts);
  keep(sum, "two_hands_sum_of_both");
  ASSERT_TRUE(sum.two_hands && sum.two_hands->sum);
  EXPECT_TRUE(sum.two_hands->sum->target_shown);
  EXPECT_FALSE(sum.two_hands->of.left.bar.target_shown);
  ASSERT_TRUE(sum.two_hands->left_of_sum);
  constexpr double kRounding = 1e-12;  // one quotient
  EXPECT_NEAR(*sum.two_hands->left_of_sum, 0.25, kRounding);
  // One scale: what both give adds up in the linear middle.
  constexpr double kRoundingOfHeights = 1e-9;  // sums of three
  EXPECT_NEAR(sum.two_hands->of.left.bar.force + sum.two_hands->of.right.bar.force,
              sum.two_hands->sum->force, kRoundingOfHeights);
  for (const char* other : {"two_hands_each", "two_hands_turns", "two_hands_rest"})
    EXPECT_FALSE(picture_for(middle(other, {2.0, 6.0})).two_hands->sum) << other;
}

TEST_F(TwoHandsOnTheScreen, AWeakHandMovesItsBarAsFarAsAStrongOne) {
  const auto picture = picture_for(middle("two_hands_turns", {2.0, 6.0}));  // 20 % of each maximum
  constexpr double kRounding = 1e-12;
  EXPECT_NEAR(picture.two_hands->of.left.bar.force, picture.two_hands->of.right.bar.force,
              kRounding);
}

TEST_F(TwoHandsOnTheScreen, OtherHandAtRestIsCalledSoAndShowsNoForceOfIt) {
  for (const char* name : {"two_hands_affected_works_25", "two_hands_other_works_50"}) {
    bool worked = false;
    for (const PatientFacts& facts : every(frames(name, {2.0, 6.0}))) {
      const PatientPicture picture = picture_for(facts);
      const OfHands<bool> works{picture.two_hands->of.left.works,
                                picture.two_hands->of.right.works};
      EXPECT_FALSE(works.left && works.right) << name;
      if (works.left == works.right) continue;
      worked = true;
      const Hand resting = works.left ? Hand::right : Hand::left;
      EXPECT_EQ(picture.detail, "Other hand at rest");
      EXPECT_FALSE(picture.two_hands->of[resting].bar.force_shown);
      EXPECT_EQ(picture.two_hands->of[resting].bar.force, 0.0);
      EXPECT_EQ(picture.two_hands->of[resting].act, "at rest");
    }
    EXPECT_TRUE(worked) << name;
  }
}

TEST_F(TwoHandsOnTheScreen, NothingBehindASwitchThatIsOffIsInThePicture) {
  constexpr double kFar_N = 321.0;
  for (const std::string& name : every(kTasks))
    for (const PatientFacts& facts : every(frames(name, {2.0, 6.0}, 4.0))) {
      PatientFacts hidden = facts;
      ShownHands& hands = *hidden.stimulus.hands;
      for (ShownHand* one : {&hands.of.left, &hands.of.right, &hands.sum}) {
        one->force_shown = one->target_shown = false;
        one->force_N = one->target_force_N = 0.0;
      }
      const PatientPicture without = picture_for(hidden);
      for (ShownHand* one : {&hands.of.left, &hands.of.right, &hands.sum})
        one->force_N = one->target_force_N = kFar_N;
      const PatientPicture with = picture_for(hidden);
      EXPECT_TRUE(*with.two_hands == *without.two_hands) << name;
      EXPECT_EQ(with.headline + with.detail, without.headline + without.detail) << name;
      EXPECT_EQ(with.force_N, 0.0) << name;
    }
}

TEST_F(TwoHandsOnTheScreen, NoNumberIsOnItInAnyLanguage) {
  for (const std::string language : every(isograsp::test::every_language())) {
    const Spoken spoken(language.c_str());
    for (const std::string& name : every(kTasks))
      for (const PatientFacts& facts : every(frames(name, {2.0, 6.0}, 4.0))) {
        const PatientPicture picture = picture_for(facts);
        const TwoHandsPicture& both = *picture.two_hands;
        const QString all = QString::fromStdString(
            picture.headline + picture.detail + both.sum_name + both.of.left.name +
            both.of.left.act + both.of.right.name + both.of.right.act);
        EXPECT_FALSE(all.contains(QRegularExpression("[0-9]"))) << all.toStdString();
      }
  }
}

TEST_F(TwoHandsOnTheScreen, CalmIsTheSamePictureAndHalfAScreenHoldsAllOfIt) {
  for (const std::string& name : every(kTasks)) {
    PatientFacts facts = middle(name, {2.0, 6.0});
    const PatientPicture lively = picture_for(facts);
    facts.calm = true;
    EXPECT_EQ(painted(picture_for(facts)), painted(lively)) << name;  // nothing scrolls
    const QRectF screen(QPointF(), kScreen);
    for (const auto half : {Presentation::Half::left, Presentation::Half::right}) {
      const QRectF area = content_area(screen, half);
      const QImage image = painted(lively, area);
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
          if (!area.adjusted(-1, -1, 1, 1).contains(x, y)) {
            ASSERT_EQ(image.pixel(x, y), qRgb(255, 255, 255)) << name << " at " << x << ", " << y;
          }
      keep(lively, QString("two_hands_half_%1_%2").arg(static_cast<int>(half)).arg(name.c_str()),
           area);
    }
  }
}

TEST_F(TwoHandsOnTheScreen, WhatIsReachedStandsStillWhileTheTargetMoves) {
  // The band that is asked for moves with its target; the scale never does.
  const auto all = frames("two_hands_sum", {2.0, 6.0});
  std::map<double, int> heights;
  isograsp::test::AtLeast moved(10);
  double before = -1.0;
  for (const PatientFacts& facts : all) {
    const auto picture = picture_for(facts);
    ++heights[picture.two_hands->sum->force];
    if (picture.two_hands->sum->target != before) ++moved;
    before = picture.two_hands->sum->target;
  }
  EXPECT_EQ(heights.size(), 1U);
}

TEST_F(TwoHandsOnTheScreen, WordsSpeakOfBothHandsBetweenTrialsAndInNeed) {
  session::TwoPlatformsSnapshot now;
  now.frames = 1;
  PatientFacts facts = patient_facts(now);
  facts.session_open = true;
  EXPECT_EQ(picture_for(facts).headline, "Please take both hands out of the devices");
  facts.stage = session::Stage::zeroing;
  EXPECT_EQ(picture_for(facts).headline, "Hands off, please");
  facts.stage = session::Stage::idle;
  facts.stimulus.cue = Cue::relax;
  EXPECT_EQ(picture_for(facts).headline, "Relax both hands");
  facts.just_completed = true;
  EXPECT_EQ(picture_for(facts).detail, "Relax both hands.");
  facts.device_fault = true;
  EXPECT_EQ(picture_for(facts).notice_words,
            "The device needs help. You did nothing wrong. Relax both hands.");
  PatientFacts paused = middle("two_hands_sum", {2.0, 6.0});
  paused.stage = session::Stage::paused;
  paused.pause_cause = session::PauseCause::therapist;
  EXPECT_EQ(picture_for(paused).notice_words, "Pause. Relax both hands.");
}

TEST_F(TwoHandsOnTheScreen, IsKeptToBeLookedAtInEveryLanguage) {
  for (const std::string language : every(isograsp::test::every_language())) {
    const Spoken spoken(language.c_str());
    for (const std::string& name : every(kTasks)) {
      PatientFacts facts = middle(name, {2.0, 6.0});
      facts.simulated = true;
      keep(picture_for(facts), QString("two_hands_%1_%2").arg(name.c_str(), language.c_str()));
      EXPECT_EQ(picture_for(facts).page, Page::two_hands);
    }
    const auto maxima = frames("two_hands_maximum", {8.0, 25.0});
    for (const std::size_t k : {5U, 131U, 257U})
      keep(picture_for(maxima[k]), QString("two_hands_maximum_%1_%2").arg(k).arg(language.c_str()));
  }
}

}  // namespace
}  // namespace isograsp::gui::test::two_hands_picture_test
