// SPDX-License-Identifier: GPL-3.0-or-later
// A report says what is stored, no more and no less, in PDF and HTML alike.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "reports/findings/progress_report.hpp"
#include "reports/findings/report_text.hpp"
#include "reports/paper/html_writer.hpp"
#include "reports/paper/pdf_writer.hpp"
#include "storage/access/open_store.hpp"
#include "tasks/facts/measure_words.hpp"
#include "tests/reports/demo_clinic.hpp"
#include "tests/reports/paper_test.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::reports::report_test {
namespace {

namespace fs = std::filesystem;

/// Spaces of all kinds become one plain space, so that line breaks of a layout do not matter.
std::string plain(std::string text) {
  for (const std::string space : {"\u00a0", "\n", "\f"})
    for (auto at = text.find(space); at != std::string::npos; at = text.find(space))
      text.replace(at, space.size(), " ");
  std::string result;
  for (const char c : text)
    if (c != ' ' || (!result.empty() && result.back() != ' ')) result += c;
  return result;
}

class Report : public testing::Test {
 protected:
  void SetUp() override {
    test::draw_without_a_display();
    auto opened = storage::open_store(folder_.path("clinic.db"), storage::OpenMode::create);
    ASSERT_TRUE(opened.ok()) << opened.error().message();
    store_ = std::move(*opened);
  }

  ReportContent gather(const std::string& code) {
    auto content = gather_progress(*store_, code);
    EXPECT_TRUE(content.ok()) << (content.ok() ? "" : content.error().message());
    return content.ok() ? *content : ReportContent{};
  }

  /// Writes both forms; ISOGRASP_KEEP_REPORTS=FOLDER keeps a copy for looking at.
  void write(const ReportContent& content, const std::string& name) {
    pdf_ = folder_.path(name + ".pdf");
    html_ = folder_.path(name + ".html");
    const auto pdf_done = write_pdf(content, pdf_);
    ASSERT_TRUE(pdf_done.ok()) << pdf_done.error().message();
    const auto html_done = write_html(content, html_);
    ASSERT_TRUE(html_done.ok()) << html_done.error().message();
    if (const char* keep = std::getenv("ISOGRASP_KEEP_REPORTS"); keep != nullptr)
      for (const auto& file : {pdf_, html_})
        fs::copy_file(file, fs::path(keep) / fs::path(file).filename(),
                      fs::copy_options::overwrite_existing);
  }

  /// Text of page `page` of the PDF, all pages if 0; empty if there is no pdftotext.
  [[nodiscard]] std::string pdf_text(int page = 0) const {
    const std::string pages =
        page == 0 ? "" : "-f " + std::to_string(page) + " -l " + std::to_string(page);
    const std::string command =
        "pdftotext -layout " + pages + " '" + pdf_ + "' '" + folder_.path("text.txt") + "' 2>&1";
    if (std::system(command.c_str()) != 0) return "";
    return plain(test::read_file(folder_.path("text.txt")));
  }
  [[nodiscard]] static bool have_pdftotext() {
    return std::system("command -v pdftotext > /dev/null") == 0;
  }

