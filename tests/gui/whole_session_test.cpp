// SPDX-License-Identifier: GPL-3.0-or-later
// A therapist's whole session with both windows on a real display (Xvfb): add patient, connect,
// zero, rest, maximum, task, result, report. Screenshots are kept as test output.
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QTableWidget>
#include <algorithm>
#include <cstdio>

#include "gui/presenter/next_words.hpp"
#include "operator.hpp"
#include "short_library.hpp"
#include "storage/access/open_store.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::whole_session_test {
namespace {

class WholeSession : public QtTest {
 protected:
  WholeSession()
      : windows_(settling_soon({folder_.path("clinic.db"), "sim://healthy?seed=7",
                                make_short_library(folder_, "3"), "test"})),
        operator_(windows_) {
    windows_.show();
  }
  ~WholeSession() override {
    windows_.presenter().connecting().end_session();
    EXPECT_TRUE(wait_until([&] { return !windows_.presenter().state().busy(); }));
  }

  /// Both windows as test output.
  void keep_picture(const QString& name) {
    const auto folder = qEnvironmentVariable("ISOGRASP_TEST_PICTURES");
    if (folder.isEmpty()) return;
    QDir().mkpath(folder);
    windows_.therapist().grab().save(folder + "/" + name + "_therapist.png");
    windows_.patient()->grabFramebuffer().save(folder + "/" + name + "_patient.png");
  }

  /// Trials of the only patient as another program would read them.
  std::vector<storage::TrialRecord> stored_trials() {
    auto store = storage::open_store(folder_.path("clinic.db"), storage::OpenMode::read_only);
    EXPECT_TRUE(store.ok());
    const auto patients = (*store)->patients();
    const auto sessions = (*store)->sessions(patients->front().id);
    EXPECT_EQ(sessions->size(), 1U);
    EXPECT_EQ(sessions->front().hand, Hand::right);
    EXPECT_TRUE(sessions->front().simulated);
    return *(*store)->trials(sessions->front().id);
  }

  TemporaryFolder folder_;
  Windows windows_;
  Operator operator_;
};

TEST_F(WholeSession, EndsWithResultsInTheDatabaseAndAReport) {
  if (QGuiApplication::platformName() != "xcb") GTEST_SKIP() << "needs a display";
  windows_.show_patient_screen();
  ASSERT_NE(windows_.patient(), nullptr);
  auto& presenter = windows_.presenter();
  operator_.prepare("sim://healthy?seed=7");
  keep_picture("zeroed");

  EXPECT_EQ(presenter.flow().view().next(), Step::rest);
  operator_.strap_in();
  operator_.run_task();
  EXPECT_EQ(presenter.flow().view().next(), Step::work);
  operator_.run_task();
  EXPECT_EQ(presenter.flow().view().next(), Step::work);
  operator_.start_task();
  ASSERT_TRUE(wait_until([&] { return !presenter.state().live_score().empty(); }))
      << "the score is live";
  keep_picture("tracking");
  operator_.press("pause");
  ASSERT_TRUE(
      wait_until([&] { return presenter.state().snapshot().stage == session::Stage::paused; }));
  EXPECT_TRUE(wait_until(
      [&] { return presenter.patient_view().picture().notice == PatientPicture::Notice::pause; }));
  keep_picture("paused");
  operator_.press("pause");  // now Resume
  operator_.finish_task();
  EXPECT_EQ(presenter.flow().view().next(), Step::work) << "the next task, or once more";
  EXPECT_GT(operator_.find<QTableWidget>("score").rowCount(), 0);
  ASSERT_TRUE(wait_until([&] { return windows_.clinic().history().size() > 0; }));

  operator_.choose_task("pose_targets");
  operator_.start_task();
  ASSERT_TRUE(wait_until([&] { return presenter.state().snapshot().grasp.contact[0]; }));
  EXPECT_TRUE(wait_until(
      [&] { return presenter.patient_view().picture().page == PatientPicture::Page::object; }));
  keep_picture("object");
  operator_.press("stop");
  operator_.finish_task();

  const auto pdf = folder_.path("report.pdf");
  bool written = false;
  QObject::connect(&windows_.clinic().report(), &ReportWork::written, [&] { written = true; });
  windows_.clinic().report().start(presenter.state().choices.patient, pdf);
  ASSERT_TRUE(wait_until([&] { return written; }));
  EXPECT_TRUE(std::filesystem::exists(pdf));
  EXPECT_GT(windows_.patient()->rate().pictures, 0);

  const auto trials = stored_trials();
  ASSERT_EQ(trials.size(), 4U);
  EXPECT_EQ(trials[0].status, storage::TrialStatus::completed);
  EXPECT_EQ(trials[1].status, storage::TrialStatus::completed);
  EXPECT_EQ(trials[2].status, storage::TrialStatus::completed);
  EXPECT_GT(trials[2].references.at("maximum_force_N"), 0.0);
  EXPECT_EQ(trials[3].status, storage::TrialStatus::aborted);
  for (const auto& trial : every(trials)) EXPECT_EQ(trial.dropped, 0);

  operator_.disconnect();
  EXPECT_FALSE(presenter.state().choices.today.hand.has_value())
      << "asked anew in the next session";
}

class WholeSessionOfAnArm : public QtTest {
 protected:
  WholeSessionOfAnArm()
      : windows_(GuiConfig{folder_.path("clinic.db"), "sim://arm?patient=healthy&seed=7",
                           make_arm_library(folder_), "test"}) {
    windows_.show();
  }
  ~WholeSessionOfAnArm() override {
    windows_.presenter().connecting().end_session();
    EXPECT_TRUE(wait_until([&] { return !windows_.presenter().state().busy(); }));
  }
  void keep_picture(const QString& name) {
    const auto folder = qEnvironmentVariable("ISOGRASP_TEST_PICTURES");
    if (folder.isEmpty()) return;
    QDir().mkpath(folder);
    const auto drawn = windows_.patient()->rate().pictures;
    EXPECT_TRUE(wait_until([&] { return windows_.patient()->rate().pictures > drawn + 1; }));
    windows_.therapist().grab().save(folder + "/" + name + "_therapist.png");
    windows_.patient()->grabFramebuffer().save(folder + "/" + name + "_patient.png");
  }

