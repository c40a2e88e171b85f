// SPDX-License-Identifier: GPL-3.0-or-later
// Long work in the therapist's window: it shows how far it is, can be cancelled, and the window
// lives meanwhile.
#include <QProgressBar>
#include <QSignalSpy>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <unistd.h>

#include "operator.hpp"
#include "short_library.hpp"
#include "storage/access/open_store.hpp"
#include "tests/reports/demo_clinic.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::report_work_test {
namespace {

namespace fs = std::filesystem;

class LongWork : public QtTest {
 protected:
  /// A course of six sessions is made once and copied for each test.
  static void SetUpTestSuite() {
    made_ = std::make_unique<TemporaryFolder>();
    auto store = storage::open_store(made_->path("clinic.db"), storage::OpenMode::create);
    ASSERT_TRUE(store.ok());
    add_course(**store, kCode, true);
    ASSERT_TRUE((*store)->add_patient("P-0001").ok());
  }
  static void TearDownTestSuite() { made_.reset(); }

  LongWork() {
    fs::copy_file(made_->path("clinic.db"), database_);
    fs::create_directory(reports_);
  }

  [[nodiscard]] bool no_file() const { return fs::is_empty(reports_); }

  static constexpr const char* kCode = "TK-104";
  static inline std::unique_ptr<TemporaryFolder> made_;
  TemporaryFolder folder_;
  std::string database_ = folder_.path("clinic.db");
  std::string reports_ = folder_.path("reports");
  std::string pdf_ = reports_ + "/report.pdf";
};

/// The clinic alone, open.
class ReportInTheBackground : public LongWork {
 protected:
  ReportInTheBackground() {
    clinic_->open();
    EXPECT_TRUE(wait_until([&] { return clinic_->is_open(); }));
  }
  ReportWork& report() { return clinic_->report(); }

  /// Cancels at the first progress whose words begin so.
  void cancel_at(const char* words) {
    QObject::connect(&report(), &ReportWork::progress, &report(),
                     [this, words](double, const QString& at) {
                       if (at.startsWith(words)) report().cancel();
                     });
  }

