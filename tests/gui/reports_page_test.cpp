// SPDX-License-Identifier: GPL-3.0-or-later
// The reports page in the therapist's window: the preview is of the chosen patient and period, the
// export writes what it lists.
#include <QComboBox>
#include <QFileDialog>
#include <QListWidget>
#include <QProgressBar>
#include <QSignalSpy>
#include <QTabWidget>
#include <filesystem>
#include <set>

#include "gui/look/page_view.hpp"
#include "gui/office_pages/export_panel.hpp"
#include "operator.hpp"
#include "reports/findings/progress_report.hpp"
#include "short_library.hpp"
#include "storage/access/open_store.hpp"
#include "tests/reports/demo_clinic.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::reports_page_test {
namespace {

namespace fs = std::filesystem;
constexpr const char* kCode = "TK-104";

class ReportsPageTest : public QtTest {
 protected:
  /// A course of six sessions is made once and copied for each test.
  static void SetUpTestSuite() {
    made_ = std::make_unique<TemporaryFolder>();
    auto store = *storage::open_store(made_->path("clinic.db"), storage::OpenMode::create);
    add_course(*store, kCode, true);
    ASSERT_TRUE(store->add_patient("P-0001").ok());
  }
  static void TearDownTestSuite() { made_.reset(); }

  ReportsPageTest() {
    fs::copy(made_->path("clinic.db"), folder_.path("clinic.db"));
    windows_ = std::make_unique<Windows>(
        GuiConfig{folder_.path("clinic.db"), "", make_short_library(folder_), "test"});
    operator_ = std::make_unique<Operator>(*windows_);
    windows_->therapist().show();
    EXPECT_TRUE(wait_until([&] { return windows_->clinic().is_open(); }));
    windows_->presenter().choices().choose_patient(kCode);
    windows_->therapist().show_page(TherapistWindow::Page::reports);
  }

  [[nodiscard]] PageView& view() { return operator_->find<PageView>("report_pages"); }
  bool painted() {
    return wait_until([&] { return view().isVisible() && view().complete(); });
  }
  void choose(const char* box, int index) {
    auto& list = operator_->find<QComboBox>(box);
    list.setCurrentIndex(index);
    Q_EMIT list.activated(index);
  }
  void show_tab(int index) { operator_->find<QTabWidget>("report_tabs").setCurrentIndex(index); }
  void keep(const char* name) { keep_pictures_of_both_sizes(windows_->therapist(), name); }

  static inline std::unique_ptr<TemporaryFolder> made_;
  TemporaryFolder folder_;
  std::unique_ptr<Windows> windows_;
  std::unique_ptr<Operator> operator_;
};

TEST_F(ReportsPageTest, ShowsThePagesOfTheChosenPatient) {
  ASSERT_TRUE(painted());
  EXPECT_GE(view().pages(), 2);
  EXPECT_EQ(view().page(), 1);
  EXPECT_EQ(operator_->find<QLabel>("report_patient").text(), kCode);
  keep("reports");
  QTest::keyClick(&view(), Qt::Key_End);
  EXPECT_EQ(view().page(), view().pages());
  ASSERT_TRUE(painted());
  windows_->presenter().choices().choose_patient("P-0001");
  EXPECT_EQ(view().pages(), 0) << "never the pages of somebody else";
}

/// A home without the folder for documents, as a new account has it.
class BareHome {
 public:
  explicit BareHome(const std::string& home) : home_(qgetenv("HOME")) {
    fs::create_directories(home);
    qputenv("HOME", QByteArray::fromStdString(home));
  }
  ~BareHome() { qputenv("HOME", home_); }
  BareHome(const BareHome&) = delete;
  BareHome& operator=(const BareHome&) = delete;

