// SPDX-License-Identifier: GPL-3.0-or-later
// The therapist's window without a display: names for assistive technology, keys, texts that fit,
// and the first steps of a session. Pages of the patient's screen are painted into pictures.
#include <QAbstractItemView>
#include <QComboBox>
#include <QDateTime>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QShortcut>
#include <QStackedWidget>
#include <QTabWidget>
#include <QToolButton>
#include <optional>
#include <set>

#include "gui/patient_screen/patient_canvas.hpp"
#include "operator.hpp"
#include "short_library.hpp"
#include "storage/access/open_store.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::widgets_test {
namespace {

class TherapistWindowTest : public QtTest {
 protected:
  TherapistWindowTest()
      : windows_({folder_.path("clinic.db"), "", make_short_library(folder_), "test"}),
        operator_(windows_) {
    windows_.therapist().show();
    EXPECT_TRUE(wait_until([&] { return windows_.clinic().is_open(); }));
  }

  TemporaryFolder folder_;
  Windows windows_;
  Operator operator_;
};

TEST_F(TherapistWindowTest, EveryFocusableWidgetHasANameATooltipAndAKey) {
  const auto shortcuts = windows_.therapist().findChildren<QShortcut*>();
  const QRegularExpression kKey(
      R"(Alt\+|Ctrl\+|Shift\+|\([A-Z]\)|\bF\d|Escape|Enter|[Aa]rrow|Tab|[Ss]pace|Home|Delete|keys)");
  int seen = 0;
  for (auto* widget : every(windows_.therapist().findChildren<QWidget*>())) {
    if (widget->focusPolicy() == Qt::NoFocus) continue;
    if (widget->objectName().startsWith("qt_")) continue;  // parts of Qt's own widgets
    if (qobject_cast<QComboBox*>(widget->parentWidget()) != nullptr) continue;
    if (widget->inherits("QComboBoxPrivateContainer") || widget->inherits("QHeaderView")) continue;
    if (widget->inherits("QComboBoxListView") || widget->inherits("QTableCornerButton")) continue;
    if (widget->parentWidget()->inherits("QTabBar")) continue;  // its scroll buttons
    if (widget->inherits("QLabel")) continue;                   // only links in it take the focus
    ++seen;
    const auto what = widget->objectName().toStdString() + " " + widget->metaObject()->className();
    EXPECT_FALSE(widget->accessibleName().isEmpty()) << what;
    EXPECT_FALSE(widget->toolTip().isEmpty()) << what;
    EXPECT_TRUE(kKey.match(widget->toolTip()).hasMatch())
        << what << " has no key: " << widget->toolTip().toStdString();
  }
  EXPECT_GE(seen, 14) << "the walk must have found the window's widgets";
}

TEST_F(TherapistWindowTest, NoTwoWidgetsOfAPageShareAMnemonic) {
  auto& pages = operator_.find<QStackedWidget>("pages");
  std::size_t seen = 0;
  for (int i = 0; i < pages.count(); ++i) {
    std::map<QString, std::string> used;
    for (auto* widget : every(pages.widget(i)->findChildren<QWidget*>())) {
      const auto text = widget->property("text").toString();
      const auto key = QKeySequence::mnemonic(text).toString();
      if (key.isEmpty()) continue;
      EXPECT_TRUE(used.emplace(key, text.toStdString()).second)
          << key.toStdString() << " is used by " << used[key] << " and " << text.toStdString();
    }
    seen += used.size();
  }
  EXPECT_GE(seen, 15U);
}

TEST_F(TherapistWindowTest, NoHandIsChosenBeforehand) {
  operator_.add_patient();
  EXPECT_FALSE(operator_.find<QPushButton>("hand_left").isChecked());
  EXPECT_FALSE(operator_.find<QPushButton>("hand_right").isChecked());
  EXPECT_FALSE(windows_.presenter().state().choices.today.hand.has_value());
}

TEST_F(TherapistWindowTest, AnotherPatientIsAskedForTheHandAgain) {
  operator_.add_patient();
  operator_.press("hand_left");
  EXPECT_EQ(windows_.presenter().state().choices.today.hand, Hand::left);
  operator_.add_patient();
  ASSERT_TRUE(
      wait_until([&] { return !windows_.presenter().state().choices.today.hand.has_value(); }));
}

TEST_F(TherapistWindowTest, AHandThatIsNotTheAffectedOneMustBeConfirmed) {
  operator_.add_patient();
  auto& presenter = windows_.presenter();
  storage::PatientProfile profile;
  profile.affected = storage::Side::left;
  windows_.person_file().save(presenter.state().choices.patient, profile);
  ASSERT_TRUE(wait_until([&] {
    const auto& records = windows_.person_file().records();
    return records && records->profile.affected == storage::Side::left;
  }));
  operator_.press("hand_right");
  EXPECT_EQ(presenter.flow().view().next(), Step::hand);
  EXPECT_NE(presenter.flow().view().sentence.find("not the affected hand"), std::string::npos);
  operator_.press("confirm_hand");
  EXPECT_EQ(presenter.flow().view().next(), Step::screening);
  operator_.open_section(Step::hand);
  operator_.press("hand_left");
  EXPECT_EQ(presenter.flow().view().next(), Step::screening) << "the affected one needs no word";
  profile.affected = storage::Side::right;
  windows_.person_file().save(presenter.state().choices.patient, profile);
  ASSERT_TRUE(wait_until([&] { return presenter.flow().hand_to_confirm(); }))
      << "also if it is told, or read, after the hand was chosen";
}

TEST_F(TherapistWindowTest, WhatWasTypedIsStoredWhenTheWindowCloses) {
  operator_.add_patient();
  const auto code = windows_.presenter().state().choices.patient;
  windows_.therapist().show_page(TherapistWindow::Page::patient);
  operator_.find<QTabWidget>("patient_tabs").setCurrentIndex(1);
  auto& goals = operator_.find<QPlainTextEdit>("goals");
  ASSERT_TRUE(wait_until([&] { return goals.isEnabled(); }));
  goals.setPlainText("Hold a cup.");
  windows_.therapist().close();  // before the second after the last key is over
  ASSERT_TRUE(wait_until([&] {
    const auto& records = windows_.person_file().records();
    return records && windows_.person_file().code() == code &&
           records->profile.goals == "Hold a cup.";
  }));
}

TEST_F(TherapistWindowTest, ADemonstrationThatCouldNotBeMadeIsOfferedAgain) {
  int asked = 0;
  windows_.therapist().open_demonstration = [&] { ++asked; };
  operator_.press("demonstration");
  EXPECT_EQ(asked, 1);
  EXPECT_FALSE(operator_.find<QPushButton>("demonstration").isEnabled());
  windows_.therapist().demonstration_failed("the disk is full");
  EXPECT_TRUE(operator_.find<QPushButton>("demonstration").isEnabled());
  EXPECT_TRUE(operator_.find<QLabel>("message").text().contains("disk is full"));
}

TEST_F(TherapistWindowTest, ANumberIsAnsweredFromTheKeyboard) {
  operator_.add_patient();
  operator_.press("hand_right");
  auto& zero = operator_.find<QToolButton>("screening_pain_0");
  zero.setFocus();
  for (int value = 0; value < 3; ++value)
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Right);
  EXPECT_FALSE(windows_.presenter().state().choices.today.screening.pain.has_value())
      << "moving answers nothing";
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
  EXPECT_EQ(windows_.presenter().state().choices.today.screening.pain, 3);
}

