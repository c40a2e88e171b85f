// SPDX-License-Identifier: GPL-3.0-or-later
// A therapist's whole session with a tracked hand, in the windows: the same pages as with the
// platform, with the steps, tasks and numbers of a hand.
#include <QTableWidget>
#include <cmath>
#include <map>
#include <numbers>

#include "device/hand/hand_csv.hpp"
#include "gui/presenter/patient_view.hpp"
#include "gui/session_pages/state_light.hpp"
#include "operator.hpp"
#include "short_library.hpp"
#include "storage/access/open_store.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/scripted_hand.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::hand_session_test {
namespace {

using isograsp::test::must;

constexpr const char* kHandUri = "sim://hand?user=healthy&seed=7";

class HandInWindows : public QtTest {
 protected:
  HandInWindows()
      : windows_(GuiConfig{folder_.path("clinic.db"), "", make_hand_library(folder_), "test"}) {
    windows_.show();
  }
  ~HandInWindows() override {
    windows_.presenter().connecting().end_session();
    EXPECT_TRUE(wait_until([&] { return !windows_.presenter().state().busy(); }));
  }

  const SessionState& state() { return windows_.presenter().state(); }
  const FlowView& view() { return windows_.presenter().flow().view(); }
  StepState step(Step which) { return view().steps[static_cast<std::size_t>(which)]; }
  bool is_there(const char* name) { return operator_.find<QWidget>(name).isVisible(); }
  QString label(const char* name) { return operator_.find<QLabel>(name).text(); }
  void connect(const char* hand = "hand_right") {
    operator_.prepare_person(hand);
    operator_.choose_device(kHandUri);
    begin_session();
  }
  void begin_session() {
    operator_.answer_screening();
    operator_.press("connect");
    ASSERT_TRUE(wait_until([&] { return view().may_zero; })) << view().sentence;
  }
  void do_entry_test() {
    operator_.press("entry_test");
    ASSERT_TRUE(wait_until([&] { return !view().may_zero; }));
    ASSERT_TRUE(wait_until([&] { return view().may_zero; })) << view().sentence;
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

TEST_F(HandInWindows, StepsTasksAndQuestionsAreThoseOfATrackedHandBeforeItIsConnected) {
  operator_.prepare_person();
  operator_.choose_device(kHandUri);
  EXPECT_GE(state().library.tasks.size(), 4U);
  for (const auto& task : isograsp::test::every(state().library.tasks))
    EXPECT_EQ(task.apparatus(), kTrackedHand) << task.name;
  EXPECT_EQ(state().chosen_protocol().spec.name, "Hand, short") << "the usual one";
  QStringList names;
  for (int place = 1; place <= static_cast<int>(kStepCount); ++place) {
    auto& head = operator_.find<QPushButton>(qPrintable(QStringLiteral("section_%1").arg(place)));
    if (head.isVisible()) names << head.accessibleName().section(':', 0, 0);
  }
  EXPECT_EQ(names, (QStringList{"Step 1 of 6, Patient", "Step 2 of 6, Hand today",
                                "Step 3 of 6, Screening", "Step 4 of 6, Tracker",
                                "Step 5 of 6, Entry test", "Step 6 of 6, Protocol"}));
  EXPECT_EQ(operator_.find<QPushButton>("page_4").text(), "Tracker");
  EXPECT_EQ(view().next(), Step::screening) << "answers about forces are none about this";
  EXPECT_TRUE(is_there("hand_screening_clear"));
  EXPECT_FALSE(is_there("screening_clear"));
  EXPECT_FALSE(is_there("arm_screening_clear"));
  auto& form = *operator_.find<QWidget>("hand_screening_clear").parentWidget();
  for (const auto* widget : isograsp::test::every(form.findChildren<QWidget*>())) {
    const auto all = widget->property("text").toString() + widget->toolTip();
    for (const char* foreign : {"force", "strap", "sensor", "device", "zero"})
      EXPECT_FALSE(all.contains(foreign, Qt::CaseInsensitive)) << all.toStdString();
  }
  operator_.press("hand_screening_shoulder");
  operator_.press("hand_screening_pain_1");
  EXPECT_FALSE(view().may_connect) << "nobody has decided";
  keep_picture(windows_.therapist(), "hand_screening");
  operator_.press("hand_screening_moves");
  EXPECT_TRUE(wait_until([&] { return view().may_connect; })) << view().sentence;
  keep_picture(windows_.therapist(), "hand_connect");
  for (const char* foreign : {"force", "strap", "sensor", "device"})
    EXPECT_EQ(QString::fromStdString(view().sentence).toLower().indexOf(foreign), -1)
        << view().sentence;
}

TEST_F(HandInWindows, AWholeSessionLeadsThroughTheEntryTestToAStoredPlacement) {
  connect();
  EXPECT_EQ(view().next(), Step::zero) << view().sentence;
  EXPECT_EQ(step(Step::rest), StepState::absent);
  EXPECT_TRUE(is_there("entry_test"));
  EXPECT_FALSE(is_there("zero"));
  EXPECT_FALSE(is_there("start_posture"));
  EXPECT_FALSE(view().may_check);
  EXPECT_FALSE(view().may_start) << "nobody knows how far this hand opens";
  operator_.press("entry_test");
  ASSERT_TRUE(wait_until([&] { return is_there("entry_progress"); }));
  EXPECT_TRUE(label("entry_words").contains("rest")) << label("entry_words").toStdString();
  ASSERT_TRUE(wait_until([&] { return label("entry_words").contains("Opened 1 of 3"); }))
      << label("entry_words").toStdString();
  EXPECT_NE(view().sentence.find("1 of 3"), std::string::npos) << view().sentence;
  keep_picture(windows_.therapist(), "hand_entry_runs");
  ASSERT_TRUE(wait_until([&] { return view().next() == Step::work; })) << view().sentence;
  EXPECT_EQ(step(Step::zero), StepState::done);
  ASSERT_TRUE(state().open->hand);
  const double opening_m = state().open->hand->opening_m;
  EXPECT_GT(opening_m, 0.05);
  const auto widest = QString::number(static_cast<int>(700.0 * opening_m));
  EXPECT_TRUE(label("entry_result").contains(widest + " mm"))
      << label("entry_result").toStdString();

  operator_.press("start");
  ASSERT_TRUE(wait_until([&] { return state().open->hand->grasp.object_there; }))
      << view().sentence << label("message").toStdString();
  ASSERT_TRUE(wait_until([&] { return state().open->hand->grasp.held; }));
  keep_picture(windows_.therapist(), "hand_trial");
  ASSERT_TRUE(wait_until([&] { return state().guide().over(); }, 120)) << view().sentence;
  EXPECT_FALSE(view().next().has_value()) << "every step is done";
  EXPECT_GT(operator_.find<QTableWidget>("score").rowCount(), 0);
  keep_picture(windows_.therapist(), "hand_over");
  operator_.press("effort_3");
  operator_.press("pain_0");
  operator_.press("shoulder_pain_0");
  operator_.press("closing_end");
  ASSERT_TRUE(wait_until([&] { return !state().busy(); }));

  const auto session = stored_session();
  EXPECT_TRUE(session.simulated);
  EXPECT_EQ(session.protocol_name, "Hand, short");
  const auto trials = stored_trials();
  ASSERT_EQ(trials.size(), 1U);
  EXPECT_EQ(trials[0].status, storage::TrialStatus::completed);
  const auto store =
      must(storage::open_store(folder_.path("clinic.db"), storage::OpenMode::read_only));
  std::map<std::string, std::string> answers;
  for (const auto& answer : must(store->answers(session.id)))
    if (answer.topic != "screen") answers[answer.item] = answer.value;
  EXPECT_EQ(answers["shoulder"], "no");
  EXPECT_EQ(answers["forearm_supported"], "yes");
  EXPECT_FALSE(answers.contains("no_clearance")) << "a question about forces";
}

TEST_F(HandInWindows, TheKeyOfTheTherapistLetsTheObjectGoAndThatIsNoDrop) {
  connect("hand_left");
  EXPECT_FALSE(operator_.find<QWidget>("let_go").isEnabled()) << "there is nothing to let go";
  do_entry_test();
  operator_.press("start");
  ASSERT_TRUE(wait_until([&] {
    return state().open->hand->grasp.held && !state().open->hand->grasp.supported;
  })) << view().sentence;
  ASSERT_TRUE(wait_until([&] { return label("digit_state_0") == "tied"; }))
      << label("digit_state_0").toStdString();
  // Tied while it held by itself; a moment later it may not any more.
  EXPECT_TRUE(label("grasp_verdict").contains("✓") ||
              label("grasp_verdict").contains("only the help"))
      << label("grasp_verdict").toStdString();
  EXPECT_TRUE(label("tracker_rate").contains("pictures a second"))
      << label("tracker_rate").toStdString();
  EXPECT_FALSE(is_there("camera_on")) << "nobody is looked at: this hand is simulated";
  keep_picture(windows_.therapist(), "hand_tied");
  const auto picture = [this] { return windows_.presenter().patient_view().picture(0.3); };
  ASSERT_TRUE(wait_until([&] {
    const PatientPicture now = picture();
    return now.page == PatientPicture::Page::hand && now.tracked_hand->object;
  })) << "the person sees what the therapist sees";
  EXPECT_TRUE(picture().tracked_hand->hand.has_value());
  EXPECT_TRUE(picture().simulated);
  operator_.press("let_go");
  ASSERT_TRUE(wait_until([&] { return label("hand_task").contains("let go for the hand"); }))
      << label("hand_task").toStdString();
  EXPECT_FALSE(view().may_let_go) << "once is enough";
  ASSERT_TRUE(wait_until([&] { return state().guide().over(); })) << view().sentence;
  operator_.disconnect();
  const auto trials = stored_trials();
  ASSERT_EQ(trials.size(), 1U);
  EXPECT_EQ(trials[0].status, storage::TrialStatus::completed);
  const auto store =
      must(storage::open_store(folder_.path("clinic.db"), storage::OpenMode::read_only));
  std::map<std::string, double> values;
  for (const auto& measure : must(store->measures(trials[0].id)))
    if (measure.value) values[measure.name] = *measure.value;
  EXPECT_EQ(values.at("releases_helped"), 1.0);
  EXPECT_EQ(values.at("placement_fails"), 0.0);
  int told = 0;
  for (const auto& event : must(store->events(stored_session().id)))
    told += event.kind == "let_go" ? 1 : 0;
  EXPECT_EQ(told, 1);
}

/// What a tracker saw of a hand that opens to 23 mm and no further, for a minute.
std::string hand_that_opens_little(const TemporaryFolder& folder) {
  const std::string path = folder.path("opens_little.csv");
  auto writer = must(HandCsvWriter::create(path));
  const auto hand = isograsp::test::usual_hand();
  constexpr double kRate_Hz = 90.0;
  constexpr double kCycle_s = 3.0;
  for (int k = 0; k < 60 * static_cast<int>(kRate_Hz); ++k) {
    const double t_s = k / kRate_Hz;
    HandFrame frame = isograsp::test::picture_of(hand, isograsp::test::hand_posture(0.5, t_s));
    const double gap_m = 0.015 + 0.008 * std::cos(2.0 * std::numbers::pi * t_s / kCycle_s);
    constexpr std::size_t kTip = 3;
    frame.joints[joint_of(Digit::thumb, kTip)] =
        frame.joints[joint_of(Digit::index, kTip)] + Vec3(gap_m, 0.0, 0.0);
    frame.t_s = t_s;
    writer.write(frame);
  }
  must(writer.commit());
  return path;
}

TEST_F(HandInWindows, ThePatientWatchesAHealthyHandDoTheTaskWithoutATrackerAndNothingIsStored) {
  operator_.prepare_person("hand_left");
  operator_.choose_device(kHandUri);
  windows_.presenter().choices().choose_protocol(std::nullopt);
  const auto picture = [&] { return windows_.presenter().patient_view().picture(0.3); };
  for (const char* kind : {"hand_opening", "virtual_pick_place"}) {
    operator_.choose_task(kind);
    operator_.press("show_how");
    ASSERT_TRUE(wait_until([&] {
      return picture().example && picture().page == PatientPicture::Page::hand;
    })) << kind
        << ": " << label("message").toStdString();
    EXPECT_EQ(picture().detail, "Watch how it is done") << kind;
    EXPECT_FALSE(picture().simulated) << "it is marked as a demonstration, as nothing else";
    EXPECT_TRUE(picture().tracked_hand->hand.has_value()) << kind;
    operator_.press("show_how");
    EXPECT_FALSE(picture().example);
  }
  EXPECT_FALSE(state().session_open());
  const auto store =
      must(storage::open_store(folder_.path("clinic.db"), storage::OpenMode::read_only));
  EXPECT_TRUE(must(store->recent_sessions(1)).empty());
}

TEST_F(HandInWindows, AHandThatOpensTooLittleIsToldWhichTasksAreForItAndMayStillBeMeasured) {
  operator_.prepare_person();
  windows_.presenter().choices().choose_device("replay://" + hand_that_opens_little(folder_));
  EXPECT_TRUE(view().hand_entry) << "a recording of a hand is one";
  begin_session();
  do_entry_test();
  EXPECT_EQ(view().situation, Situation::zero_refused) << view().sentence;
  EXPECT_NE(view().sentence.find("Opening force"), std::string::npos) << view().sentence;
  EXPECT_TRUE(label("entry_result").contains("Open on cue")) << label("entry_result").toStdString();
  EXPECT_NE(step(Step::zero), StepState::done);
  keep_picture(windows_.therapist(), "hand_barred");
  operator_.choose_task("virtual_pick_place");
  EXPECT_FALSE(view().may_start);
  EXPECT_NE(view().start_hint.find("No virtual objects"), std::string::npos) << view().start_hint;
  operator_.choose_task("hand_opening");
  EXPECT_TRUE(view().may_start) << "how far it opens can be measured";
  operator_.start_task();
  operator_.press("stop");
  operator_.finish_task();
  EXPECT_TRUE(view().may_start);
  operator_.choose_task("virtual_pick_place");
  EXPECT_FALSE(view().may_start) << "it is still barred";
  EXPECT_NE(view().sentence.find("Opening force"), std::string::npos) << view().sentence;
}

}  // namespace
}  // namespace isograsp::gui::test::hand_session_test
