// SPDX-License-Identifier: GPL-3.0-or-later
// What the patient takes home. Says better or worse only where a verdict does; no numbers of
// measures, no names of tests.
#include <algorithm>
#include <array>
#include <cmath>

#include "reports/paper/panel.hpp"
#include "reports/paper/plot_tools.hpp"
#include "reports/paper/plots.hpp"
#include "reports/paper/plotting.hpp"

namespace isograsp::reports {

namespace {

/// Everyday words for what a primary measure is about.
Words plain_name(const MeasureSeries& series) {
  struct Plain {
    std::string_view measure;
    std::string_view channel;  ///< its end; empty: any
    Words words;
  };
  constexpr Plain kPlain[] = {{"maximum_force", "opening", "how strongly you open your hand"_text},
                              {"opening_force", "", "how strongly you open your hand"_text},
                              {"maximum_force", "grip", "how strongly you grip"_text},
                              {"maximum_force", "pinch", "how strongly you pinch"_text},
                              {"maximum_force", "", "how strongly you press"_text},
                              {"maximum_window_mean", "", "how strongly you press"_text},
                              {"release", "", "how soon you let go"_text},
                              {"residual", "", "how fully you let go"_text},
                              {"relative_rmse", "", "how closely you follow the line"_text},
                              {"rmse", "", "how closely you follow"_text},
                              {"time_in_range", "", "how closely you follow the line"_text},
                              {"cv", "", "how steadily you hold"_text},
                              {"individuation", "", "moving one finger alone"_text},
                              {"direction", "", "pressing in the right direction"_text},
                              {"reaction", "", "how soon you start"_text},
                              {"targets_reached", "", "moving the block"_text},
                              {"tilt", "", "keeping the block level"_text},
                              {"completion", "", "moving the block"_text},
                              {"median_completion", "", "moving the block"_text}};
  for (const Plain& plain : kPlain)
    if (series.name.starts_with(plain.measure) && series.channel.ends_with(plain.channel))
      return plain.words;
  return "what we measure together"_text;
}

Text in_plain_words(const MeasureSeries& series, std::optional<Hand> hand) {
  const Text what = "%1 (%2)"_text(plain_name(series), hand_words(hand));
  const auto& change = series.verdict->change;
  switch (change.verdict) {
    case Verdict::improved:
      return (change.confirmed ? "Better than at the start: %1."_text
                               : "Perhaps better than at the start: %1. We look again."_text)(what);
    case Verdict::worsened:
      return (change.confirmed
                  ? "Harder than at the start: %1. Talk about it with your therapist."_text
                  : "Perhaps harder than at the start: %1. We look again."_text)(what);
    case Verdict::within_error: return "About the same as at the start: %1."_text(what);
    case Verdict::cannot_be_judged: break;
  }
  return "We do not know yet: %1."_text(what);
}

/// What is trained next, with which hand.
Text next_practice(Component component, Hand hand) {
  struct Next {
    Words right;
    Words left;
  };
  static constexpr std::array<Next, kComponentCount> kNext{{
      {"Next we practise to grip more strongly with the right hand."_text,
       "Next we practise to grip more strongly with the left hand."_text},
      {"Next we practise to open the hand with the right hand."_text,
       "Next we practise to open the hand with the left hand."_text},
      {"Next we practise to let go with the right hand."_text,
       "Next we practise to let go with the left hand."_text},
      {"Next we practise to follow with an even force with the right hand."_text,
       "Next we practise to follow with an even force with the left hand."_text},
      {"Next we practise to move one finger alone with the right hand."_text,
       "Next we practise to move one finger alone with the left hand."_text},
      {"Next we practise to press in the right direction with the right hand."_text,
       "Next we practise to press in the right direction with the left hand."_text},
  }};
  const Next& next = kNext[static_cast<std::size_t>(component)];
  return hand == Hand::right ? next.right : next.left;
}

}  // namespace

Panel patient_page(const ReportContent& content, const Language& language) {
  const Speaker say(language);
  Panel panel;
  panel.large_print = true;
  const bool both =
      !content.sections.empty() &&
      std::all_of(content.sections.begin(), content.sections.end(),
                  [](const TaskSection& section) { return !section.hand.has_value(); });
  panel.heading = both ? say("Your hands"_text) : say("Your hand"_text);
  const PracticeDose& dose = content.dose;
  if (!content.goals.empty()) panel.lines.push_back(say("Your goal: %1"_text(content.goals)));
  const long minutes = std::lround(dose.active_s / 60.0);
  panel.lines.push_back(
      say(dose.days == 1
              ? "You practised on 1 day, for %1 minutes in all."_text(minutes)
              : "You practised on %1 days, for %2 minutes in all."_text(dose.days, minutes)));
  for (const auto& section : content.sections)
    for (const auto& series : section.series) {
      if (!series.verdict) continue;
      auto line = say(in_plain_words(series, section.hand));
      if (std::find(panel.lines.begin(), panel.lines.end(), line) == panel.lines.end())
        panel.lines.push_back(std::move(line));
    }
  if (const auto* main = main_limit(content.limits))
    panel.lines.push_back(say(next_practice(main->component, content.limits.hand)));
  if (!dose.weeks.empty())
    panel.plots.push_back({say("Minutes of practice, week by week"_text),
                           say("One bar for each week, as long as its minutes of practice."_text),
                           1.0, 230.0, [&dose, &language](QSizeF size, double unit) {
                             return dose_plot(dose, true, size, unit, language);
                           }});
  return panel;
}

PlotView dose_plot(const PracticeDose& dose, bool large, QSizeF size, double unit,
                   const Language& language) {
  PlotView view(size, unit, language);
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
  constexpr int kLeastSpan = 6;  // weeks: a single bar is not as wide as the plot
  rect.axis(QCPAxis::atBottom)->setRange(first - 0.6, std::max(last, first + kLeastSpan - 1) + 0.6);
  constexpr double kAir = 1.1;
  rect.axis(QCPAxis::atLeft)->setRange(0.0, kAir * most);
  rect.axis(QCPAxis::atLeft)->setLabel(view.said("minutes"_text));
  rect.axis(QCPAxis::atBottom)->setLabel(view.said("week"_text));
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