  std::unique_ptr<Clinic> clinic_ = std::make_unique<Clinic>(database_);
};

TEST_F(ReportInTheBackground, OtherEventsHappenBetweenAnyTwoStepsOfPainting) {
  int ticks = 0;
  QTimer other;
  QObject::connect(&other, &QTimer::timeout, [&] { ++ticks; });
  other.start(0);
  int steps = 0;
  int at_last_step = 0;
  QObject::connect(&report(), &ReportWork::progress, [&](double, const QString& words) {
    if (!words.startsWith("page")) return;
    if (steps++ > 0) {
      EXPECT_GT(ticks, at_last_step) << "two steps in one turn of the event loop";
    }
    at_last_step = ticks;
  });
  report().start(kCode, pdf_);
  ASSERT_TRUE(wait_until([&] { return !report().running(); }));
  EXPECT_TRUE(fs::exists(pdf_));
  EXPECT_GT(steps, 20);
}

TEST_F(ReportInTheBackground, ProgressOnlyGrowsAndNamesEveryPage) {
  double last = -1.0;
  QStringList pages;
  QObject::connect(&report(), &ReportWork::progress, [&](double fraction, const QString& words) {
    EXPECT_GE(fraction, last);
    last = fraction;
    if (words.startsWith("page") && !pages.contains(words)) pages << words;
  });
  report().start(kCode, pdf_);
  ASSERT_TRUE(wait_until([&] { return !report().running(); }));
  EXPECT_EQ(last, 1.0);
  ASSERT_GE(pages.size(), 2);
  for (int page = 1; page <= pages.size(); ++page)
    EXPECT_EQ(pages[page - 1], QString("page %1 of %2").arg(page).arg(pages.size()));
}

TEST_F(ReportInTheBackground, CancelledAnywhereItLeavesNoFileAndTheOldOneAsItWas) {
  for (const char* where : {"reading", "session", "task", "checking", "page 1", "page 2"}) {
    cancel_at(where);
    QSignalSpy cancelled(&report(), &ReportWork::cancelled);
    QSignalSpy written(&report(), &ReportWork::written);
    report().start(kCode, pdf_);
    if (report().running()) {
      ASSERT_TRUE(wait_until([&] { return !report().running(); }));
    }
    EXPECT_EQ(cancelled.count(), 1) << where;
    QTest::qWait(1);  // what the worker had under way arrives
    EXPECT_EQ(written.count(), 0) << where;
    EXPECT_TRUE(no_file()) << where;
    QObject::disconnect(&report(), &ReportWork::progress, nullptr, nullptr);
  }
  std::ofstream(pdf_) << "the old report";
  cancel_at("page 2");
  report().start(kCode, pdf_);
  ASSERT_TRUE(wait_until([&] { return !report().running(); }));
  EXPECT_EQ(read_file(pdf_), "the old report");
}

TEST_F(ReportInTheBackground, CanBeWrittenAfterOneWasCancelled) {
  report().start(kCode, reports_ + "/never.pdf");
  report().cancel();
  report().start(kCode, pdf_);
  ASSERT_TRUE(wait_until([&] { return !report().running(); }));
  EXPECT_EQ(read_file(pdf_).substr(0, 5), "%PDF-");
  EXPECT_FALSE(fs::exists(reports_ + "/never.pdf"));
}

TEST_F(ReportInTheBackground, PaintsNothingWhileItIsHeld) {
  report().hold(true);
  int pages = 0;
  double last = 0.0;
  QObject::connect(&report(), &ReportWork::progress, [&](double fraction, const QString& words) {
    pages += words.startsWith("page") ? 1 : 0;
    last = fraction;
  });
  report().start(kCode, pdf_);
  clinic_->load_history("P-0001");  // stands behind the gathering
  ASSERT_TRUE(wait_until([&] { return !clinic_->history_loading(); }));
  for (int i = 0; i < 50; ++i) QCoreApplication::processEvents();
  EXPECT_EQ(pages, 0);
  EXPECT_TRUE(report().running());
  report().hold(false);
  ASSERT_TRUE(wait_until([&] { return !report().running(); }));
  EXPECT_GT(pages, 0);
  EXPECT_TRUE(fs::exists(pdf_));
}

TEST_F(ReportInTheBackground, EndsWithoutAFileWhenTheProgramEnds) {
  bool painting = false;
  QObject::connect(&report(), &ReportWork::progress, [&](double, const QString& words) {
    painting = painting || words.startsWith("page 2");
  });
  report().start(kCode, pdf_);
  clinic_ = std::make_unique<Clinic>(database_);  // while it gathers
  EXPECT_TRUE(no_file());
  clinic_->open();
  ASSERT_TRUE(wait_until([&] { return clinic_->is_open(); }));
  QObject::connect(&report(), &ReportWork::progress, [&](double, const QString& words) {
    painting = painting || words.startsWith("page 2");
  });
  report().start(kCode, pdf_);
  while (!painting && report().running()) QCoreApplication::processEvents();
  clinic_.reset();  // while it paints
  EXPECT_TRUE(no_file());
}

TEST_F(ReportInTheBackground, AFileThatCannotBeWrittenIsToldInWords) {
  QSignalSpy failed(&report(), &ReportWork::failed);
  report().start(kCode, folder_.path("absent/report.pdf"));
  ASSERT_TRUE(wait_until([&] { return !report().running(); }));
  ASSERT_EQ(failed.count(), 1);
  const auto why = failed.front().front().toString().toStdString();
  EXPECT_NE(why.find(folder_.path("absent") + ": "), std::string::npos) << why;
  EXPECT_NE(why.find("does not exist"), std::string::npos) << why;
  EXPECT_NE(why.find("choose another folder"), std::string::npos) << why;
}

TEST_F(ReportInTheBackground, AFolderThatMayNotBeWrittenIntoIsNamed) {
  if (geteuid() == 0) {  // root may write everywhere but where a file stands in the way
    std::ofstream(folder_.path("closed")) << "a file";
  } else {
    fs::create_directory(folder_.path("closed"));
    fs::permissions(folder_.path("closed"), fs::perms::owner_read | fs::perms::owner_exec);
  }
  QSignalSpy failed(&report(), &ReportWork::failed);
  report().start(kCode, folder_.path("closed/report.pdf"));
  ASSERT_TRUE(wait_until([&] { return !report().running(); }));
  ASSERT_EQ(failed.count(), 1);
  const auto why = failed.front().front().toString().toStdString();
  EXPECT_NE(why.find(folder_.path("closed") + ": "), std::string::npos) << why;
  EXPECT_NE(why.find("choose another folder"), std::string::npos) << why;
}

TEST_F(ReportInTheBackground, AnotherPatientsHistoryIsNeverShownWhileOnesOwnIsRead) {
  clinic_->load_history(kCode);
  ASSERT_TRUE(wait_until([&] { return !clinic_->history_loading(); }));
  ASSERT_FALSE(clinic_->history().empty());
  clinic_->load_history("P-0001");
  EXPECT_TRUE(clinic_->history().empty());
  EXPECT_TRUE(clinic_->history_loading());
  clinic_->load_history(kCode);  // before the answer came
  ASSERT_TRUE(wait_until([&] { return !clinic_->history_loading(); }));
  EXPECT_FALSE(clinic_->history().empty());
}

/// The therapist's window, with the patient of the course chosen.
class LongWorkInTheWindow : public LongWork {
 protected:
  LongWorkInTheWindow()
      : windows_(settling_soon(
            {database_, "sim://healthy?seed=7", make_short_library(folder_, "3"), "test"})),
        operator_(windows_) {
    windows_.show();
    EXPECT_TRUE(wait_until([&] { return windows_.clinic().is_open(); }));
    windows_.presenter().choices().choose_patient(kCode);
    EXPECT_TRUE(wait_until([&] { return !windows_.clinic().history_loading(); }));
    windows_.presenter().choices().choose_protocol(std::nullopt);
  }
  /// Up to the press of Connect.
  void begin_connecting() {
    windows_.therapist().show_page(TherapistWindow::Page::session);
    operator_.press("hand_right");
    operator_.press("screening_clear");
    operator_.press("connect");
  }
  ~LongWorkInTheWindow() override {
    windows_.presenter().connecting().end_session();
    EXPECT_TRUE(wait_until([&] { return !windows_.presenter().state().busy(); }));
  }
  ReportWork& report() { return windows_.clinic().report(); }