 private:
  QByteArray home_;
};

TEST_F(ReportsPageTest, IsSavedWhereTheWindowProposesAlsoWithoutAFolderForDocuments) {
  const BareHome home(folder_.path("home"));
  ASSERT_TRUE(painted());
  operator_->press("report");
  auto* dialog = windows_->therapist().findChild<QFileDialog*>();
  ASSERT_NE(dialog, nullptr);
  EXPECT_TRUE(dialog->directory().exists()) << dialog->directory().path().toStdString();
  QMetaObject::invokeMethod(dialog, "accept");
  auto& report = windows_->clinic().report();
  ASSERT_TRUE(wait_until([&] { return !report.running(); }));
  EXPECT_TRUE(operator_->find<QLabel>("report_remark").text().startsWith("Report written"))
      << operator_->find<QLabel>("report_remark").text().toStdString();
  EXPECT_TRUE(fs::exists(folder_.path("home") + "/" + kCode + ".pdf"));
}

TEST_F(ReportsPageTest, AnExportIsProposedIntoAFolderThatExists) {
  const BareHome home(folder_.path("home"));
  show_tab(1);
  operator_->press("export");
  auto* dialog = windows_->therapist().findChild<QFileDialog*>();
  ASSERT_NE(dialog, nullptr);
  EXPECT_EQ(dialog->directory().path().toStdString(), folder_.path("home"));
  dialog->reject();
}

TEST_F(ReportsPageTest, AShorterPeriodHasItsOwnPages) {
  ASSERT_TRUE(painted());
  const int pages = view().pages();
  const auto before = view().grab().toImage();
  choose("report_last", 0);
  ASSERT_TRUE(wait_until([&] {
    return view().complete() && (view().pages() != pages || view().grab().toImage() != before);
  }));
  choose("report_first", 3);
  EXPECT_EQ(operator_->find<QComboBox>("report_last").currentIndex(), 3)
      << "the end is never before the beginning";
}

TEST_F(ReportsPageTest, ZoomPaintsThePagesAnew) {
  ASSERT_TRUE(painted());
  const double fitting = view().scale();
  operator_->press("report_larger");
  EXPECT_GT(view().scale(), fitting);
  EXPECT_FALSE(view().complete());
  ASSERT_TRUE(painted());
  operator_->press("report_smaller");
  operator_->press("report_smaller");
  EXPECT_LT(view().scale(), fitting);
  ASSERT_TRUE(painted());
  operator_->press("report_fit");
  EXPECT_DOUBLE_EQ(view().scale(), fitting);
}

TEST_F(ReportsPageTest, APreviewThatIsHeldPaintsNothing) {
  auto store = *storage::open_store(folder_.path("clinic.db"), storage::OpenMode::read_only);
  PageView alone;
  alone.resize(600, 400);
  alone.hold(true);
  alone.show_pages(
      std::make_shared<const reports::ReportPages>(*reports::gather_progress(*store, kCode)));
  alone.show();
  for (int i = 0; i < 200; ++i) QCoreApplication::processEvents();
  EXPECT_FALSE(alone.complete());
  alone.hold(false);
  ASSERT_TRUE(wait_until([&] { return alone.complete(); }));
}

TEST_F(ReportsPageTest, TheExportListsAndWritesTheSameFiles) {
  show_tab(1);
  auto& files = operator_->find<QListWidget>("export_files");
  ASSERT_TRUE(wait_until([&] { return files.count() > 0; }));
  const int all = files.count();
  keep("export");
  choose("export_last", 1);
  ASSERT_TRUE(wait_until([&] { return files.count() > 0 && files.count() < all; }));
  auto& panel = *windows_->therapist().findChild<ExportPanel*>();
  QSignalSpy written(&windows_->clinic().research_export(), &ExportWork::written);
  fs::create_directories(folder_.path("study"));
  panel.write_into(QString::fromStdString(folder_.path("study")));
  EXPECT_TRUE(operator_->find<QProgressBar>("export_progress").isVisible());
  ASSERT_TRUE(wait_until([&] { return !windows_->clinic().research_export().running(); }));
  ASSERT_EQ(written.count(), 1) << operator_->find<QLabel>("export_remark").text().toStdString();
  int found = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder_.path("study/isograsp-export")))
    found += entry.is_regular_file() ? 1 : 0;
  EXPECT_EQ(found, files.count());
  panel.write_into(QString::fromStdString(folder_.path("study")));
  ASSERT_TRUE(wait_until([&] { return !windows_->clinic().research_export().running(); }));
  EXPECT_TRUE(fs::exists(folder_.path("study/isograsp-export-2"))) << "nothing is overwritten";
}

