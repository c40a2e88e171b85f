// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/clinic/patient_course.hpp"

#include <QObject>
#include <QStringList>
#include <map>

#include "gui/words/words.hpp"
#include "reports/findings/renewed.hpp"
#include "tasks/facts/measure_words.hpp"

namespace isograsp::gui {

Result<PatientCourse> read_course(storage::SessionStore& store, const std::string& code) {
  const auto patient = store.find_patient(code);
  if (!patient) return patient.error();
  if (!patient->has_value())
    return refused("there is no patient %1"_text(code), {}).at(store.path());
  PatientCourse course;
  course.code = (*patient)->code;
  auto points = reports::renewed_progress(store, (*patient)->id);
  if (!points) return points.error();
  course.points = *std::move(points);
  std::map<storage::RowId, std::vector<Measure>> measures;
  for (const auto& point : course.points) measures[point.trial_id].push_back(point.measure);
  auto sessions = store.sessions((*patient)->id);
  if (!sessions) return sessions.error();
  for (auto& record : *sessions) {
    auto trials = store.trials(record.id);
    if (!trials) return trials.error();
    CourseSession session{static_cast<int>(course.sessions.size()) + 1, std::move(record), {}};
    for (auto& trial : *trials) {
      const storage::RowId id = trial.id;
      session.trials.push_back({std::move(trial), std::move(measures[id])});
    }
    course.sessions.push_back(std::move(session));
  }
  return course;
}

bool is_assessment(const storage::TrialRecord& trial) noexcept {
  return trial.status == storage::TrialStatus::completed && !trial.practice && !trial.helped;
}

const Measure* key_measure(const CourseTrial& trial) {
  const auto spec = tasks::parse_task(trial.record.task_text, trial.record.task_name);
  return spec ? key_measure(*spec, trial.measures) : nullptr;
}

const Measure* key_measure(const tasks::TaskSpec& task, const std::vector<Measure>& measures) {
  const Measure* best = nullptr;
  tasks::Place best_place;
  for (const auto& measure : measures) {
    const auto place = tasks::place_of(task, measure.name, measure.channel);
    if (place.prominence == tasks::Prominence::none) continue;
    const bool better = best == nullptr || place.prominence > best_place.prominence ||
                        (place.prominence == best_place.prominence && place.rank < best_place.rank);
    if (!better) continue;
    best = &measure;
    best_place = place;
  }
  return best;
}

QString source_mark(const storage::SessionRecord& session) {
  if (session.simulated) return QObject::tr("SIMULATED");
  return session.recorded ? QObject::tr("RECORDED") : QString();
}

QString trials_words(int count) {
  return count == 1 ? QObject::tr("1 trial") : QObject::tr("%1 trials").arg(count);
}

QString hand_words(std::optional<Hand> hand) {
  if (!hand) return QObject::tr("both hands");
  return hand == Hand::right ? QObject::tr("right hand") : QObject::tr("left hand");
}

QString standing_words(const storage::TrialRecord& trial) {
  QStringList words{status_words(trial.status)};
  if (trial.practice) words << QObject::tr("practice");
  if (trial.helped) words << QObject::tr("helped");
  return words.join(QObject::tr(", "));
}

}  // namespace isograsp::gui
