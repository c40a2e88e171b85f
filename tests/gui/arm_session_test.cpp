// SPDX-License-Identifier: GPL-3.0-or-later
// A therapist's whole session with an arm seen by cameras, in the windows: the same pages as with
// the platform, with the steps, tasks and pictures of an arm.
#include <QDialog>
#include <QSpinBox>
#include <QTableWidget>
#include <map>
#include <numbers>
#include <sstream>

#include "gui/arm_pages/cameras_dialog.hpp"
#include "gui/session_pages/state_light.hpp"
#include "operator.hpp"
#include "short_library.hpp"
#include "storage/access/open_store.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"
#include "virtual_patient/arm/virtual_arm.hpp"

namespace isograsp::gui::test::arm_session_test {
namespace {

using isograsp::test::must;

constexpr const char* kArmUri = "sim://arm?patient=healthy&seed=7";

class ArmInWindows : public QtTest {
 protected:
  ArmInWindows()
      : windows_(GuiConfig{folder_.path("clinic.db"), "", make_arm_library(folder_), "test"}) {
    windows_.show();
  }
  ~ArmInWindows() override {
    windows_.presenter().connecting().end_session();
    EXPECT_TRUE(wait_until([&] { return !windows_.presenter().state().busy(); }));
  }

  const SessionState& state() { return windows_.presenter().state(); }
  const FlowView& view() { return windows_.presenter().flow().view(); }
  PatientPicture picture() { return windows_.presenter().patient_view().picture(0.3); }
  StepState step(Step which) { return view().steps[static_cast<std::size_t>(which)]; }
  bool is_there(const char* name) { return operator_.find<QWidget>(name).isVisible(); }
  QString label(const char* name) { return operator_.find<QLabel>(name).text(); }
  /// All tasks and protocols that can be chosen are for `apparatus`, and there are some.
  void expect_only(std::string_view apparatus) {
    EXPECT_GT(state().library.tasks.size(), 3U);
    for (const auto& task : isograsp::test::every(state().library.tasks))
      EXPECT_EQ(task.apparatus(), apparatus) << task.name;
    for (const auto& protocol : isograsp::test::every(state().library.protocols))
      EXPECT_EQ(protocol.apparatus(), apparatus) << protocol.spec.name;
  }
  void connect(const char* hand) {
    operator_.prepare_person(hand);
    operator_.choose_device(kArmUri);
    operator_.answer_screening();
    operator_.press("connect");
    ASSERT_TRUE(wait_until([&] { return view().may_zero; })) << view().sentence;
  }
  void take_start_posture() {
    auto& light = operator_.find<StateLight>("posture_light");
    ASSERT_TRUE(wait_until([&] { return light.mood() == Mood::ready; }))
        << label("posture_words").toStdString();
    operator_.press("start_posture");
    ASSERT_TRUE(wait_until([&] { return view().next() == Step::work; })) << view().sentence;
    EXPECT_EQ(step(Step::zero), StepState::done);
  }
  storage::SessionRecord stored_session() {
    const auto store =
        must(storage::open_store(folder_.path("clinic.db"), storage::OpenMode::read_only));
    return must(store->recent_sessions(1)).at(0);
  }
  std::vector<storage::TrialRecord> stored_trials() {
    const auto store =
        must(storage::open_store(folder_.path("clinic.db"), storage::OpenMode::read_only));
    return must(store->trials(must(store->recent_sessions(1)).at(0).id));
  }

