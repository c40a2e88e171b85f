// SPDX-License-Identifier: GPL-3.0-or-later
// A stored trial of both hands is opened as what it is: two forces and what was asked of them, and
// the picture that both hands saw.
#include <QComboBox>
#include <QLabel>

#include "gui/trial_pages/trial_view.hpp"
#include "hand/two_hands_columns.hpp"
#include "qt_test.hpp"
#include "storage/access/open_store.hpp"
#include "tests/session/whole_session.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::two_hands_replay_test {
namespace {

using isograsp::test::must;

class StoredTwoHands : public QtTest {
 protected:
  TemporaryFolder folder_;
};

TEST_F(StoredTwoHands, ShowsTheForceOfEachHandAndOfBothAndWhatThePatientSaw) {
  const std::string library = std::string(ISOGRASP_SOURCE_DIR) + "/library";
  const std::string database = folder_.path("clinic.db");
  const std::string pair = "sim://pair?file=paretic_left&seed=7";
  isograsp::test::run_whole({database, "B-1", must(session::two_platforms_uri({pair, pair})),
                             library + "/protocols/two_hands_short.toml", library});
  const auto store = must(storage::open_store(database, storage::OpenMode::read_only));
  const auto session = must(store->recent_sessions(1)).at(0);
  const auto record = must(store->trials(session.id)).at(2);
  const auto trial =
      std::make_shared<LoadedTrial>(must(load_trial(*store, session, record, library)));
  const auto curves = curves_of(trial->replay, CurveSet::forces, {});
  std::vector<std::size_t> columns;
  for (const TrialCurve& curve : isograsp::test::every(curves)) columns.push_back(*curve.column);
  std::vector<std::size_t> expected;
  for (const Column& column : {columns::hand_grip.left, columns::hand_grip.right,
                               columns::sum_force_N, columns::target_sum_force_N})
    expected.push_back(*trial->replay.signals().find(column));
  EXPECT_EQ(columns, expected);

  TrialView view;
  view.resize(1280, 720);
  view.show();
  view.show_trial(trial);
  auto& set = widget_called<QComboBox>("trial_curves", view);
  QStringList sets;
  for (int i = 0; i < set.count(); ++i) sets << set.itemText(i);
  EXPECT_EQ(sets, (QStringList{"Forces and target", "Any recorded channel …"}));
  keep_picture(view, "two_hands_replay");
  EXPECT_TRUE(widget_called<QWidget>("trial_two_hands", view).isVisible());
  for (const double t_s : {1.0, 10.0, 25.0}) {
    const ReplayState state = trial->replay.at(t_s);
    const PatientPicture picture = picture_at(*trial, state);
    ASSERT_TRUE(picture.two_hands && picture.two_hands->sum);
    EXPECT_EQ(picture.page, PatientPicture::Page::two_hands);
    EXPECT_TRUE(picture.two_hands->sum->force_shown);
    EXPECT_TRUE(picture.two_hands->sum->target_shown);
    EXPECT_FALSE(picture.two_hands->of.left.bar.force_shown) << "the task shows their sum alone";
  }
}

}  // namespace
}  // namespace isograsp::gui::test::two_hands_replay_test
