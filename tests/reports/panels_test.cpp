// SPDX-License-Identifier: GPL-3.0-or-later
// Goals, limits, dose, signature and the page for the patient: the same on paper and on the web; no
// jargon where the patient reads; breaks, practice and treatments in the trends.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "reports/findings/progress_report.hpp"
#include "reports/paper/html_writer.hpp"
#include "reports/paper/panel.hpp"
#include "reports/paper/pdf_writer.hpp"
#include "reports/paper/plots.hpp"
#include "storage/access/open_store.hpp"
#include "tests/reports/demo_clinic.hpp"
#include "tests/reports/paper_test.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/within.hpp"

namespace isograsp::reports::panels_test {
namespace {

/// Letters and digits only: lines are broken, and ligatures of the PDF made two letters again.
std::string bare(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.compare(i, 3, "\ufb01") == 0) result += "fi";
    if (text.compare(i, 3, "\ufb02") == 0) result += "fl";
    if (text.compare(i, 3, "\ufb00") == 0) result += "ff";
    if (text.compare(i, 3, "\ufb03") == 0) result += "ffi";
    if (std::isalnum(static_cast<unsigned char>(text[i])) != 0) result += text[i];
  }
  return result;
}

class Panels : public test::PaperTest {
 protected:
  static void SetUpTestSuite() {
    open_clinic();
    test::add_course(*store_, "TK-104", false);
    test::DemoSession healthy;
    healthy.hand = Hand::left;
    healthy.date = "2026-04-08";
    healthy.skill = 1.2;
    test::add_session(*store_, "TK-104", healthy);
    const storage::RowId id = store_->find_patient("TK-104")->value().id;
    ASSERT_TRUE(store_
                    ->set_profile(id, {storage::Side::right, Hand::right, "2025-01-05", "",
                                       "Hold a cup of tea without spilling"})
                    .ok());
    ASSERT_TRUE(
        store_->add_treatment_mark(id, {0, "2026-03-20", "botulinum_toxin", "flexors"}).ok());
    ASSERT_TRUE(store_->add_clinical_score(id, {0, "2026-03-01", "ARAT", 31.0, ""}).ok());
    ASSERT_TRUE(store_->add_clinical_score(id, {0, "2026-04-08", "ARAT", 40.0, ""}).ok());
  }
  static ReportContent content(const ReportScope& scope = {}) {
    return gather_progress(*store_, "TK-104", {}, scope).value();
  }
  static std::vector<Panel> all_panels(const ReportContent& content) {
    auto panels = panels_above(content, kEnglish);
    for (const auto& more : {panels_between(content, kEnglish), panels_below(content, kEnglish)})
      panels.insert(panels.end(), more.begin(), more.end());
    return panels;
  }
  static const TaskSection& section(const ReportContent& content, const std::string& task) {
    return *std::find_if(content.sections.begin(), content.sections.end(), [&](const auto& one) {
      return one.task == task && one.hand == Hand::right;
    });
  }
};

TEST_F(Panels, SayTheSameInPdfAndHtml) {
  const auto what = content();
  const std::string html = folder_->path("panels.html");
  const std::string pdf = folder_->path("panels.pdf");
  ASSERT_TRUE(write_html(what, html).ok());
  ASSERT_TRUE(write_pdf(what, pdf).ok());
  if (const char* keep = std::getenv("ISOGRASP_KEEP_REPORTS"); keep != nullptr)
    for (const auto& file : {pdf, html})
      std::filesystem::copy_file(
          file, std::filesystem::path(keep) / std::filesystem::path(file).filename(),
          std::filesystem::copy_options::overwrite_existing);
  std::vector<std::string> said;
  for (const auto& panel : all_panels(what)) {
    said.push_back(panel.heading);
    for (const auto* texts : {&panel.lines, &panel.notes, &panel.blanks})
      said.insert(said.end(), texts->begin(), texts->end());
    for (const auto& plot : panel.plots) said.push_back(plot.title);
    if (panel.table)
      for (const auto& row : panel.table->rows) said.push_back(row.at(1));
  }
  EXPECT_GE(said.size(), 30u);
  const auto page = bare(test::read_file(html));
  for (const auto& text : test::every(said))
    EXPECT_NE(page.find(bare(text.substr(0, text.find('\n')))), std::string::npos) << text;
  const std::string command = "pdftotext '" + pdf + "' '" + folder_->path("text.txt") + "' 2>&1";
  if (std::system(command.c_str()) != 0) GTEST_SKIP() << "pdftotext is not installed";
  const auto paper = bare(test::read_file(folder_->path("text.txt")));
  for (const auto& text : test::every(said))
    EXPECT_NE(paper.find(bare(text.substr(0, text.find('\n')))), std::string::npos) << text;
}

