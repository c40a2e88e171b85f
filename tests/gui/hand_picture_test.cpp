// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn of a tracked hand: the hand that grasps, what its fingertips and the target tell,
// what is said where it is out of sight, of a left hand, too; the shadow below it.
#include "gui/picture/hand_picture.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>

#include <gtest/gtest.h>

#include "gui/patient_screen/patient_canvas.hpp"
#include "gui/patient_screen/table_shade.hpp"
#include "gui/presenter/patient_facts.hpp"
#include "hand_stage.hpp"
#include "qt_test.hpp"
#include "tests/support/within.hpp"
#include "virtual_hand/study_plan.hpp"

namespace isograsp::gui::test::hand_picture_test {
namespace {

using session::HandSnapshot;
using Tip = HandPicture::Tip;
using Target = HandPicture::Target;
using virtual_hand::DigitState;

constexpr double kRounding_m = 1e-12;  // a metre through two rotations
constexpr double kTable_m = 0.1;

/// A frame of a placement: a hand that is seen, and one that grasps a slim cuboid.
HandSnapshot placement(Hand side = Hand::right) {
  const auto model = isograsp::test::usual_hand(side);
  HandSnapshot now;
  now.frames = 100;
  now.stage = session::Stage::trial;
  now.hand.known = true;
  now.hand.held = false;
  now.pose.emplace();
  now.pose->pose = isograsp::test::hand_posture(0.6, 0.0);
  now.hand.frame = isograsp::test::picture_of(model, now.pose->pose);
  now.seen_hand = now.grasping_hand = virtual_hand::hand_in_space(model, now.pose->pose);
  for (std::size_t d = 0; d < kDigitCount; ++d) now.link_radii_m[d] = model.digits[d].radii_m;
  now.ground = hand_world::Ground{kTable_m, std::nullopt};
  tasks::HandView view;
  view.about_object = true;
  view.object = 4;
  view.placement = 0;
  view.assistance = virtual_hand::AssistanceLevel::full;
  view.target_shown = true;
  view.X_WT = {Vec3(0.1, 0.25, 0.0), Quat::Identity()};
  now.special.special = view;
  now.task.target_count = 3;
  now.grasp.hand_there = now.grasp.object_there = true;
  now.grasp.level = view.assistance;
  now.grasp.object.X_WO = {Vec3(0.0, 0.11, 0.0),
                           Quat(Eigen::AngleAxisd(1.5707963267948966, Vec3::UnitY()))};
  return now;
}
tasks::HandView& task_of(HandSnapshot& now) {
  return std::get<tasks::HandView>(now.special.special);
}

PatientPicture shown(const HandSnapshot& now, Hand side = Hand::right,
                     const char* task = "virtual_place.toml") {
  static std::map<std::string, std::shared_ptr<tasks::TaskSpec>> read;
  auto& spec = read[task];
  if (spec == nullptr) spec = std::make_shared<tasks::TaskSpec>(HandStage::task(task));
  PatientFacts facts = patient_facts(now);
  facts.session_open = true;
  facts.hand = side;
  facts.task = spec;
  return picture_for(facts);
}

bool says(const std::string& words, const std::string& part) {
  return words.find(part) != std::string::npos;
}

TEST(HandPicture, TheSolidHandIsTheOneThatGraspsAndWithoutAnObjectTheOneThatIsSeen) {
  HandSnapshot now = placement();
  now.grasping_hand->X_WP.p += Vec3(0.03, 0.0, 0.0);
  now.grasp.tracked_gap_m = 0.03;
  HandPicture picture = hand_picture(now);
  EXPECT_EQ(picture.hand->X_WP.p, now.grasping_hand->X_WP.p);
  EXPECT_EQ(picture.tracked->X_WP.p, now.seen_hand->X_WP.p);
  now.grasp = {};
  picture = hand_picture(now);
  EXPECT_EQ(picture.hand->X_WP.p, now.seen_hand->X_WP.p);
  EXPECT_FALSE(picture.tracked.has_value());
}

TEST(HandPicture, TheTrackedHandComesInByDegreesAsItLeavesTheVirtualOne) {
  HandSnapshot now = placement();
  constexpr double kStep_m = 0.0005;
  // Of one step; any larger one would be seen as a blink.
  const double most_step = 1.01 * kMostOpacity * kStep_m / (kClearlyApart_m - kSamePlace_m);
  double before = 0.0;
  for (double gap_m = 0.0; gap_m < 0.05; gap_m += kStep_m) {
    now.grasp.tracked_gap_m = gap_m;
    const HandPicture picture = hand_picture(now);
    EXPECT_EQ(picture.tracked.has_value(), picture.tracked_opacity > 0.0);
    EXPECT_GE(picture.tracked_opacity, before) << gap_m;
    EXPECT_LE(picture.tracked_opacity - before, most_step) << gap_m;
    before = picture.tracked_opacity;
  }
  EXPECT_EQ(before, kMostOpacity);
}

TEST(HandPicture, FingertipsTellTouchAndTieAndTheMarkOfEachLiesOnTheObject) {
  HandSnapshot now = placement();
  now.grasp.digits[0].state = DigitState::attached;
  now.grasp.digits[1].state = DigitState::contact;
  now.grasp.digits[1].touching = true;
  now.grasp.digits[2].state = DigitState::blocked;
  now.grasp.digits[2].touching = true;
  now.grasp.digits[3].state = DigitState::blocked;
  const HandPicture picture = hand_picture(now);
  EXPECT_EQ(picture.tips,
            (std::array{Tip::tied, Tip::touches, Tip::touches, Tip::bare, Tip::bare}));
  const Vec3 half_m = picture.object->half_m;
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    ASSERT_EQ(picture.marks[d].has_value(), picture.tips[d] != Tip::bare) << d;
    if (!picture.marks[d]) continue;
    const Vec3 p_O = picture.X_WO.q.conjugate() * (picture.marks[d]->p_W - picture.X_WO.p);
    EXPECT_WITHIN((p_O.cwiseAbs() - half_m).maxCoeff(), 0.0, 1e-9) << "on a face";
    EXPECT_WITHIN(picture.marks[d]->normal_W.norm(), 1.0, 1e-9);
  }
}

TEST(HandPicture, TheTargetIsSeenThroughThenOpaqueAndThenTheObjectIsPurple) {
  HandSnapshot now = placement();
  PatientPicture picture = shown(now);
  EXPECT_EQ(picture.page, PatientPicture::Page::hand);
  EXPECT_EQ(picture.tracked_hand->target, Target::away);
  EXPECT_EQ(picture.tracked_hand->X_WT.p, task_of(now).X_WT.p);
  EXPECT_FALSE(picture.tracked_hand->placed);
  EXPECT_TRUE(says(picture.headline, "Take")) << picture.headline;
  now.grasp.held = true;
  EXPECT_TRUE(says(shown(now).headline, "blue")) << shown(now).headline;
  task_of(now).at_target = true;
  now.task.hold_fraction = 0.4;
  picture = shown(now);
  EXPECT_EQ(picture.tracked_hand->target, Target::within);
  EXPECT_EQ(picture.hold_fraction, 0.4);
  EXPECT_TRUE(says(picture.headline, "Hold")) << picture.headline;
  task_of(now).let_go_asked = true;
  picture = shown(now);
  EXPECT_TRUE(picture.tracked_hand->placed && picture.matched);
  EXPECT_EQ(picture.tracked_hand->target, Target::none);
  EXPECT_EQ(picture.hold_fraction, 0.0) << "a tick is in its place";
  EXPECT_TRUE(says(picture.headline, "Let go")) << picture.headline;
  task_of(now).helped = true;
  EXPECT_FALSE(says(shown(now).headline, "Let go")) << "nothing is asked any more";
}

TEST(HandPicture, ALostHandKeepsItsLastPoseAndIsSaidToStandStillWithoutAPause) {
  HandSnapshot now = placement();
  const PatientPicture seen = shown(now);
  now.hand.held = true;
  now.hand.unseen_s = 0.15;
  now.grasp.frozen = true;
  const PatientPicture moment = shown(now);
  EXPECT_FALSE(moment.tracked_hand->frozen) << "gaps of a moment are ordinary";
  EXPECT_EQ(moment.headline, seen.headline);
  now.hand.unseen_s = 0.5;
  now.stage = session::Stage::paused;
  now.pause_cause = session::PauseCause::occluded;
  const PatientPicture lost = shown(now);
  EXPECT_TRUE(lost.tracked_hand->frozen);
  EXPECT_EQ(lost.notice, PatientPicture::Notice::none) << "nothing covers it";
  EXPECT_TRUE(says(lost.headline, "out of sight")) << lost.headline;
  EXPECT_TRUE(says(lost.detail, "stands still")) << lost.detail;
  for (std::size_t d = 0; d < kDigitCount; ++d)
    EXPECT_EQ(lost.tracked_hand->hand->digits[d].joints, seen.tracked_hand->hand->digits[d].joints);
  EXPECT_EQ(lost.tracked_hand->X_WO.p, seen.tracked_hand->X_WO.p);
  now.pause_cause = session::PauseCause::therapist;
  EXPECT_EQ(shown(now).notice, PatientPicture::Notice::pause);
  now.pause_cause = session::PauseCause::device_fault;
  EXPECT_EQ(shown(now).notice, PatientPicture::Notice::fault);
  EXPECT_TRUE(says(shown(now).notice_words, "camera")) << shown(now).notice_words;
}

TEST(HandPicture, AHandThatWasNeverSeenIsAskedForAndTheOtherHandIsNamed) {
  HandSnapshot now = placement();
  now.hand = {};
  now.seen_hand.reset();
  now.grasping_hand.reset();
  now.pose.reset();
  now.grasp.hand_there = false;
  const PatientPicture unknown = shown(now);
  EXPECT_FALSE(unknown.tracked_hand->hand.has_value());
  EXPECT_FALSE(unknown.tracked_hand->frozen);
  EXPECT_TRUE(says(unknown.headline, "camera")) << unknown.headline;
  now.health.fault = HandFault::other_hand;
  for (const Hand side : {Hand::right, Hand::left})
    EXPECT_TRUE(says(shown(now, side).headline, std::string(name_of(side)))) << name_of(side);
}

TEST(HandPicture, OfALeftHandTheWorldIsNotMirroredAndTheThumbIsOnItsRight) {
  for (const Hand side : {Hand::right, Hand::left}) {
    const HandSnapshot now = placement(side);
    const PatientPicture picture = shown(now, side);
    const HandPicture& hand = *picture.tracked_hand;
    EXPECT_EQ(hand.X_WO.p, now.grasp.object.X_WO.p);
    EXPECT_EQ(hand.X_WT.p, now.special.hand().X_WT.p);
    for (std::size_t d = 0; d < kDigitCount; ++d)
      for (std::size_t end = 0; end <= virtual_hand::kLinkCount; ++end)
        EXPECT_WITHIN((hand.hand->digits[d].joints[end] -
                       now.hand.frame.joints[joint_of(static_cast<Digit>(d), end)])
                          .norm(),
                      0.0, kRounding_m)
            << "where the tracker has it";
    // The back is up and the fingers point away from the viewer.
    const double thumb_x = hand.hand->digit(Digit::thumb).joints[0].x();
    const double little_x = hand.hand->digit(Digit::little).joints[0].x();
    EXPECT_EQ(thumb_x < little_x, side == Hand::right) << name_of(side);
  }
}

TEST(HandPicture, TheLevelOfHelpIsOnTheScreenInWordsForEachPlacement) {
  using virtual_hand::AssistanceLevel;
  std::set<std::string> words;
  for (const auto level : {AssistanceLevel::full, AssistanceLevel::softer, AssistanceLevel::off}) {
    HandSnapshot now = placement();
    task_of(now).assistance = level;
    EXPECT_EQ(shown(now).tracked_hand->assistance, level);
    words.insert(help_words(level));
  }
  EXPECT_EQ(words.size(), 3U);
  HandSnapshot between = placement();
  task_of(between).object = -1;
  between.grasp.object_there = false;
  EXPECT_FALSE(shown(between).tracked_hand->assistance.has_value());
  EXPECT_TRUE(says(shown(between).detail, "next object")) << shown(between).detail;
}

TEST(HandPicture, TheCameraSignStandsOnEveryPageAsLongAsACameraLooks) {
  application();
  HandSnapshot now = placement();
  EXPECT_FALSE(shown(now).camera_on) << "a hand in software needs no camera";
  now.camera_on = true;
  EXPECT_TRUE(shown(now).camera_on);
  now.stage = session::Stage::idle;
  EXPECT_TRUE(shown(now).camera_on);
  PatientFacts over = patient_facts(now);
  over.session_open = true;
  over.just_completed = true;
  PatientPicture picture = picture_for(over);
  EXPECT_EQ(picture.page, PatientPicture::Page::message);
  const auto painted = [](const PatientPicture& of) {
    QImage image(640, 360, QImage::Format_RGB32);
    QPainter painter(&image);
    paint_page(painter, QRectF(image.rect()), of);
    return image;
  };
  const QImage with = painted(picture);
  picture.camera_on = false;
  EXPECT_NE(painted(picture), with);
}

TEST(HandPicture, TheEntryTestSaysItsStageAndCountsTheOpenings) {
  HandSnapshot now = placement();
  now.special = {};
  now.grasp = {};
  now.ground.reset();
  now.stage = session::Stage::zeroing;
  now.zero_progress = 0.25;
  now.thumb_index_gap_m = 0.06;
  now.entry.emplace();
  PatientPicture picture = shown(now);
  EXPECT_EQ(picture.page, PatientPicture::Page::hand);
  EXPECT_TRUE(says(picture.headline, "Rest")) << picture.headline;
  EXPECT_TRUE(picture.progress_shown);
  EXPECT_EQ(picture.progress, 0.25);
  EXPECT_FALSE(picture.tracked_hand->opening.has_value()) << "nothing of it counts yet";
  now.entry = session::EntryShown{session::HandEntry::Stage::openings, true, 2};
  picture = shown(now);
  EXPECT_TRUE(says(picture.headline, "Open")) << picture.headline;
  EXPECT_TRUE(says(picture.detail, "2 of 3")) << picture.detail;
  EXPECT_EQ(picture.targets_reached, 2);
  EXPECT_EQ(picture.target_count, session::HandEntry::kOpenings);
  EXPECT_EQ(picture.tracked_hand->opening->gap_m, 0.06);
  now.entry->open = false;
  EXPECT_TRUE(says(shown(now).headline, "Close")) << shown(now).headline;
  now.stage = session::Stage::idle;
  now.entry.reset();
  EXPECT_FALSE(says(shown(now).headline, "Hands off"));
}

TEST(HandPicture, ATaskOfOpeningShowsHowFarTheHandOpensAndWhatToDo) {
  HandSnapshot now = placement();
  now.special.special = tasks::HandView{};
  now.grasp = {};
  now.ground.reset();
  now.task.cue = Cue::open;
  double before = -1.0;
  for (const double gap_m : {0.0, 0.02, 0.08, 0.14}) {
    now.thumb_index_gap_m = gap_m;
    const PatientPicture picture = shown(now, Hand::right, "hand_opening.toml");
    EXPECT_TRUE(says(picture.headline, "Open your hand")) << picture.headline;
    EXPECT_GT(picture.tracked_hand->opening->share, before);
    before = picture.tracked_hand->opening->share;
    EXPECT_FALSE(picture.tracked_hand->object.has_value());
  }
  now.thumb_index_gap_m = 2.0 * kFullOpening_m;
  EXPECT_EQ(shown(now, Hand::right, "hand_opening.toml").tracked_hand->opening->share, 1.0);
  now.thumb_index_gap_m = tasks::kNotMeasured;
  EXPECT_FALSE(shown(now, Hand::right, "hand_opening.toml").tracked_hand->opening.has_value());
  now.task.cue = Cue::close;
  EXPECT_TRUE(says(shown(now, Hand::right, "hand_opening.toml").headline, "Close your hand"));
}

TEST(HandPicture, AHandBelowTheTableIsAskedToBeLifted) {
  HandSnapshot now = placement();
  EXPECT_FALSE(says(shown(now).headline, "Lift"));
  now.ground->table_m = now.grasping_hand->X_WP.p.y() + 0.2;
  EXPECT_TRUE(says(shown(now).headline, "Lift")) << shown(now).headline;
}

TEST(HandPicture, OtherApparatusesHaveNoneOfIt) {
  PatientFacts platform = patient_facts(session::Snapshot{});
  PatientFacts arm = patient_facts(session::ArmSnapshot{});
  for (PatientFacts* facts : {&platform, &arm}) {
    facts->session_open = facts->arrived = true;
    EXPECT_FALSE(facts->tracked.has_value());
    const PatientPicture picture = picture_for(*facts);
    EXPECT_NE(picture.page, PatientPicture::Page::hand);
    EXPECT_FALSE(picture.tracked_hand.has_value());
    EXPECT_FALSE(picture.camera_on);
  }
}

TEST(HandPicture, InAWholePlacementEveryFrameHasAHandAndNoWordsBlink) {
  constexpr double kShortest_s = 0.1;  // what stands for less is seen as a flash
  HandStage stage;
  stage.pass_entry();
  stage.begin(HandStage::task("virtual_place_training.toml"));
  std::string words;
  double since_s = 0.0;
  int changes = 0;
  stage.run_to([&](const HandSnapshot& now) {
    const PatientPicture picture = shown(now);
    EXPECT_TRUE(picture.tracked_hand->hand.has_value());
    EXPECT_FALSE(picture.headline.empty());
    if (picture.headline != words) {
      if (changes > 0) {
        EXPECT_GE(now.session_time_s - since_s, kShortest_s) << words;
      }
      ++changes;
      words = picture.headline;
      since_s = now.session_time_s;
    }
    return now.task.targets_reached >= 1;
  });
  EXPECT_GE(changes, 4) << "take, bring, hold, let go";
}

constexpr ShadeArea kArea{-0.2, 0.2, 0.4, 0.4, kTable_m, 80, 80};

int darkest(const std::vector<std::uint8_t>& shade) {
  return *std::min_element(shade.begin(), shade.end());
}
std::ptrdiff_t shaded(const std::vector<std::uint8_t>& shade) {
  return std::count_if(shade.begin(), shade.end(),
                       [](std::uint8_t bright) { return bright < 254; });
}

TEST(TableShade, IsDarkAndSmallWhereAnObjectLiesAndPaleAndWideBelowOneThatIsLifted) {
  HandPicture picture;
  EXPECT_EQ(darkest(table_shade(picture, kArea)), 255) << "nothing casts a shadow";
  picture.object = virtual_hand::study_objects()[4].shape;
  picture.X_WO.p = {0.0, kTable_m + picture.object->half_m.z(), 0.0};
  picture.X_WO.q = Quat(Eigen::AngleAxisd(-1.5707963267948966, Vec3::UnitX()));
  const auto standing = table_shade(picture, kArea);
  picture.X_WO.p.y() += 0.1;
  const auto lifted = table_shade(picture, kArea);
  EXPECT_LT(darkest(standing), darkest(lifted));
  EXPECT_LT(shaded(standing), shaded(lifted));
  picture.X_WO.p.y() -= 1.0;
  EXPECT_EQ(darkest(table_shade(picture, kArea)), 255) << "it is below the table";
}

TEST(TableShade, LiesStraightBelowWhatCastsIt) {
  HandPicture picture;
  picture.object = virtual_hand::study_objects()[0].shape;
  for (const Vec3& at : {Vec3(0.1, 0.15, -0.05), Vec3(-0.12, 0.2, 0.08)}) {
    picture.X_WO.p = at;
    const auto shade = table_shade(picture, kArea);
    const auto place = std::min_element(shade.begin(), shade.end()) - shade.begin();
    constexpr double kPoint_m = 0.005;
    const double x = -0.2 + kPoint_m * static_cast<double>(place % 80);
    const double z = 0.2 - kPoint_m * static_cast<double>(place / 80);
    // Of the darkest points the first one, in a corner of the object's own ground plan.
    const double reach_m = picture.object->half_m.norm() + 2.0 * kPoint_m;
    EXPECT_LT(std::hypot(x - at.x(), z - at.z()), reach_m);
  }
}

}  // namespace
}  // namespace isograsp::gui::test::hand_picture_test