  Windows windows_;
  Operator operator_;
};

TEST_F(LongWorkInTheWindow, TheReportShowsItsProgressAndACancelButtonThatWorks) {
  windows_.therapist().show_page(TherapistWindow::Page::reports);
  auto& writing = operator_.find<QWidget>("report_writing");
  auto& button = operator_.find<QPushButton>("report");
  EXPECT_FALSE(writing.isVisible());
  EXPECT_TRUE(button.isEnabled());
  report().start(kCode, pdf_);
  EXPECT_TRUE(writing.isVisible());
  EXPECT_FALSE(button.isEnabled());
  EXPECT_TRUE(operator_.find<QLabel>("report_doing").text().contains(kCode));
  EXPECT_EQ(operator_.find<QProgressBar>("report_progress").maximum(), 1000);
  operator_.press("report_cancel");
  EXPECT_FALSE(report().running());
  EXPECT_FALSE(writing.isVisible());
  EXPECT_TRUE(button.isEnabled());
  EXPECT_TRUE(operator_.find<QLabel>("report_remark").text().startsWith("Cancelled"));
  EXPECT_TRUE(no_file());
}

TEST_F(LongWorkInTheWindow, ClosingWaitsForTheReport) {
  report().start(kCode, pdf_);
  windows_.therapist().close();
  EXPECT_TRUE(windows_.therapist().isVisible());
  ASSERT_TRUE(wait_until([&] { return !windows_.therapist().isVisible(); }));
  EXPECT_TRUE(fs::exists(pdf_));
}

TEST_F(LongWorkInTheWindow, ClosingStaysOpenIfThereIsNoReportInTheEnd) {
  report().start(kCode, folder_.path("absent/report.pdf"));
  windows_.therapist().close();
  ASSERT_TRUE(wait_until([&] { return !report().running(); }));
  EXPECT_TRUE(windows_.therapist().isVisible());
  EXPECT_TRUE(operator_.find<QLabel>("report_remark").text().contains("absent"));
}

TEST_F(LongWorkInTheWindow, ASessionCanBeginWhileAReportIsWritten) {
  report().start(kCode, pdf_);
  begin_connecting();
  ASSERT_TRUE(wait_until([&] { return windows_.presenter().state().session_open(); }));
  ASSERT_TRUE(wait_until([&] { return !report().running(); }));
  EXPECT_TRUE(fs::exists(pdf_));
}

TEST_F(LongWorkInTheWindow, ThePagesWaitForTheEndOfATrial) {
  begin_connecting();
  operator_.set_zero();
  operator_.strap_in();
  operator_.start_task();
  report().start(kCode, pdf_);
  ASSERT_TRUE(
      wait_until([&] { return operator_.find<QLabel>("report_doing").text().contains("waits"); }));
  while (windows_.presenter().flow().view().may_stop && report().running()) QTest::qWait(10);
  EXPECT_TRUE(report().running()) << "painted during the trial";
  ASSERT_TRUE(wait_until([&] { return !report().running(); }));
  EXPECT_TRUE(fs::exists(pdf_));
}

TEST_F(LongWorkInTheWindow, ConnectingCanBeCancelledAndTriedAgain) {
  auto& presenter = windows_.presenter();
  begin_connecting();
  ASSERT_TRUE(presenter.flow().view().may_cancel_connecting);
  EXPECT_EQ(operator_.find<QPushButton>("connect").text(), "&Cancel");
  presenter.poll();
  EXPECT_TRUE(operator_.find<QProgressBar>("connect_progress").isVisible());
  operator_.press("connect");  // now Cancel
  EXPECT_FALSE(presenter.state().busy());
  EXPECT_TRUE(presenter.flow().view().may_connect);
  EXPECT_TRUE(presenter.flow().view().device_words.find("Not connected") == 0);

  operator_.press("connect");
  ASSERT_TRUE(wait_until([&] { return presenter.state().session_open(); }));
  operator_.press("zero");
}

TEST_F(LongWorkInTheWindow, ClosingWhileConnectingDoesNotWaitForTheDevice) {
  begin_connecting();
  ASSERT_TRUE(windows_.presenter().state().busy());
  windows_.therapist().close();
  EXPECT_FALSE(windows_.therapist().isVisible());
}

}  // namespace
}  // namespace isograsp::gui::test::report_work_test
