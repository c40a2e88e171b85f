// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/record_pages/measure_trend.hpp"

#include <QObject>
#include <QStringList>
#include <algorithm>
#include <map>

#include "gui/clinic/history.hpp"
#include "gui/words/texts.hpp"
#include "gui/words/words.hpp"
#include "reports/findings/comparable.hpp"
#include "reports/findings/report_text.hpp"
#include "tasks/facts/measure_words.hpp"

namespace isograsp::gui {

namespace {

MeasureTrend::Kind kind_of(const storage::MeasurePoint& point) {
  if (point.helped) return MeasureTrend::Kind::helped;
  return point.practice ? MeasureTrend::Kind::practised : MeasureTrend::Kind::assessed;
}

/// Did the trials of the series ask for different things under one name?
bool is_mixed(const HistorySeries& series,
              const std::map<storage::RowId, const storage::TrialRecord*>& trials) {
  const storage::TrialRecord* first = nullptr;
  for (const auto& point : series.points) {
    const auto trial = trials.find(point.trial_id);
    if (trial == trials.end()) continue;
    if (first == nullptr) first = trial->second;
    if (trial->second->task_text != first->task_text ||
        reports::lasting_scene(trial->second->scene_text) !=
            reports::lasting_scene(first->scene_text))
      return true;
  }
  return false;
}

QString task_words(const storage::MeasurePoint& point, bool several_versions, bool mixed) {
  QStringList words;  // what must not be cut off comes first
  if (point.simulated) words << QObject::tr("SIMULATED");
  if (mixed) words << QObject::tr("levels differ");
  words << translated(point.task_name) << hand_words(point.hand);
  if (several_versions)
    words.insert(words.size() - 1, QObject::tr("version %1").arg(point.task_version));
  return words.join(QStringLiteral(" · "));
}

MeasureTrend draw(const HistorySeries& series, const std::map<storage::RowId, int>& numbers) {
  MeasureTrend trend;
  trend.title = measure_title(series.points.front().measure);
  trend.unit = series.unit;
  trend.simulated = series.points.front().simulated;
  const auto& front = series.points.front();
  trend.source = {0, front.task_name, front.hand, front.measure.name, front.measure.channel, "",
                  ""};
  trend.task_version = front.task_version;
  const double factor = tasks::printed_unit(series.points.front().measure.unit).factor;
  for (const auto& point : series.points) {
    if (!point.measure.value) {
      ++trend.without;
      continue;
    }
    const auto session = numbers.find(point.session_id);
    if (session == numbers.end()) continue;
    const double value = *point.measure.value * factor;
    trend.dates[session->second] = local_date(point.started_utc);
    trend.points.push_back({session->second, point.trial_number, kind_of(point), value});
    if (trend.points.back().kind != MeasureTrend::Kind::assessed) continue;
    if (trend.means.empty() || trend.means.back().session != session->second)
      trend.means.push_back({session->second, 0.0, 0});
    auto& mean = trend.means.back();
    ++mean.trials;
    mean.value += (value - mean.value) / mean.trials;
  }
  trend.last = measure_value(series.points.back().measure);
  return trend;
}

}  // namespace

std::vector<MeasureTrend> choose_trends(const PatientCourse& course) {
  std::map<storage::RowId, int> numbers;
  std::map<storage::RowId, const storage::TrialRecord*> trials;
  std::map<std::string, std::vector<int>> versions;  // of each task
  for (const auto& session : course.sessions) {
    numbers[session.record.id] = session.number;
    for (const auto& trial : session.trials) {
      trials[trial.record.id] = &trial.record;
      auto& of_task = versions[trial.record.task_name];
      if (std::find(of_task.begin(), of_task.end(), trial.record.task_version) == of_task.end())
        of_task.push_back(trial.record.task_version);
    }
  }
  struct Placed {
    tasks::Place place;
    storage::RowId newest = 0;
    MeasureTrend trend;
  };
  std::vector<Placed> chosen;
  std::map<storage::RowId, std::optional<tasks::TaskSpec>>
      specs;  // of the newest trial of a series
  for (const auto& series : sort_history(course.points)) {
    const auto& newest = series.points.back();
    const auto trial = trials.find(newest.trial_id);
    if (trial == trials.end()) continue;
    auto [spec, unread] = specs.try_emplace(newest.trial_id);
    if (unread)
      if (auto parsed = tasks::parse_task(trial->second->task_text, newest.task_name))
        spec->second = *std::move(parsed);
    const auto place = tasks::place_of(spec->second, newest.measure.name, newest.measure.channel);
    if (place.prominence == tasks::Prominence::none) continue;
    auto trend = draw(series, numbers);
    if (trend.points.empty()) continue;
    trend.key = place.prominence == tasks::Prominence::key;
    trend.mixed = is_mixed(series, trials);
    trend.task = task_words(newest, versions[newest.task_name].size() > 1, trend.mixed);
    chosen.push_back({place, newest.trial_id, std::move(trend)});
  }
  std::stable_sort(chosen.begin(), chosen.end(), [](const Placed& a, const Placed& b) {
    if (a.place.prominence != b.place.prominence) return a.place.prominence > b.place.prominence;
    if (a.newest != b.newest) return a.newest > b.newest;
    return a.place.rank < b.place.rank;
  });
  std::vector<MeasureTrend> trends;
  trends.reserve(chosen.size());
  for (auto& one : chosen) trends.push_back(std::move(one.trend));
  return trends;
}

QString verdict_line(const reports::PatientVerdict& verdict) {
  if (!verdict.verdict) return QObject::tr("Cannot be judged yet: no assessment yet");
  const auto& change = verdict.verdict->change;
  const QString basis = change.verdict == reports::Verdict::cannot_be_judged
                            ? translated(verdict.verdict->reason)
                            : translated(reports::mdc_words(change, verdict.unit));
  switch (change.verdict) {
    case reports::Verdict::improved:
      return (change.confirmed ? QObject::tr("Improved (confirmed) · %1")
                               : QObject::tr("Improved (possible) · %1"))
          .arg(basis);
    case reports::Verdict::worsened:
      return (change.confirmed ? QObject::tr("Worsened (confirmed) · %1")
                               : QObject::tr("Worsened (possible) · %1"))
          .arg(basis);
    case reports::Verdict::within_error:
      return QObject::tr("Not larger than measurement error · %1").arg(basis);
    case reports::Verdict::cannot_be_judged: break;
  }
  return QObject::tr("Cannot be judged yet: %1").arg(basis);
}

void add_verdicts(std::vector<MeasureTrend>& trends,
                  const std::vector<reports::PatientVerdict>& verdicts) {
  for (const auto& verdict : verdicts) {
    storage::PrimaryMeasure about = verdict.primary;
    about.id = 0;
    about.chosen_utc.clear();
    about.chosen_by.clear();
    for (auto& trend : trends)
      if (trend.source == about && trend.task_version == verdict.task_version &&
          trend.simulated == (verdict.source == reports::Source::simulated))
        trend.remark = verdict_line(verdict);
  }
  std::stable_partition(trends.begin(), trends.end(),
                        [](const MeasureTrend& trend) { return !trend.remark.isEmpty(); });
}

}  // namespace isograsp::gui