TEST_F(ReportsPageTest, EveryFormatIsOfferedInWordsAndWritesWhatItLists) {
  show_tab(1);
  auto& files = operator_->find<QListWidget>("export_files");
  auto& formats = operator_->find<QComboBox>("export_format");
  auto& panel = *windows_->therapist().findChild<ExportPanel*>();
  ASSERT_EQ(formats.count(), static_cast<int>(exports::kExportFormats.size()));
  ASSERT_TRUE(wait_until([&] { return files.count() > 0; }));
  choose("export_last", 0);
  for (int format = 0; format < formats.count(); ++format) {
    files.clear();
    choose("export_format", format);
    ASSERT_TRUE(wait_until([&] { return files.count() > 0; }));
    keep(("export_" + std::to_string(format)).c_str());
    const std::string study = folder_.path("format_" + std::to_string(format));
    fs::create_directories(study);
    panel.write_into(QString::fromStdString(study));
    ASSERT_TRUE(wait_until([&] { return !windows_->clinic().research_export().running(); }));
    std::set<QString> listed;
    for (int row = 0; row < files.count(); ++row) listed.insert(files.item(row)->text());
    std::set<QString> written;
    for (const auto& entry : fs::recursive_directory_iterator(study + "/isograsp-export"))
      if (entry.is_regular_file())
        written.insert(QString::fromStdString(
            fs::relative(entry.path(), study + "/isograsp-export").string()));
    EXPECT_EQ(written, listed) << formats.itemText(format).toStdString();
  }
}

TEST_F(ReportsPageTest, AnExportThatIsCancelledLeavesNothing) {
  show_tab(1);
  ASSERT_TRUE(wait_until([&] { return operator_->find<QListWidget>("export_files").count() > 0; }));
  auto& panel = *windows_->therapist().findChild<ExportPanel*>();
  QSignalSpy cancelled(&windows_->clinic().research_export(), &ExportWork::cancelled);
  fs::create_directories(folder_.path("study"));
  panel.write_into(QString::fromStdString(folder_.path("study")));
  operator_->press("export_cancel");
  ASSERT_TRUE(wait_until([&] { return !windows_->clinic().research_export().running(); }));
  EXPECT_EQ(cancelled.count(), 1);
  EXPECT_TRUE(fs::is_empty(folder_.path("study")));
}

TEST_F(ReportsPageTest, AnotherPatientHasNothingOfTheOneBefore) {
  ASSERT_TRUE(painted());
  choose("report_last", 1);
  show_tab(1);
  ASSERT_TRUE(wait_until([&] { return operator_->find<QListWidget>("export_files").count() > 0; }));
  windows_->presenter().choices().choose_patient("P-0001");
  EXPECT_EQ(operator_->find<QListWidget>("export_files").count(), 0);
  EXPECT_EQ(operator_->find<QComboBox>("export_last").count(), 0);
  show_tab(0);
  EXPECT_EQ(operator_->find<QComboBox>("report_last").count(), 0);
  EXPECT_EQ(view().pages(), 0);
}

TEST_F(ReportsPageTest, TheWindowStaysUntilAnExportIsWritten) {
  show_tab(1);
  ASSERT_TRUE(wait_until([&] { return operator_->find<QListWidget>("export_files").count() > 0; }));
  auto& panel = *windows_->therapist().findChild<ExportPanel*>();
  fs::create_directories(folder_.path("study"));
  windows_->clinic().research_export().hold(true);
  panel.write_into(QString::fromStdString(folder_.path("study")));
  windows_->therapist().close();
  EXPECT_TRUE(windows_->therapist().isVisible());
  windows_->clinic().research_export().hold(false);
  ASSERT_TRUE(wait_until([&] { return !windows_->therapist().isVisible(); }));
  EXPECT_FALSE(fs::is_empty(folder_.path("study/isograsp-export")));
}

TEST_F(ReportsPageTest, WithoutAPatientItSaysWhatToDo) {
  windows_->presenter().choices().choose_patient("");
  EXPECT_TRUE(operator_->find<QLabel>("report_nothing").isVisible());
  EXPECT_FALSE(operator_->find<QPushButton>("report").isEnabled());
  show_tab(1);
  EXPECT_FALSE(operator_->find<QPushButton>("export").isEnabled());
  choose("export_whose", 1);
  ASSERT_TRUE(wait_until([&] { return operator_->find<QPushButton>("export").isEnabled(); }));
}

}  // namespace
}  // namespace isograsp::gui::test::reports_page_test
