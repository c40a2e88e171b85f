// SPDX-License-Identifier: GPL-3.0-or-later
// Settings of a workstation: kept, checked, and taking effect while a session goes on.
#include "gui/clinic/settings.hpp"

#include <QComboBox>
#include <QLineEdit>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

#include "core/files.hpp"
#include "gui/presenter/next_words.hpp"
#include "gui/windows.hpp"
#include "operator.hpp"
#include "short_library.hpp"
#include "storage/access/open_store.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/within.hpp"

namespace isograsp::gui::test::settings_test {
namespace {

class SettingsTest : public QtTest {
 protected:
  [[nodiscard]] QString path() const { return QString::fromStdString(folder_.path("i.ini")); }
  TemporaryFolder folder_;
};

TEST_F(SettingsTest, WhatIsChosenIsThereTheNextTime) {
  Settings chosen;
  chosen.language = "de";
  chosen.font_percent = 150;
  chosen.patient_screen = "HDMI-2";
  chosen.viewing_distance_m = 0.75;
  chosen.screen_height_m = 0.296;
  chosen.display_delay_s = 0.0213;
  chosen.volume_percent = 20;
  chosen.share_of_maximum = true;
  chosen.devices = {{"Room 2", "can://can0?protocol=rft"}, {"Raum, 3 = \"neu\"", "qtm://a?rig=b"}};
  SettingsFile(path()).change(chosen);
  EXPECT_EQ(SettingsFile(path()).now(), chosen);
  chosen.display_delay_s.reset();  // not measured any more
  chosen.devices.pop_back();       // forgotten
  SettingsFile(path()).change(chosen);
  EXPECT_EQ(SettingsFile(path()).now(), chosen);
}

TEST_F(SettingsTest, AValueThatMakesNoSenseIsNamedAndNotUsed) {
  folder_.write("i.ini", "font_percent=900\n[patient]\nviewing_distance_m=near\n");
  const SettingsFile file(path());
  ASSERT_EQ(file.problems().size(), 2);
  EXPECT_TRUE(file.problems()[0].contains("font_percent"));
  EXPECT_TRUE(file.problems()[1].contains("viewing_distance_m = \"near\""));
  EXPECT_EQ(file.now(), Settings{});
}

TEST_F(SettingsTest, DevicesThatMakeNoSenseAreNamedAndLeftOutHoweverManyTheFileSaysThereAre) {
  folder_.write("i.ini",
                "[devices]\nsize=2000000000\n1\\name=Room 2\n1\\address=can://can0\n2\\name=\n");
  const SettingsFile file(path());
  ASSERT_EQ(file.now().devices.size(), 1U);
  EXPECT_EQ(file.now().devices[0], (NamedDevice{"Room 2", "can://can0"}));
  ASSERT_EQ(file.problems().size(), 1);
  EXPECT_TRUE(file.problems()[0].contains("1999999999 devices"))
      << file.problems()[0].toStdString();
}

TEST_F(SettingsTest, AFileThatCannotBeWrittenIsSaid) {
  SettingsFile unwritable(QStringLiteral("/proc/isograsp.ini"));
  QString said;
  QObject::connect(&unwritable, &SettingsFile::failed, [&](const QString& why) { said = why; });
  Settings settings;
  settings.font_percent = 150;
  unwritable.change(settings);
  EXPECT_TRUE(said.contains("/proc/isograsp.ini"));
  EXPECT_EQ(unwritable.now().font_percent, 150) << "it holds all the same";
}

TEST_F(SettingsTest, OtherLettersMakeTheWindowAnewAtItsPlaceAndTheSessionGoesOn) {
  Windows windows({folder_.path("clinic.db"), "", ISOGRASP_SOURCE_DIR "/library", "test"});
  windows.show();
  ASSERT_TRUE(wait_until([&] { return windows.clinic().is_open(); }));
  const Operator therapist(windows);
  therapist.prepare_person();
  windows.presenter().choices().choose_device("sim://healthy?seed=7");
  therapist.press("connect");
  ASSERT_TRUE(wait_until([&] { return windows.presenter().state().session_open(); }));
  auto& note = therapist.find<QLineEdit>("note");
  QTest::keyClicks(&note, "half a wo");
  windows.therapist().show_page(TherapistWindow::Page::settings);
  QSignalSpy ended(qApp, &QGuiApplication::lastWindowClosed);
  const auto place = windows.therapist().geometry();
  auto& letters = therapist.find<QComboBox>("settings_letters");
  const auto before = QApplication::font().pointSizeF();
  letters.setCurrentIndex(letters.findData(150));
  Q_EMIT letters.activated(letters.currentIndex());
  ASSERT_TRUE(wait_until([&] { return QApplication::font().pointSizeF() > 1.4 * before; }));
  EXPECT_EQ(windows.therapist().page(), TherapistWindow::Page::settings);
  EXPECT_EQ(windows.therapist().geometry().topLeft(), place.topLeft());
  EXPECT_TRUE(windows.therapist().isVisible());
  EXPECT_TRUE(windows.presenter().state().session_open());
  EXPECT_EQ(therapist.find<QLineEdit>("note").text(), "half a wo");
  EXPECT_EQ(ended.count(), 0) << "the program goes on";
  Settings usual;
  windows.settings().change(usual);
  ASSERT_TRUE(wait_until([&] { return QApplication::font().pointSizeF() == before; }));
  windows.presenter().connecting().end_session();
  ASSERT_TRUE(wait_until([&] { return !windows.presenter().state().busy(); }));
}

TEST_F(SettingsTest, ANumberCanBeTypedDigitByDigit) {
  Windows windows({folder_.path("clinic.db"), "", ISOGRASP_SOURCE_DIR "/library", "test"});
  windows.show();
  ASSERT_TRUE(wait_until([&] { return windows.clinic().is_open(); }));
  const Operator therapist(windows);
  windows.therapist().show_page(TherapistWindow::Page::settings);
  const auto type = [&](const char* field, const char* digits) {
    auto& box = therapist.find<QAbstractSpinBox>(field);
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, digits);
    QTest::keyClick(&box, Qt::Key_Return);
  };
  type("settings_distance", "135");
  type("settings_height", "33.6");
  type("settings_delay", "12.5");
  EXPECT_DOUBLE_EQ(windows.settings().now().viewing_distance_m, 1.35);
  constexpr double kWritten = 1e-12;  // m, s: of a number with one decimal
  EXPECT_WITHIN(windows.settings().now().screen_height_m.value_or(0.0), 0.336, kWritten);
  EXPECT_WITHIN(windows.settings().now().display_delay_s.value_or(0.0), 0.0125, kWritten);
}

TEST_F(SettingsTest, SayWhatCannotBeNoticedInADatabaseWithoutAPassphrase) {
  Windows windows({folder_.path("clinic.db"), "", ISOGRASP_SOURCE_DIR "/library", "test"});
  windows.show();
  ASSERT_TRUE(wait_until([&] { return windows.clinic().is_open(); }));
  const Operator therapist(windows);
  windows.therapist().show_page(TherapistWindow::Page::settings);
  EXPECT_TRUE(therapist.find<QLabel>("records_hold").text().contains("has no passphrase"));
  EXPECT_TRUE(therapist.find<QLabel>("records_limits").text().contains("computes seals"));
  EXPECT_FALSE(therapist.find<QLabel>("records_found").isVisible()) << "nobody logs in";
  keep_pictures_of_both_sizes(windows.therapist(), "settings_unprotected");
}

TEST_F(SettingsTest, AVisualGainThatTheScreenCannotShowIsSaidOnceATrial) {
  const auto library = make_short_library(folder_);
  const auto path = library + "/tasks/familiarisation.toml";
  ASSERT_TRUE(write_text(path, read_text(path).value() + "\ngain_deg_per_N = 90\n").ok());
  Windows windows({folder_.path("clinic.db"), "", library, "test"});
  windows.show();
  ASSERT_TRUE(wait_until([&] { return windows.clinic().is_open(); }));
  const Operator therapist(windows);
  therapist.prepare("sim://healthy?seed=7");
  auto& presenter = windows.presenter();
  ASSERT_TRUE(wait_until([&] {
    return presenter.flow().view().may_choose_task && presenter.flow().view().may_strap;
  }));
  const auto& tasks = presenter.state().library.tasks;
  for (std::size_t i = 0; i < tasks.size(); ++i)
    if (tasks[i].name == "Familiarisation") presenter.tasks().choose(static_cast<int>(i));
  ASSERT_EQ(next_words(presenter.state()), "Familiarisation");
  therapist.start_task();
  QObject::disconnect(&presenter.flow(), &SessionFlow::failed, nullptr, nullptr);  // to be expected
  QSignalSpy said(&presenter.flow(), &SessionFlow::failed);
  constexpr double kPicture_m = 0.3;
  ASSERT_TRUE(wait_until(
      [&] { return presenter.patient_view().picture(kPicture_m).gain_deg_per_N.has_value(); }));
  for (int i = 0; i < 100; ++i)
    presenter.patient_view().picture_shown(presenter.patient_view().picture(kPicture_m));
  ASSERT_EQ(said.count(), 1);
  EXPECT_TRUE(said[0][0].toString().contains("90° per newton"))
      << said[0][0].toString().toStdString();
  presenter.connecting().end_session();
  ASSERT_TRUE(wait_until([&] { return !presenter.state().busy(); }));
}

TEST_F(SettingsTest, PostureAndScreenAreOfferedAsLastTime) {
  Windows windows({folder_.path("clinic.db"), "", ISOGRASP_SOURCE_DIR "/library", "test"});
  windows.show();
  ASSERT_TRUE(wait_until([&] { return windows.clinic().is_open(); }));
  const Operator therapist(windows);
  therapist.prepare_person();
  auto& presenter = windows.presenter();
  presenter.choices().choose_protocol(std::nullopt);
  Presentation half;
  half.half = Presentation::Half::left;
  presenter.seating().say_presentation(half);
  presenter.choices().choose_device("sim://healthy?seed=7");
  therapist.press("connect");
  ASSERT_TRUE(wait_until([&] { return presenter.state().session_open(); }));
  half.sound = true;  // said while the session is open
  presenter.seating().say_presentation(half);
  therapist.set_zero();
  SittingPosture posture;
  posture.of(PostureItem::elbow) = "90";
  posture.of(PostureItem::straps) = "3, 4, 4";
  presenter.seating().say_posture(Hand::right, posture);
  therapist.press("strapped");
  therapist.disconnect();
  {
    auto store = storage::open_store(folder_.path("clinic.db"), storage::OpenMode::read_only);
    const auto session = (*store)->recent_sessions(1)->front();
    const auto answers = *(*store)->answers(session.id);
    EXPECT_EQ(posture_in(answers), posture);
    EXPECT_EQ(presentation_in(answers), half);
    const auto has = [&](const char* item) {
      return std::any_of(answers.begin(), answers.end(),
                         [&](const auto& answer) { return answer.item == item; });
    };
    EXPECT_TRUE(has("donning_time_s"));
    EXPECT_TRUE(has("display_delay_s"));
  }
  const auto code = presenter.state().choices.patient;
  therapist.add_patient();
  EXPECT_EQ(presenter.seating().presentation(), Presentation{}) << "nothing of somebody else";
  presenter.choices().choose_patient(code);
  ASSERT_TRUE(wait_until([&] { return presenter.seating().presentation() == half; }));
  presenter.choices().choose_hand(Hand::left);
  EXPECT_FALSE(presenter.seating().posture(Hand::left).said()) << "of the other hand";
  presenter.choices().choose_hand(Hand::right);
  ASSERT_TRUE(wait_until([&] { return presenter.seating().posture(Hand::right) == posture; }));
  EXPECT_TRUE(therapist.find<QAbstractButton>("strapped").text().contains("as last time"));
}

}  // namespace
}  // namespace isograsp::gui::test::settings_test
