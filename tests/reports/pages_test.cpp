// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of a report are the same wherever they are painted; a report of a period says so; an
// export is what was listed before, all of it or nothing.
#include <QBuffer>
#include <QPdfWriter>
#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "exports/research_export.hpp"
#include "reports/findings/progress_report.hpp"
#include "reports/findings/report_text.hpp"
#include "reports/paper/pdf_writer.hpp"
#include "reports/paper/report_pages.hpp"
#include "reports/paper/report_writer.hpp"
#include "storage/access/open_store.hpp"
#include "tests/reports/demo_clinic.hpp"
#include "tests/reports/painted_page.hpp"
#include "tests/reports/paper_test.hpp"
#include "tests/support/every.hpp"
#include "tests/support/files_below.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::reports::pages_test {
namespace {

namespace fs = std::filesystem;
using test::files_below;

class Pages : public test::PaperTest {
 protected:
  static void SetUpTestSuite() {
    open_clinic();
    test::add_course(*store_, "TK-104", false);
    test::add_course(*store_, "TK-105", true);
  }

  static ReportContent content(const ReportScope& scope = {}, const char* code = "TK-104") {
    return gather_progress(*store_, code, {}, scope).value();
  }
  static QImage picture(const ReportPages& pages, int page, double scale) {
    PagePicture painted(pages, page, scale);
    while (!painted.complete()) painted.paint_next();
    return painted.image();
  }
  /// Share of the pixels that are not white.
  static double ink(const QImage& image) {
    int dark = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) dark += qGray(image.pixel(x, y)) < 250 ? 1 : 0;
    return static_cast<double>(dark) / (image.width() * image.height());
  }
};

TEST_F(Pages, OfThePreviewAreAsManyAsThoseOfThePdf) {
  const ReportPages pages(content());
  EXPECT_GE(pages.pages(), 2);
  EXPECT_EQ(pages.pages(), PdfReport(content()).pages());
  EXPECT_EQ(pages.steps(), PdfReport(content()).steps());
}

TEST_F(Pages, LookTheSameAtEveryScale) {
  const ReportPages pages(content());
  for (const int page : test::every(test::all_pages(pages))) {
    const auto small = picture(pages, page, 1.0);
    const auto large = picture(pages, page, 2.0);
    EXPECT_EQ(small.size() * 2, large.size());
    EXPECT_GT(ink(small), 0.005) << "page " << page << " is empty";
    // Where the small one has ink, so has the large one: compared in blocks of 16 points.
    constexpr int kBlock = 16;
    constexpr double kEmpty = 0.002;  // of a block: less is the rim of something
    int wrong = 0;
    for (int y = 0; y + kBlock <= small.height(); y += kBlock)
      for (int x = 0; x + kBlock <= small.width(); x += kBlock) {
        const double one = ink(small.copy(x, y, kBlock, kBlock));
        const double two = ink(large.copy(2 * x, 2 * y, 2 * kBlock, 2 * kBlock));
        wrong += (one > 0.2 && two < kEmpty) || (two > 0.2 && one < kEmpty) ? 1 : 0;
      }
    EXPECT_EQ(wrong, 0) << "page " << page;
  }
}

TEST_F(Pages, ArePaintedOnAnyPagedDeviceWithItsOwnResolution) {
  const ReportPages pages(content());
  for (const int resolution : {300, 600, 1200}) {
    QBuffer file;
    file.open(QIODevice::WriteOnly);
    QPdfWriter device(&file);
    device.setResolution(resolution);
    device.setPageSize(QPageSize(QPageSize::A4));
    PagePrinter printer(pages, device);
    int last = -1;
    while (!printer.complete()) {
      EXPECT_GE(printer.page(), last);
      last = printer.page();
      ASSERT_TRUE(printer.paint_next());
    }
    EXPECT_EQ(last, pages.pages() - 1);
    EXPECT_EQ(file.data().count("/Type /Page\n"), pages.pages()) << resolution;
  }
}

TEST_F(Pages, ThatOfThePatientIsTheLastOneAndIsPrintedAlone) {
  const ReportPages pages(content());
  ASSERT_EQ(pages.patient_page(), pages.pages() - 1);
  QBuffer file;
  file.open(QIODevice::WriteOnly);
  QPdfWriter device(&file);
  device.setPageSize(QPageSize(QPageSize::A4));
  PagePrinter printer(pages, device, *pages.patient_page());
  while (!printer.complete()) ASSERT_TRUE(printer.paint_next());
  EXPECT_EQ(printer.steps_done(), pages.steps(*pages.patient_page()));
  EXPECT_EQ(file.data().count("/Type /Page\n"), 1);
  EXPECT_EQ(ReportPages(ReportContent{}).patient_page(), std::nullopt) << "nothing is stored";
}

