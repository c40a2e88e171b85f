// SPDX-License-Identifier: GPL-3.0-or-later
// A therapist's whole session with both hands, each on a platform, in the windows: chosen, asked,
// zeroed and put in together, free at once, and a fault of one platform that is nobody's failure.
#include <QLabel>
#include <QListWidget>
#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <map>
#include <memory>

#include "gui/presenter/patient_view.hpp"
#include "operator.hpp"
#include "session/open_two_platforms.hpp"
#include "session/two_platforms/two_platforms.hpp"
#include "short_library.hpp"
#include "spoken.hpp"
#include "storage/access/open_store.hpp"
#include "tests/support/every.hpp"
#include "tests/support/every_language.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::two_hands_session_test {
namespace {

using isograsp::test::every;
using isograsp::test::must;

constexpr const char* kPair = "sim://pair?file=paretic_left&seed=7";

class BothInWindows : public QtTest {
 protected:
  explicit BothInWindows(const std::function<void(GuiConfig&)>& change = [](GuiConfig&) {})
      : windows_([&] {
          auto config = settling_soon(
              {folder_.path("clinic.db"), "", make_two_hands_library(folder_), "test"});
          change(config);
          return config;
        }()) {
    windows_.therapist().resize(1280, 720);
    windows_.show();
  }
  ~BothInWindows() override {
    windows_.presenter().connecting().end_session();
    EXPECT_TRUE(wait_until([&] { return !windows_.presenter().state().busy(); }));
  }

  const SessionState& state() { return windows_.presenter().state(); }
  const FlowView& view() { return windows_.presenter().flow().view(); }
  bool is_there(const char* name) { return operator_.find<QWidget>(name).isVisible(); }
  QString label(const char* name) { return operator_.find<QLabel>(name).text(); }
  PatientPicture picture() { return windows_.presenter().patient_view().picture(0.3); }
  /// Who is chosen has an affected left side.
  void say_affected_left() {
    windows_.therapist().show_page(TherapistWindow::Page::patient);
    auto& left = operator_.find<QAbstractButton>("affected_left");
    ASSERT_TRUE(wait_until([&] { return left.isEnabled(); }));
    left.click();
    windows_.therapist().show_page(TherapistWindow::Page::session);
    ASSERT_TRUE(wait_until([&] {
      const auto store = stored();
      return must(store->profile(must(store->patients()).at(0).id)).affected == storage::Side::left;
    }));
  }
  std::unique_ptr<storage::SessionStore> stored() {
    return must(storage::open_store(folder_.path("clinic.db"), storage::OpenMode::read_only));
  }

