// SPDX-License-Identifier: GPL-3.0-or-later
// One measure over the sessions.
#include <algorithm>
#include <limits>

#include "reports/measure_words.hpp"
#include "reports/plot_tools.hpp"
#include "reports/plots.hpp"
#include "reports/report_text.hpp"

namespace isograsp {

namespace {
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr int kMostDatedTicks = 4;
constexpr double kDateLine = 8.0;  // a second line of tick labels [points]
}  // namespace

PlotView trend_plot(const MeasureSeries& series, const TaskSection& section,
                    const ReportContent& content, QSizeF size, double unit) {
  PlotView view(size, unit);
  const int count = static_cast<int>(content.sessions.size());
  const bool dated = count <= kMostDatedTicks;
  QCPAxisRect& rect = view.add_axes({kLeft, 4.0, size.width() - kLeft - kRight,
                                     size.height() - 4.0 - kBelow - (dated ? kDateLine : 0.0)});
  const auto printed = printed_unit(series.unit);
  Values x, mean, x_trials, trials, x_first, first, x_later, later, x_without;
  for (const auto& value : series.values) {
    const double session = content.sessions[value.session].number;
    x.push_back(session);
    mean.push_back(value.mean ? *value.mean * printed.factor : kNaN);
    if (value.trials.size() > 1 || !value.mean)
      for (const double trial : value.trials) {
        x_trials.push_back(session);
        trials.push_back(trial * printed.factor);
      }
    if (value.mean) {
      (value.first_day ? x_first : x_later).push_back(session);
      (value.first_day ? first : later).push_back(mean.back());
    }
    if (value.without_value > 0) x_without.push_back(session);
  }
  QCPRange range = range_of({&mean, &trials});
  // "of 5": the scale is known.
  if (series.unit.starts_with("of "))
    range = {0.0, 1.08 * std::strtod(series.unit.c_str() + 3, nullptr)};
  rect.axis(QCPAxis::atLeft)->setRange(range);
  rect.axis(QCPAxis::atLeft)
      ->setLabel(QString::fromStdString(printed.text.empty() ? "ratio" : printed.text));

  constexpr int kLeastSpan = 3;  // sessions: two points side by side look like a jump otherwise
  rect.axis(QCPAxis::atBottom)->setRange(0.5, std::max(count, kLeastSpan) + 0.5);
  rect.axis(QCPAxis::atBottom)->setLabel("session");
  auto ticker = QSharedPointer<QCPAxisTickerText>::create();
  constexpr int kMostTicks = 12;
  const int step = 1 + (count - 1) / kMostTicks;
  for (int i = 0; i < count; i += step) {
    const auto& session = content.sessions[static_cast<std::size_t>(i)];
    QString label = QString::number(session.number);
    if (dated) {
      const auto date = QString::fromStdString(format_date(session.date));
      label += "\n" + date.left(date.size() - 5);  // without the year
    }
    ticker->addTick(session.number, label);
  }
  rect.axis(QCPAxis::atBottom)->setTicker(ticker);

  const QColor color = Palette::of(section.hand);
  const auto shape =
      section.hand == Hand::right ? QCPScatterStyle::ssCircle : QCPScatterStyle::ssSquare;
  if (series.baseline) {
    const double base = *series.baseline * printed.factor;
    add_line(rect, {0.5, std::max(count, kLeastSpan) + 0.5}, {base, base},
             dashed(Palette::quiet(), view.px(0.7), {1.5, 2.5}));
  }
  add_line(rect, x, mean, QPen(color, view.px(1.0)));
  const auto add_marks = [&](const Values& keys, const Values& values,
                             const QCPScatterStyle& style) {
    QCPGraph& marks = add_line(rect, keys, values, QPen(Qt::NoPen));
    marks.setLineStyle(QCPGraph::lsNone);
    marks.setScatterStyle(style);
  };
  add_marks(x_trials, trials,
            {QCPScatterStyle::ssDisc, QPen(Palette::pale(section.hand), view.px(0.5)),
             Palette::pale(section.hand), view.px(2.6)});
  add_marks(x_first, first, {shape, QPen(color, view.px(1.1)), Qt::white, view.px(5.0)});
  add_marks(x_later, later, {shape, QPen(color, view.px(1.1)), color, view.px(5.0)});
  const double floor = range.lower + 0.06 * range.size();
  add_marks(
      x_without, Values(x_without.size(), floor),
      {QCPScatterStyle::ssCross, QPen(Palette::ink(), view.px(0.9)), Qt::NoBrush, view.px(4.5)});
  return view;
}

}  // namespace isograsp