TEST_F(Panels, ThePatientReadsPlainWordsAndOnePicture) {
  const auto what = content();
  const auto page = patient_page(what, kEnglish);
  EXPECT_TRUE(page.large_print);
  EXPECT_EQ(page.plots.size(), 1u);
  EXPECT_FALSE(page.table.has_value());
  std::string text;
  for (const auto& line : page.lines) text += line + "\n";
  EXPECT_NE(text.find("cup of tea"), std::string::npos);
  EXPECT_NE(text.find("You practised on 6 days"), std::string::npos) << text;
  for (const char* jargon : {"RMS", "MDC", "%", "interval", "baseline", "measure", "verdict", " N"})
    EXPECT_EQ(text.find(jargon), std::string::npos) << jargon;
}

TEST_F(Panels, EveryTableHasAWidthForEveryColumnAndFillsThePage) {
  test::AtLeast tables(2);
  for (const auto& panel : test::every(all_panels(content())))
    if (panel.table) {
      ++tables;
      double sum = 0.0;
      for (const double share : panel.table->shares) sum += share;
      EXPECT_WITHIN(sum, 1.0, 1e-9) << panel.heading;
      EXPECT_EQ(panel.table->shares.size(), panel.table->heads.size());
      for (const auto& row : test::every(panel.table->rows))
        EXPECT_EQ(row.size(), panel.table->heads.size()) << panel.heading;
    }
}

TEST_F(Panels, TheBestAndTheWorstTrialAreThoseOfTheSeries) {
  const auto what = content();
  const auto& sine = section(what, "Grip force, sine");
  ASSERT_TRUE(sine.best && sine.worst);
  const auto error = [](const DrawnTrial& trial) {
    return *std::find_if(trial.measures.begin(), trial.measures.end(), [](const auto& m) {
              return m.name == "relative_rmse";
            })->value;
  };
  double least = 1e9;
  double most = 0.0;
  const auto series = std::find_if(sine.series.begin(), sine.series.end(),
                                   [](const auto& one) { return one.name == "relative_rmse"; });
  for (const auto& value : series->values)
    for (const double trial : value.trials) {
      least = std::min(least, trial);
      most = std::max(most, trial);
    }
  EXPECT_EQ(error(*sine.best), least);
  EXPECT_EQ(error(*sine.worst), most);
  EXPECT_FALSE(section(what, "Two targets").best) << "only of force tasks";
}

TEST_F(Panels, PracticeStandsInTheTrendAndInNoValue) {
  const auto what = content();
  const auto& sine = section(what, "Grip force, sine");
  for (const auto& series : test::every(sine.series)) {
    EXPECT_EQ(series.practice.size(), 6u) << series.name;
    for (const auto& value : test::every(series.values)) EXPECT_EQ(value.trials.size(), 2u);
  }
}

TEST_F(Panels, OtherConditionsAreABreakWhereTheyBegin) {
  test::DemoSession demo;
  for (const auto& [date, version] :
       {std::pair{"2026-03-02", 1}, {"2026-03-09", 2}, {"2026-03-16", 2}, {"2026-03-23", 1}}) {
    demo.date = date;
    demo.task_version = version;
    test::add_session(*store_, "TK-BR1", demo);
  }
  const auto what = gather_progress(*store_, "TK-BR1").value();
  const auto& grip = section(what, "Maximum grip force");
  ASSERT_EQ(grip.breaks.size(), 2u);
  EXPECT_EQ(grip.breaks[0].session, 1u);
  EXPECT_EQ(grip.breaks[1].session, 3u);
  EXPECT_EQ(english(grip.breaks[0].reason), "other version of the task");
  EXPECT_EQ(grip.series[0].values.size(), 2u) << "equal conditions are compared across them";
}

}  // namespace
}  // namespace isograsp::reports::panels_test
