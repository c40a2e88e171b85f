// SPDX-License-Identifier: GPL-3.0-or-later
// A report is written in small steps: the same file, counted page by page, all of it or nothing.
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include <gtest/gtest.h>

#include "reports/findings/progress_report.hpp"
#include "reports/paper/html_writer.hpp"
#include "reports/paper/pdf_writer.hpp"
#include "storage/access/open_store.hpp"
#include "tests/reports/demo_clinic.hpp"
#include "tests/reports/paper_test.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::reports::writing_test {
namespace {

namespace fs = std::filesystem;

/// A PDF without what names the moment of its making.
std::string timeless(const std::string& pdf) {
  static const std::regex kMoment(
      "CreationDate \\([^)]*\\)|<xmp:(Create|Modify|Metadata)Date>[^<]*|/ID "
      "\\[[^\\]]*\\]|uuid:[^<]*");
  return std::regex_replace(pdf, kMoment, "");
}

/// One course of six sessions, made once for all tests.
class Writing : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    test::draw_without_a_display();
    folder_ = std::make_unique<test::TemporaryFolder>();
    auto opened = storage::open_store(folder_->path("clinic.db"), storage::OpenMode::create);
    ASSERT_TRUE(opened.ok()) << opened.error().message();
    store_ = std::move(*opened);
    test::add_course(*store_, "TK-104", false);
    auto content = gather_progress(*store_, "TK-104");
    ASSERT_TRUE(content.ok());
    content_ = *std::move(content);
  }
  static void TearDownTestSuite() {
    store_.reset();
    folder_.reset();
  }

  /// Files in a fresh folder after writing was stopped before step `stop_at`.
  static void stop_before_step(int stop_at, const std::string& path) {
    const auto writer = make_report_writer(content_, path);
    int step = 0;
    const auto done =
        write_all(*writer, path, [&](double, const Text&) { return step++ < stop_at; });
    ASSERT_FALSE(done.ok());
    EXPECT_EQ(step, stop_at + 1);
  }

  static std::unique_ptr<test::TemporaryFolder> folder_;
  static std::unique_ptr<storage::SessionStore> store_;
  static ReportContent content_;
};
std::unique_ptr<test::TemporaryFolder> Writing::folder_;
std::unique_ptr<storage::SessionStore> Writing::store_;
ReportContent Writing::content_;

TEST_F(Writing, InStepsAndBesideAnotherReportGivesTheSameFileAsAtOnce) {
  for (const std::string ending : {".pdf", ".html"}) {
    const auto path = folder_->path("at_once" + ending);
    ASSERT_TRUE((ending == ".pdf" ? write_pdf : write_html)(content_, path, {}, kEnglish).ok());
    const auto one = make_report_writer(content_, path);
    const auto other = make_report_writer(content_, path);
    other->paint_next();
    while (!one->complete()) {
      one->paint_next();
      if (!other->complete()) other->paint_next();
    }
    EXPECT_EQ(timeless(one->take()), timeless(test::read_file(path))) << ending;
    EXPECT_EQ(timeless(other->take()), timeless(test::read_file(path))) << ending;
  }
}

TEST_F(Writing, ProgressGrowsFromZeroAndCountsEveryPageInOrder) {
  PdfReport report(content_);
  ASSERT_GE(report.pages(), 2);
  std::vector<std::string> pages;
  double last = -1.0;
  const auto done =
      write_all(report, folder_->path("counted.pdf"), [&](double fraction, const Text& words) {
        EXPECT_GT(fraction, last);
        EXPECT_LT(fraction, 1.0);
        last = fraction;
        if (pages.empty() || pages.back() != english(words)) pages.push_back(english(words));
        return true;
      });
  ASSERT_TRUE(done.ok());
  std::vector<std::string> expected;
  for (int page = 1; page <= report.pages(); ++page)
    expected.push_back("page " + std::to_string(page) + " of " + std::to_string(report.pages()));
  EXPECT_EQ(pages, expected);
}

TEST_F(Writing, StoppedAnywhereLeavesNoFileAndTheOldOneAsItWas) {
  const test::TemporaryFolder empty;
  for (const std::string name : {"report.pdf", "report.html"}) {
    const int steps = make_report_writer(content_, name)->steps();
    for (const int stop_at : {0, 1, steps / 2, steps - 1}) {
      stop_before_step(stop_at, empty.path(name));
      EXPECT_TRUE(fs::is_empty(fs::path(empty.path(name)).parent_path())) << stop_at;
    }
    const auto old = folder_->write("old_" + name, "the old report");
    stop_before_step(steps - 1, old);
    EXPECT_EQ(test::read_file(old), "the old report");
  }
}

TEST_F(Writing, GatheringStopsWhereverItIsAskedTo) {
  int questions = 0;
  double last = -1.0;
  const auto whole = gather_progress(*store_, "TK-104", [&](double fraction, const Text&) {
    EXPECT_GT(fraction, last);
    EXPECT_LT(fraction, 1.0);
    last = fraction;
    ++questions;
    return true;
  });
  ASSERT_TRUE(whole.ok());
  EXPECT_GT(questions, static_cast<int>(content_.sessions.size() + content_.sections.size()));
  for (int stop_at = 0; stop_at < questions; ++stop_at) {
    int asked = 0;
    const auto stopped =
        gather_progress(*store_, "TK-104", [&](double, const Text&) { return asked++ < stop_at; });
    EXPECT_FALSE(stopped.ok());
    EXPECT_EQ(asked, stop_at + 1) << "goes on after it was asked to stop";
  }
}

}  // namespace
}  // namespace isograsp::reports::writing_test
