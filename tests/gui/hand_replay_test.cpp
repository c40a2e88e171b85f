// SPDX-License-Identifier: GPL-3.0-or-later
// A stored trial of a tracked hand is shown again as both screens showed it, and tells finger by
// finger why it held and why it let go.
#include "gui/trial_pages/hand_replay.hpp"

#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <algorithm>
#include <cmath>

#include "gui/rules/hand_live.hpp"
#include "gui/trial_pages/trial_view.hpp"
#include "hand/hand_columns.hpp"
#include "hand_stage.hpp"
#include "qt_test.hpp"
#include "short_library.hpp"
#include "storage/access/open_store.hpp"
#include "tests/session/whole_session.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/within.hpp"

namespace isograsp::gui::test::hand_replay_test {
namespace {

using isograsp::test::AtLeast;
using isograsp::test::every;
using isograsp::test::must;
using What = GraspEvent::What;

/// Quaternions are stored and made unit vectors again: some roundings of coordinates below a metre.
constexpr double kRounding = 1e-14;
constexpr const char* kTask = "virtual_place_first.toml";

/// One object from its block to its target, and let go there.
void place_one(HandStage& stage) {
  stage.pass_entry();
  stage.begin(HandStage::task(kTask));
  stage.run_to([](const auto& now) { return now.special.hand().let_go_asked; });
  stage.run_to([](const auto& now) { return now.special.hand().placement == 1; });
}

void expect_same_hand(const std::optional<virtual_hand::HandInSpace>& a,
                      const std::optional<virtual_hand::HandInSpace>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) return;
  for (std::size_t d = 0; d < kDigitCount; ++d)
    for (std::size_t j = 0; j < a->digits[d].joints.size(); ++j)
      EXPECT_WITHIN((a->digits[d].joints[j] - b->digits[d].joints[j]).norm(), 0.0, kRounding);
}

void expect_same_picture(const HandPicture& live, const HandPicture& again) {
  expect_same_hand(live.hand, again.hand);
  expect_same_hand(live.tracked, again.tracked);
  EXPECT_EQ(live.tracked_opacity, again.tracked_opacity);
  EXPECT_EQ(live.radii_m, again.radii_m);
  EXPECT_EQ(live.tips, again.tips);
  EXPECT_EQ(live.frozen, again.frozen);
  EXPECT_EQ(live.object.has_value(), again.object.has_value());
  EXPECT_TRUE(!live.object || (live.X_WO.p - again.X_WO.p).norm() <= kRounding);
  EXPECT_EQ(live.placed, again.placed);
  EXPECT_EQ(live.target, again.target);
  EXPECT_EQ(live.assistance, again.assistance);
  EXPECT_EQ(live.ground.table_m, again.ground.table_m);
  EXPECT_TRUE(!live.object || live.ground.block.has_value() == again.ground.block.has_value());
}

void expect_same_grasp(const std::optional<GraspLive>& live,
                       const std::optional<GraspLive>& again) {
  ASSERT_EQ(live.has_value(), again.has_value());
  if (!live) return;
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    EXPECT_EQ(live->digits[d].state, again->digits[d].state);
    EXPECT_EQ(live->digits[d].share, again->digits[d].share);
  }
  EXPECT_EQ(live->release_N, again->release_N);
  EXPECT_EQ(live->feasible, again->feasible);
  for (std::size_t k = 0; k < live->criteria.size(); ++k) {
    ASSERT_EQ(live->criteria[k].has_value(), again->criteria[k].has_value()) << k;
    if (!live->criteria[k]) continue;
    EXPECT_EQ(live->criteria[k]->value, again->criteria[k]->value) << k;
    EXPECT_EQ(live->criteria[k]->limit, again->criteria[k]->limit) << k;
  }
  EXPECT_EQ(live->level, again->level);
  EXPECT_EQ(live->placement, again->placement);
  EXPECT_EQ(live->let_go_asked, again->let_go_asked);
  EXPECT_EQ(live->helped, again->helped);
}

TEST(HandReplay, EveryRowGivesThePictureAndTheNumbersThatWereShown) {
  for (const Hand side : {Hand::right, Hand::left}) {
    HandStage stage(side);
    place_one(stage);
    const auto replay = must(TrialReplay::make(stage.signals()));
    ASSERT_TRUE(HandReplay::is_of_hand(replay));
    const auto task = HandStage::task(kTask);
    const HandReplay hand(replay, stage.hand(), &task);
    ASSERT_TRUE(hand.has_object());
    AtLeast compared(300);
    for (const auto& [shown, row] : stage.kept()) {
      // What is ordered after a row is on the screen at once, and in the next row.
      if (shown.special.hand().order != tasks::ObjectOrder::none) continue;
      const auto again = hand.at(replay, replay.at(row.front()));
      SCOPED_TRACE(row.front());
      expect_same_picture(hand_picture(shown), hand_picture(again));
      expect_same_grasp(grasp_live(shown), grasp_live(again));
      EXPECT_EQ(shown.thumb_index_gap_m, again.thumb_index_gap_m);
      if (testing::Test::HasFailure()) return;
      ++compared;
    }
  }
}

