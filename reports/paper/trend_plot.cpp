// SPDX-License-Identifier: GPL-3.0-or-later
// One measure over the sessions.
#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/paper/plot_tools.hpp"
#include "reports/paper/plots.hpp"
#include "tasks/facts/measure_words.hpp"

namespace isograsp::reports {

namespace {
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kAbove = 4.0;
constexpr double kLetterRow = 7.2;  // of letters of treatments

}  // namespace

std::vector<ErrorBand> error_bands(const MeasureSeries& series) {
  if (!series.verdict || !series.verdict->change.mdc_up) return {};
  const auto& change = series.verdict->change;
  const double down = *change.mdc_down;
  const double up = *change.mdc_up;
  const double baseline = *change.baseline;
  if (tasks::words_of(series.name, series.channel).better != tasks::Better::near_zero)
    return {{baseline + down, baseline + up}};
  // Judged by their distance from zero: so far away on either side.
  const double near = std::abs(baseline) + down;
  const double far = std::abs(baseline) + up;
  if (near <= 0.0) return {{-far, far}};
  const ErrorBand above{near, far};
  const ErrorBand below{-far, -near};
  return baseline < 0.0 ? std::vector{below, above} : std::vector{above, below};
}

namespace {

QChar letter_of(const std::string& kind) {
  if (kind == "botulinum_toxin") return 'B';
  return kind == "other" ? QChar('X') : QChar(kind.front()).toUpper();
}

/// Above the plot, so that no line goes through it. `row` counts upwards from 0.
QCPItemText* add_above(PlotView& view, QCPAxisRect& rect, int row, const QString& text,
                       const QColor& color) {
  auto* label = new QCPItemText(rect.parentPlot());  // the plot owns it
  label->position->setAxes(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
  label->position->setAxisRect(&rect);
  label->position->setTypeX(QCPItemPosition::ptPlotCoords);
  label->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
  label->position->setCoords(0.0, -view.px(row * kLetterRow) / rect.minimumSize().height());
  label->setPositionAlignment(Qt::AlignHCenter | Qt::AlignBottom);
  label->setClipToAxisRect(false);
  label->setText(text);
  label->setFont(report_font(view.px(5.8), color == Palette::ink()));
  label->setColor(color);
  return label;
}

/// Healthy people are far from the patient: on one scale the patient's course would be a flat line.
bool far_away(const Values& norm, const QCPRange& of_patient) {
  constexpr double kLeastShare = 0.35;  // of the scale is the patient's
  const double low = std::min(of_patient.lower, *std::min_element(norm.begin(), norm.end()));
  const double high = std::max(of_patient.upper, *std::max_element(norm.begin(), norm.end()));
  return of_patient.size() < kLeastShare * (high - low);
}

/// Where they are, above the plot at its right end.
void add_far_norm(PlotView& view, QCPAxisRect& rect, const Values& norm, int row) {
  const bool above = norm.front() > rect.axis(QCPAxis::atLeft)->range().center();
  const auto number = [](double value) {
    return Number{QString::number(value, 'g', 3).toStdString()};
  };
  const Text text = (above ? "healthy %1\u2013%2 \u2191"_text : "healthy %1\u2013%2 \u2193"_text)(
      number(norm.front()), number(norm.back()));
  auto* label = add_above(view, rect, row, view.said(text), Palette::quiet());
  label->position->setTypeX(QCPItemPosition::ptAxisRectRatio);
  label->position->setCoords(1.0, label->position->coords().y());
  label->setPositionAlignment(Qt::AlignRight | Qt::AlignBottom);
}

/// Healthy people at `x`: a bar of the middle 90 %, or a triangle for each of a few.
void add_norm(PlotView& view, QCPAxisRect& rect, const NormBand& norm, double x, double factor) {
  if (norm.low) {
    add_line(rect, {x, x}, {*norm.low * factor, *norm.high * factor},
             QPen(Palette::quiet(), view.px(2.4), Qt::SolidLine, Qt::FlatCap));
    return;
  }
  Values values;
  for (const double value : norm.values) values.push_back(value * factor);
  QCPGraph& marks = add_line(rect, Values(values.size(), x), values, QPen(Qt::NoPen));
  marks.setLineStyle(QCPGraph::lsNone);
  marks.setScatterStyle(
      {QCPScatterStyle::ssTriangle, QPen(Palette::quiet(), view.px(0.6)), Qt::white, view.px(3.4)});
}

/// Where a treatment stands along the sessions, and in which row above the plot.
struct TreatmentPlace {
  double x;
  int row;  ///< several between the same two sessions stand above each other
  QChar letter;
};
std::vector<TreatmentPlace> treatment_places(const ReportContent& content) {
  std::vector<TreatmentPlace> places;
  for (const auto& mark : content.treatments) {
    const auto after =
        std::find_if(content.sessions.begin(), content.sessions.end(),
                     [&](const auto& session) { return session.date >= mark.on_date; });
    if (after == content.sessions.begin() || after == content.sessions.end()) continue;
    const double x = after->number - 0.5;
    const int row = places.empty() || places.back().x != x ? 0 : places.back().row + 1;
    places.push_back({x, row, letter_of(mark.kind)});
  }
  return places;
}

/// Treatments between two sessions, and where the conditions changed.
void add_marks_of_time(PlotView& view, QCPAxisRect& rect, const TaskSection& section,
                       const ReportContent& content, const std::vector<TreatmentPlace>& treated) {
  const QCPRange y = rect.axis(QCPAxis::atLeft)->range();
  const auto upright = [&](double x, const QPen& pen) {
    add_line(rect, {x, x}, {y.lower, y.upper}, pen);
  };
  for (const auto& change : section.breaks) {
    const double x = content.sessions[change.session].number - 0.5;
    constexpr double kApart = 0.08;  // sessions: a double line
    for (const double side : {-kApart, kApart})
      upright(x + side, QPen(Palette::quiet(), view.px(0.5)));
  }
  for (const auto& [x, row, letter] : treated) {
    if (row == 0) upright(x, dashed(Palette::ink(), view.px(0.6), {2.0, 2.0}));
    auto* label = add_above(view, rect, row, QString(letter), Palette::ink());
    label->position->setCoords(x, label->position->coords().y());
  }
}

/// What is drawn, in the printed unit, over the numbers of the sessions.
struct Drawn {
  Values x, mean;  ///< a gap (NaN) where the conditions changed
  Values x_trials, trials;
  Values x_first, first, x_later, later;  ///< means of the first day, and of all others
  Values x_practice, practice;
  Values x_without;  ///< sessions with trials that have no value
  Values band;       ///< on the side of the baseline; of the other only what the values reach
  Values norm;       ///< lowest and highest; empty: none
};

bool breaks_between(const TaskSection& section, const ReportContent& content, double before,
                    double session) {
  return std::any_of(section.breaks.begin(), section.breaks.end(), [&](const auto& change) {
    const double at = content.sessions[change.session].number;
    return before < at && at <= session;
  });
}

Drawn drawn(const MeasureSeries& series, const TaskSection& section, const ReportContent& content,
            double factor) {
  Drawn all;
  for (const auto& value : series.values) {
    const double session = content.sessions[value.session].number;
    if (!all.x.isEmpty() && breaks_between(section, content, all.x.back(), session)) {
      all.x.push_back(session - 0.5);
      all.mean.push_back(kNaN);
    }
    all.x.push_back(session);
    all.mean.push_back(value.mean ? *value.mean * factor : kNaN);
    if (value.trials.size() > 1 || !value.mean)
      for (const double trial : value.trials) {
        all.x_trials.push_back(session);
        all.trials.push_back(trial * factor);
      }
    if (value.mean) {
      (value.first_day ? all.x_first : all.x_later).push_back(session);
      (value.first_day ? all.first : all.later).push_back(all.mean.back());
    }
    if (value.without_value > 0) all.x_without.push_back(session);
  }
  for (const auto& [session, value] : series.practice) {
    all.x_practice.push_back(content.sessions[session].number);
    all.practice.push_back(value * factor);
  }
  if (const auto bands = error_bands(series); !bands.empty())
    all.band = {bands.front().low * factor, bands.front().high * factor};
  if (series.norm) {
    all.norm = {series.norm->values.front(), series.norm->values.back()};
    if (series.norm->low) all.norm = {*series.norm->low, *series.norm->high};
    for (double& value : all.norm) value *= factor;
  }
  return all;
}

/// Of the axis of values; healthy people are on it unless they are `norm_far`.
QCPRange range_for(const Drawn& all, bool norm_far, const std::string& unit) {
  // "of 5": the scale is known.
  if (unit.starts_with("of ")) return {0.0, 1.08 * std::strtod(unit.c_str() + 3, nullptr)};
  return norm_far ? range_of({&all.mean, &all.trials, &all.band, &all.practice})
                  : range_of({&all.mean, &all.trials, &all.band, &all.practice, &all.norm});
}

/// Measurement error round the baseline, and the baseline itself, along the whole axis.
void add_baseline(PlotView& view, QCPAxisRect& rect, const MeasureSeries& series,
                  const Values& ends, double factor) {
  for (const auto& [low, high] : error_bands(series)) {
    QCPGraph& lower = add_line(rect, ends, {low * factor, low * factor}, QPen(Qt::NoPen));
    QCPGraph& upper = add_line(rect, ends, {high * factor, high * factor}, QPen(Qt::NoPen));
    upper.setBrush(Palette::tolerance());
    upper.setChannelFillGraph(&lower);
  }
  if (!series.baseline) return;
  const double base = *series.baseline * factor;
  add_line(rect, ends, {base, base}, dashed(Palette::quiet(), view.px(0.7), {1.5, 2.5}));
}

void add_values(PlotView& view, QCPAxisRect& rect, const Drawn& all, const QCPRange& range,
                std::optional<Hand> hand) {
  const QColor color = Palette::of(hand);
  const auto shape = !hand                 ? QCPScatterStyle::ssDiamond
                     : hand == Hand::right ? QCPScatterStyle::ssCircle
                                           : QCPScatterStyle::ssSquare;
  add_line(rect, all.x, all.mean, QPen(color, view.px(1.0)));
  const auto add_marks = [&](const Values& keys, const Values& values,
                             const QCPScatterStyle& style) {
    QCPGraph& marks = add_line(rect, keys, values, QPen(Qt::NoPen));
    marks.setLineStyle(QCPGraph::lsNone);
    marks.setScatterStyle(style);
  };
  add_marks(all.x_trials, all.trials,
            {QCPScatterStyle::ssDisc, QPen(Palette::pale(hand), view.px(0.5)), Palette::pale(hand),
             view.px(2.6)});
  add_marks(
      all.x_practice, all.practice,
      {QCPScatterStyle::ssCircle, QPen(Palette::quiet(), view.px(0.6)), Qt::white, view.px(3.0)});
  add_marks(all.x_first, all.first, {shape, QPen(color, view.px(1.1)), Qt::white, view.px(5.0)});
  add_marks(all.x_later, all.later, {shape, QPen(color, view.px(1.1)), color, view.px(5.0)});
  const double floor = range.lower + 0.06 * range.size();
  add_marks(
      all.x_without, Values(all.x_without.size(), floor),
      {QCPScatterStyle::ssCross, QPen(Palette::ink(), view.px(0.9)), Qt::NoBrush, view.px(4.5)});
}

}  // namespace

PlotView trend_plot(const MeasureSeries& series, const TaskSection& section,
                    const ReportContent& content, QSizeF size, double unit,
                    const Language& language) {
  PlotView view(size, unit, language);
  const auto printed = tasks::printed_unit(series.unit);
  const Drawn all = drawn(series, section, content, printed.factor);
  const bool norm_far =
      !all.norm.isEmpty() &&
      far_away(all.norm, range_of({&all.mean, &all.trials, &all.band, &all.practice}));
  const auto treated = treatment_places(content);
  int rows_above = 0;
  for (const auto& place : treated) rows_above = std::max(rows_above, place.row + 1);
  const int norm_row = rows_above;
  if (norm_far) ++rows_above;
  const double above = std::max(kAbove, rows_above * kLetterRow);
  const bool dated = ticks_have_dates(content);
  QCPAxisRect& rect = view.add_axes({kLeft, above, size.width() - kLeft - kRight,
                                     size.height() - above - kBelow - (dated ? kDateLine : 0.0)});
  const QCPRange range = range_for(all, norm_far, series.unit);
  rect.axis(QCPAxis::atLeft)->setRange(range);
  rect.axis(QCPAxis::atLeft)
      ->setLabel(view.said(printed.text.empty() ? "ratio"_text : tasks::unit_words(printed.text)));

  const SessionSpan span = session_span(content);
  constexpr double kRoomForNorm = 0.05;  // of the length
  const bool norm_beside = series.norm && !norm_far;
  const double right = span.high + (norm_beside ? kRoomForNorm * (span.high - span.low) : 0.0);
  rect.axis(QCPAxis::atBottom)->setRange(span.low, right);
  rect.axis(QCPAxis::atBottom)->setLabel(view.said("session"_text));
  add_session_ticks(view, *rect.axis(QCPAxis::atBottom), content);

  add_baseline(view, rect, series, {span.low, right}, printed.factor);
  if (norm_far) add_far_norm(view, rect, all.norm, norm_row);
  if (norm_beside) add_norm(view, rect, *series.norm, (span.high + right) / 2.0, printed.factor);
  add_marks_of_time(view, rect, section, content, treated);
  add_values(view, rect, all, range, section.hand);
  return view;
}

}  // namespace isograsp::reports