  TemporaryFolder folder_;
  Windows windows_;
  Operator operator_{windows_};
};

TEST_F(BothInWindows, StepsTasksAndPlatformsAreThoseOfBothHandsOnceTheyAreChosen) {
  operator_.add_patient();
  EXPECT_FALSE(is_there("platforms_left"));
  operator_.press("hand_both");
  EXPECT_GE(state().library.tasks.size(), 9U);
  for (const auto& task : every(state().library.tasks))
    EXPECT_EQ(task.apparatus(), kTwoPlatforms) << task.name;
  EXPECT_EQ(state().chosen_protocol().spec.name, "Two hands, short") << "the usual one";
  EXPECT_EQ(view().next(), Step::screening) << view().sentence;
  EXPECT_TRUE(is_there("left_screening_clear"));
  EXPECT_FALSE(is_there("right_screening_clear")) << "one hand after the other";
  EXPECT_FALSE(is_there("screening_clear"));
  keep_picture(windows_.therapist(), "both_screening_left");
  operator_.press("left_screening_skin_or_sensation");
  operator_.press("left_screening_pain_2");
  operator_.press("left_screening_limited");
  operator_.press("left_screening_allow_comfortable");
  EXPECT_TRUE(wait_until([&] { return is_there("right_screening_clear"); }));
  EXPECT_FALSE(view().may_connect) << "the right hand was not asked";
  keep_picture(windows_.therapist(), "both_screening_right");
  operator_.press("right_screening_clear");
  EXPECT_TRUE(label("both_screening_outcome").contains("comfortable force only"))
      << label("both_screening_outcome").toStdString();
  EXPECT_EQ(view().situation, Situation::choose_device);
  EXPECT_TRUE(is_there("platforms_left"));
  EXPECT_TRUE(is_there("platforms_right"));
  EXPECT_FALSE(is_there("devices"));
  keep_picture(windows_.therapist(), "both_platforms");
  operator_.choose_platform("platforms_right", kPair);
  EXPECT_EQ(state().choices.platforms.left, kPair) << "a person in software has two hands";
  EXPECT_EQ(state().choices.device_uri, must(session::two_platforms_uri({kPair, kPair})));
  EXPECT_TRUE(state().simulated());
  EXPECT_TRUE(wait_until([&] { return view().may_connect; })) << view().sentence;
  windows_.presenter().choices().choose_platform(Hand::left, "can://can0?protocol=rft");
  EXPECT_EQ(state().choices.platforms.right, "") << "nobody is half simulated";
  EXPECT_FALSE(view().may_connect);
  windows_.presenter().choices().choose_platform(Hand::right, "can://can0?protocol=rft");
  EXPECT_NE(view().sentence.find("both hands are given one platform"), std::string::npos)
      << view().sentence;
  EXPECT_FALSE(view().may_connect);
  operator_.open_section(Step::hand);
  operator_.press("hand_left");
  EXPECT_EQ(state().choices.device_uri, "") << "one hand has another device";
  EXPECT_FALSE(is_there("platforms_left"));
  for (const auto& task : every(state().library.tasks))
    EXPECT_NE(task.apparatus(), kTwoPlatforms) << task.name;
}

TEST_F(BothInWindows, NothingBeginsBeforeTheStopIsTestedSomebodyStaysAndTheHandsAreIn) {
  operator_.prepare_both(kPair);
  EXPECT_EQ(view().situation, Situation::test_stop) << view().sentence;
  EXPECT_EQ(view().next(), Step::rest);
  EXPECT_FALSE(view().may_start || view().may_begin || view().may_strap || view().may_repeat);
  EXPECT_FALSE(operator_.find<QAbstractButton>("within_reach").isEnabled());
  EXPECT_TRUE(label("supports_words").contains("unstrapped"));
  keep_picture(windows_.therapist(), "both_stop_test");
  windows_.presenter().trials().start();
  windows_.presenter().preparing().mark_strapped();
  windows_.presenter().preparing().stay_within_reach(true);
  EXPECT_EQ(view().situation, Situation::test_stop) << "no other way leads past it";
  QTest::keyClick(&windows_.therapist(), Qt::Key_F9);  // what the pedal sends
  EXPECT_EQ(view().situation, Situation::promise_reach) << view().sentence;
  EXPECT_EQ(view().press, NextPress::reach);
  EXPECT_FALSE(view().may_start || view().may_strap);
  operator_.press("within_reach");
  EXPECT_EQ(view().situation, Situation::strap_in) << view().sentence;
  EXPECT_FALSE(view().may_start);
  operator_.press("other_strapped");
  keep_picture(windows_.therapist(), "both_go_in");
  operator_.press("strapped");
  ASSERT_TRUE(wait_until([&] { return view().may_begin; })) << view().sentence;
  operator_.run_task();
  EXPECT_TRUE(QString::fromStdString(english(state().rest_words())).startsWith("At rest left"))
      << english(state().rest_words());
  operator_.set_zero();
  EXPECT_EQ(view().situation, Situation::strap_again)
      << "the hands are out; stop and reach hold for the session: " << view().sentence;
  EXPECT_FALSE(view().may_start || view().may_repeat);
  operator_.press("strapped");
  EXPECT_TRUE(wait_until([&] { return view().may_begin; })) << view().sentence;
  operator_.disconnect();
  const auto store = stored();
  const auto session = must(store->recent_sessions(1)).at(0);
  std::map<std::string, std::string> said;
  for (const auto& answer : must(store->answers(session.id)))
    said[answer.topic + " " + answer.item] = answer.value;
  EXPECT_EQ(said["safety stop_tested"], "yes");
  EXPECT_EQ(said["safety within_reach"], "yes");
  EXPECT_EQ(said["safety less_affected_hand_strapped"], "yes");
  EXPECT_EQ(said["crosstalk outcome"], "skipped");
  EXPECT_EQ(said["screening left_pain"], "0");
  EXPECT_EQ(said["screening right_allowed"], "maximum");
  const auto events = must(store->events(session.id));
  EXPECT_TRUE(std::any_of(events.begin(), events.end(), [](const auto& event) {
    return event.text == "The stop was pressed as a test.";
  }));
  EXPECT_FALSE(state().choices.today.both) << "asked anew in the next session";
}

TEST_F(BothInWindows, EachHandHasItsOwnPostureWhichIsOfferedToThatHandNextTime) {
  operator_.prepare_both(kPair);
  operator_.press("posture_edit");
  const auto choose = [&](const char* name, const char* value) {
    auto& box = operator_.find<QComboBox>(name);
    const int row = box.findData(QString(value));
    ASSERT_GE(row, 0) << name;
    box.setCurrentIndex(row);
    Q_EMIT box.activated(row);
  };
  choose("posture_seat", "wheelchair");
  choose("posture_elbow_deg", "90");
  auto& straps = operator_.find<QLineEdit>("posture_straps");
  straps.setFocus();
  straps.setText("3, 4, 4");  // not finished: it is of the left hand nevertheless
  operator_.press("posture_of_right");
  EXPECT_EQ(straps.text(), "") << "of the right hand nothing was said";
  EXPECT_EQ(operator_.find<QComboBox>("posture_seat").currentData().toString(), "wheelchair");
  EXPECT_EQ(operator_.find<QComboBox>("posture_elbow_deg").accessibleName(), "Elbow, right hand");
  choose("posture_elbow_deg", "110");
  choose("posture_wrist", "flexed");
  const QString said = label("posture");
  EXPECT_TRUE(said.contains("Left hand, now: wheelchair, elbow 90°")) << said.toStdString();
  EXPECT_TRUE(said.contains("Right hand, now: elbow 110°, wrist flexed")) << said.toStdString();
  keep_picture(windows_.therapist(), "both_postures");
  operator_.put_both_in();
  operator_.disconnect();
  std::map<std::string, std::string> stored_as;
  for (const auto& answer : must(stored()->answers(must(stored()->recent_sessions(1)).at(0).id)))
    if (answer.topic == "posture" && answer.item != "donning_time_s")
      stored_as[answer.item] = answer.value;
  EXPECT_EQ(stored_as, (std::map<std::string, std::string>{{"seat", "wheelchair"},
                                                           {"left_elbow_deg", "90"},
                                                           {"left_straps", "3, 4, 4"},
                                                           {"right_elbow_deg", "110"},
                                                           {"right_wrist", "flexed"}}));
  operator_.press("hand_left");
  auto& seating = windows_.presenter().seating();
  EXPECT_FALSE(seating.posture(Hand::left).said()) << "that was beside the other hand";
  operator_.open_section(Step::hand);
  operator_.press("hand_both");
  ASSERT_TRUE(wait_until([&] { return seating.posture(Hand::left).said(); }));
  EXPECT_EQ(seating.posture(Hand::left).of(PostureItem::elbow), "90");
  EXPECT_EQ(seating.posture(Hand::right).of(PostureItem::elbow), "110");
  EXPECT_EQ(seating.posture(Hand::right).of(PostureItem::seat), "wheelchair");
  EXPECT_EQ(seating.posture(Hand::right).of(PostureItem::straps), "") << "the left hand's";
  EXPECT_TRUE(operator_.find<QAbstractButton>("strapped").text().contains("as last time"));
  SittingPosture other = seating.posture(Hand::right);
  other.of(PostureItem::elbow) = "70";
  seating.say_posture(Hand::right, other);
  EXPECT_EQ(label("posture_deviations"),
            "Right hand, not as last time: Elbow: 70° instead of 110°.");
  EXPECT_TRUE(label("posture").contains("Left hand, as last time"));
}

TEST_F(BothInWindows, AWholeSessionGoesFromBothZerosThroughRestAndMaximaToOneForceTogether) {
  operator_.add_patient();
  ASSERT_NO_FATAL_FAILURE(say_affected_left());
  operator_.press("hand_both");
  operator_.press("left_screening_clear");
  operator_.press("right_screening_clear");
  operator_.choose_platform("platforms_left", kPair);
  operator_.press("connect");
  ASSERT_TRUE(wait_until([&] { return view().situation == Situation::zero_missing; }))
      << view().sentence;
  keep_picture(windows_.therapist(), "both_zero");
  operator_.press("zero");
  ASSERT_TRUE(wait_until([&] { return view().situation == Situation::check_platforms; }))
      << view().sentence;
  EXPECT_EQ(view().next(), Step::zero);
  EXPECT_FALSE(view().may_start || view().may_strap || view().may_test_stop);
  operator_.press("crosstalk_check");
  EXPECT_TRUE(label("crosstalk_words").contains("left platform"));
  keep_picture(windows_.therapist(), "both_crosstalk");
  operator_.press("crosstalk_check");  // stops: nobody presses the platforms of software
  operator_.press("crosstalk_skip");
  ASSERT_TRUE(wait_until([&] { return view().situation == Situation::test_stop; }))
      << view().sentence;
  EXPECT_EQ(picture().headline, "Relax both hands");
  operator_.put_both_in();
  // Nobody presses Start: the resting force follows when the hands have settled.
  ASSERT_TRUE(wait_until([&] { return picture().page == PatientPicture::Page::two_hands; }))
      << view().sentence;
  EXPECT_EQ(picture().headline, "Let both hands rest");
  ASSERT_TRUE(wait_until([&] { return picture().headline.find("Squeeze") == 0; }, 60))
      << view().sentence << label("message").toStdString();
  ASSERT_TRUE(wait_until([&] { return picture().two_hands && picture().two_hands->sum; }, 60))
      << view().sentence << label("message").toStdString();
  ASSERT_TRUE(wait_until([&] { return label("hands_share").contains("of effort"); }))
      << label("hands_share").toStdString();
  EXPECT_TRUE(label("hands_share").contains("(left)"));
  EXPECT_TRUE(label("health_left").startsWith("Left platform"));
  EXPECT_TRUE(label("health_right").startsWith("Right platform"));
  keep_picture(windows_.therapist(), "both_tracking");
  ASSERT_TRUE(wait_until([&] { return state().guide().over(); }, 120)) << view().sentence;
  keep_picture(windows_.therapist(), "both_over");
  operator_.disconnect();
  const auto store = stored();
  const auto session = must(store->recent_sessions(1)).at(0);
  EXPECT_FALSE(session.hand) << "both";
  EXPECT_TRUE(session.simulated);
  EXPECT_EQ(session.allowed, "maximum");
  const auto trials = must(store->trials(session.id));
  ASSERT_EQ(trials.size(), 3U);
  for (const auto& trial : every(trials))
    EXPECT_EQ(trial.status, storage::TrialStatus::completed) << trial.task_name;
  const auto measures = must(store->measures(trials[2].id));
  EXPECT_TRUE(std::any_of(measures.begin(), measures.end(), [](const auto& measure) {
    return measure.name == "share_affected" && measure.value;
  }));
}

TEST_F(BothInWindows, ASecondPedalIsTheClutchOfBothHandsAndDoesNothingToBubbles) {
  operator_.prepare_both(kPair);
  operator_.put_both_in();
  const auto carried = [&]() -> const std::optional<CarryPicture>& {
    static const std::optional<CarryPicture> kNone;
    static PatientPicture seen;
    seen = picture();
    return seen.two_hands ? seen.two_hands->carry : kNone;
  };
  ASSERT_TRUE(wait_until([&] { return view().may_begin; })) << view().sentence;
  for (const char* first : {"bilateral_rest", "bilateral_maximum"}) {
    operator_.choose_task(first);
    operator_.run_task();
  }
  for (const bool clutch : {true, false}) {
    operator_.choose_task("bimanual_pick_place",
                          clutch ? "Two hands, carry: clutch" : "Two hands, carry: bubbles");
    operator_.start_task();
    ASSERT_TRUE(wait_until([&] { return carried() && carried()->target_shown; }, 20));
    QTest::keyPress(&windows_.therapist(), Qt::Key_F6);
    if (clutch) {
      EXPECT_TRUE(wait_until([&] { return carried() && carried()->clutch; }));
      EXPECT_EQ(picture().headline, "Your hands stay where they are");
      // The person in software has a foot of its own, which is never down for so long.
      EXPECT_FALSE(wait_until([&] { return !carried() || !carried()->clutch; }, 2));
    } else {
      EXPECT_FALSE(wait_until([&] { return carried() && carried()->clutch; }, 1));
    }
    QTest::keyRelease(&windows_.therapist(), Qt::Key_F6);
    EXPECT_TRUE(wait_until([&] { return carried() && !carried()->clutch; }));
    windows_.presenter().trials().stop();
    ASSERT_TRUE(wait_until([&] { return view().may_choose_task; })) << view().sentence;
  }
}

TEST_F(BothInWindows, EveryPageHoldsItsWordsInEveryLanguage) {
  for (const std::string language : every(isograsp::test::every_language())) {
    const Spoken spoken(language.c_str());
    TemporaryFolder folder;
    auto config =
        settling_soon({folder.path("clinic.db"), "", make_two_hands_library(folder), "test"});
    config.settings = folder.write("isograsp.ini", "[General]\nlanguage=" + language);
    Windows windows(config);
    windows.therapist().resize(1280, 720);
    windows.show();
    const Operator therapist(windows);
    const auto keep = [&](const char* name) {
      keep_picture(windows.therapist(), QString("both_%1_%2").arg(language.c_str(), name));
    };
    therapist.add_patient();
    therapist.press("hand_both");
    keep("1_screening");
    therapist.press("left_screening_pain_2");
    therapist.press("left_screening_allow_comfortable");
    keep("2_screening_right");
    therapist.press("right_screening_clear");
    therapist.choose_platform("platforms_left", kPair);
    keep("3_platforms");
    therapist.press("connect");
    ASSERT_TRUE(wait_until([&] { return windows.presenter().flow().view().may_zero; }));
    therapist.press("zero");
    keep("4_zero");
    const auto& view = windows.presenter().flow().view();
    ASSERT_TRUE(wait_until([&] { return view.situation == Situation::check_platforms; }));
    keep("5_crosstalk");
    therapist.press("crosstalk_skip");
    ASSERT_TRUE(wait_until([&] { return view.situation == Situation::test_stop; }));
    keep("5_stop");
    QTest::keyClick(&windows.therapist(), Qt::Key_F10);
    therapist.press("within_reach");
    keep("6_in");
    therapist.press("posture_edit");
    keep("6_postures");
    windows.therapist().show_page(TherapistWindow::Page::device);
    keep("7_device");
    windows.presenter().connecting().end_session();
    ASSERT_TRUE(wait_until([&] { return !windows.presenter().state().busy(); }));
  }
}

/// Hands that press next to nothing, and platforms one of which falls silent.
struct Still final : FingerSource {
  void see(const Stimulus&) noexcept override {}
  [[nodiscard]] FingerWrenches press(double) noexcept override { return {}; }
};
Still still_hands;
std::atomic<int> silent_hand{-1};  // 0 left, 1 right

class Breakable final : public ForceDevice {
 public:
  Breakable(std::unique_ptr<ForceDevice> of, Hand hand) : of_(std::move(of)), hand_(hand) {}
  [[nodiscard]] const DeviceInfo& info() const noexcept override { return of_->info(); }
  [[nodiscard]] DeviceHealth health() const noexcept override {
    DeviceHealth health = of_->health();
    if (!silent()) return health;
    health.state = DeviceState::faulted;
    health.fault = DeviceFault::silence;
    health.finger = Finger::index;
    return health;
  }
  [[nodiscard]] Result<void> start(Clock& clock) override { return of_->start(clock); }
  [[nodiscard]] ReadStatus read(Timestamp deadline, SensorSample& out) noexcept override {
    const ReadStatus status = of_->read(deadline, out);
    if (silent()) out.valid = false;
    return status;
  }
  [[nodiscard]] Timestamp now(const Clock& clock) const noexcept override {
    return of_->now(clock);
  }
  void stop() noexcept override { of_->stop(); }