TEST_F(TherapistWindowTest, ARecordingFollowsNoProtocol) {
  auto& presenter = windows_.presenter();
  ASSERT_TRUE(presenter.state().choices.protocol) << "one is proposed";
  operator_.prepare_person();
  presenter.choices().choose_device("replay://" + write_recording_with_gap(folder_));
  EXPECT_FALSE(presenter.state().has_protocol());
  operator_.press("connect");
  ASSERT_TRUE(wait_until([&] { return presenter.state().session_open(); }));
  EXPECT_FALSE(presenter.state().follows());
  operator_.disconnect();
  auto store = storage::open_store(folder_.path("clinic.db"), storage::OpenMode::read_only);
  EXPECT_EQ((*store)->recent_sessions(1)->front().protocol_name, "");
}

TEST_F(TherapistWindowTest, ExactlyTheNextButtonIsHighlighted) {
  const auto highlighted = [&] {
    QStringList names;
    for (auto* button : windows_.therapist().findChildren<QPushButton*>())
      if (button->isEnabled() && button->isVisible() &&
          !button->property("next").toString().isEmpty())
        names.append(button->objectName());
    return names;
  };
  EXPECT_EQ(highlighted(), QStringList{"add_patient"});
  operator_.add_patient();
  EXPECT_EQ(highlighted(), (QStringList{"hand_left", "hand_right"}));
  operator_.press("hand_right");
  EXPECT_EQ(highlighted(), QStringList{"screening_clear"});
  operator_.press("screening_clear");
  operator_.choose_device("sim://healthy?seed=7");
  // It is looked up whether the protocol was interrupted today.
  EXPECT_TRUE(wait_until([&] { return highlighted() == QStringList{"connect"}; }));
}