  TemporaryFolder folder_;
  Windows windows_;
  Operator operator_{windows_};
};

TEST_F(WholeSessionOfAnArm, DrawsTheObjectAndItsTargetInTheirRoom) {
  if (QGuiApplication::platformName() != "xcb") GTEST_SKIP() << "needs a display";
  windows_.show_patient_screen();
  ASSERT_NE(windows_.patient(), nullptr);
  auto& presenter = windows_.presenter();
  const auto picture = [&] { return presenter.patient_view().picture(0.3); };
  operator_.prepare_person();
  operator_.press("connect");
  ASSERT_TRUE(wait_until([&] {
    return presenter.state().open &&
           presenter.state().open->still.state() == StillWatch::State::still;
  })) << presenter.flow().view().sentence;
  keep_picture("arm_still");
  operator_.press("start_posture");
  ASSERT_TRUE(wait_until([&] { return presenter.flow().view().next() == Step::work; }))
      << presenter.flow().view().sentence;
  operator_.press("start");
  ASSERT_TRUE(wait_until([&] { return picture().angle.ranged; }));
  keep_picture("arm_range");
  ASSERT_TRUE(wait_until([&] { return picture().target_shown; }));
  keep_picture("arm_object");
  ASSERT_TRUE(wait_until([&] { return picture().matched; })) << presenter.flow().view().sentence;
  keep_picture("arm_matched");
  ASSERT_TRUE(wait_until([&] { return presenter.state().guide().over(); }));
  EXPECT_GT(windows_.patient()->rate().pictures, 0);
}

/// Presses of a mouse button and of keys, wherever they go.
class Counter final : public QObject {
 public:
  Counter() { QCoreApplication::instance()->installEventFilter(this); }
  int clicks = 0;
  int keys = 0;

