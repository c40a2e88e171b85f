// SPDX-License-Identifier: GPL-3.0-or-later
// What the therapist's window offers at which moment: keys, the question of an interrupted
// protocol, the end of the work, a file that another program has open.
#include <QDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

#include "gui/file_in_use.hpp"
#include "gui/look/look.hpp"
#include "gui/session_pages/step_section.hpp"
#include "operator.hpp"
#include "short_library.hpp"
#include "storage/access/open_store.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::therapist_window_test {
namespace {

class SessionWindow : public QtTest {
 protected:
  SessionWindow()
      : windows_(settling_soon({folder_.path("clinic.db"), "sim://healthy?seed=7",
                                make_short_library(folder_, "3"), "test"})),
        operator_(windows_) {
    windows_.show();
    EXPECT_TRUE(wait_until([&] { return windows_.clinic().is_open(); }));
  }
  ~SessionWindow() override {
    presenter_.connecting().end_session();
    EXPECT_TRUE(wait_until([&] { return !presenter_.state().busy(); }));
  }

  void choose_protocol(const std::string& name) {
    for (std::size_t i = 0; i < presenter_.state().library.protocols.size(); ++i)
      if (presenter_.state().library.protocols[i].spec.name == name)
        return presenter_.choices().choose_protocol(static_cast<int>(i));
    FAIL() << name;
  }

  /// Buttons of the session that are marked as next, and can be seen and pressed.
  std::vector<std::string> marked() {
    std::vector<std::string> names;
    windows_.therapist().show_page(TherapistWindow::Page::session);
    for (auto* button : windows_.therapist().findChildren<QPushButton*>())
      if (!button->property("next").toString().isEmpty() && button->isVisible() &&
          button->isEnabled())
        names.push_back(button->objectName().toStdString());
    return names;
  }
  QPushButton& next_thing() { return operator_.find<QPushButton>("next_thing"); }
  void press_f8() { QTest::keyClick(&windows_.therapist(), Qt::Key_F8); }