TEST_F(TherapistWindowTest, WhatCouldNotBeConnectedIsTriedAgainWithOnePress) {
  const auto recording = folder_.path("later.csv");
  operator_.prepare_person();
  windows_.presenter().choices().choose_device("replay://" + recording);
  operator_.press("connect");
  const auto& happened = operator_.find<QLabel>("fault_happened");
  ASSERT_TRUE(wait_until([&] { return happened.isVisible(); }));
  EXPECT_TRUE(happened.text().contains("later.csv")) << happened.text().toStdString();
  EXPECT_EQ(operator_.find<QLabel>("fault_safe").text(),
            "No session has begun, and nothing was changed.");
  EXPECT_FALSE(operator_.find<QLabel>("fault_remedy").text().isEmpty());
  EXPECT_EQ(operator_.find<QAbstractButton>("next_thing").text(), "Try again");
  keep_picture(windows_.therapist(), "try_again");
  operator_.press("try_again");
  ASSERT_TRUE(wait_until([&] { return !windows_.presenter().state().busy(); }));
  EXPECT_TRUE(happened.isVisible()) << "it is still not there";
  windows_.presenter().choices().choose_device("sim://healthy?seed=7");
  EXPECT_FALSE(happened.isVisible()) << "something else was chosen";
}

TEST_F(TherapistWindowTest, SearchFindsAPatientByAnyPartOfTheCode) {
  operator_.add_patient();
  auto& list = operator_.find<QListWidget>("patient_list");
  auto& search = operator_.find<QLineEdit>("patient_search");
  const auto code = QString::fromStdString(windows_.clinic().patients()[0].code);
  ASSERT_TRUE(wait_until([&] { return list.count() == 1; }));
  QTest::keyClicks(&search, code.mid(3).toLower());
  EXPECT_EQ(list.count(), 1);
  search.setText("nobody");
  EXPECT_EQ(list.count(), 0);
}

TEST_F(TherapistWindowTest, WhoIsHereTodayStandsFirstAndSaysSo) {
  const auto database = folder_.path("earlier.db");
  {
    auto store = *storage::open_store(database, storage::OpenMode::create);
    for (const auto* code : {"P-0001", "P-0002", "P-0003"})
      ASSERT_TRUE(store->add_patient(code, "2026-01-02T10:00:00Z").ok());
    const auto add_session = [&](const char* code, const char* started_utc) {
      storage::SessionRecord session;
      session.patient_id = store->find_patient(code).value()->id;
      session.started_utc = started_utc;
      session.hand = Hand::left;
      session.device_uri = "sim://healthy";
      ASSERT_TRUE(store->begin_session(session).ok());
    };
    add_session("P-0001", "2026-02-03T10:00:00Z");
    const auto now = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
    add_session("P-0002", now.c_str());
  }
  Windows windows({database, "", folder_.path("library"), "test"});
  windows.therapist().show();
  const auto& list = Operator(windows).find<QListWidget>("patient_list");
  ASSERT_TRUE(wait_until(
      [&] { return list.count() == 3 && list.item(2)->toolTip().contains("No session yet"); }));
  EXPECT_EQ(list.item(0)->text(), "P-0002");
  EXPECT_TRUE(list.item(0)->toolTip().contains("TODAY"));
  EXPECT_EQ(list.item(1)->text(), "P-0001");
  EXPECT_TRUE(list.item(1)->toolTip().contains("left hand"))
      << list.item(1)->toolTip().toStdString();
  EXPECT_TRUE(list.item(2)->toolTip().contains("No session yet"));
  for (int row : {1, 2}) EXPECT_FALSE(list.item(row)->toolTip().contains("TODAY"));
}

