// SPDX-License-Identifier: GPL-3.0-or-later
// Where things stand on paper and on the web: nothing lies on something else, nothing runs off the
// page, and a narrow screen shows all that a wide one does.
#include <QRegularExpression>
#include <cctype>
#include <cstdlib>
#include <map>

#include <gtest/gtest.h>

#include "languages/languages.hpp"
#include "reports/findings/progress_report.hpp"
#include "reports/paper/html_writer.hpp"
#include "reports/paper/panel.hpp"
#include "reports/paper/pdf_content.hpp"
#include "reports/paper/plots.hpp"
#include "reports/paper/plotting.hpp"
#include "storage/access/open_store.hpp"
#include "tests/reports/demo_clinic.hpp"
#include "tests/reports/painted_page.hpp"
#include "tests/reports/paper_test.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::reports::layout_test {
namespace {

using test::painted;

class Layout : public test::PaperTest {
 protected:
  static void SetUpTestSuite() {
    open_clinic();
    test::add_course(*store_, "TK-104", true);
    const storage::RowId id = store_->find_patient("TK-104")->value().id;
    ASSERT_TRUE(store_
                    ->set_profile(id, {storage::Side::right, Hand::right, "2025-01-05", "",
                                       "Hold a cup of tea without spilling"})
                    .ok());
    ASSERT_TRUE(store_->add_clinical_score(id, {0, "2026-03-01", "ARAT", 31.0, ""}).ok());
  }

  /// All that can make a page full: verdicts with wide limits, treatments close together, norms.
  static ReportContent rich() {
    auto content = gather_progress(*store_, "TK-104").value();
    content.primary_measures = 4;
    for (auto& section : content.sections)
      for (auto& series : section.series) {
        if (!series.key) continue;
        ChangeVerdict verdict;
        verdict.change.verdict = Verdict::within_error;
        verdict.change.baseline = series.baseline;
        verdict.change.last = series.last;
        verdict.change.change = series.change;
        verdict.change.mdc_down = -0.987 * std::abs(series.baseline.value_or(1.0));
        verdict.change.mdc_up = 123.4 * std::abs(series.baseline.value_or(1.0));
        verdict.people = 12;
        verdict.chosen_by = "Dr Example";
        verdict.chosen_on = "2026-03-03";
        series.verdict = verdict;
        series.norm =
            NormBand{"women of %1 to %2, dominant hand"_text(60, 69), {20.0, 30.0}, 20.0, 30.0};
      }
    content.treatments = {{1, "2026-03-10", "botulinum_toxin", "flexors"},
                          {2, "2026-03-10", "orthosis", "at night"},
                          {3, "2026-03-10", "therapy", ""},
                          {4, "2026-03-17", "drug", "baclofen"},
                          {5, "2026-03-24", "other", ""}};
    return content;
  }
};

std::string joined(const std::vector<QString>& lines) {
  QString all;
  for (const auto& line : lines) all += line + "\n";
  return all.toStdString();
}

constexpr double kSlack = 0.5;  // points
const QRectF kInside(pdf::kSide - kSlack, 20.0, pdf::kWidth + 2.0 * kSlack,
                     pdf::kPageHeight - 2.0 * 20.0);

/// What `rich` has and says, in each language of the program.
class LayoutIn : public Layout, public testing::WithParamInterface<languages::LanguageFacts> {
 protected:
  [[nodiscard]] static const Language& language() { return languages::language(GetParam().code); }
  [[nodiscard]] static QString said(const Text& text) {
    return QString::fromStdString(translated(text, language()));
  }
};
INSTANTIATE_TEST_SUITE_P(, LayoutIn, testing::ValuesIn(languages::kLanguages),
                         [](const auto& language) { return std::string(language.param.code); });

TEST_P(LayoutIn, NoTextLiesOnAnother) {
  const ReportPages pages(rich(), language());
  for (const int page : test::every(test::all_pages(pages))) {
    const auto pairs = overprinted(painted(pages, page));
    EXPECT_TRUE(pairs.empty()) << "page " << page + 1 << "\n" << joined(pairs);
  }
}

TEST_P(LayoutIn, NoTextLeavesItsMargins) {
  const ReportPages pages(rich(), language());
  for (const int page : test::every(test::all_pages(pages)))
    for (const auto& text : test::every(painted(pages, page).texts)) {
      if (text.slanted) continue;
      EXPECT_TRUE(kInside.contains(text.box))
          << "page " << page + 1 << ": " << text.text.toStdString() << " at " << text.box.x()
          << ", " << text.box.y() << " to " << text.box.right();
    }
}

/// None of whose words has a letter of English.
class Foreign : public Language {
 public:
  [[nodiscard]] std::string_view words(std::string_view english) const override {
    std::string& said = said_[std::string(english)];
    if (!said.empty()) return said;
    for (const char c : english)
      if (std::isalpha(static_cast<unsigned char>(c)) != 0)
        said += "\u0416";
      else
        said += c;
    return said;
  }

