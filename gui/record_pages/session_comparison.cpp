// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/record_pages/session_comparison.hpp"

#include <QObject>
#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "gui/words/texts.hpp"
#include "gui/words/words.hpp"
#include "reports/findings/comparable.hpp"
#include "tasks/facts/measure_words.hpp"
#include "tasks/reasons/reasons.hpp"

namespace isograsp::gui {

namespace {

/// What makes two trials the same task; the name alone does not.
using TaskKey = std::tuple<std::string, int, std::string, std::string>;
TaskKey task_of(const storage::TrialRecord& trial) {
  return {trial.task_name, trial.task_version, trial.task_text,
          reports::lasting_scene(trial.scene_text)};
}

using MeasureKey = std::tuple<std::string, std::string, int, std::string>;
MeasureKey key_of(const Measure& measure) {
  return {measure.name, measure.channel, measure.version, measure.unit};
}

struct Collected {
  const Measure* first = nullptr;  ///< for its words
  double sum = 0.0;
  SessionMean mean;
};

struct TaskOfSession {
  const storage::TrialRecord* trial = nullptr;
  std::vector<MeasureKey> order;
  std::map<MeasureKey, Collected> measures;
};

struct SessionWork {
  std::vector<TaskKey> order;
  std::map<TaskKey, TaskOfSession> tasks;
};

SessionWork collect(const CourseSession& session) {
  SessionWork work;
  for (const auto& trial : session.trials) {
    if (!is_assessment(trial.record)) continue;
    const auto key = task_of(trial.record);
    auto& task = work.tasks[key];
    if (task.trial == nullptr) work.order.push_back(key);
    task.trial = &trial.record;
    for (const auto& measure : trial.measures) {
      auto& collected = task.measures[key_of(measure)];
      if (collected.first == nullptr) {
        collected.first = &measure;
        task.order.push_back(key_of(measure));
      }
      if (measure.value) {
        ++collected.mean.trials;
        collected.sum += *measure.value;
      } else {
        ++collected.mean.without;
        collected.mean.reason = translated(tasks::reason_words(measure.reason));
      }
    }
  }
  for (auto& [key, task] : work.tasks)
    for (auto& [name, collected] : task.measures) {
      SessionMean& mean = collected.mean;
      const bool censored =
          tasks::words_of(collected.first->name, collected.first->channel).censored;
      if (mean.trials > 0 && !(censored && mean.without > 0)) {
        mean.value = collected.sum / mean.trials;
        mean.reason.clear();
      }
    }
  return work;
}

/// Why two sessions have nothing to compare; empty: they may have.
QString difference(const storage::SessionRecord& a, const storage::SessionRecord& b) {
  if (a.id == b.id) return QObject::tr("This is one session twice: choose another one.");
  if (a.hand != b.hand) return QObject::tr("The two sessions are of different hands.");
  if (a.simulated != b.simulated || a.recorded != b.recorded)
    return QObject::tr("The forces of the two sessions come from different sources.");
  if (a.rate_Hz != b.rate_Hz) return QObject::tr("The two sessions have different frame rates.");
  if (a.device_delay_s != b.device_delay_s)
    return QObject::tr("The filter delay of the device differs between the two sessions.");
  if (a.display_delay_s != b.display_delay_s)
    return QObject::tr("The measured delay of the display differs between the two sessions.");
  return {};
}

QString task_difference(const TaskKey& a, const TaskKey& b) {
  if (std::get<1>(a) != std::get<1>(b)) return QObject::tr("other version of the task");
  if (std::get<2>(a) != std::get<2>(b)) return QObject::tr("other parameters or level");
  return QObject::tr("other object");
}

void add_rows(const TaskOfSession& in_a, const TaskOfSession& in_b, SessionComparison& comparison) {
  const auto spec = tasks::parse_task(in_b.trial->task_text, in_b.trial->task_name);
  const auto task_spec = spec ? std::optional(*spec) : std::nullopt;
  const auto name = translated(in_b.trial->task_name);
  std::vector<std::pair<tasks::Place, ComparedMeasure>> rows;
  std::set<QString> other_version;
  for (const auto& key : in_b.order) {
    const auto& b = in_b.measures.at(key);
    const auto a = in_a.measures.find(key);
    if (a == in_a.measures.end()) {
      const bool there = std::any_of(in_a.order.begin(), in_a.order.end(), [&](const auto& other) {
        return std::get<0>(other) == std::get<0>(key) && std::get<1>(other) == std::get<1>(key);
      });
      if (there) other_version.insert(measure_title(*b.first));
      continue;
    }
    const auto place = tasks::place_of(task_spec, b.first->name, b.first->channel);
    ComparedMeasure row{name,
                        measure_title(*b.first),
                        b.first->unit,
                        place.prominence == tasks::Prominence::key,
                        place.prominence != tasks::Prominence::none,
                        a->second.mean,
                        b.mean,
                        std::nullopt};
    if (row.a.value && row.b.value) row.difference = *row.b.value - *row.a.value;
    rows.emplace_back(place, std::move(row));
  }
  std::stable_sort(rows.begin(), rows.end(), [](const auto& one, const auto& other) {
    if (one.first.prominence != other.first.prominence)
      return one.first.prominence > other.first.prominence;
    return one.first.rank < other.first.rank;
  });
  for (auto& row : rows) comparison.rows.push_back(std::move(row.second));
  for (const auto& title : other_version)
    comparison.left_out.push_back(
        QObject::tr("%1, %2: other version of the measure").arg(name, title));
}

}  // namespace

SessionComparison compare_sessions(const CourseSession& a, const CourseSession& b) {
  SessionComparison comparison;
  if (const auto why = difference(a.record, b.record); !why.isEmpty()) {
    comparison.left_out.push_back(why);
    return comparison;
  }
  const SessionWork in_a = collect(a);
  const SessionWork in_b = collect(b);
  for (const auto& key : in_b.order) {
    if (const auto same = in_a.tasks.find(key); same != in_a.tasks.end()) {
      add_rows(same->second, in_b.tasks.at(key), comparison);
      continue;
    }
    const auto like = std::find_if(in_a.order.begin(), in_a.order.end(), [&](const TaskKey& other) {
      return std::get<0>(other) == std::get<0>(key);
    });
    if (like == in_a.order.end()) continue;
    const auto note =
        QObject::tr("%1: %2").arg(translated(std::get<0>(key)), task_difference(*like, key));
    if (std::find(comparison.left_out.begin(), comparison.left_out.end(), note) ==
        comparison.left_out.end())
      comparison.left_out.push_back(note);
  }
  return comparison;
}

}  // namespace isograsp::gui