TEST_F(TherapistWindowTest, KeysAndClicksPassOverTheHeadingsOfTheTaskList) {
  auto& list = operator_.find<QListWidget>("tasks");
  const auto number = [&](int row) { return list.item(row)->data(Qt::UserRole); };
  int headings = 0;
  for (int row = 0; row < list.count(); ++row) headings += number(row).isValid() ? 0 : 1;
  EXPECT_GE(headings, 3);
  EXPECT_EQ(list.count() - headings,
            static_cast<int>(windows_.presenter().state().library.tasks.size()));
  EXPECT_FALSE(number(0).isValid()) << "a heading comes first";
  list.setFocus();
  std::set<std::optional<int>> visited{windows_.presenter().state().task()};
  for (int step = 0; step < list.count(); ++step) {
    QTest::keyClick(&list, Qt::Key_Down);
    ASSERT_TRUE(number(list.currentRow()).isValid()) << list.currentRow();
    EXPECT_EQ(number(list.currentRow()).toInt(), windows_.presenter().state().task());
    visited.insert(windows_.presenter().state().task());
  }
  EXPECT_EQ(visited.size(), windows_.presenter().state().library.tasks.size());
  const auto chosen = windows_.presenter().state().task();
  QTest::mouseClick(list.viewport(), Qt::LeftButton, Qt::NoModifier,
                    list.visualItemRect(list.item(0)).center());
  EXPECT_EQ(windows_.presenter().state().task(), chosen);
}

TEST_F(TherapistWindowTest, AnAbsentDeviceIsRefusedInWords) {
  operator_.add_patient();
  operator_.press("hand_right");
  operator_.press("screening_clear");
  windows_.presenter().choices().choose_device("replay:///nowhere/recording.csv");
  operator_.press("connect");
  ASSERT_TRUE(wait_until([&] { return !windows_.presenter().state().busy(); }));
  const auto words = operator_.find<QLabel>("device_words").text();
  EXPECT_TRUE(words.contains("recording.csv")) << words.toStdString();
  EXPECT_TRUE(operator_.find<QPushButton>("connect").isEnabled()) << "it can be tried again";
}

TEST_F(TherapistWindowTest, NothingIsCutOffAtTheSmallestSize) {
  auto& window = windows_.therapist();
  window.resize(1280, 720);
  ASSERT_TRUE(laid_out(window));
  for (auto* button : every(window.findChildren<QPushButton*>())) {
    if (!button->isVisible()) continue;
    EXPECT_GE(button->width(), button->minimumSizeHint().width()) << button->text().toStdString();
    EXPECT_GE(button->height(), button->minimumSizeHint().height()) << button->text().toStdString();
  }
  for (auto* list : every(window.findChildren<QListWidget*>())) {
    const auto below = list->mapTo(&window, QPoint(0, list->height())).y();
    for (auto* sibling :
         every(list->parentWidget()->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)))
      if (sibling->isVisible() && sibling->mapTo(&window, {}).y() > list->mapTo(&window, {}).y()) {
        EXPECT_GE(sibling->mapTo(&window, {}).y(), below)
            << list->objectName().toStdString() << " covers what stands below it";
      }
  }
  for (auto* label : every(window.findChildren<QLabel*>())) {
    if (!label->isVisible() || label->wordWrap() || label->text().isEmpty()) continue;
    EXPECT_GE(label->width(), label->sizeHint().width()) << label->text().toStdString();
  }
}

TEST_F(TherapistWindowTest, WithoutOpenGlThePatientScreenIsRefusedInWords) {
  if (QGuiApplication::platformName() != "offscreen") GTEST_SKIP() << "this display has OpenGL";
  windows_.show_patient_screen();
  EXPECT_EQ(windows_.patient(), nullptr);
  EXPECT_FALSE(operator_.find<QLabel>("message").text().isEmpty());
}

TEST(Database, ThatIsNoDatabaseIsNamedInTheWindow) {
  application();
  TemporaryFolder folder;
  const auto path = folder.write("notes.txt", "These are my notes, not a database.\n");
  Windows windows({path, "", make_short_library(folder), "test"});
  windows.therapist().show();
  ASSERT_TRUE(wait_until([&] { return windows.presenter().flow().view().mood == Mood::fault; }));
  EXPECT_NE(windows.presenter().flow().view().sentence.find("notes.txt"), std::string::npos);
}

// Pages of the patient's screen.

