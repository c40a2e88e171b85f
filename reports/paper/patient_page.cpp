// SPDX-License-Identifier: GPL-3.0-or-later
// What the patient takes home. Says better or worse only where a verdict does; no numbers of
// measures, no names of tests.
#include <algorithm>
#include <cmath>

#include "reports/paper/panel.hpp"
#include "reports/paper/plot_tools.hpp"
#include "reports/paper/plots.hpp"
#include "reports/paper/plotting.hpp"

namespace isograsp::reports {

namespace {

/// Everyday words for what a primary measure is about.
std::string plain_name(const MeasureSeries& series) {
  struct Plain {
    std::string_view measure;
    std::string_view channel;  ///< its end; empty: any
    std::string_view words;
  };
  constexpr Plain kPlain[] = {{"maximum_force", "opening", "how strongly you open your hand"},
                              {"opening_force", "", "how strongly you open your hand"},
                              {"maximum_force", "grip", "how strongly you grip"},
                              {"maximum_force", "pinch", "how strongly you pinch"},
                              {"maximum_force", "", "how strongly you press"},
                              {"maximum_window_mean", "", "how strongly you press"},
                              {"release", "", "how soon you let go"},
                              {"residual", "", "how fully you let go"},
                              {"relative_rmse", "", "how closely you follow the line"},
                              {"rmse", "", "how closely you follow"},
                              {"time_in_range", "", "how closely you follow the line"},
                              {"cv", "", "how steadily you hold"},
                              {"individuation", "", "moving one finger alone"},
                              {"direction", "", "pressing in the right direction"},
                              {"reaction", "", "how soon you start"},
                              {"targets_reached", "", "moving the block"},
                              {"tilt", "", "keeping the block level"},
                              {"completion", "", "moving the block"},
                              {"median_completion", "", "moving the block"}};
  for (const Plain& plain : kPlain)
    if (series.name.starts_with(plain.measure) && series.channel.ends_with(plain.channel))
      return std::string(plain.words);
  return "what we measure together";
}

std::string in_plain_words(const MeasureSeries& series, Hand hand) {
  const std::string what = plain_name(series) + " (" + std::string(name_of(hand)) + " hand)";
  const auto& change = series.verdict->change;
  switch (change.verdict) {
    case Verdict::improved:
      return change.confirmed ? "Better than at the start: " + what + "."
                              : "Perhaps better than at the start: " + what + ". We look again.";
    case Verdict::worsened:
      return change.confirmed
                 ? "Harder than at the start: " + what + ". Talk about it with your therapist."
                 : "Perhaps harder than at the start: " + what + ". We look again.";
    case Verdict::within_error: return "About the same as at the start: " + what + ".";
    case Verdict::cannot_be_judged: break;
  }
  return "We do not know yet: " + what + ".";
}

std::string_view plain_name(Component component) {
  constexpr std::array<std::string_view, kComponentCount> kPlain{"to grip more strongly",
                                                                 "to open the hand",
                                                                 "to let go",
                                                                 "to follow with an even force",
                                                                 "to move one finger alone",
                                                                 "to press in the right direction"};
  return kPlain[static_cast<std::size_t>(component)];
}

}  // namespace

Panel patient_page(const ReportContent& content) {
  Panel panel;
  panel.large_print = true;
  panel.heading = "Your hand";
  const PracticeDose& dose = content.dose;
  if (!content.goals.empty()) panel.lines.push_back("Your goal: " + content.goals);
  panel.lines.push_back("You practised on " + std::to_string(dose.days) +
                        (dose.days == 1 ? " day" : " days") + ", for " +
                        std::to_string(std::lround(dose.active_s / 60.0)) + " minutes in all.");
  for (const auto& section : content.sections)
    for (const auto& series : section.series) {
      if (!series.verdict) continue;
      auto line = in_plain_words(series, section.hand);
      if (std::find(panel.lines.begin(), panel.lines.end(), line) == panel.lines.end())
        panel.lines.push_back(std::move(line));
    }
  if (const auto* main = main_limit(content.limits))
    panel.lines.push_back("Next we practise " + std::string(plain_name(main->component)) +
                          " with the " + std::string(name_of(content.limits.hand)) + " hand.");
  if (!dose.weeks.empty())
    panel.plots.push_back(
        {"Minutes of practice, week by week",
         "One bar for each week, as long as its minutes of practice.", 1.0, 230.0,
         [&dose](QSizeF size, double unit) { return dose_plot(dose, true, size, unit); }});
  return panel;
}

PlotView dose_plot(const PracticeDose& dose, bool large, QSizeF size, double unit) {
  PlotView view(size, unit);
  const double font = large ? 15.0 : 6.8;
  const double left = large ? 68.0 : kLeft;  // "0.75" and the name of the axis
  const double below = large ? 58.0 : kBelow;
  QCPAxisRect& rect =
      view.add_axes({left, 6.0, size.width() - left - kRight, size.height() - 6.0 - below});
  auto* bars = new QCPBars(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
  const QColor color = Palette::of(Hand::right);
  bars->setBrush(color);
  bars->setPen(Qt::NoPen);
  bars->setWidth(0.7);
  double most = 1.0;
  for (const auto& week : dose.weeks) {
    const double minutes = week.active_s / 60.0;
    bars->addData(week.week, minutes);
    most = std::max(most, minutes);
  }
  const int first = dose.weeks.front().week;
  const int last = dose.weeks.back().week;
  constexpr int kLeastSpan = 6;  // weeks: a single one is no wall
  rect.axis(QCPAxis::atBottom)->setRange(first - 0.6, std::max(last, first + kLeastSpan - 1) + 0.6);
  constexpr double kAir = 1.1;
  rect.axis(QCPAxis::atLeft)->setRange(0.0, kAir * most);
  rect.axis(QCPAxis::atLeft)->setLabel("minutes");
  rect.axis(QCPAxis::atBottom)->setLabel("week");
  auto ticker = QSharedPointer<QCPAxisTickerText>::create();
  const int most_ticks = large ? 10 : 26;
  const int step = 1 + (last - first) / most_ticks;
  for (int week = first; week <= last; week += step) ticker->addTick(week, QString::number(week));
  rect.axis(QCPAxis::atBottom)->setTicker(ticker);
  for (const auto side : {QCPAxis::atBottom, QCPAxis::atLeft}) {
    rect.axis(side)->setTickLabelFont(report_font(view.px(font), false));
    rect.axis(side)->setLabelFont(report_font(view.px(font), false));
    if (large) rect.axis(side)->setTickLabelColor(Palette::ink());
    if (large) rect.axis(side)->setLabelColor(Palette::ink());
  }
  return view;
}

}  // namespace isograsp::reports