TEST_F(Pages, AreNotPaintedOnADeviceThatTakesNothing) {
  const ReportPages pages(content());
  QPdfWriter device(QStringLiteral("/no/such/folder/report.pdf"));
  PagePrinter printer(pages, device);
  EXPECT_FALSE(printer.paint_next());
}

TEST_F(Pages, OfSimulatedPatientsCarryTheirMarkInThePreviewToo) {
  const auto plain = content();
  auto marked = plain;
  marked.simulated = true;
  const ReportPages without(plain);
  const ReportPages with(marked);
  for (const int page : test::every(test::all_pages(with)))
    EXPECT_NE(picture(with, page, 1.0), picture(without, page, 1.0)) << page;
}

TEST_F(Pages, OfAPeriodLeaveOutTheOtherSessionsAndSaySo) {
  const auto all = content();
  const auto some = content({2, 4});
  ASSERT_EQ(all.sessions.size(), 6U);
  ASSERT_EQ(some.sessions.size(), 3U);
  EXPECT_EQ(some.sessions_stored, 6);
  EXPECT_EQ(some.sessions.front().number, 2) << "sessions keep their numbers";
  EXPECT_EQ(some.sessions.front().day, all.sessions[1].day) << "counted from the first of all";
  for (const auto& section : test::every(some.sections))
    for (const auto& series : test::every(section.series))
      for (const auto& value : test::every(series.values))
        EXPECT_LT(value.session, some.sessions.size());
  const auto facts = header_facts(some);
  EXPECT_TRUE(std::any_of(facts.begin(), facts.end(),
                          [](const auto& fact) { return fact.value == "3 of 6"; }));
  ASSERT_FALSE(some.quality.empty());
  EXPECT_NE(english(some.quality.front().text).find("2 to 4 of 6"), std::string::npos);
  EXPECT_TRUE(all.quality.empty() || english(all.quality.front().label) != "Period");
  EXPECT_EQ(content({1, 6}).quality.size(), all.quality.size());
  const auto none = content({9, 0});
  EXPECT_EQ(none.sessions.size(), 0U);
  EXPECT_TRUE(
      write_all(*make_report_writer(none, folder_->path("none.html")), folder_->path("none.html"))
          .ok());
  EXPECT_TRUE(
      write_all(*make_report_writer(none, folder_->path("none.pdf")), folder_->path("none.pdf"))
          .ok());
}

TEST_F(Pages, AnExportWritesExactlyTheFilesThatWereListed) {
  exports::ExportRequest request{"TK-104"};
  request.first_session = 2;
  request.last_session = 3;
  auto listed = exports::list_export(*store_, request).value();
  std::sort(listed.begin(), listed.end());
  const auto out = folder_->path("listed");
  const auto trials = exports::write_export(*store_, request, exports::ExportFormat::csv, out);
  ASSERT_TRUE(trials.ok()) << trials.error().message();
  EXPECT_EQ(files_below(out), listed);
  EXPECT_GT(*trials, 2U);
  EXPECT_TRUE(std::all_of(listed.begin(), listed.end(), [](const std::string& file) {
    return file.find("session_2/") != std::string::npos ||
           file.find("session_3/") != std::string::npos || file.starts_with("SHA256SUMS");
  }));
  for (const auto& file : test::every(listed))
    EXPECT_EQ(file.find("TK"), std::string::npos) << "no code in the name of a file";
  EXPECT_FALSE(exports::write_export(*store_, request, exports::ExportFormat::csv, out).ok())
      << "nothing is overwritten";
  EXPECT_FALSE(exports::list_export(*store_, {"XX-999"}).ok());
}

TEST_F(Pages, AnExportThatIsCancelledLeavesNothing) {
  for (const int after : {0, 1, 5}) {
    const auto out = folder_->path("cancelled");
    int asked = 0;
    const auto trials = exports::write_export(*store_, {}, exports::ExportFormat::csv, out,
                                              [&](double fraction, const Text&) {
                                                EXPECT_GE(fraction, 0.0);
                                                return asked++ < after;
                                              });
    EXPECT_FALSE(trials.ok());
    EXPECT_FALSE(fs::exists(out)) << after;
  }
  fs::create_directories(folder_->path("kept"));
  EXPECT_FALSE(exports::write_export(*store_, {}, exports::ExportFormat::csv, folder_->path("kept"),
                                     [](double fraction, const auto&) { return fraction < 1.0; })
                   .ok());
  EXPECT_TRUE(fs::is_empty(folder_->path("kept")));
}

}  // namespace
}  // namespace isograsp::reports::pages_test
