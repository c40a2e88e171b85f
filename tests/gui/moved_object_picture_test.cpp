// SPDX-License-Identifier: GPL-3.0-or-later
// What a patient sees of an object that both hands move: a tray that they lift, a box that they
// carry. It stands where the stimulus says, hands are told apart by shape, no number is on it.
#include <QRegularExpression>

#include "gui/patient_screen/patient_canvas.hpp"
#include "gui/picture/two_hands_picture.hpp"
#include "gui/presenter/patient_facts.hpp"
#include "qt_test.hpp"
#include "session/library/library.hpp"
#include "spoken.hpp"
#include "tests/support/every.hpp"
#include "tests/support/every_language.hpp"
#include "tests/support/must.hpp"

namespace isograsp::gui::test::moved_object_picture_test {
namespace {

using isograsp::test::every;
using isograsp::test::must;

const std::string kLibrary = ISOGRASP_SOURCE_DIR "/library";
constexpr QSize kScreen(1280, 720);

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

PatientFacts working(const std::string& task, tasks::TwoHandsView view,
                     session::TwoPlatformsSnapshot now, Cue cue = Cue::move) {
  now.frames = 1;
  now.stage = session::Stage::trial;
  now.task.phase = tasks::Phase::transport;
  now.task.cue = cue;
  now.task.target_count = 4;
  now.task.targets_reached = 1;
  for (const Hand hand : kBothHands) view.of[hand].cue = cue;
  now.special.special = view;
  PatientFacts facts = patient_facts(now);
  facts.session_open = true;
  facts.task = std::make_shared<const tasks::TaskSpec>(
      must(session::load_task(kLibrary + "/tasks/" + task + ".toml")));
  return facts;
}

struct Tray {
  double height_m = 0.0;
  double angle_rad = 0.0;
  OfHands<bool> slips{false, false};
  OfHands<bool> touches{true, true};
};
PatientFacts lifting(const Tray& tray) {
  session::TwoPlatformsSnapshot now;
  session::LiftedView& seen = now.lifted.emplace();
  seen.size_m = Vec3(0.3, 0.03, 0.2);
  seen.object.X_WO = {Vec3(0, tray.height_m, 0),
                      Quat(Eigen::AngleAxisd(tray.angle_rad, Vec3::UnitZ()))};
  for (const Hand hand : kBothHands) {
    seen.of[hand].end_O = Vec3(hand == Hand::left ? -0.15 : 0.15, 0, 0);
    seen.of[hand].touches = tray.touches[hand];
    seen.of[hand].slips = tray.slips[hand];
  }
  tasks::TwoHandsView view;
  tasks::MovedView& asked = view.moved.emplace();
  asked.target_shown = true;
  asked.on_rest = false;
  asked.X_WT.p.y() = 0.08;
  asked.band = {0.02, 0.17};
  return working("two_hands_lift", view, now);
}

struct Box {
  Vec3 p_W = Vec3::Zero();
  OfHands<Vec3> point{Vec3(-0.1, 0, 0), Vec3(0.1, 0, 0)};
  bool held = false;
  bool clutch = false;
  Cue cue = Cue::move;
};
PatientFacts carrying(const Box& box) {
  session::TwoPlatformsSnapshot now;
  session::CarriedView& seen = now.carried.emplace();
  seen.size_m = Vec3::Constant(0.06);
  seen.half_size_m = Vec3::Constant(0.05);
  seen.object.X_WO.p = box.p_W;
  seen.held = box.held;
  seen.clutch = box.clutch;
  for (const Hand hand : kBothHands) {
    seen.of[hand].p_W = box.point[hand];
    seen.of[hand].bubble_W = box.point[hand] + Vec3(hand == Hand::left ? -0.02 : 0.02, 0, 0);
  }
  seen.of.right.excess = 0.2;
  tasks::TwoHandsView view;
  tasks::MovedView& asked = view.moved.emplace();
  asked.target_shown = true;
  asked.on_rest = false;
  asked.X_WT.p = Vec3(0.12, 0.08, 0);
  asked.band = {0.02, 0.26};
  return working("two_hands_carry", view, now, box.cue);
}

const std::vector<std::pair<QString, PatientFacts>>& all_pictures() {
  static const std::vector<std::pair<QString, PatientFacts>> all{
      {"tray_on_its_rest", lifting({0.0, 0.0, {false, false}, {false, true}})},
      {"tray_leans", lifting({0.05, 0.25})},
      {"tray_in_the_band", lifting({0.08, 0.02})},
      {"tray_slips", lifting({0.04, -0.1, {true, false}})},
      {"box_free", carrying({})},
      {"box_held",
       carrying({Vec3(0.05, 0.03, 0), {Vec3(0.02, 0.03, 0), Vec3(0.08, 0.03, 0)}, true})},
      {"box_clutch",
       carrying({Vec3(0.05, 0.03, 0), {Vec3(0.02, 0.03, 0), Vec3(0.08, 0.03, 0)}, true, true})},
      {"box_there", carrying({Vec3(0.12, 0.08, 0),
                              {Vec3(0.09, 0.08, 0), Vec3(0.15, 0.08, 0)},
                              true,
                              false,
                              Cue::let_go})}};
  return all;
}

class MovedObjectOnTheScreen : public QtTest {};

TEST_F(MovedObjectOnTheScreen, ATrayStandsAsHighAndLeansAsItDoes) {
  const PatientPicture rest = picture_for(lifting({}));
  ASSERT_TRUE(rest.two_hands && rest.two_hands->tray);
  EXPECT_FALSE(rest.two_hands->tray->on_target);
  const PatientPicture up = picture_for(lifting({0.08, 0.1}));
  EXPECT_TRUE(up.two_hands->tray->on_target);
  EXPECT_FALSE(picture_for(lifting({0.08, 0.3})).two_hands->tray->on_target) << "it leans";
  EXPECT_EQ(picture_for(lifting({0.05, 0.3})).detail, "The left end is too low");
  EXPECT_EQ(picture_for(lifting({0.05, -0.3})).detail, "The right end is too low");
  EXPECT_EQ(picture_for(lifting({0.05, 0.0, {true, false}})).detail,
            "It slides: press more firmly");
  const QRect moved = difference(painted(rest), painted(picture_for(lifting({0.03, 0.0}))));
  EXPECT_FALSE(moved.isEmpty());
  EXPECT_NE(painted(picture_for(lifting({0.05, 0.2}))),
            painted(picture_for(lifting({0.05, -0.2}))));
}

TEST_F(MovedObjectOnTheScreen, ABoxAndBothPointsStandWhereTheyAreAndNothingElseMoves) {
  const PatientPicture free = picture_for(carrying({}));
  ASSERT_TRUE(free.two_hands && free.two_hands->carry);
  EXPECT_EQ(free.headline, "Press both hands against the box");
  Box box;
  box.point.left.y() = 0.01;
  const QRect moved = difference(painted(free), painted(picture_for(carrying(box))));
  ASSERT_FALSE(moved.isEmpty());
  EXPECT_LT(moved.right(), kScreen.width() / 2) << "the right hand stays";
  box.held = true;
  EXPECT_EQ(picture_for(carrying(box)).headline, "Carry it to the outline");
  box.clutch = true;
  EXPECT_EQ(picture_for(carrying(box)).headline, "Your hands stay where they are");
  box.cue = Cue::let_go;
  EXPECT_EQ(picture_for(carrying(box)).headline, "Let go");
  // However far a bubble goes, it is in the picture.
  Box far;
  far.point.left = Vec3(-1.0, 0.6, 0);
  const CarryPicture seen = *picture_for(carrying(far)).two_hands->carry;
  EXPECT_LE(seen.low_W.x(), -1.0 - 0.02 - 0.05);
  EXPECT_GE(seen.high_W.y(), 0.6 + 0.05);
}

TEST_F(MovedObjectOnTheScreen, HandsDifferByShapeAndNoNumberIsOnItInAnyLanguage) {
  for (const std::string language : every(isograsp::test::every_language())) {
    const Spoken spoken(language.c_str());
    for (const auto& [name, facts] : every(all_pictures())) {
      const PatientPicture picture = picture_for(facts);
      const TwoHandsPicture& both = *picture.two_hands;
      const QString all =
          QString::fromStdString(picture.headline + picture.detail + both.of.left.name +
                                 both.of.left.act + both.of.right.name + both.of.right.act);
      EXPECT_FALSE(all.contains(QRegularExpression("[0-9]"))) << all.toStdString();
    }
  }
  // Of the mirror image of a symmetric picture more differs than the letters.
  const QImage grey =
      painted(picture_for(lifting({0.05, 0.0}))).convertToFormat(QImage::Format_Grayscale8);
  constexpr int kClearly = 40;  // of 255: more than the difference of the two colours
  int differ = 0;
  for (int y = kScreen.height() / 4; y < kScreen.height() * 9 / 10; ++y)
    for (int x = 0; x < kScreen.width() / 2; ++x)
      if (std::abs(qGray(grey.pixel(x, y)) - qGray(grey.pixel(kScreen.width() - 1 - x, y))) >
          kClearly)
        ++differ;
  EXPECT_GT(differ, 300);
}

TEST_F(MovedObjectOnTheScreen, CalmIsTheSamePictureAndHalfAScreenHoldsAllOfIt) {
  for (auto [name, facts] : every(all_pictures())) {
    const PatientPicture lively = picture_for(facts);
    facts.calm = true;
    EXPECT_EQ(painted(picture_for(facts)), painted(lively)) << name.toStdString();
    for (const auto half : {Presentation::Half::left, Presentation::Half::right}) {
      const QRectF area = content_area(QRectF(QPointF(), kScreen), half);
      const QImage image = painted(lively, area);
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
          if (!area.adjusted(-1, -1, 1, 1).contains(x, y)) {
            ASSERT_EQ(image.pixel(x, y), qRgb(255, 255, 255))
                << name.toStdString() << " at " << x << ", " << y;
          }
      keep(lively, QString("%1_half_%2").arg(name).arg(static_cast<int>(half)), area);
    }
    keep(lively, name);
  }
}

}  // namespace
}  // namespace isograsp::gui::test::moved_object_picture_test