QImage paint(const PatientPicture& picture) {
  application();
  QImage image(640, 360, QImage::Format_RGB32);
  QPainter painter(&image);
  paint_page(painter, QRectF(image.rect()), picture);
  return image;
}

double relative_luminance(QRgb colour) {
  const auto linear = [](int value) {
    const double v = value / 255.0;
    return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(qRed(colour)) + 0.7152 * linear(qGreen(colour)) +
         0.0722 * linear(qBlue(colour));
}

TEST(PatientCanvas, TextHasAContrastOfAtLeastSevenToOne) {
  PatientPicture picture;
  picture.sign = PatientPicture::Sign::wait;
  for (const bool detail : {false, true}) {
    (detail ? picture.detail : picture.headline) = "████████";  // full blocks: the pure ink
    (detail ? picture.headline : picture.detail).clear();
    const QImage image = paint(picture);
    double darkest = 1.0;
    for (int y = image.height() / 2; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        darkest = std::min(darkest, relative_luminance(image.pixel(x, y)));
    const double paper = relative_luminance(image.pixel(2, 2));
    EXPECT_GE((paper + 0.05) / (darkest + 0.05), 7.0);
  }
}

TEST(PatientCanvas, EveryPageLooksDifferent) {
  std::vector<QImage> pages;
  PatientPicture picture;
  for (const auto sign :
       {PatientPicture::Sign::wait, PatientPicture::Sign::hand_out, PatientPicture::Sign::rest,
        PatientPicture::Sign::act, PatientPicture::Sign::let_go, PatientPicture::Sign::memory,
        PatientPicture::Sign::good}) {
    picture.sign = sign;
    pages.push_back(paint(picture));
  }
  picture.notice_words = "The same words.";
  for (const auto notice : {PatientPicture::Notice::pause, PatientPicture::Notice::fault}) {
    picture.notice = notice;
    pages.push_back(paint(picture));
  }
  for (std::size_t a = 0; a < pages.size(); ++a)
    for (std::size_t b = a + 1; b < pages.size(); ++b)
      EXPECT_TRUE(pages[a] != pages[b]) << a << " and " << b;
}

TEST(PatientCanvas, OnACalmScreenTheTargetStandsStill) {
  auto preview = std::make_shared<TargetPreview>();
  preview->period_s = 0.1;
  preview->ahead_s = 4.0;
  for (int k = 0; k < 200; ++k) preview->target_N.push_back(5.0 + 4.0 * std::sin(0.2 * k));
  preview->axis = {0.0, 10.0};
  PatientPicture picture;
  picture.page = PatientPicture::Page::tracking;
  picture.line_shown = true;
  picture.preview = preview;
  picture.axis = preview->axis;
  for (const bool calm : {false, true}) {
    picture.calm = calm;
    // Right of the present on both pictures, and of the dashed line that marks it.
    const QRect future(160, 110, 80, 210);
    picture.task_time_s = 1.0;
    const auto before = paint(picture).copy(future);
    picture.task_time_s = 1.3;
    EXPECT_EQ(paint(picture).copy(future) == before, calm);
  }
  picture.preview = nullptr;  // nothing moves there that could stand still
  const auto as_usual = paint(picture);
  picture.calm = false;
  EXPECT_EQ(paint(picture), as_usual);
}

TEST(PatientCanvas, TheDotOnTheTargetIsMarkedByShapeToo) {
  PatientPicture picture;
  picture.page = PatientPicture::Page::tracking;
  picture.line_shown = picture.force_shown = true;
  picture.axis = {0.0, 10.0};
  picture.target_N = 10.0;
  const auto whites_near_dot = [&](double force_N) {
    picture.force_N = force_N;
    picture.on_target = force_N == picture.target_N;
    const QImage image = paint(picture);
    const int x = 640 / 2;
    const int y = static_cast<int>(360 * (0.90 - 0.60 * picture.axis.share(force_N)));
    int bright = 0;
    for (int dy = -6; dy <= 6; ++dy)
      for (int dx = -6; dx <= 6; ++dx) bright += qGreen(image.pixel(x + dx, y + dy)) > 200;
    return bright;
  };
  EXPECT_GT(whites_near_dot(10.0), 4) << "a white check inside the disc";
  EXPECT_EQ(whites_near_dot(5.0), 0) << "a plain disc";
}

}  // namespace
}  // namespace isograsp::gui::test::widgets_test
