// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/history.hpp"

#include <QObject>
#include <algorithm>

#include "gui/words.hpp"
#include "reports/measure_words.hpp"

namespace isograsp {

namespace {

bool same_task(const MeasurePoint& a, const MeasurePoint& b) {
  return a.task_name == b.task_name && a.task_version == b.task_version && a.hand == b.hand &&
         a.simulated == b.simulated;
}

bool same_series(const MeasurePoint& a, const MeasurePoint& b) {
  return same_task(a, b) && a.measure.name == b.measure.name &&
         a.measure.channel == b.measure.channel && a.measure.version == b.measure.version;
}

QString title_of(const MeasurePoint& point) {
  const auto hand = point.hand == Hand::right ? QObject::tr("right") : QObject::tr("left");
  auto title =
      QObject::tr("%1 (%2): %3")
          .arg(QString::fromStdString(point.task_name), hand, measure_title(point.measure));
  if (point.simulated) title += QObject::tr(", simulated");
  return title;
}

}  // namespace

std::vector<HistorySeries> sort_history(const std::vector<MeasurePoint>& points) {
  std::vector<HistorySeries> series;
  for (const auto& point : points) {
    auto found = std::find_if(series.begin(), series.end(), [&](const HistorySeries& known) {
      return same_series(known.points.front(), point);
    });
    if (found == series.end()) {
      series.push_back(
          {title_of(point), QString::fromStdString(printed_unit(point.measure.unit).text), {}});
      found = series.end() - 1;
    }
    found->points.push_back(point);
  }
  // The task of the newest trial is what the therapist wants to see; inside a task the order in
  // which its measures were computed stays.
  const auto newest = [&](const HistorySeries& one) {
    RowId trial = 0;
    for (const auto& point : points)
      if (same_task(point, one.points.front())) trial = std::max(trial, point.trial_id);
    return trial;
  };
  std::stable_sort(
      series.begin(), series.end(),
      [&](const HistorySeries& a, const HistorySeries& b) { return newest(a) > newest(b); });
  return series;
}

}  // namespace isograsp
