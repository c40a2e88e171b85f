// SPDX-License-Identifier: GPL-3.0-or-later
// Every step of a session with a tracked hand in every language, as it stands on the smallest
// screen: no text is cut off, nothing needs a scroll bar sideways. One session: its window is made
// anew in each language, as a change of the settings does it.
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>

#include "cut_texts.hpp"
#include "gui/hand_pages/basis_dialog.hpp"
#include "operator.hpp"
#include "short_library.hpp"
#include "spoken.hpp"
#include "tests/support/every_language.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::hand_pages_test {
namespace {

constexpr const char* kHandUri = "sim://hand?user=healthy&seed=7";
const QSize kSmallest(1280, 720);

class HandPages : public QtTest {
 protected:
  HandPages() {
    windows_.therapist().resize(kSmallest);
    windows_.show();
  }
  ~HandPages() override {
    windows_.presenter().connecting().end_session();
    EXPECT_TRUE(wait_until([&] { return !windows_.presenter().state().busy(); }));
  }

  const SessionState& state() { return windows_.presenter().state(); }
  const FlowView& view() { return windows_.presenter().flow().view(); }

  void speak_in(const char* language) {
    Settings settings = windows_.settings().now();
    if (settings.language == language) return;
    settings.language = language;
    const auto* const before = &windows_.therapist();
    windows_.settings().change(settings);
    ASSERT_TRUE(wait_until([&] { return &windows_.therapist() != before; }));
  }
  /// What stands there now, in every language; English is spoken afterwards.
  void expect_whole(const char* name, TherapistWindow::Page page = TherapistWindow::Page::session) {
    for (const char* const language : test::every_language()) {
      ASSERT_NO_FATAL_FAILURE(speak_in(language));
      windows_.therapist().show_page(page);
      EXPECT_TRUE(laid_out(windows_.therapist()));
      expect_fits(windows_.therapist(), std::string(name) + " in " + language);
      EXPECT_FALSE(operator_.find<QLabel>("camera_on").isVisible()) << "this hand is simulated";
      keep_picture(windows_.therapist(), QStringLiteral("step_%1_%2").arg(name, language));
    }
    ASSERT_NO_FATAL_FAILURE(speak_in("en"));
    windows_.therapist().show_page(page);
  }
  void expect_fits(QWidget& window, const std::string& what) {
    EXPECT_LE(window.width(), kSmallest.width()) << what;
    EXPECT_LE(window.height(), kSmallest.height()) << what;
    for (const auto* area : window.findChildren<QScrollArea*>()) {
      const bool sideways = area->isVisible() && area->horizontalScrollBar()->maximum() > 0;
      EXPECT_FALSE(sideways) << what;
    }
    for (const auto* label : window.findChildren<QLabel*>()) {
      if (!label->isVisible() || !label->wordWrap() || label->text().isEmpty()) continue;
      EXPECT_GE(label->height(), label->heightForWidth(label->width()))
          << what << ": " << label->text().toStdString();
    }
    EXPECT_EQ(cut_texts(window, what, seen_), std::set<std::string>{});
  }

  TemporaryFolder folder_;
  Spoken spoken_{"en"};
  Windows windows_{GuiConfig{folder_.path("clinic.db"), "", make_hand_library(folder_), "test",
                             folder_.write("isograsp.ini", "[General]\nlanguage=en\n")}};
  Operator operator_{windows_};
  int seen_ = 0;
};

TEST_F(HandPages, CutNoTextOffFromTheFirstStepToTheRating) {
  operator_.add_patient();
  windows_.presenter().choices().choose_device(kHandUri);
  ASSERT_NO_FATAL_FAILURE(expect_whole("hand"));
  operator_.press("hand_right");
  ASSERT_NO_FATAL_FAILURE(expect_whole("screening"));

  windows_.presenter().choices().choose_device("leap://127.0.0.1:1");
  operator_.answer_screening();
  ASSERT_NO_FATAL_FAILURE(expect_whole("tracker"));
  operator_.press("connect");
  ASSERT_TRUE(wait_until([&] { return view().situation == Situation::session_failed; }));
  ASSERT_NO_FATAL_FAILURE(expect_whole("no_basis"));
  for (const char* const language : test::every_language()) {
    ASSERT_NO_FATAL_FAILURE(speak_in(language));
    operator_.press("basis_open");
    auto& dialog = *windows_.therapist().findChild<BasisDialog*>();
    EXPECT_TRUE(laid_out(dialog));
    expect_fits(dialog, std::string("lawful basis in ") + language);
    keep_picture(dialog, QStringLiteral("step_basis_%1").arg(language));
    operator_.press("basis_cancel");
  }
  ASSERT_NO_FATAL_FAILURE(speak_in("en"));

  windows_.presenter().choices().choose_device(kHandUri);
  operator_.press("connect");
  ASSERT_TRUE(wait_until([&] { return view().may_zero; })) << view().sentence;
  ASSERT_NO_FATAL_FAILURE(expect_whole("connected"));
  ASSERT_NO_FATAL_FAILURE(expect_whole("tracker_page", TherapistWindow::Page::device));
  windows_.therapist().show_page(TherapistWindow::Page::session);
  operator_.press("entry_test");
  ASSERT_TRUE(wait_until([&] { return state().open->hand->entry.has_value(); }));
  ASSERT_NO_FATAL_FAILURE(expect_whole("entry_rest"));
  ASSERT_TRUE(wait_until([&] { return view().may_start; })) << view().sentence;
  ASSERT_NO_FATAL_FAILURE(expect_whole("protocol"));

  operator_.press("start");
  ASSERT_TRUE(wait_until([&] { return state().open->hand->grasp.held; })) << view().sentence;
  operator_.press("pause");
  ASSERT_TRUE(wait_until([&] { return view().may_resume; })) << view().sentence;
  ASSERT_NO_FATAL_FAILURE(expect_whole("placement"));
  operator_.press("pause");  // it goes on
  ASSERT_TRUE(wait_until([&] { return state().guide().over(); }, 120)) << view().sentence;
  ASSERT_NO_FATAL_FAILURE(expect_whole("over"));
  operator_.press("effort_3");
  ASSERT_NO_FATAL_FAILURE(expect_whole("rating_half"));
  operator_.press("pain_1");
  operator_.press("shoulder_pain_5");
  ASSERT_NO_FATAL_FAILURE(expect_whole("rated"));
  constexpr int kTextsOfAPage = 40;
  EXPECT_GT(seen_, 30 * kTextsOfAPage);
}

}  // namespace
}  // namespace isograsp::gui::test::hand_pages_test
