// SPDX-License-Identifier: GPL-3.0-or-later
// Faults during a trial, with real datagrams of emulated boxes and a disk that is full: both
// screens say so with the same look at the session, nothing is lost, and the work goes on.
#include <QDateTime>
#include <csignal>
#include <filesystem>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>
#include <sys/resource.h>

#include "device/config/net_ft_sensor.hpp"
#include "operator.hpp"
#include "storage/access/open_store.hpp"
#include "tests/device/net_ft_boxes.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::fault_test {
namespace {

namespace fs = std::filesystem;

/// A hand that is not there: sensors dither round zero.
FingerPlay at_rest() {
  FingerPlay play;
  play.t_s = {0.0};
  play.wrench_C = {FingerWrenches{}};
  return play;
}

class FaultDuringATrial : public QtTest {
 protected:
  FaultDuringATrial()
      : windows_({folder_.path("clinic.db"), "", ISOGRASP_SOURCE_DIR "/library", "test"}),
        operator_(windows_) {
    windows_.show();
    EXPECT_TRUE(wait_until([&] { return windows_.clinic().is_open(); }));
  }
  ~FaultDuringATrial() override {
    presenter_.connecting().end_session();
    EXPECT_TRUE(wait_until([&] { return !presenter_.state().busy(); }));
  }

  /// Three boxes, one of which will have that fault; free handling is chosen.
  void connect(const std::string& fault) {
    EmulatorOptions options;
    options.config = DeviceConfig::standard(kNetFtFamily);
    constexpr int kDither = 3;  // counts
    options.noise_counts = kDither;
    if (!fault.empty()) options.faults.push_back(*Fault::parse(fault));
    boxes_ = std::make_unique<Boxes>(options, at_rest());
    operator_.prepare_person();
    presenter_.choices().choose_protocol(std::nullopt);
    presenter_.choices().choose_device("udp://" + boxes_->full_address(0) + "," +
                                       boxes_->full_address(1) + "," + boxes_->full_address(2) +
                                       "?protocol=net-ft");
    operator_.press("connect");
    operator_.set_zero();
    operator_.choose_task("observe");
  }
  void start_trial(const std::string& fault) {
    connect(fault);
    operator_.start_task();
  }

  /// The fault has come when the first snapshot tells it: both screens must say so with that look.
  void expect_both_screens_say_so(const char* word) {
    bool late = false;
    const auto watch = QObject::connect(&presenter_.flow(), &SessionFlow::frame, [&] {
      const bool told = presenter_.state().snapshot().stage == session::Stage::paused;
      const bool shown =
          presenter_.flow().view().mood == Mood::fault &&
          presenter_.patient_view().picture().notice == PatientPicture::Notice::fault;
      late = late || (told && !shown);
    });
    ASSERT_TRUE(wait_until([&] { return presenter_.flow().view().mood == Mood::fault; }, 30));
    QObject::disconnect(watch);
    EXPECT_FALSE(late);
    EXPECT_TRUE(wait_until(
        [&] { return presenter_.flow().view().device_words.find(word) != std::string::npos; }, 30))
        << presenter_.flow().view().device_words;
    EXPECT_NE(presenter_.patient_view().picture().notice_words.find("You did nothing wrong"),
              std::string::npos);
  }

  std::vector<storage::EventRecord> stored_faults() {
    auto store = storage::open_store(folder_.path("clinic.db"), storage::OpenMode::read_only);
    auto events = *(*store)->events((*store)->recent_sessions(1)->front().id);
    std::erase_if(events, [](const storage::EventRecord& event) { return event.kind != "fault"; });
    return events;
  }

  std::vector<storage::TrialRecord> stored_trials() {
    auto store = storage::open_store(folder_.path("clinic.db"), storage::OpenMode::read_only);
    return *(*store)->trials((*store)->recent_sessions(1)->front().id);
  }