 protected:
  bool eventFilter(QObject* target, QEvent* event) override {
    // Each event reaches its window and then its widget: only the widget counts.
    if (qobject_cast<QWidget*>(target) == nullptr) return false;
    clicks += event->type() == QEvent::MouseButtonPress;
    keys += event->type() == QEvent::KeyPress;
    return false;
  }
};

TEST_F(WholeSession, SessionsNeedFewClicksAndNoTyping) {
  // A therapist's: from an empty window to the first trial, to the saved report; of somebody who is
  // known to the first trial of the next session.
  constexpr int kMostToFirstTrial = 9;
  constexpr int kMostClicks = 13;
  constexpr int kMostWhenKnown = 7;
  constexpr int kMostForOtherHand = 5;
  auto& presenter = windows_.presenter();
  ASSERT_TRUE(wait_until([&] { return windows_.clinic().is_open(); }));
  // The battery is proposed, and takes ten minutes: a shorter one takes its place here.
  for (std::size_t i = 0; i < presenter.state().library.protocols.size(); ++i)
    if (presenter.state().library.protocols[i].spec.name == "First session")
      presenter.choices().choose_protocol(static_cast<int>(i));
  const Counter counter;
  operator_.press("add_patient");
  operator_.press("hand_right");
  operator_.press("screening_clear");
  auto& devices = operator_.find<QListWidget>("devices");
  const auto row = devices.findItems("healthy", Qt::MatchContains);
  ASSERT_FALSE(row.isEmpty());
  QTest::mouseClick(devices.viewport(), Qt::LeftButton, {},
                    devices.visualItemRect(row.front()).center());
  operator_.press("connect");
  operator_.press("zero");
  ASSERT_TRUE(wait_until([&] { return presenter.state().snapshot().zeroed; }));
  operator_.press("strapped");
  EXPECT_LE(counter.clicks, kMostToFirstTrial);
  // Nobody presses Start: the resting force follows when the hand has settled.
  ASSERT_TRUE(wait_until([&] { return presenter.state().guide().over(); }, 250))
      << presenter.flow().view().sentence;
  operator_.press("effort_4");
  operator_.press("pain_0");
  EXPECT_GT(operator_.find<QTableWidget>("score").rowCount(), 0) << "the result";
  operator_.press("closing_report");
  auto* dialog = windows_.therapist().findChild<QFileDialog*>();
  ASSERT_NE(dialog, nullptr);
  dialog->selectFile(QString::fromStdString(folder_.path("report.pdf")));
  auto* buttons = dialog->findChild<QDialogButtonBox*>();
  ASSERT_NE(buttons, nullptr);
  bool written = false;
  QObject::connect(&windows_.clinic().report(), &ReportWork::written, [&] { written = true; });
  QTest::mouseClick(buttons->button(QDialogButtonBox::Save), Qt::LeftButton);
  ASSERT_TRUE(wait_until([&] { return written; }));
  EXPECT_LE(counter.clicks, kMostClicks);
  EXPECT_GE(counter.clicks, 10) << "every press was counted";
  EXPECT_EQ(counter.keys, 0);
  std::printf("clicks from an empty window to the report: %d\n", counter.clicks);
  windows_.therapist().show_page(TherapistWindow::Page::session);
  auto& closing = operator_.find<QTableWidget>("closing");
  ASSERT_TRUE(wait_until([&] { return closing.rowCount() > 0; })) << "today";
  EXPECT_LE(closing.rowCount(), 4);
  test::keep_picture(windows_.therapist(), "closing");
  operator_.press("closing_end");
  ASSERT_TRUE(wait_until([&] { return !presenter.state().busy(); }));
  EXPECT_GE(stored_trials().size(), 3U);
  EXPECT_EQ(windows_.therapist().page(), TherapistWindow::Page::start);
  EXPECT_EQ(presenter.state().choices.patient, "") << "nobody is chosen for who comes next";

  const Counter known;
  auto& patients = operator_.find<QListWidget>("patient_list");
  ASSERT_TRUE(laid_out(windows_.therapist()));
  ASSERT_TRUE(wait_until([&] { return patients.isEnabled() && patients.count() == 1; }));
  operator_.press(qPrintable(QStringLiteral("begin_") + patients.item(0)->text()));
  EXPECT_EQ(presenter.state().chosen_protocol().spec.name, "First session") << "as last time";
  for (const char* button : {"hand_right", "screening_clear", "connect", "zero", "strapped"})
    operator_.press(button);
  ASSERT_TRUE(wait_until([&] { return presenter.flow().view().may_stop; }, 90));
  EXPECT_LE(known.clicks, kMostWhenKnown);
  EXPECT_EQ(known.keys, 0);

  presenter.trials().stop();
  ASSERT_TRUE(wait_until([&] { return presenter.flow().view().may_take_other_hand; }));
  const Counter other;
  operator_.open_section(Step::hand);
  for (const char* button : {"other_hand", "screening_clear", "zero", "strapped"})
    operator_.press(button);
  ASSERT_TRUE(wait_until([&] { return presenter.flow().view().may_stop; }, 90));
  EXPECT_LE(other.clicks, kMostForOtherHand);
  EXPECT_GE(other.clicks, 5) << "every press was counted";
  EXPECT_EQ(presenter.state().open->session->known().record.hand, Hand::left);
  presenter.connecting().end_session();
  ASSERT_TRUE(wait_until([&] { return !presenter.state().busy(); }));
}

TEST_F(WholeSession, TheOtherHandIsAskedEverythingAnewButTheDevice) {
  auto& presenter = windows_.presenter();
  operator_.prepare("sim://healthy?seed=7");
  operator_.open_section(Step::hand);
  operator_.press("other_hand");
  ASSERT_TRUE(wait_until([&] { return !presenter.state().busy(); }));
  EXPECT_EQ(presenter.state().choices.today.hand, Hand::left);
  EXPECT_EQ(presenter.flow().view().situation, Situation::screen)
      << presenter.flow().view().sentence;
  EXPECT_FALSE(presenter.state().session_open()) << "nothing is connected before the screening";
  operator_.press("screening_clear");
  ASSERT_TRUE(wait_until([&] { return presenter.state().session_open(); }));
  EXPECT_EQ(presenter.state().choices.device_uri, "sim://healthy?seed=7");
  EXPECT_FALSE(presenter.state().snapshot().zeroed);
  operator_.disconnect();
  auto store = storage::open_store(folder_.path("clinic.db"), storage::OpenMode::read_only);
  const auto sessions = *(*store)->recent_sessions(3);
  ASSERT_EQ(sessions.size(), 2U);
  EXPECT_EQ(sessions.front().hand, Hand::left);
  EXPECT_EQ(sessions.back().hand, Hand::right);
  EXPECT_EQ(sessions.front().patient_id, sessions.back().patient_id);
}

TEST_F(WholeSession, ADeviceThatIsChosenForTheOtherHandWaitsForItsPress) {
  auto& presenter = windows_.presenter();
  operator_.prepare("sim://healthy?seed=7");
  operator_.open_section(Step::hand);
  operator_.press("other_hand");
  ASSERT_TRUE(wait_until([&] { return !presenter.state().busy(); }));
  operator_.choose_device("sim://paretic?seed=7");
  operator_.press("screening_clear");
  ASSERT_TRUE(wait_until([&] { return presenter.flow().view().may_connect; }));
  int polls = 0;
  QObject::connect(&presenter.flow(), &SessionFlow::frame, [&] { ++polls; });
  ASSERT_TRUE(wait_until([&] { return polls > 3; }));
  EXPECT_FALSE(presenter.state().busy());
}

TEST_F(WholeSession, AProtocolGoesOnByItselfUntilSomebodyHoldsIt) {
  auto& presenter = windows_.presenter();
  operator_.prepare_person();
  const auto& protocols = presenter.state().library.protocols;
  const auto found = std::find_if(protocols.begin(), protocols.end(), [](const auto& protocol) {
    return protocol.spec.name == "Short demonstration";
  });
  ASSERT_NE(found, protocols.end());
  presenter.choices().choose_protocol(static_cast<int>(found - protocols.begin()));
  operator_.press("connect");
  operator_.set_zero();
  ASSERT_TRUE(wait_until([&] { return presenter.state().guide().acts_done() == 1; }))
      << "the zero is the first act";
  presenter.trials().start();
  EXPECT_FALSE(presenter.flow().view().may_stop) << "F8 skips neither the word nor the minute";
  operator_.press("strapped");
  EXPECT_TRUE(presenter.state().guide().goes_on());
  ASSERT_TRUE(wait_until([&] { return presenter.state().snapshot().trial_number == 1; }))
      << "the resting force begins when the hand has settled: " << presenter.flow().view().sentence;
  ASSERT_TRUE(wait_until([&] { return presenter.flow().view().may_stand_by; }));
  EXPECT_NE(presenter.flow().view().sentence.find("Next, in"), std::string::npos)
      << presenter.flow().view().sentence;
  // Nobody presses: the maximum begins when its instruction has been read.
  ASSERT_TRUE(wait_until([&] { return presenter.state().snapshot().trial_number == 2; }));
  operator_.press("helped");
  ASSERT_TRUE(wait_until([&] { return presenter.flow().view().may_stand_by; }));
  presenter.trials().start_pause_resume();
  EXPECT_FALSE(presenter.state().guide().goes_on())
      << "the one key holds what would begin by itself";
  EXPECT_FALSE(presenter.flow().view().may_stop) << "and does not begin it sooner";
  operator_.press("skip");
  EXPECT_EQ(next_words(presenter.state()), "Two targets");
  operator_.press("repeat");  // the maximum, beside the protocol
  ASSERT_TRUE(wait_until([&] { return presenter.state().snapshot().trial_number == 3; }));
  ASSERT_TRUE(wait_until([&] { return !presenter.flow().view().may_stop; }));
  EXPECT_EQ(next_words(presenter.state()), "Two targets") << "where the protocol stood";
  operator_.press("skip");
  EXPECT_TRUE(presenter.state().guide().over());
  EXPECT_TRUE(presenter.state().guide().rating_due());
  operator_.press("effort_4");
  operator_.press("pain_5");
  EXPECT_NE(presenter.flow().view().sentence.find("stop the work"), std::string::npos)
      << presenter.flow().view().sentence;
  operator_.disconnect();

  const auto trials = stored_trials();
  ASSERT_EQ(trials.size(), 3U);
  EXPECT_EQ(trials[1].place, (storage::TrialPlace{2, 0}));
  EXPECT_TRUE(trials[1].helped);
  EXPECT_FALSE(trials[2].place.has_value());
  EXPECT_FALSE(trials[2].helped);
  auto store = storage::open_store(folder_.path("clinic.db"), storage::OpenMode::read_only);
  const auto session = (*store)->recent_sessions(1)->front();
  EXPECT_EQ(session.protocol_name, "Short demonstration");
  EXPECT_EQ(session.allowed, "maximum");
  const auto answers = *(*store)->answers(session.id);
  EXPECT_EQ(std::count_if(answers.begin(), answers.end(),
                          [](const auto& answer) { return answer.topic == "screening"; }),
            static_cast<std::ptrdiff_t>(kCautionCount) + 1);
  EXPECT_EQ((*store)->ratings(session.id)->size(), 1U);
}

TEST_F(WholeSession, ZeroAndRestAreTwoActs) {
  auto& presenter = windows_.presenter();
  operator_.prepare("sim://healthy?seed=7");
  EXPECT_TRUE(operator_.find<QAbstractButton>("zero_changed").isHidden());
  EXPECT_NE(presenter.flow().view().sentence.find("Strap the hand in"), std::string::npos);
  operator_.press("strapped");
  ASSERT_TRUE(wait_until([&] { return !presenter.flow().view().may_start; }, 5))
      << presenter.flow().view().sentence << " / " << next_words(presenter.state());
  EXPECT_NE(presenter.flow().view().sentence.find("settles"), std::string::npos)
      << presenter.flow().view().sentence;
  operator_.set_zero();  // the hand is out again
  EXPECT_FALSE(presenter.flow().view().may_start) << "and goes in again first";
  operator_.strap_in();
  operator_.run_task();
  EXPECT_EQ(presenter.flow().view().sentence.find("At rest thumb"), 0u)
      << presenter.flow().view().sentence;
}

TEST_F(WholeSession, ASilentSensorPausesTheTrialOnBothScreens) {
  if (QGuiApplication::platformName() != "xcb") GTEST_SKIP() << "needs a display";
  windows_.show_patient_screen();
  auto& presenter = windows_.presenter();
  operator_.prepare_person();
  presenter.choices().choose_device("replay://" + write_recording_with_gap(folder_));
  operator_.press("connect");
  ASSERT_TRUE(wait_until([&] { return presenter.state().session_open(); }));
  EXPECT_TRUE(wait_until([&] { return presenter.flow().view().next() == Step::work; }))
      << "a recording needs no zero, rest or maximum";
  operator_.start_task();
  ASSERT_TRUE(
      wait_until([&] { return presenter.state().snapshot().stage == session::Stage::paused; }));
  EXPECT_TRUE(wait_until(
      [&] { return presenter.patient_view().picture().notice == PatientPicture::Notice::fault; }));
  EXPECT_TRUE(wait_until([&] { return presenter.flow().view().mood == Mood::fault; }))
      << presenter.flow().view().sentence;
  EXPECT_FALSE(operator_.find<QLabel>("sentence").text().isEmpty());
  keep_picture("fault");
}

TEST_F(WholeSession, AZeroWithLostSamplesIsRefusedInWords) {
  auto& presenter = windows_.presenter();
  operator_.prepare_person();
  presenter.choices().choose_device("sim://healthy?seed=7&drop=0.25");
  operator_.press("connect");
  operator_.press("zero");
  ASSERT_TRUE(wait_until([&] {
    return presenter.flow().view().sentence.find("Zero refused") != std::string::npos;
  })) << presenter.flow().view().sentence;
  EXPECT_FALSE(presenter.flow().view().may_start);
}

}  // namespace
}  // namespace isograsp::gui::test::whole_session_test