  TemporaryFolder folder_;
  Windows windows_;
  Operator operator_;
  SessionPresenter& presenter_ = windows_.presenter();
};

using Names = std::vector<std::string>;

TEST_F(SessionWindow, EnterPressesTheButtonThatHasTheFocus) {
  operator_.add_patient();
  auto& left = operator_.find<QPushButton>("hand_left");
  for (const auto key : {Qt::Key_Return, Qt::Key_Enter}) {
    presenter_.choices().choose_hand(Hand::right);
    left.setFocus();
    ASSERT_EQ(windows_.therapist().focusWidget(), &left);
    QTest::keyClick(&left, key);
    EXPECT_EQ(presenter_.state().choices.today.hand, Hand::left);
  }
}

TEST_F(SessionWindow, OneButtonIsNextAndTheHandSettlesBeforeAnythingStarts) {
  operator_.prepare_person();
  choose_protocol("First session");
  ASSERT_TRUE(wait_until([&] { return presenter_.flow().view().may_connect; }));
  EXPECT_EQ(marked(), Names{"connect"});
  operator_.press("connect");
  ASSERT_TRUE(wait_until([&] { return presenter_.flow().view().may_zero; }));
  EXPECT_EQ(marked(), Names{"zero"});
  operator_.set_zero();
  ASSERT_TRUE(wait_until([&] { return presenter_.flow().view().may_strap; }));
  EXPECT_EQ(marked(), Names{"strapped"});
  QTest::keyClick(&windows_.therapist(), Qt::Key_F9);
  EXPECT_FALSE(presenter_.flow().under_way());
  EXPECT_TRUE(presenter_.flow().view().may_strap) << "the pedal confirms nothing";
  press_f8();
  EXPECT_FALSE(presenter_.flow().view().may_strap) << "the hand is in";
  EXPECT_FALSE(presenter_.flow().view().may_stop) << "F8 does not skip the minute";
  ASSERT_TRUE(wait_until([&] { return presenter_.flow().view().may_stop; }))
      << "it goes on by itself: " << presenter_.flow().view().sentence;
}

TEST_F(SessionWindow, TheBarAndF8GoTheWholeWayWhereNothingHasToBeChosen) {
  const auto says = [&](const char* words) {
    return wait_until([&] { return next_thing().isVisible() && next_thing().text() == words; });
  };
  windows_.therapist().show_page(TherapistWindow::Page::start);
  EXPECT_TRUE(says("Add patient"));
  press_f8();
  EXPECT_TRUE(says("Choose the hand"));
  press_f8();
  EXPECT_EQ(presenter_.state().choices.today.hand, std::nullopt) << "nothing is filled in";
  EXPECT_EQ(windows_.therapist().focusWidget(), &operator_.find<QWidget>("hand_left"));
  operator_.press("hand_right");
  EXPECT_TRUE(says("Answer the screening"));
  press_f8();
  EXPECT_FALSE(presenter_.flow().view().may_connect) << "nothing is answered";
  QTest::keyClick(windows_.therapist().focusWidget(), Qt::Key_Return);
  choose_protocol("First session");
  EXPECT_TRUE(says("Connect"));
  windows_.therapist().show_page(TherapistWindow::Page::library);
  EXPECT_TRUE(says("Connect")) << "on every page";
  press_f8();
  EXPECT_TRUE(says("Device is empty: set zero"));
  press_f8();
  EXPECT_TRUE(says("Hand is in and strapped"));
  press_f8();
  EXPECT_TRUE(wait_until([&] { return presenter_.flow().view().may_stop; }));
  EXPECT_FALSE(next_thing().isVisible()) << "nothing is next while a trial runs";
}

TEST_F(SessionWindow, EnterPressesWhatIsNextWhereNothingElseHasTheFocus) {
  operator_.prepare_person();
  choose_protocol("First session");
  ASSERT_TRUE(wait_until([&] { return presenter_.flow().view().may_connect; }));
  auto& search = operator_.find<QLineEdit>("patient_search");
  windows_.therapist().show_page(TherapistWindow::Page::start);
  search.setFocus();
  QTest::keyClick(&search, Qt::Key_Return);
  EXPECT_FALSE(presenter_.state().busy()) << "Enter in a field is the field's";
  windows_.therapist().show_page(TherapistWindow::Page::session);
  if (auto* focus = windows_.therapist().focusWidget(); focus != nullptr) focus->clearFocus();
  QTest::keyClick(&windows_.therapist(), Qt::Key_Return);
  EXPECT_TRUE(presenter_.state().busy());
  ASSERT_TRUE(wait_until([&] { return presenter_.state().session_open(); }));
}

TEST_F(SessionWindow, AKeyThatIsHeldAndADoubleClickPassOneStep) {
  operator_.prepare_person();
  choose_protocol("First session");
  operator_.press("connect");
  ASSERT_TRUE(wait_until([&] { return presenter_.flow().view().may_zero; }));
  for (const auto key : {Qt::Key_F8, Qt::Key_Return}) {
    QKeyEvent held(QEvent::KeyPress, key, Qt::NoModifier, {}, true);
    QApplication::sendEvent(&windows_.therapist(), &held);
  }
  EXPECT_TRUE(presenter_.flow().view().may_zero) << "not even one, by a key held from before";
  QTest::mouseClick(&next_thing(), Qt::LeftButton);
  QTest::mouseDClick(&next_thing(), Qt::LeftButton);  // the second press of a double click alone
  QTest::mouseRelease(&next_thing(), Qt::LeftButton);
  ASSERT_TRUE(wait_until([&] { return presenter_.flow().view().may_strap; }));
  EXPECT_EQ(next_thing().text(), "Hand is in and strapped") << "the zero alone was set";
}

/// Whatever is next: the bar's is filled; the login's covers all others.
TEST_F(SessionWindow, TheFilledButtonIsThatOfTheBarAlone) {
  QStringList filled;
  for (const auto* button : windows_.therapist().findChildren<QPushButton*>())
    if (button->property("main").toString() == "yes") filled << button->objectName();
  EXPECT_EQ(filled, QStringList{"login"});
}

TEST_F(SessionWindow, TheQuestionOfAnInterruptedProtocolIsReadableOnASmallDisplay) {
  operator_.prepare_person();
  choose_protocol("First session");
  operator_.press("connect");
  operator_.set_zero();
  operator_.press("strapped");
  // Zero and resting force would be asked again; the maximum is done.
  ASSERT_TRUE(wait_until([&] { return presenter_.state().guide().acts_done() >= 3; }, 120));
  presenter_.protocol().stand_by();
  operator_.disconnect();
  auto& window = windows_.therapist();
  window.resize(1280, 720);
  operator_.press("hand_right");
  operator_.press("screening_clear");
  ASSERT_TRUE(wait_until([&] { return presenter_.state().choices.interrupted.acts.has_value(); }));
  EXPECT_EQ(presenter_.flow().view().next(), Step::work) << "its step is open";
  ASSERT_TRUE(laid_out(window));
  for (const char* name : {"earlier_question", "earlier_go_on", "earlier_anew"}) {
    auto& part = operator_.find<QWidget>(name);
    EXPECT_TRUE(part.isVisible()) << name;
    EXPECT_EQ(part.visibleRegion().boundingRect(), part.rect()) << name << " is cut";
    EXPECT_GE(part.height(), part.hasHeightForWidth() ? part.heightForWidth(part.width())
                                                      : part.sizeHint().height())
        << name;
  }
  operator_.press("earlier_go_on");
  EXPECT_TRUE(presenter_.flow().view().may_connect);
}

TEST_F(SessionWindow, TheSentenceOfTheEndNamesButtonsThatAreThere) {
  operator_.prepare_person();
  choose_protocol("First session");
  operator_.press("connect");
  operator_.set_zero();
  EXPECT_FALSE(operator_.find<QWidget>("end_report").isVisible());
  ASSERT_TRUE(wait_until([&] { return presenter_.state().guide().acts_done() == 1; }));
  while (!presenter_.state().guide().over()) presenter_.protocol().skip();
  EXPECT_NE(presenter_.flow().view().sentence.find("report, or disconnect"), std::string::npos);
  EXPECT_TRUE(operator_.find<QWidget>("end_report").isVisible());
  EXPECT_FALSE(operator_.find<QWidget>("start").isVisible());
  operator_.press("end_disconnect");
  ASSERT_TRUE(wait_until([&] { return !presenter_.state().busy(); }));
}

TEST_F(SessionWindow, ALongSummaryKeepsItsBeginning) {
  StepSection section(
      3, "Screening",
      [] {
        auto* body = new QWidget;
        new QVBoxLayout(body);
        return body;
      }(),
      &windows_.therapist());
  section.show_state(StepState::done, "Comfortable force only, at most 20 N, skin, pain 3 of 10",
                     "Screening");
  section.resize(260, 40);
  section.show();
  const auto shown = section.findChild<QLabel*>("summary_3")->text();
  EXPECT_TRUE(shown.startsWith("Comfort")) << shown.toStdString();
  EXPECT_TRUE(shown.endsWith(QStringLiteral("…"))) << shown.toStdString();
  EXPECT_TRUE(section.findChild<QPushButton*>("section_3")->toolTip().contains("pain 3 of 10"));
}

TEST_F(SessionWindow, TheWordsOfAStepLeaveTheRingOfTheFocusWhole) {
  operator_.add_patient();
  windows_.therapist().show_page(TherapistWindow::Page::session);
  auto& head = operator_.find<QPushButton>("section_2");  // next: its name and number are marked
  head.setFocus();
  ASSERT_TRUE(wait_until([&] { return head.isVisible() && head.hasFocus(); }));
  const QImage picture = head.grab().toImage();
  constexpr int kCorner_px = 10;
  for (const int y : {1, picture.height() - 2})
    for (int x = kCorner_px; x < picture.width() - kCorner_px; ++x)
      ASSERT_EQ(picture.pixelColor(x, y), look::kAccent) << x << ", " << y;
}

/// Presses that button of the question as soon as it stands there.
void answer(const char* name, QString& words) {
  QTimer::singleShot(0, qApp, [name, &words] {
    for (auto* window : QApplication::topLevelWidgets())
      if (window->objectName() == "file_in_use" && window->isVisible()) {
        words = window->findChild<QLabel*>("file_in_use_words")->text();
        return window->findChild<QPushButton*>(name)->click();
      }
    answer(name, words);
  });
}

class FileInUseTest : public QtTest {
 protected:
  TemporaryFolder folder_;
  std::string database_ = folder_.path("clinic.db");
};

TEST_F(FileInUseTest, ASecondProgramIsToldWhoHasTheFileAndMayLook) {
  QString words;
  {
    const auto first = file_to_open(database_);
    ASSERT_TRUE(first && first->use);
    EXPECT_FALSE(first->look_only);
    answer("file_look", words);
    const auto second = file_to_open(database_);
    ASSERT_TRUE(second);
    EXPECT_TRUE(second->look_only);
    EXPECT_FALSE(second->use);
    EXPECT_TRUE(words.contains("process " + QString::number(getpid()))) << words.toStdString();
    answer("file_leave", words);
    EXPECT_FALSE(file_to_open(database_));
  }
  const auto again = file_to_open(database_);
  ASSERT_TRUE(again && again->use) << "it is free when the window has gone";
}

TEST_F(FileInUseTest, LookingChangesNothingAndBeginsNoSession) {
  {
    auto store = storage::open_store(database_, storage::OpenMode::create);
    ASSERT_TRUE((*store)->add_patient("P-0427").ok());
  }
  GuiConfig config{database_, "sim://healthy?seed=7", ISOGRASP_SOURCE_DIR "/library", "test"};
  config.look_only = true;
  Windows windows(config);
  windows.show();
  ASSERT_TRUE(wait_until([&] { return windows.clinic().is_open(); }));
  auto& presenter = windows.presenter();
  ASSERT_EQ(windows.clinic().patients().size(), 1U);
  presenter.choices().choose_patient("P-0427");
  presenter.choices().choose_hand(Hand::right);
  EXPECT_FALSE(presenter.flow().view().may_connect);
  EXPECT_EQ(presenter.flow().view().situation, Situation::look_only);
  const Operator therapist(windows);
  EXPECT_FALSE(therapist.find<QPushButton>("add_patient").isEnabled());
}

}  // namespace
}  // namespace isograsp::gui::test::therapist_window_test