  /// The end of the last second of the running trial that another program finds in the file.
  [[nodiscard]] QTime stored_until() const {
    soci::session sql(soci::sqlite3, folder_.path("clinic.db"));
    std::string started_utc;
    double trial_s = 0.0;
    int second = 0;
    sql << "SELECT s.started_utc, t.session_time_s, max(b.second) FROM sessions s JOIN trials t ON "
           "t.session_id = s.id JOIN signal_blocks b ON b.trial_id = t.id WHERE t.status = "
           "'running'",
        soci::into(started_utc), soci::into(trial_s), soci::into(second);
    return QDateTime::fromString(QString::fromStdString(started_utc), Qt::ISODate)
        .toLocalTime()
        .addMSecs(static_cast<qint64>(1000.0 * (trial_s + second + 1)))
        .time();
  }
  /// What is told is from a moment before the file was asked; seconds may have been stored between.
  static constexpr int kLatest_s = 10;

  TemporaryFolder folder_;
  std::unique_ptr<Boxes> boxes_;
  Windows windows_;
  Operator operator_;
  SessionPresenter& presenter_ = windows_.presenter();
};

TEST_F(FaultDuringATrial, AnUnpluggedSensorIsSaidAndTheTrialGoesOnWhenItIsBack) {
  start_trial("silence=index:2s@10s");
  expect_both_screens_say_so("index");
  ASSERT_TRUE(wait_until(
      [&] {
        return presenter_.flow().view().may_resume &&
               presenter_.flow().view().device_mood != Mood::fault;
      },
      30))
      << presenter_.flow().view().sentence;
  operator_.press("pause");  // now Resume
  ASSERT_TRUE(
      wait_until([&] { return presenter_.state().snapshot().stage == session::Stage::trial; }));
  operator_.press("stop");
  operator_.finish_task();
  const auto trials = stored_trials();
  ASSERT_EQ(trials.size(), 1U);
  EXPECT_EQ(trials[0].dropped, 0);
}

TEST_F(FaultDuringATrial, ACardSaysUpToWhenAllIsStored) {
  start_trial("silence=index:30s@10s");
  expect_both_screens_say_so("index");
  const auto& safe = operator_.find<QLabel>("fault_safe");
  ASSERT_TRUE(wait_until([&] { return safe.isVisible(); }));
  keep_picture(windows_.therapist(), "fault");
  const auto until = QTime::fromString(safe.text().section(' ', -3, -3), "HH:mm:ss");
  ASSERT_TRUE(until.isValid()) << safe.text().toStdString();
  EXPECT_LE(until, stored_until()) << "it is in the file";
  EXPECT_GT(until, stored_until().addSecs(-kLatest_s)) << "and it is not told late";
  EXPECT_TRUE(operator_.find<QLabel>("fault_happened").text().contains("index"));
  EXPECT_FALSE(operator_.find<QAbstractButton>("try_again").isVisible()) << "it can go on";
  operator_.press("stop");
  operator_.finish_task();
}

TEST_F(FaultDuringATrial, AFrozenSensorIsSaid) {
  start_trial("freeze=middle:30s@10s");
  expect_both_screens_say_so("middle");
  operator_.press("stop");
  operator_.finish_task();
  EXPECT_EQ(stored_trials().size(), 1U) << "what there was is kept";
  EXPECT_TRUE(presenter_.state().traces().faults.size() >= 1)
      << "and the fault stands in the history";
}

TEST_F(FaultDuringATrial, AnOverloadIsSaid) {
  start_trial("saturate=thumb:2s@10s");
  ASSERT_TRUE(wait_until(
      [&] { return presenter_.flow().view().device_words.find("thumb") != std::string::npos; }, 30))
      << presenter_.flow().view().device_words;
  EXPECT_NE(presenter_.flow().view().device_mood, Mood::ready);
  operator_.press("stop");
  operator_.finish_task();
}

TEST_F(FaultDuringATrial, ARestartBetweenTrialsIsStoredAndNothingStartsBeforeANewZero) {
  connect("dip=index@15s");
  ASSERT_TRUE(wait_until([&] { return presenter_.flow().view().may_start; }));
  ASSERT_TRUE(wait_until(
      [&] {
        return presenter_.state().snapshot().restarted &&
               presenter_.flow().view().device_mood != Mood::fault;
      },
      60))
      << presenter_.flow().view().sentence;
  const auto& view = presenter_.flow().view();
  EXPECT_FALSE(view.may_start);
  EXPECT_EQ(view.mood, Mood::attention);
  EXPECT_EQ(view.next(), Step::zero);
  EXPECT_EQ(operator_.find<QLabel>("sentence").text().toStdString(), view.device_words);
  EXPECT_NE(view.sentence.find("zero again"), std::string::npos) << view.sentence;
  EXPECT_TRUE(operator_.find<QAbstractButton>("zero").isVisible()) << "its step is open again";
  EXPECT_FALSE(operator_.find<QAbstractButton>("start").isEnabled());
  operator_.set_zero();
  operator_.choose_task("observe");
  EXPECT_TRUE(
      wait_until([&] { return presenter_.flow().view().may_start; }, 5) ||
      presenter_.state().snapshot().restarted)  // on a busy machine a sensor may be lost again
      << presenter_.flow().view().sentence;
  presenter_.connecting().end_session();
  ASSERT_TRUE(wait_until([&] { return !presenter_.state().busy(); }));
  const auto faults = stored_faults();
  bool index_told = false;
  for (const auto& fault : every(faults)) {
    EXPECT_FALSE(fault.trial_id) << "between trials";
    EXPECT_GT(fault.session_time_s, 0.0);
    index_told = index_told || fault.text.find("index") != std::string::npos;
  }
  EXPECT_TRUE(index_told);
}

/// Files of this process cannot grow beyond that while it lives: as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t most_bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = most_bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

TEST_F(FaultDuringATrial, AFullDiskEndsTheSessionInWordsAndKeepsWhatWasWritten) {
  start_trial("");
  ASSERT_TRUE(wait_until([&] { return presenter_.state().snapshot().task.task_time_s > 2.5; }));
  {
    std::uintmax_t largest = 0;
    for (const auto& entry : fs::directory_iterator(folder_.path("")))
      if (entry.is_regular_file()) largest = std::max(largest, entry.file_size());
    const FullDisk full(largest);
    ASSERT_TRUE(wait_until([&] { return !presenter_.state().session_open(); }, 30));
    EXPECT_EQ(presenter_.flow().view().mood, Mood::fault);
    EXPECT_EQ(presenter_.patient_view().picture().notice, PatientPicture::Notice::fault)
        << presenter_.patient_view().picture().headline;
    ASSERT_TRUE(wait_until([&] { return !presenter_.state().busy(); }));
    EXPECT_NE(presenter_.flow().view().sentence.find("disk"), std::string::npos)
        << presenter_.flow().view().sentence;
    const auto result = operator_.find<QLabel>("result_remark").text();
    EXPECT_TRUE(result.contains("Free handling: interrupted")) << result.toStdString();
    EXPECT_FALSE(presenter_.state().traces().last_trial->measures.empty() &&
                 presenter_.state().live_score().empty());
    QTest::qWait(100);  // the disk is seen full
  }
  EXPECT_TRUE(wait_until([&] { return presenter_.flow().view().mood != Mood::fault; }))
      << "there is room again: " << presenter_.flow().view().sentence;
  EXPECT_EQ(presenter_.flow().view().next(), Step::hand);
  const auto trials = stored_trials();
  ASSERT_EQ(trials.size(), 1U);
  auto store = storage::open_store(folder_.path("clinic.db"), storage::OpenMode::existing);
  ASSERT_TRUE(store.ok());
  const auto signals = (*store)->signals(trials[0]);
  ASSERT_TRUE(signals.ok()) << signals.error().message();
  EXPECT_GT(signals->rows(), 150U) << "the seconds before";
}

TEST_F(FaultDuringATrial, ASessionThatAFullDiskRefusedIsToldUntilThereIsRoom) {
  operator_.prepare_person();
  presenter_.choices().choose_protocol(std::nullopt);
  presenter_.choices().choose_device("sim://healthy?seed=7");
  {
    const FullDisk full(0);
    operator_.press("connect");
    ASSERT_TRUE(wait_until([&] { return !presenter_.state().busy(); }));
    EXPECT_EQ(presenter_.flow().view().situation, Situation::session_failed)
        << presenter_.flow().view().sentence;
    QTest::qWait(100);  // the disk is seen full
  }
  EXPECT_TRUE(wait_until([&] { return presenter_.flow().view().mood != Mood::fault; }))
      << "there is room again: " << presenter_.flow().view().sentence;
}

}  // namespace
}  // namespace isograsp::gui::test::fault_test
