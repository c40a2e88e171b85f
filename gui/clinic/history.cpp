// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/clinic/history.hpp"

#include <QObject>
#include <algorithm>
#include <map>
#include <tuple>

#include "gui/words/texts.hpp"
#include "gui/words/words.hpp"
#include "tasks/facts/measure_words.hpp"

namespace isograsp::gui {

namespace {

/// What makes trials comparable: task, its version, hand, simulated or not.
using TaskKey = std::tuple<std::string, int, std::optional<Hand>, bool>;
TaskKey task_of(const storage::MeasurePoint& point) {
  return {point.task_name, point.task_version, point.hand, point.simulated};
}

/// And in addition the measure, its channel and its version.
using SeriesKey = std::tuple<TaskKey, std::string, std::string, int>;
SeriesKey series_of(const storage::MeasurePoint& point) {
  const auto& measure = point.measure;
  return {task_of(point), measure.name, measure.channel, measure.version};
}

QString series_words(const storage::MeasurePoint& point) {
  const auto hand = !point.hand                 ? QObject::tr("both")
                    : point.hand == Hand::right ? QObject::tr("right")
                                                : QObject::tr("left");
  auto title = QObject::tr("%1 (%2): %3")
                   .arg(translated(point.task_name), hand, measure_title(point.measure));
  if (point.simulated) title += QObject::tr(", simulated");
  return title;
}

}  // namespace

std::vector<HistorySeries> sort_history(const std::vector<storage::MeasurePoint>& points) {
  std::vector<HistorySeries> series;
  std::map<SeriesKey, std::size_t> places;
  for (const auto& point : points) {
    const auto [place, is_new] = places.try_emplace(series_of(point), series.size());
    if (is_new)
      series.push_back({series_words(point),
                        translated(tasks::unit_words(tasks::printed_unit(point.measure.unit).text)),
                        {}});
    series[place->second].points.push_back(point);
  }
  // The task of the newest trial is what the therapist wants to see; inside a task the order in
  // which its measures were computed stays.
  std::map<TaskKey, storage::RowId> newest;
  for (const auto& point : points) {
    storage::RowId& trial = newest[task_of(point)];
    trial = std::max(trial, point.trial_id);
  }
  std::stable_sort(series.begin(), series.end(),
                   [&](const HistorySeries& a, const HistorySeries& b) {
                     return newest[task_of(a.points.front())] > newest[task_of(b.points.front())];
                   });
  return series;
}

const storage::MeasurePoint* last_time(const std::vector<HistorySeries>& history,
                                       const TrialLike& like, const Measure& measure) {
  const TaskKey task{like.task_name, like.task_version, like.hand, like.simulated};
  const SeriesKey wanted{task, measure.name, measure.channel, measure.version};
  for (const auto& series : history) {
    if (series_of(series.points.front()) != wanted) continue;
    const auto earlier = std::find_if(
        series.points.rbegin(), series.points.rend(), [&](const storage::MeasurePoint& point) {
          return point.session_id < like.session_id && !point.practice && !point.helped &&
                 point.measure.value.has_value();
        });
    return earlier == series.points.rend() ? nullptr : &*earlier;
  }
  return nullptr;
}

}  // namespace isograsp::gui
