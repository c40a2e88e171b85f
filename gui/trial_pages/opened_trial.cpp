// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/trial_pages/opened_trial.hpp"

#include <QJsonDocument>
#include <QJsonObject>
#include <QObject>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "gui/clinic/patient_course.hpp"
#include "gui/look/look.hpp"
#include "gui/words/texts.hpp"
#include "gui/words/words.hpp"
#include "hand/columns.hpp"
#include "hand/platform_records.hpp"

namespace isograsp::gui {

namespace {

/// The first `count` groups, if all of them can be read.
Result<Signals> first_groups(storage::SessionStore& store, storage::TrialRecord trial,
                             std::size_t count) {
  trial.groups.resize(count);
  return store.signals(trial);
}

/// The longest beginning of the trial that can be read, in whole blocks of one second.
Signals readable_beginning(storage::SessionStore& store, storage::TrialRecord trial,
                           double rate_Hz) {
  const auto block = std::max<std::int64_t>(1, std::llround(rate_Hz));
  std::int64_t readable = 0;  // blocks
  std::int64_t broken = trial.samples / block + 1;
  Signals beginning;
  while (broken - readable > 1) {
    const std::int64_t half = (readable + broken) / 2;
    trial.samples = half * block;
    if (auto signals = store.signals(trial)) {
      readable = half;
      beginning = *std::move(signals);
    } else {
      broken = half;
    }
  }
  return beginning;
}

/// What can still be read of damaged signals: as many groups as possible over the whole trial, or
/// if the first of them is damaged, all of them up to there.
Signals readable_part(storage::SessionStore& store, const storage::TrialRecord& trial,
                      double rate_Hz) {
  for (std::size_t count = trial.groups.size() - 1; count > 0; --count)
    if (auto signals = first_groups(store, trial, count)) return *std::move(signals);
  return readable_beginning(store, trial, rate_Hz);
}

std::string words_for_damage(const Error& error, const Signals& left,
                             const storage::TrialRecord& trial) {
  const auto whole = static_cast<std::int64_t>(left.rows()) == trial.samples;
  std::size_t columns = 0;
  for (const auto& group : trial.groups) columns += group.columns.size();
  const auto kept =
      left.rows() == 0 ? QObject::tr("None of its signals can be shown.")
      : whole
          ? QObject::tr("%1 of its %2 channels can be shown.").arg(left.names().size()).arg(columns)
          : QObject::tr("Its first %1 of %2 samples can be shown.")
                .arg(left.rows())
                .arg(trial.samples);
  return QObject::tr("This trial is damaged: %1. %2")
      .arg(translated(error.what), kept)
      .toStdString();
}

/// The events of the trial, and those of the session that fall into it, e.g. notes.
std::vector<TrialMark> marks_of(const std::vector<storage::EventRecord>& events,
                                const storage::TrialRecord& trial, double length_s) {
  std::vector<TrialMark> marks;
  for (const auto& event : events) {
    const double t_s = event.session_time_s - trial.session_time_s;
    const bool inside = t_s >= 0.0 && t_s <= length_s;
    if (event.trial_id == trial.id || (!event.trial_id && inside))
      marks.push_back({t_s, event.kind, event.text});
  }
  std::stable_sort(marks.begin(), marks.end(),
                   [](const TrialMark& a, const TrialMark& b) { return a.t_s < b.t_s; });
  return marks;
}

QString share_words(std::int64_t part, std::int64_t whole) {
  return QObject::tr("%1 (%2 %)")
      .arg(part)
      .arg(short_number(100.0 * static_cast<double>(part) /
                        static_cast<double>(std::max<std::int64_t>(1, whole))));
}

void add_sample_facts(const OpenedTrial& opened, std::vector<TrialFact>& facts) {
  std::int64_t held = 0;
  std::int64_t missing = 0;
  std::int64_t beyond = 0;
  for (const double flags : opened.signals.column(columns::sample_flags)) {
    if (!(flags >= 0.0)) continue;
    const auto bits = static_cast<unsigned>(flags);
    held += (bits & bit(SampleFlag::held)) != 0 ? 1 : 0;
    missing += (bits & bit(SampleFlag::missing)) != 0 ? 1 : 0;
    beyond += (bits & (bit(SampleFlag::saturated) | bit(SampleFlag::overload))) != 0 ? 1 : 0;
  }
  const auto rows = opened.trial.samples;
  facts.push_back({QObject::tr("Samples"), QString::number(rows), false});
  // The frames of a trial are few enough that one in a hundred is seen in its measures.
  const auto noticeable = [&](std::int64_t part) { return 100 * part > rows; };
  if (missing > 0)
    facts.push_back({QObject::tr("Missing"), share_words(missing, rows), noticeable(missing)});
  if (held > 0) facts.push_back({QObject::tr("Held"), share_words(held, rows), noticeable(held)});
  if (beyond > 0) facts.push_back({QObject::tr("Beyond range"), share_words(beyond, rows), true});
  if (opened.trial.dropped > 0)
    facts.push_back({QObject::tr("Not recorded"), QString::number(opened.trial.dropped), true});
}

/// Counters of sensors and bus at the end of the trial; they count from the start of the session.
void add_health_facts(const std::string& health_json, std::vector<TrialFact>& facts) {
  const auto health = QJsonDocument::fromJson(QByteArray::fromStdString(health_json)).object();
  if (health.isEmpty()) return;
  const std::array<std::pair<const char*, QString>, 9> counters{
      {{"lost", QObject::tr("lost")},
       {"invalid", QObject::tr("invalid")},
       {"torn", QObject::tr("torn")},
       {"late", QObject::tr("late")},
       {"stale", QObject::tr("stale")},
       {"saturated", QObject::tr("saturated")},
       {"overload", QObject::tr("overloaded")},
       {"status_errors", QObject::tr("status errors")},
       {"restarts", QObject::tr("restarts")}}};
  QStringList sensors;
  for (const Finger finger : kFingers) {
    const auto sensor = health.value(QString::fromLatin1(name_of(finger).data())).toObject();
    QStringList counted;
    for (const auto& [key, word] : counters)
      if (const auto count = sensor.value(QLatin1String(key)).toDouble(); count > 0.0)
        counted << QObject::tr("%1 %2").arg(word).arg(count, 0, 'f', 0);
    if (!counted.isEmpty())
      sensors << QObject::tr("%1: %2").arg(finger_title(finger), counted.join(QObject::tr(", ")));
  }
  const auto bus = health.value(QLatin1String("kernel_drops")).toDouble() +
                   health.value(QLatin1String("overflows")).toDouble();
  if (bus > 0.0) sensors << QObject::tr("Bus: %1 frames lost").arg(bus, 0, 'f', 0);
  facts.push_back(
      {QObject::tr("Sensors and bus"),
       sensors.isEmpty() ? QObject::tr("nothing to report") : sensors.join(QObject::tr("; ")),
       false});
}

constexpr QLatin1String kCameras("cameras");
constexpr QLatin1String kTracker("tracker");

QJsonObject health_object(const std::string& health_json) {
  return QJsonDocument::fromJson(QByteArray::fromStdString(health_json)).object();
}

/// Counters of cameras or tracker at the end of the trial; they count from the start of the
/// session.
void add_picture_facts(const QJsonObject& cameras, std::vector<TrialFact>& facts) {
  const std::array<std::pair<const char*, QString>, 6> counters{
      {{"lost", QObject::tr("lost")},
       {"damaged", QObject::tr("damaged")},
       {"malformed", QObject::tr("damaged")},
       {"untracked", QObject::tr("without the hand")},
       {"other_side", QObject::tr("of the other hand")},
       {"restarts", QObject::tr("restarts")}}};
  QStringList counted;
  for (const auto& [key, word] : counters)
    if (const auto count = cameras.value(QLatin1String(key)).toDouble(); count > 0.0)
      counted << QObject::tr("%1 %2").arg(word).arg(count, 0, 'f', 0);
  facts.push_back(
      {QObject::tr("Pictures"),
       counted.isEmpty() ? QObject::tr("nothing to report") : counted.join(QObject::tr(", ")),
       false});
}

}  // namespace

Result<OpenedTrial> open_trial(storage::SessionStore& store, const storage::SessionRecord& session,
                               const storage::TrialRecord& trial) {
  OpenedTrial opened{session, trial, {}, {}, {}, {}};
  auto measures = store.measures(trial.id);
  if (!measures) return measures.error();
  opened.measures = *std::move(measures);
  if (auto signals = store.signals(trial)) {
    opened.signals = *std::move(signals);
  } else {
    if (!trial.groups.empty()) opened.signals = readable_part(store, trial, session.rate_Hz);
    opened.damage = words_for_damage(signals.error(), opened.signals, trial);
  }
  const auto events = store.events(session.id);
  if (!events) return events.error();
  const double length_s = static_cast<double>(trial.samples) / session.rate_Hz;
  opened.marks = marks_of(*events, trial, length_s);
  return opened;
}

std::vector<TrialFact> facts_of(const OpenedTrial& opened) {
  const storage::TrialRecord& trial = opened.trial;
  std::vector<TrialFact> facts;
  const auto add = [&](const QString& what, const QString& value, bool doubtful = false) {
    facts.push_back({what, value, doubtful});
  };
  add(QObject::tr("Recorded"), local_time(opened.session.started_utc));
  add(QObject::tr("Hand"), hand_words(opened.session.hand));
  const auto mark = source_mark(opened.session);
  if (!mark.isEmpty()) add(QObject::tr("Source"), mark);
  add(QObject::tr("Ended"), status_words(trial.status),
      trial.status != storage::TrialStatus::completed);
  add(QObject::tr("Counts as"), trial.helped           ? QObject::tr("helped: no assessment")
                                : trial.practice       ? QObject::tr("practice: no assessment")
                                : is_assessment(trial) ? QObject::tr("assessment")
                                                       : QObject::tr("no assessment"));
  add(QObject::tr("Task version"), QString::number(trial.task_version));
  add(QObject::tr("Seed"),
      trial.seed == 0 ? QObject::tr("not known") : QString::number(trial.seed));
  if (const auto maximum_N = storage::value_of(trial.references, platform::kMaximumForce_N))
    add(QObject::tr("Maximum force"), QObject::tr("%1 N").arg(short_number(*maximum_N)));
  const QJsonObject health = health_object(trial.health_json);
  const bool tracked = health.contains(kTracker);
  const bool cameras = health.contains(kCameras) || tracked;
  if (tracked)
    add(QObject::tr("Size of the hand"),
        trial.preparations.empty() ? QObject::tr("usual: not measured") : QObject::tr("measured"),
        trial.preparations.empty());
  else if (cameras)
    add(QObject::tr("Start posture"),
        trial.preparations.empty() ? QObject::tr("none") : QObject::tr("measured"));
  else if (trial.preparations.empty())
    add(QObject::tr("Zero"), QObject::tr("none in force"), !opened.session.recorded);
  if (const auto drift_N = storage::value_of(trial.drift, platform::kDrift_N))
    add(QObject::tr("Zero drift"),
        trial.drifted ? QObject::tr("%1 N: the forces are in doubt").arg(short_number(*drift_N))
                      : QObject::tr("%1 N").arg(short_number(*drift_N)),
        trial.drifted);
  else if (!cameras && !trial.preparations.empty())
    add(QObject::tr("Zero drift"), QObject::tr("not known: no zero followed"));
  add_sample_facts(opened, facts);
  constexpr double kWorthSaying_s = 1e-5;  // in virtual time nothing is late
  if (trial.worst_lateness_s >= kWorthSaying_s)
    add(QObject::tr("Latest frame"),
        QObject::tr("%1 ms late").arg(short_number(trial.worst_lateness_s * 1e3)));
  if (cameras)
    add_picture_facts(health.value(tracked ? kTracker : kCameras).toObject(), facts);
  else
    add_health_facts(trial.health_json, facts);
  return facts;
}

}  // namespace isograsp::gui