 private:
  mutable std::map<std::string, std::string> said_;
};

TEST_F(Layout, NothingOnPaperIsSaidInEnglishAlone) {
  static const Foreign kForeign;
  const ReportPages pages(rich(), kForeign);
  // Names, units, and what people wrote.
  static const QRegularExpression kAsItIs(
      "IsoGrasp|TK-104|Dr Example|Hold a cup of tea without spilling|mm|ms");
  static const QRegularExpression kWord("[A-Za-z]{2,}");
  for (const int page : test::every(test::all_pages(pages)))
    for (const auto& text : test::every(painted(pages, page).texts)) {
      QString rest = text.text;
      rest.remove(kAsItIs);
      EXPECT_FALSE(rest.contains(kWord)) << "page " << page + 1 << ": " << text.text.toStdString();
    }
}

TEST_P(LayoutIn, LimitsOfMeasurementErrorKeepToTheirColumn) {
  const ReportPages pages(rich(), language());
  const QString verdict = said("Verdict"_text);
  double verdict_x = 0.0;
  double widest = 0.0;
  for (const int page : test::every(test::all_pages(pages)))
    for (const auto& text : painted(pages, page).texts) {
      if (text.text == verdict) verdict_x = text.box.left();
      // "+2345678 N": the last line of a limit
      if (text.text.startsWith("MDC95")) widest = std::max(widest, text.box.right());
    }
  ASSERT_GT(verdict_x, 0.0);
  ASSERT_GT(widest, 0.0);
  EXPECT_LT(widest, verdict_x);
}

TEST_F(Layout, ATableThatGoesOnRepeatsItsHead) {
  auto content = rich();
  for (int copy = 0; copy < 4; ++copy) content.sections.push_back(content.sections.back());
  const ReportPages pages(content);
  int with_rows = 0;
  for (const int page : test::every(test::all_pages(pages))) {
    const auto all = painted(pages, page);
    const auto on_page = [&](const char* words) {
      return std::any_of(all.texts.begin(), all.texts.end(),
                         [&](const auto& text) { return text.text.startsWith(words); });
    };
    if (!on_page("MDC95")) continue;
    ++with_rows;
    EXPECT_TRUE(on_page("Verdict")) << "page " << page + 1;
  }
  EXPECT_GE(with_rows, 2);
}

TEST_F(Layout, HealthyPeopleFarAwayLeaveTheCourseItsScale) {
  auto content = rich();
  TaskSection& section =
      *std::find_if(content.sections.begin(), content.sections.end(),
                    [](const auto& one) { return one.task == "Maximum grip force"; });
  MeasureSeries& series = section.series.front();
  series.verdict.reset();
  const auto upper = [&](double low, double high) {
    series.norm = NormBand{{}, {low, high}, low, high};
    PlotView view = trend_plot(series, section, content, QSizeF(200.0, 100.0), 1.0);
    return view.plot().axisRect(0)->axis(QCPAxis::atLeft)->range().upper;
  };
  const double most = *series.last * 10.0 + 1.0;
  const double without = upper(1e3 * most, 2e3 * most);
  EXPECT_LT(without, 1e3 * most);
  const double near = 1.05 * without;
  EXPECT_GE(upper(0.9 * near, near), near) << "those that are near stand on the scale";
}

TEST_F(Layout, NoLineGoesThroughTheLetterOfATreatment) {
  const ReportPages pages(rich());
  int letters = 0;
  for (const int page : test::every(test::all_pages(pages))) {
    const auto all = painted(pages, page);
    for (const auto& text : test::every(all.texts)) {
      if (text.text.size() != 1 || !QString("BOTDX").contains(text.text)) continue;
      ++letters;
      for (const QLineF& line : test::every(all.lines)) {
        const QRectF core = text.box.adjusted(0.3, 0.3, -0.3, -0.3);
        // Straight lines and those of the values: cut by a side or inside.
        const QLineF sides[] = {{core.topLeft(), core.topRight()},
                                {core.topRight(), core.bottomRight()},
                                {core.bottomRight(), core.bottomLeft()},
                                {core.bottomLeft(), core.topLeft()}};
        const bool cut = core.contains(line.p1()) || core.contains(line.p2()) ||
                         std::any_of(std::begin(sides), std::end(sides), [&](const QLineF& side) {
                           QPointF ignored;
                           return line.intersects(side, &ignored) == QLineF::BoundedIntersection;
                         });
        EXPECT_FALSE(cut) << "page " << page + 1 << ": " << text.text.toStdString() << " at "
                          << text.box.x() << ", " << text.box.y();
        if (cut) break;
      }
    }
  }
  EXPECT_GE(letters, 5) << "of each trend";
}

/// Everything but the footer itself ends above the footer.
void expect_above_footer(const ReportPages& pages) {
  for (const int page : test::every(test::all_pages(pages)))
    for (const auto& text : test::every(painted(pages, page).texts))
      if (!text.slanted && text.box.bottom() > pdf::kPageHeight - pdf::kBottom + kSlack) {
        EXPECT_GT(text.box.top(), pdf::kPageHeight - 46.0)
            << "page " << page + 1 << ": " << text.text.toStdString() << " at " << text.box.y();
      }
}

TEST_P(LayoutIn, ThePageForThePatientEndsAboveItsFooter) {
  auto content = rich();
  content.goals =
      "Hold a cup of tea without spilling, open the door of the flat with the key in the right "
      "hand, write a postcard to the grandchildren and carry the shopping bag home from the corner";
  const ReportPages pages(content, language());
  const QString week = said("week"_text);
  expect_above_footer(pages);
  const auto last = painted(pages, pages.pages() - 1);
  EXPECT_TRUE(std::any_of(last.texts.begin(), last.texts.end(), [&](const auto& text) {
    return text.text == week && text.box.height() > 8.0;
  })) << "the picture is on the page of the patient";
}

TEST_P(LayoutIn, MinutesOfAShortPracticeAreNamedInsideThePageForThePatient) {
  auto content = rich();
  ASSERT_FALSE(content.dose.weeks.empty());
  for (auto& week : content.dose.weeks) week.active_s = 33.0;  // ticks "0.25", "0.5", "0.75"
  const ReportPages pages(content, language());
  const QString minutes = said("minutes"_text);
  const QString half = QString::fromStdString(language().number("0.5"));
  bool written = false;
  int named = 0;
  for (const auto& text : painted(pages, pages.pages() - 1).texts) {
    written = written || text.text == half;
    if (text.text != minutes) continue;
    ++named;
    EXPECT_TRUE(kInside.contains(text.box)) << text.box.x() << " to " << text.box.right();
  }
  EXPECT_EQ(named, 1);
  EXPECT_TRUE(written) << "the axis writes numbers as the language does";
}

TEST_F(Layout, WhatFitsOnNoPageGoesOnOnTheNext) {
  auto content = rich();
  for (int i = 0; i < 90; ++i)
    content.goals += "One more thing that this person would like to do again, number " +
                     std::to_string(i) + ". ";
  const ReportPages pages(content);
  expect_above_footer(pages);
  for (const int page : test::every(test::all_pages(pages))) {
    const auto pairs = overprinted(painted(pages, page));
    EXPECT_TRUE(pairs.empty()) << "page " << page + 1 << "\n" << joined(pairs);
  }
}

TEST_F(Layout, EveryCellOfATableOnTheWebSaysItsColumnWhereThereIsNoHead) {
  const std::string path = folder_->path("narrow.html");
  ASSERT_TRUE(write_html(rich(), path).ok());
  const auto html = QString::fromStdString(test::read_file(path));
  const int begin = html.indexOf("<caption>Key measures");
  ASSERT_GT(begin, 0);
  const QString table = html.mid(begin, html.indexOf("</table>", begin) - begin);
  QStringList heads;
  for (auto head = QRegularExpression("<th[^>]*scope=\"col\"[^>]*>([^<]*)</th>").globalMatch(table);
       head.hasNext();)
    heads.push_back(head.next().captured(1));
  ASSERT_EQ(heads.size(), 6);
  for (const QString& row : test::every(table.split("<tr").mid(2))) {
    QStringList labels;
    for (auto cell = QRegularExpression("<t[dh][^>]*data-head=\"([^\"]*)\"").globalMatch(row);
         cell.hasNext();)
      labels.push_back(cell.next().captured(1));
    EXPECT_EQ(labels, heads) << row.toStdString();
  }
  // On a narrow screen rows become blocks with these words, and the badge leaves the code alone.
  const int narrow = html.indexOf("@media (max-width:");
  ASSERT_GT(narrow, 0);
  const QString rules = html.mid(narrow, html.indexOf("</style>") - narrow);
  for (const char* rule : {"attr(data-head)", ".badge { position: static", "display: block"})
    EXPECT_TRUE(rules.contains(rule)) << rule;
}

}  // namespace
}  // namespace isograsp::reports::layout_test