TEST(HandReplay, TheStoryBeginsWithAGraspThatHoldsAndEndsWithFingersThatPulled) {
  HandStage stage;
  place_one(stage);
  const auto story = grasp_story(stage.signals());
  ASSERT_GE(story.size(), 2U);
  const GraspEvent& first = story.front();
  EXPECT_EQ(first.what, What::tied);
  EXPECT_TRUE(first.grasp.feasible);
  EXPECT_EQ(first.digits & ~first.grasp.digits, 0U) << "who is tied is of the grasp that holds";
  EXPECT_GT(first.grasp.G_min, first.grasp.G_min_limit);
  EXPECT_GT(first.grasp.H_det, first.grasp.H_det_limit);
  AtLeast pulled(1);
  for (const GraspEvent& event : every(story)) {
    if (event.what != What::pulled) continue;
    EXPECT_GT(event.pull_N, event.limit_N) << event.t_s;
    EXPECT_GT(event.limit_N, 0.0);
    EXPECT_TRUE(words_of(event).contains("pulled with")) << words_of(event).toStdString();
    ++pulled;
  }
}

/// From the states alone: tied are those that were told to be, at every row.
TEST(HandReplay, TheStoryLeavesOutNoTieAndNoRelease) {
  HandStage stage;
  place_one(stage);
  const Signals signals = stage.signals();
  const auto story = grasp_story(signals);
  const auto t_s = signals.column(columns::t_s);
  unsigned tied = 0;
  auto next = story.begin();
  AtLeast rows(300);
  for (std::size_t row = 0; row < t_s.size(); ++row) {
    for (; next != story.end() && next->t_s == t_s[row]; ++next)
      tied = next->what == What::tied ? tied | next->digits : tied & ~unsigned{next->digits};
    for (std::size_t d = 0; d < kDigitCount; ++d)
      ASSERT_EQ((tied >> d & 1U) != 0, signals.column(columns::grasp_state[d])[row] == 2.0) << row;
    ++rows;
  }
  EXPECT_EQ(next, story.end());
}

TEST(HandReplay, WhatTheTherapistLetGoIsToldAsThatAndNeitherAsADropNorAsAPull) {
  HandStage stage;
  stage.pass_entry();
  stage.begin(HandStage::task(kTask));
  stage.run_to([](const auto& now) {
    return std::any_of(now.grasp.digits.begin(), now.grasp.digits.end(), [](const auto& digit) {
      return digit.state == virtual_hand::DigitState::attached;
    });
  });
  stage.run(0.2);
  stage.let_go();
  stage.run(0.5);
  const auto story = grasp_story(stage.signals());
  ASSERT_FALSE(story.empty());
  EXPECT_EQ(story.back().what, What::helped) << words_of(story.back()).toStdString();
}