 private:
  [[nodiscard]] bool silent() const noexcept {
    return silent_hand == (hand_ == Hand::left ? 0 : 1);
  }
  std::unique_ptr<ForceDevice> of_;
  Hand hand_;
};

Result<std::unique_ptr<session::Apparatus>> open_breakable(const session::ApparatusRequest&) {
  session::TwoPlatforms::Devices devices;
  for (const Hand hand : kBothHands) {
    DeviceOptions options;
    options.source = &still_hands;
    auto device = open_device("sim://healthy?seed=7", options);
    if (!device) return device.error();
    devices[hand] = std::make_unique<Breakable>(*std::move(device), hand);
  }
  return std::unique_ptr<session::Apparatus>(
      std::make_unique<session::TwoPlatforms>(std::move(devices), nullptr, std::nullopt));
}
constexpr std::array<session::ApparatusRow, 1> kBreakable{
    {{"", "", "", open_breakable, session::TwoPlatforms::kKind}}};

class BreakableInWindows : public BothInWindows {
 protected:
  BreakableInWindows() : BothInWindows([](GuiConfig& config) { config.apparatuses = kBreakable; }) {
    silent_hand = -1;
  }
};

TEST_F(BreakableInWindows, AFaultOfOnePlatformPausesBothSaysWhoseAndIsNobodysFailure) {
  operator_.prepare_both(kPair);
  operator_.put_both_in();
  ASSERT_TRUE(wait_until([&] { return view().may_begin; })) << view().sentence;
  for (const Hand hand : every(kBothHands)) {
    const std::string whose = hand == Hand::left ? "Left platform: " : "Right platform: ";
    operator_.start_task();
    silent_hand = hand == Hand::left ? 0 : 1;
    ASSERT_TRUE(wait_until([&] { return state().snapshot().stage == session::Stage::paused; }));
    ASSERT_TRUE(wait_until([&] { return view().mood == Mood::fault; }));
    EXPECT_EQ(view().sentence.find(whose), 0U) << view().sentence;
    EXPECT_EQ(view().device_words.find(whose), 0U) << view().device_words;
    EXPECT_FALSE(view().may_resume);
    EXPECT_EQ(picture().notice, PatientPicture::Notice::fault);
    EXPECT_EQ(picture().notice_words,
              "The device needs help. You did nothing wrong. Relax both hands.");
    windows_.therapist().show_page(TherapistWindow::Page::device);
    const auto& faults = operator_.find<QListWidget>("device_faults");
    ASSERT_GE(faults.count(), 1);
    EXPECT_TRUE(
        faults.item(0)->text().contains(hand == Hand::left ? "left platform" : "right platform"))
        << faults.item(0)->text().toStdString();
    keep_picture(windows_.therapist(), QString("both_fault_%1").arg(hand == Hand::left ? 1 : 2));
    windows_.therapist().show_page(TherapistWindow::Page::session);
    silent_hand = -1;
    ASSERT_TRUE(wait_until([&] { return view().may_resume; })) << view().sentence;
    operator_.press("pause");  // now Resume
    operator_.finish_task();
    EXPECT_EQ(state().traces().last_trial->trial.status, storage::TrialStatus::completed);
    operator_.choose_task("bilateral_rest");
  }
}

}  // namespace
}  // namespace isograsp::gui::test::two_hands_session_test