  test::TemporaryFolder folder_;
  std::unique_ptr<storage::SessionStore> store_;
  std::string pdf_;
  std::string html_;
};

TEST_F(Report, ShowsTheStoredMeasuresAndNothingElse) {
  test::add_course(*store_, "TK-104", false);
  const auto content = gather("TK-104");
  const auto patient = store_->find_patient("TK-104");
  const auto points = store_->progress((*patient)->id);
  ASSERT_TRUE(points.ok());
  int series_seen = 0;
  for (const auto& section : test::every(content.sections))
    for (const auto& series : test::every(section.series)) {
      ++series_seen;
      std::vector<double> stored;
      for (const auto& point : *points)
        if (point.task_name == section.task && point.measure.name == series.name &&
            point.measure.channel == series.channel && !point.practice && point.measure.value)
          stored.push_back(*point.measure.value);
      std::vector<double> shown;
      for (const auto& value : series.values)
        shown.insert(shown.end(), value.trials.begin(), value.trials.end());
      EXPECT_EQ(shown, stored) << section.task << " " << series.name;
    }
  EXPECT_EQ(series_seen, 1 + 1 + 3 + 3);  // rest, maximum, sine, two targets
}

TEST_F(Report, BaselineIsTheMeanOfTheFirstTwoDays) {
  test::add_course(*store_, "TK-104", false);
  for (const auto& section : test::every(gather("TK-104").sections))
    for (const auto& series : test::every(section.series)) {
      ASSERT_EQ(series.values.size(), 6u);
      ASSERT_TRUE(series.baseline && series.last && series.change) << series.name;
      EXPECT_DOUBLE_EQ(*series.baseline, (*series.values[0].mean + *series.values[1].mean) / 2.0);
      EXPECT_DOUBLE_EQ(*series.last, *series.values[5].mean);
      EXPECT_DOUBLE_EQ(*series.change, *series.last - *series.baseline);
      EXPECT_TRUE(series.values[0].first_day);
      EXPECT_FALSE(series.values[1].first_day);
    }
}

TEST_F(Report, WithoutPrimaryMeasuresNothingGetsAVerdict) {
  test::add_course(*store_, "TK-104", false);
  for (const auto& section : test::every(gather("TK-104").sections))
    for (const auto& series : test::every(section.series))
      EXPECT_FALSE(series.verdict) << series.name;
}

TEST_F(Report, KeepsHandsApart) {
  test::DemoSession demo;
  test::add_session(*store_, "TK-2", demo);
  demo.hand = Hand::left;
  demo.date = "2026-03-09";
  test::add_session(*store_, "TK-2", demo);
  const auto content = gather("TK-2");
  EXPECT_EQ(content.sections.size(), 8u);
  for (const auto& section : test::every(content.sections))
    for (const auto& series : test::every(section.series))
      for (const auto& value : test::every(series.values))
        EXPECT_EQ(content.sessions[value.session].hand, section.hand);
}

TEST_F(Report, ComparesOnlyEqualTaskVersionsAndSources) {
  test::DemoSession demo;
  test::add_session(*store_, "TK-3", demo);
  demo.date = "2026-03-09";
  demo.task_version = 2;
  test::add_session(*store_, "TK-3", demo);
  demo.date = "2026-03-16";
  demo.simulated = true;
  test::add_session(*store_, "TK-3", demo);
  for (const auto& section : test::every(gather("TK-3").sections)) {
    for (const auto& series : test::every(section.series)) {
      if (section.task == "Two targets") continue;
      ASSERT_EQ(series.values.size(), 1u) << section.task << " " << series.name;
      EXPECT_EQ(series.values[0].session, 2u);
    }
    const auto all = [&] {
      std::string text;
      for (const auto& note : section.notes) text += english(note) + "\n";
      return text;
    }();
    EXPECT_NE(all.find("other source of forces"), std::string::npos) << section.task;
  }
}

TEST_F(Report, AFailedTargetDoesNotDropOutOfTheMeanTime) {
  tasks::MeasureWords words = tasks::words_of("completion_time", "target_5");
  EXPECT_TRUE(words.censored);
  test::DemoSession demo;
  demo.skill = 0.1;  // never reaches the fifth target
  test::add_session(*store_, "TK-4", demo);
  const auto content = gather("TK-4");
  const auto section = std::find_if(content.sections.begin(), content.sections.end(),
                                    [](const auto& s) { return s.task == "Two targets"; });
  ASSERT_NE(section, content.sections.end());
  EXPECT_NE(english(last_trial_results(*section)).find("not reached within 30 s"),
            std::string::npos);
  EXPECT_NE(english(last_trial_title(*section, content)).find("2\u00a0Mar"), std::string::npos);
}

TEST_F(Report, EveryPageOfSimulatedDataSaysSo) {
  test::add_course(*store_, "SIM-01", true);
  const auto content = gather("SIM-01");
  EXPECT_EQ(english(watermark(content)), "SIMULATED DEVICE");
  write(content, "simulated");
  EXPECT_NE(
      test::read_file(html_).find("<div class=\"watermark\" aria-hidden=\"true\">SIMULATED DEVICE"),
      std::string::npos);
  if (!have_pdftotext()) GTEST_SKIP() << "pdftotext is not installed";
  int pages = 0;
  for (int page = 1; page <= 9; ++page) {
    const auto text = pdf_text(page);
    if (text.empty()) break;
    ++pages;
    EXPECT_NE(text.find("SIMULATED DEVICE"), std::string::npos) << "page " << page;
  }
  EXPECT_GE(pages, 1);
  EXPECT_LE(pages, 6);
}

TEST_F(Report, MeasuredDataCarryNoWatermarkAndRecordedDataCarryTheirOwn) {
  test::DemoSession demo;
  test::add_session(*store_, "TK-5", demo);
  EXPECT_EQ(english(watermark(gather("TK-5"))), "");
  demo.recorded = true;
  test::add_session(*store_, "REC-1", demo);
  const auto content = gather("REC-1");
  EXPECT_EQ(english(watermark(content)), "REPLAYED RECORDING");
  write(content, "recorded");
  const auto html = test::read_file(html_);
  EXPECT_NE(html.find("a replayed recording, not measured with this device"), std::string::npos);
  EXPECT_NE(html.find("index sensor stands in for the thumb"), std::string::npos);
}

TEST_F(Report, PdfAndHtmlHoldTheSameNumbers) {
  test::add_course(*store_, "TK-104", false);
  const auto content = gather("TK-104");
  write(content, "course");
  const auto html = plain(test::read_file(html_));
  const auto pdf = pdf_text();
  const auto rows = glance_rows(content);
  EXPECT_EQ(rows.size(), 4u);
  for (const auto& row : test::every(rows))
    for (const auto& number : {row.baseline, row.last, row.change}) {
      EXPECT_NE(html.find(plain(number)), std::string::npos) << row.measure << " " << number;
      if (have_pdftotext()) {
        EXPECT_NE(pdf.find(plain(number)), std::string::npos) << row.measure << " " << number;
      }
    }
  for (const auto& line : test::every(content.quality)) {
    EXPECT_NE(html.find(plain(english(line.label))), std::string::npos);
    if (have_pdftotext()) {
      EXPECT_NE(pdf.find(plain(english(line.label))), std::string::npos);
    }
  }
}

TEST_F(Report, TheSameDataGiveTheSameReport) {
  test::add_course(*store_, "TK-104", false);
  write(gather("TK-104"), "first");
  const auto html = test::read_file(html_);
  const auto pdf = pdf_text();
  write(gather("TK-104"), "second");
  EXPECT_EQ(test::read_file(html_), html);
  EXPECT_EQ(pdf_text(), pdf);
}

TEST_F(Report, TheQualityBoxTellsFaultsGapsAndUnfinishedTrials) {
  test::add_course(*store_, "TK-104", false);
  std::map<std::string, QualityLine> lines;
  for (const auto& line : gather("TK-104").quality) lines[english(line.label)] = line;
  EXPECT_NE(english(lines["Instrument zero"].text).find("0.023 N"), std::string::npos);
  EXPECT_NE(english(lines["Samples"].text).find("held 1.8 %"), std::string::npos)
      << english(lines["Samples"].text);
  EXPECT_NE(english(lines["Samples"].text).find("lost on the way 2"), std::string::npos);
  EXPECT_TRUE(lines["Samples"].attention);
  EXPECT_NE(english(lines["Faults"].text).find("1 device fault"), std::string::npos);
  EXPECT_NE(english(lines["Trials"].text).find("7 of 8 completed"), std::string::npos);
  EXPECT_NE(english(lines["Trials"].text).find("aborted"), std::string::npos);
  EXPECT_NE(english(lines["Timing"].text).find("1.2 ms"), std::string::npos);
  EXPECT_NE(english(lines["Delay"].text).find("24.8 ms"), std::string::npos);
  EXPECT_FALSE(lines["Recomputed"].attention) << english(lines["Recomputed"].text);
}

TEST_F(Report, AnUnknownPatientIsAnErrorThatNamesTheCodeAndTheRemedy) {
  const auto content = gather_progress(*store_, "NOBODY-1");
  ASSERT_FALSE(content.ok());
  EXPECT_EQ(content.error().code, Error::Code::bad_input);
  EXPECT_NE(content.error().message().find("NOBODY-1"), std::string::npos);
  EXPECT_FALSE(content.error().remedy.empty());
}

TEST_F(Report, APatientWithoutTrialsGetsAReportThatSaysSo) {
  ASSERT_TRUE(store_->add_patient("NEW-1").ok());
  const auto content = gather("NEW-1");
  EXPECT_TRUE(content.sections.empty());
  write(content, "empty");
  EXPECT_NE(plain(test::read_file(html_)).find(english(nothing_yet())), std::string::npos);
}

TEST_F(Report, APathThatCannotBeWrittenLeavesNothing) {
  ASSERT_TRUE(store_->add_patient("NEW-1").ok());
  const auto content = gather("NEW-1");
  const auto blocker = folder_.write("file", "not a folder");
  for (const std::string& path : {folder_.path("absent/report.pdf"), blocker + "/report.pdf"}) {
    const auto done = write_pdf(content, path);
    ASSERT_FALSE(done.ok());
    EXPECT_EQ(done.error().file, path);
    EXPECT_FALSE(done.error().remedy.empty());
    EXPECT_FALSE(write_html(content, path).ok());
    EXPECT_FALSE(fs::exists(path));
  }
  EXPECT_EQ(test::read_file(blocker), "not a folder");
}

TEST(MeasureWords, NumbersArePrintedWithThreeDigitsAndAPrintedUnit) {
  EXPECT_EQ(tasks::format_value(12.345, "N"), "12.3");
  EXPECT_EQ(tasks::format_value(0.18462, "s"), "0.185");
  EXPECT_EQ(tasks::format_value(0.0, "N"), "0");
  EXPECT_EQ(tasks::format_value(5.0, "of 5"), "5");
  EXPECT_EQ(tasks::format_value(0.0123, "m"), "12.3");
  EXPECT_EQ(tasks::format_change(-4.2, "%"), "\u22124.20");
  EXPECT_EQ(tasks::format_change(4.2, "%"), "+4.20");
  EXPECT_EQ(tasks::format_value(3.14159265358979, "rad"), "180");
}

}  // namespace
}  // namespace isograsp::reports::report_test