  TemporaryFolder folder_;
  Windows windows_;
  Operator operator_{windows_};
};

TEST_F(ArmInWindows, TasksAndProtocolsAreThoseOfWhatIsChosen) {
  ASSERT_TRUE(wait_until([&] { return windows_.clinic().is_open(); }));
  const std::string usual = state().chosen_protocol().spec.name;
  EXPECT_EQ(state().chosen_protocol().apparatus(), kPlatform);
  for (const auto& task : isograsp::test::every(state().library.tasks))
    EXPECT_NE(task.apparatus(), kArm) << "as long as nothing is chosen: " << task.name;
  operator_.prepare_person();
  operator_.choose_device(kArmUri);
  expect_only(kArm);
  EXPECT_EQ(state().chosen_protocol().spec.name, "Arm, short") << "the usual one of an arm";
  operator_.choose_device("sim://healthy?seed=7");
  for (const auto& task : isograsp::test::every(state().library.tasks))
    EXPECT_NE(task.apparatus(), kArm) << task.name;
  EXPECT_EQ(state().chosen_protocol().spec.name, usual);
}

TEST_F(ArmInWindows, OnItsFirstVisitAnArmIsOfferedTheProtocolThatMakesItFamiliarAndNoOther) {
  operator_.prepare_person();
  EXPECT_FALSE(operator_.find<QWidget>("take_first_visit").isVisible()) << "no cameras yet";
  operator_.choose_device(kArmUri);
  operator_.answer_screening();
  ASSERT_TRUE(wait_until([&] { return is_there("take_first_visit"); }));
  EXPECT_TRUE(label("first_visit_words").contains("Arm, first visit"));
  keep_picture(windows_.therapist(), "arm_first_visit");
  EXPECT_EQ(state().chosen_protocol().spec.name, "Arm, short") << "nothing is filled in";
  operator_.press("take_first_visit");
  EXPECT_EQ(state().chosen_protocol().spec.name, "Arm, first visit");
  EXPECT_FALSE(is_there("take_first_visit"));
}

TEST_F(ArmInWindows, AWholeSessionEndsWithItsTrialsInTheDatabase) {
  connect("hand_right");
  expect_only(kArm);
  EXPECT_EQ(view().next(), Step::zero) << view().sentence;
  EXPECT_EQ(step(Step::rest), StepState::absent);
  EXPECT_TRUE(is_there("start_posture"));
  EXPECT_FALSE(is_there("zero")) << "nothing is empty here";
  EXPECT_FALSE(view().may_check);
  EXPECT_FALSE(view().may_start) << "targets are made for the size of this arm";
  EXPECT_TRUE(is_there("arm_views"));
  auto& markers = operator_.find<QTableWidget>("markers");
  EXPECT_TRUE(wait_until([&] { return markers.rowCount() > 15; })) << "segments and markers";
  take_start_posture();
  EXPECT_TRUE(state().snapshot().zeroed);

  operator_.press("start");
  ASSERT_TRUE(wait_until([&] { return picture().page == PatientPicture::Page::range; }))
      << view().sentence;
  ASSERT_TRUE(wait_until([&] { return picture().angle.ranged; }));
  EXPECT_TRUE(wait_until([&] { return label("arm_reached").contains("Turned from"); }));
  // The protocol goes on by itself.
  ASSERT_TRUE(wait_until([&] { return picture().page == PatientPicture::Page::object; }))
      << view().sentence;
  ASSERT_TRUE(wait_until([&] { return picture().target_shown; }));
  EXPECT_TRUE(wait_until([&] { return label("arm_error").contains("15 mm"); }))
      << label("arm_error").toStdString();
  keep_picture(windows_.therapist(), "arm_trial");
  ASSERT_TRUE(wait_until([&] { return picture().matched; }));
  EXPECT_TRUE(wait_until([&] { return label("arm_reached").contains("1 of 2"); }))
      << label("arm_reached").toStdString();
  keep_picture(windows_.therapist(), "arm_matched");
  ASSERT_TRUE(wait_until([&] { return state().guide().over(); })) << view().sentence;
  EXPECT_FALSE(view().next().has_value()) << "every step is done";
  EXPECT_GT(operator_.find<QTableWidget>("score").rowCount(), 0);
  operator_.press("effort_3");
  operator_.press("pain_0");
  const std::string code = state().choices.patient;
  operator_.press("closing_end");
  ASSERT_TRUE(wait_until([&] { return !state().busy(); }));

  const auto session = stored_session();
  EXPECT_TRUE(session.simulated);
  EXPECT_EQ(session.protocol_name, "Arm, short");
  const auto trials = stored_trials();
  ASSERT_EQ(trials.size(), 2U);
  for (const auto& trial : isograsp::test::every(trials)) {
    EXPECT_EQ(trial.status, storage::TrialStatus::completed) << trial.task_name;
    EXPECT_EQ(trial.dropped, 0) << trial.task_name;
  }
  // This arm has been here; the other one has not.
  windows_.presenter().choices().choose_patient(code);
  const auto choose = [&](Hand hand) { windows_.presenter().choices().choose_hand(hand); };
  choose(Hand::left);
  ASSERT_TRUE(wait_until([&] { return state().choices.first_time; }));
  choose(Hand::right);
  ASSERT_TRUE(wait_until([&] { return !state().choices.interrupted.sought; })) << "asked after it";
  EXPECT_FALSE(state().choices.first_time);
}

TEST_F(ArmInWindows, AnArmIsAskedItsOwnQuestionsAndNoneOfItsWordsAreThoseOfThePlatform) {
  operator_.prepare_person();
  operator_.choose_device(kArmUri);
  EXPECT_EQ(view().next(), Step::screening) << "answers about a hand are none about an arm";
  EXPECT_FALSE(view().may_connect);
  EXPECT_TRUE(is_there("arm_screening_clear"));
  EXPECT_FALSE(is_there("screening_clear"));
  auto& form = *operator_.find<QWidget>("arm_screening_clear").parentWidget();
  keep_picture(form, "arm_screening");
  for (const auto* widget : isograsp::test::every(form.findChildren<QWidget*>())) {
    const auto all = widget->property("text").toString() + widget->toolTip();
    EXPECT_FALSE(all.contains("maxim", Qt::CaseInsensitive)) << all.toStdString();
    EXPECT_FALSE(all.contains("device", Qt::CaseInsensitive)) << all.toStdString();
  }
  operator_.press("arm_screening_shoulder");
  operator_.press("arm_screening_pain_2");
  EXPECT_FALSE(operator_.find<QAbstractButton>("arm_screening_allow_maximum").isEnabled())
      << "it neither turns nor holds";
  operator_.press("arm_screening_turns_10_deg");
  operator_.press("arm_screening_holds_10_s");
  operator_.press("passive_forearm");
  EXPECT_FALSE(operator_.find<QAbstractButton>("arm_screening_allow_comfortable").isEnabled())
      << "no range is filled in beforehand";
  operator_.find<QSpinBox>("passive_forearm_positive").setValue(30);
  keep_picture(form, "arm_screening_filled");
  EXPECT_FALSE(view().may_connect) << "nobody has decided";
  operator_.press("arm_screening_allow_comfortable");
  EXPECT_TRUE(wait_until([&] { return view().may_connect; })) << view().sentence;
  operator_.press("connect");
  ASSERT_TRUE(wait_until([&] { return view().may_zero; })) << view().sentence;
  take_start_posture();
  EXPECT_EQ(stored_session().allowed, "comfortable");
  const auto store =
      must(storage::open_store(folder_.path("clinic.db"), storage::OpenMode::read_only));
  std::map<std::string, std::string> answers;
  for (const auto& answer : must(store->answers(stored_session().id)))
    if (answer.topic == "screening") answers[answer.item] = answer.value;
  EXPECT_EQ(answers["shoulder"], "yes");
  EXPECT_EQ(answers["contracture"], "no");
  EXPECT_EQ(answers["tape_allergy"], "no");
  EXPECT_EQ(answers["pain"], "2");
  EXPECT_EQ(answers["passive_forearm_a3_most_deg"], "30");
  EXPECT_FALSE(answers.contains("injury")) << "a question of the platform";
}

TEST_F(ArmInWindows, ThePatientWatchesAHealthyArmDoTheTaskWithoutADeviceAndNothingIsStored) {
  operator_.prepare_person("hand_left");
  operator_.choose_device(kArmUri);
  windows_.presenter().choices().choose_protocol(std::nullopt);
  for (const auto& [kind, page] : {std::pair{"pose_matching", PatientPicture::Page::object},
                                   std::pair{"pose_following", PatientPicture::Page::object},
                                   std::pair{"active_range", PatientPicture::Page::range}}) {
    operator_.choose_task(kind);
    operator_.press("show_how");
    ASSERT_TRUE(wait_until([&] { return picture().example && picture().page == page; }))
        << kind << ": " << label("message").toStdString();
    EXPECT_EQ(picture().detail, "Watch how it is done");
    EXPECT_FALSE(picture().simulated) << "it is marked as a demonstration, as nothing else";
    if (page == PatientPicture::Page::object) {
      EXPECT_TRUE(picture().in_space);
      EXPECT_TRUE(wait_until([&] { return picture().target_shown; })) << kind;
    } else {
      EXPECT_TRUE(wait_until([&] { return picture().angle.ranged; })) << kind;
    }
    operator_.press("show_how");
    EXPECT_FALSE(picture().example);
  }
  operator_.choose_task("drinking");
  EXPECT_FALSE(is_there("show_how"));
  EXPECT_TRUE(is_there("not_shown"));
  EXPECT_TRUE(label("not_shown").contains("yourself")) << label("not_shown").toStdString();
  EXPECT_FALSE(state().session_open());
  const auto store =
      must(storage::open_store(folder_.path("clinic.db"), storage::OpenMode::read_only));
  EXPECT_TRUE(must(store->recent_sessions(1)).empty());
}

TEST_F(ArmInWindows, StepsAreNumberedWithoutAGapAndNamedAsWhatMeasuresThem) {
  const auto steps = [&] {
    QStringList names;
    for (int place = 1; place <= static_cast<int>(kStepCount); ++place) {
      auto& head = operator_.find<QPushButton>(qPrintable(QStringLiteral("section_%1").arg(place)));
      if (!head.isVisible()) continue;
      names << head.accessibleName().section(':', 0, 0);
      EXPECT_EQ(head.shortcut(), QKeySequence(Qt::ALT | (Qt::Key_0 + names.size())));
    }
    return names;
  };
  operator_.add_patient();
  windows_.therapist().show_page(TherapistWindow::Page::session);
  EXPECT_EQ(steps(), (QStringList{"Step 1 of 7, Patient", "Step 2 of 7, Hand today",
                                  "Step 3 of 7, Screening", "Step 4 of 7, Device or cameras",
                                  "Step 5 of 7, Zero or start posture", "Step 6 of 7, Hand in",
                                  "Step 7 of 7, Protocol"}));
  operator_.choose_device(kArmUri);
  EXPECT_EQ(steps(), (QStringList{"Step 1 of 6, Patient", "Step 2 of 6, Arm today",
                                  "Step 3 of 6, Screening", "Step 4 of 6, Cameras",
                                  "Step 5 of 6, Start posture", "Step 6 of 6, Protocol"}));
  EXPECT_EQ(operator_.find<QPushButton>("hand_left").text(), "&Left arm");
  EXPECT_EQ(operator_.find<QPushButton>("page_4").text(), "Cameras");
  EXPECT_EQ(operator_.find<QPushButton>("page_4").shortcut(), QKeySequence("Ctrl+4"));
  operator_.choose_device("sim://healthy?seed=7");
  EXPECT_EQ(steps(), (QStringList{"Step 1 of 7, Patient", "Step 2 of 7, Hand today",
                                  "Step 3 of 7, Screening", "Step 4 of 7, Device",
                                  "Step 5 of 7, Zero, empty", "Step 6 of 7, Hand in",
                                  "Step 7 of 7, Protocol"}));
}

TEST_F(ArmInWindows, ALeftArmIsPausedGoesOnAndIsStoppedAsOnThePlatform) {
  connect("hand_left");
  EXPECT_TRUE(wait_until([&] { return is_there("arm_remark"); })) << "its targets are mirrored";
  take_start_posture();
  operator_.press("by_hand");
  operator_.choose_task("pose_matching");
  windows_.presenter().tasks().set_practice(true);
  operator_.start_task();
  ASSERT_TRUE(wait_until([&] { return picture().target_shown; }));
  EXPECT_TRUE(wait_until([&] { return is_there("arm_practice"); })) << "it is practice";
  keep_picture(windows_.therapist(), "arm_practice");
  EXPECT_TRUE(label("arm_practice").contains("of 15:00")) << label("arm_practice").toStdString();
  operator_.press("pause");
  ASSERT_TRUE(wait_until([&] { return picture().notice == PatientPicture::Notice::pause; }));
  operator_.press("pause");  // now Resume
  ASSERT_TRUE(wait_until([&] { return picture().targets_reached == 1; })) << view().sentence;
  operator_.press("stop");
  operator_.finish_task();
  operator_.disconnect();
  EXPECT_EQ(stored_session().hand, Hand::left);
  const auto trials = stored_trials();
  ASSERT_EQ(trials.size(), 1U);
  EXPECT_EQ(trials[0].status, storage::TrialStatus::aborted);
}

/// What cameras saw of an arm at rest for a minute.
std::string still_arm(const TemporaryFolder& folder) {
  virtual_patient::ArmTraits traits = virtual_patient::arm_traits("healthy").value();
  traits.loss_per_s = 0.0;
  traits.view_rad = std::numbers::pi;
  virtual_patient::VirtualArm arm(traits, 5, Hand::right);
  std::vector<Vec3> p_W(arm.labels().size());
  std::ostringstream text;
  text << "t_s";
  for (const auto& label : arm.labels())
    for (const char* axis : {"_x_m", "_y_m", "_z_m"}) text << ',' << label << axis;
  constexpr int kFrames = 6000;
  constexpr double kPeriod_s = 0.01;
  for (int k = 0; k < kFrames; ++k) {
    arm.markers(kPeriod_s * k, p_W);
    text << '\n' << kPeriod_s * k;
    for (const Vec3& p : p_W) text << ',' << p.x() << ',' << p.y() << ',' << p.z();
  }
  text << '\n';
  return folder.write("still.csv", text.str());
}

TEST_F(ArmInWindows, ARecordingOfMarkersIsPreparedAndMeasuredAsAnArm) {
  operator_.prepare_person();
  windows_.presenter().choices().choose_device("replay://" + still_arm(folder_) +
                                               "?rig=kurillo15_trunk");
  operator_.answer_screening();
  operator_.press("connect");
  ASSERT_TRUE(wait_until([&] { return view().may_zero; })) << view().sentence;
  EXPECT_TRUE(state().recorded());
  EXPECT_FALSE(view().may_start) << "a recorded arm has a size, too";
  take_start_posture();
  operator_.choose_task("active_range");
  operator_.start_task();
  windows_.therapist().show_page(TherapistWindow::Page::device);
  EXPECT_TRUE(wait_until([&] { return label("camera_counters").contains("Lost: 0"); }))
      << label("camera_counters").toStdString();
  keep_picture(windows_.therapist(), "arm_device");
  EXPECT_FALSE(is_there("sensor_counters"));
  int titles = 0;
  for (const auto* title : windows_.therapist().findChildren<QLabel*>()) {
    EXPECT_FALSE(title->isVisible() && title->text() == "What the sensors counted");
    titles += title->isVisible() && title->text() == "What the cameras counted" ? 1 : 0;
  }
  EXPECT_EQ(titles, 1);
  windows_.therapist().show_page(TherapistWindow::Page::session);
  operator_.finish_task();
  operator_.disconnect();
  EXPECT_FALSE(stored_session().simulated);
  const auto trials = stored_trials();
  ASSERT_EQ(trials.size(), 1U);
  EXPECT_EQ(trials[0].status, storage::TrialStatus::completed);
}

TEST_F(ArmInWindows, CamerasAreAskedForAndBecomeAUri) {
  CamerasDialog dialog(ISOGRASP_SOURCE_DIR "/library");
  EXPECT_TRUE(dialog.uri().empty()) << "no address";
  EXPECT_FALSE(widget_called<QAbstractButton>("cameras_accept", dialog).isEnabled());
  widget_called<QLineEdit>("cameras_where", dialog).setText("192.168.0.7");
  EXPECT_EQ(dialog.uri(), "qtm://192.168.0.7?rig=kurillo15");
  widget_called<QComboBox>("cameras_source", dialog).setCurrentIndex(1);
  widget_called<QLineEdit>("cameras_where", dialog).setText("10.0.0.2");
  EXPECT_EQ(dialog.uri(), "natnet://10.0.0.2?rig=kurillo15");
  widget_called<QComboBox>("cameras_source", dialog).setCurrentIndex(2);
  EXPECT_TRUE(dialog.uri().empty()) << "another system is somewhere else";
  widget_called<QLineEdit>("cameras_where", dialog).setText("/tmp/a b?.c3d");
  const auto uri = must(Uri::parse(dialog.uri()));
  EXPECT_EQ(uri.scheme, "replay");
  EXPECT_EQ(uri.target, "/tmp/a b?.c3d");
  EXPECT_EQ(session::kind_of_apparatus(dialog.uri()), kArm);
  EXPECT_TRUE(widget_called<QAbstractButton>("cameras_accept", dialog).isEnabled());
  dialog.show();
  keep_picture(dialog, "arm_cameras");
}

TEST_F(ArmInWindows, CamerasThatDoNotAnswerAreRefusedInWordsAndNothingIsStored) {
  operator_.prepare_person();
  windows_.presenter().choices().choose_device("replay:///nowhere/arm.c3d?rig=kurillo15");
  expect_only(kArm);
  operator_.answer_screening();
  operator_.press("connect");
  ASSERT_TRUE(wait_until([&] { return view().situation == Situation::session_failed; }))
      << view().sentence;
  EXPECT_NE(view().sentence.find("arm.c3d"), std::string::npos) << view().sentence;
  EXPECT_FALSE(state().session_open());
}

}  // namespace
}  // namespace isograsp::gui::test::arm_session_test