/// Rows of thumb and index, by hand: what is written in a row is all that the story knows.
TEST(HandReplay, EachReasonIsToldFromTheRowsAlone) {
  struct Row {
    int thumb, index;  ///< states
    double thumb_pull_N, index_pull_N;
    int placement, fails, helped;
    int to_open = 0;
  };
  constexpr double kLimit_N = 1.0;
  const auto story_of = [](std::initializer_list<Row> rows) {
    std::vector<std::string> names{std::string(columns::t_s)};
    for (const Column& column :
         {columns::grasp_state[0], columns::grasp_state[1], columns::pull_N[0], columns::pull_N[1],
          columns::release_pull_N, columns::placement, columns::placement_fails,
          columns::object_helped, columns::let_go_asked})
      names.emplace_back(column);
    Signals signals(std::move(names));
    double t_s = 0.0;
    for (const Row& row : rows)
      signals.append_row(std::array{t_s += 0.01, 1.0 * row.thumb, 1.0 * row.index, row.thumb_pull_N,
                                    row.index_pull_N, kLimit_N, 1.0 * row.placement,
                                    1.0 * row.fails, 1.0 * row.helped, 1.0 * row.to_open});
    return grasp_story(signals);
  };
  const Row held{2, 2, 0.1, 0.1, 0, 0, 0};
  const auto pulled = story_of({held, {3, 3, 1.5, 0.2, 0, 0, 0}});
  ASSERT_EQ(pulled.size(), 2U);
  EXPECT_EQ(pulled[0].what, What::pulled);
  EXPECT_EQ(pulled[0].digits, 1U);
  EXPECT_EQ(pulled[0].pull_N, 1.5);
  EXPECT_EQ(pulled[0].limit_N, kLimit_N);
  EXPECT_EQ(pulled[1].what, What::alone);
  EXPECT_EQ(pulled[1].digits, 2U);
  const auto placed = story_of({held, {3, 3, 1.5, 0.2, 0, 0, 0, 1}});
  ASSERT_EQ(placed.size(), 2U);
  EXPECT_EQ(placed[0].what, What::pulled);
  EXPECT_EQ(placed[1].what, What::placed) << "what was left would have held";
  const auto tied = story_of({{1, 1, 0, 0, 0, 0, 0}, held});
  ASSERT_EQ(tied.size(), 1U) << "both in one line";
  EXPECT_EQ(tied[0].what, What::tied);
  EXPECT_EQ(tied[0].digits, 3U);
  // What the task orders after a row is seen in the next one.
  const auto helped = story_of({held, {2, 2, 0.1, 0.1, 0, 0, 1}, {0, 0, 0, 0, 0, 0, 1}});
  ASSERT_EQ(helped.size(), 1U);
  EXPECT_EQ(helped[0].what, What::helped);
  const auto ended = story_of({held, {0, 0, 0, 0, -1, 0, 0}});
  ASSERT_EQ(ended.size(), 1U);
  EXPECT_EQ(ended[0].what, What::ended);
  const auto dropped = story_of({{0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 1, 0}});
  ASSERT_EQ(dropped.size(), 1U) << "without help it can fall, too";
  EXPECT_EQ(dropped[0].what, What::dropped);
  EXPECT_EQ(words_of(dropped[0]), "The object was dropped");
}

TEST(HandReplay, OfAnotherTrialThereIsNoStory) {
  Signals signals({"t_s", "thumb_fz_N"});
  signals.append_row(std::array{0.0, 1.0});
  EXPECT_TRUE(grasp_story(signals).empty());
  EXPECT_FALSE(HandReplay::is_of_hand(must(TrialReplay::make(std::move(signals)))));
}

class StoredHand : public QtTest {
 protected:
  TemporaryFolder folder_;
};

TEST_F(StoredHand, IsDrawnInItsOwnSizeAndTheViewTellsWhyItHeld) {
  const std::string library = make_hand_library(folder_);
  const std::string database = folder_.path("clinic.db");
  isograsp::test::run_whole({database, "H-1", "sim://hand?user=healthy&seed=7",
                             library + "/protocols/hand_assessment.toml", library});
  const auto store = must(storage::open_store(database, storage::OpenMode::read_only));
  const auto session = must(store->recent_sessions(1)).at(0);
  const auto record = must(store->trials(session.id)).at(0);
  const auto measured = must(hand_of_trial(*store, session, record, library));
  EXPECT_EQ(measured.length_m, storage::value_of(record.references, "hand_length_m"));
  auto without = record;
  without.preparations.clear();
  EXPECT_NE(must(hand_of_trial(*store, session, without, library)).length_m, measured.length_m);

  const auto trial =
      std::make_shared<LoadedTrial>(must(load_trial(*store, session, record, library)));
  ASSERT_NE(trial->tracked, nullptr) << trial->why_no_picture.toStdString();
  ASSERT_FALSE(trial->tracked->story().empty());
  TrialView view;
  view.resize(1280, 720);
  view.show();
  view.show_trial(trial);
  auto& set = widget_called<QComboBox>("trial_curves", view);
  QStringList sets;
  for (int i = 0; i < set.count(); ++i) sets << set.itemText(i);
  EXPECT_EQ(sets, (QStringList{"Pull of the fingers on their ties", "Opening of the hand",
                               "Position of the object", "Any recorded channel …"}));
  EXPECT_TRUE(widget_called<QLabel>("replay_grasp_verdict", view).isVisible());
  auto& about = widget_called<QTableWidget>("trial_about", view);
  int told = -1;
  for (int row = 0; row < about.rowCount(); ++row)
    if (about.item(row, 0)->text().contains("tied, ")) told = row;
  ASSERT_GE(told, 0);
  Q_EMIT about.itemClicked(about.item(told, 0));
  EXPECT_EQ(view.playback().t_s(), trial->tracked->story().front().t_s) << "a click goes there";
  EXPECT_EQ(widget_called<QLabel>("replay_digit_state_0", view).text(), "tied");
  for (const auto& fact : every(trial->facts))
    for (const char* word : {"Zero", "Maximum force", "Sensors", "Start posture"})
      EXPECT_FALSE(fact.what.contains(word)) << fact.what.toStdString();
  keep_picture(view, "hand_replay");
}

}  // namespace
}  // namespace isograsp::gui::test::hand_replay_test
