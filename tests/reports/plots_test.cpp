// SPDX-License-Identifier: GPL-3.0-or-later
// A plot of a long trial holds fewer points than samples, and looks the same.
#include "reports/paper/plots.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>

#include "reports/paper/plot_tools.hpp"
#include "tests/reports/paper_test.hpp"
#include "tests/support/every.hpp"

namespace isograsp::reports::plots_test {
namespace {

TEST(VisibleRows, KeepFirstLastSmallestAndLargestOfEveryBin) {
  constexpr int kCount = 1000;
  constexpr int kBins = 7;
  Values values;
  for (int i = 0; i < kCount; ++i) values.push_back(std::sin(0.37 * i) + 0.001 * i);
  const auto rows = visible_rows(values, kBins);
  EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end()));
  EXPECT_EQ(std::adjacent_find(rows.begin(), rows.end()), rows.end()) << "a row twice";
  EXPECT_LE(rows.size(), 4 * kBins);
  for (int bin = 0; bin < kBins; ++bin) {
    const int first = kCount * bin / kBins;
    const int end = kCount * (bin + 1) / kBins;
    const auto best = std::minmax_element(values.begin() + first, values.begin() + end);
    for (const auto index : {static_cast<long>(first), static_cast<long>(end - 1),
                             best.first - values.begin(), best.second - values.begin()})
      EXPECT_TRUE(rows.contains(static_cast<int>(index))) << bin << ": " << index;
  }
}

TEST(VisibleRows, AreAllRowsWhereThereAreFewAndKeepEveryGap) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Values few{3.0, nan, 1.0, 2.0};
  EXPECT_EQ(visible_rows(few, 100), (QVector<int>{0, 1, 2, 3}));
  Values gap(300, 1.0);
  for (int i = 100; i < 130; ++i) gap[i] = nan;
  const auto shown = picked(gap, visible_rows(gap, 10));
  EXPECT_TRUE(std::any_of(shown.begin(), shown.end(), [](double v) { return std::isnan(v); }));
  EXPECT_TRUE(visible_rows({}, 10).isEmpty());
}

TEST(OverlayPlot, OfALongTrialKeepsItsExtremesAndADetailForEachPointOfItsWidth) {
  test::draw_without_a_display();
  constexpr std::size_t kRows = 60000;  // ten minutes
  std::vector<double> t_s;
  std::vector<double> force;
  for (std::size_t i = 0; i < kRows; ++i) {
    t_s.push_back(static_cast<double>(i) / 100.0);
    force.push_back(10.0 + 3.0 * std::sin(t_s.back()));
  }
  force[12345] = 25.0;  // a peak of a single sample
  TaskSection section;
  section.last = DrawnTrial{};
  section.last->curves.add_column("t_s", t_s);
  section.last->curves.add_column("phase", std::vector<double>(kRows, 0.0));
  section.last->curves.add_column("target_force_N", std::vector<double>(kRows, 10.0));
  section.last->curves.add_column("actual_force_N", force);

  constexpr double kWidth = 400.0;
  PlotView view = overlay_plot(section, *section.last, QSizeF(kWidth, 100.0), 1.0);
  const QCPGraph* actual = view.plot().graph(view.plot().graphCount() - 1);
  ASSERT_NE(actual, nullptr);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const auto& point : *actual->data()) {
    low = std::min(low, point.value);
    high = std::max(high, point.value);
  }
  EXPECT_EQ(low, *std::min_element(force.begin(), force.end()));
  EXPECT_EQ(high, 25.0);
  EXPECT_GT(actual->dataCount(), static_cast<int>(kWidth / 2.0));
  EXPECT_LE(actual->dataCount(), static_cast<int>(4.0 * kWidth));
}

/// A series that is judged: `baseline`, and changes from -2 to 3 that are no larger than the error.
MeasureSeries judged(const std::string& name, double baseline) {
  MeasureSeries series;
  series.name = name;
  series.verdict = ChangeVerdict{};
  series.verdict->change.baseline = baseline;
  series.verdict->change.mdc_down = -2.0;
  series.verdict->change.mdc_up = 3.0;
  return series;
}
std::vector<std::pair<double, double>> bands_of(const MeasureSeries& series) {
  std::vector<std::pair<double, double>> bands;
  for (const auto& band : error_bands(series)) bands.emplace_back(band.low, band.high);
  return bands;
}

TEST(ErrorBands, OfMeasuresThatAreBestNearZeroStandOnBothSidesOfIt) {
  using Bands = std::vector<std::pair<double, double>>;
  EXPECT_EQ(bands_of(judged("maximum_force", 10.0)), (Bands{{8.0, 13.0}}));
  EXPECT_EQ(bands_of(judged("lag", 10.0)), (Bands{{8.0, 13.0}, {-13.0, -8.0}}));
  EXPECT_EQ(bands_of(judged("lag", -10.0)), (Bands{{-13.0, -8.0}, {8.0, 13.0}}));
  EXPECT_EQ(bands_of(judged("lag", 1.0)), (Bands{{-4.0, 4.0}})) << "they meet at zero";
  EXPECT_TRUE(error_bands(MeasureSeries{}).empty());
}

TEST(TrendPlot, OfAPartHasItsSessionsOnItsAxisAndTreatmentsBetweenThem) {
  test::draw_without_a_display();
  ReportContent content;
  MeasureSeries series;
  series.name = "maximum_force";
  series.unit = "N";
  for (int number = 11; number <= 15; ++number) {
    ReportSession session;
    session.number = number;
    session.date = "2026-03-" + std::to_string(number);
    content.sessions.push_back(session);
    series.values.push_back({static_cast<std::size_t>(number - 11), {10.0}, 0, 10.0, false});
  }
  const auto plot = [&] {
    return trend_plot(series, TaskSection{}, content, QSizeF(200, 100), 1.0);
  };
  PlotView plain = plot();
  const QCPRange range = plain.plot().axisRect(0)->axis(QCPAxis::atBottom)->range();
  for (const auto& session : test::every(content.sessions))
    EXPECT_TRUE(range.contains(session.number));
  EXPECT_FALSE(range.contains(1.0));
  content.treatments = {{1, "2026-03-09", "drug", ""},      // before all that is shown
                        {2, "2026-03-12", "orthosis", ""},  // on the day of a session: before it
                        {3, "2026-03-12", "therapy", ""},
                        {4, "2026-03-20", "other", ""}};
  PlotView marked = plot();
  EXPECT_EQ(marked.plot().itemCount(), plain.plot().itemCount() + 2) << "a letter for each";
  const auto* letter = qobject_cast<QCPItemText*>(marked.plot().item(0));
  ASSERT_NE(letter, nullptr);
  EXPECT_EQ(letter->text(), "O");
  EXPECT_EQ(letter->position->key(), 11.5);
}

}  // namespace
}  // namespace isograsp::reports::plots_test
