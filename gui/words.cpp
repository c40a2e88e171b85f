// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/words.hpp"

#include <QDateTime>
#include <QObject>
#include <cmath>

#include "reports/measure_words.hpp"

namespace isograsp {

QString short_number(double value) {
  const double size = std::abs(value);
  const int decimals = size >= 100.0 ? 0 : size >= 10.0 ? 1 : 2;
  QString text = QString::number(value, 'f', decimals);
  return text.replace(QLatin1Char('-'), QChar(0x2212));  // a real minus sign
}

QString measure_title(const Measure& measure) {
  if (measure.name == "resting_force" && measure.channel != "grip") {
    const auto axis = QString::fromStdString(measure.channel).replace('_', ' ');
    return QObject::tr("Resting force, %1").arg(axis);
  }
  auto title = QString::fromStdString(words_for(measure.name, measure.channel).title);
  if (!title.isEmpty()) title[0] = title[0].toUpper();
  return title;
}

QString measure_value(const Measure& measure) {
  if (!measure.value) return QStringLiteral("–");
  const auto unit = QString::fromStdString(printed_unit(measure.unit).text);
  const bool count = measure.name == "targets_reached";
  const auto number = count ? QString::number(std::lround(*measure.value))
                            : QString::fromStdString(format_value(*measure.value, measure.unit));
  return unit.isEmpty() ? number : QStringLiteral("%1 %2").arg(number, unit);
}

QString measure_remark(const Measure& measure) {
  if (!measure.value) return QString::fromStdString(measure.reason);
  if (measure.excluded > 0) return QObject::tr("%1 samples left out").arg(measure.excluded);
  return {};
}

QString local_time(const std::string& utc) {
  auto time = QDateTime::fromString(QString::fromStdString(utc), Qt::ISODateWithMs);
  time.setTimeSpec(Qt::UTC);
  return time.isValid() ? time.toLocalTime().toString(QStringLiteral("yyyy-MM-dd hh:mm"))
                        : QString::fromStdString(utc);
}

QString health_line(const Snapshot& snapshot, double worst_lateness_s) {
  if (snapshot.frames == 0) return QObject::tr("No forces yet");
  std::uint64_t lost = snapshot.health.bus.kernel_drops;
  std::uint64_t damaged = 0;
  for (const auto& sensor : snapshot.health.sensors) {
    lost += sensor.lost;
    damaged += sensor.torn + sensor.invalid;
  }
  QString line = QObject::tr(
                     "Frames with gaps %1   ·   lost %2   ·   damaged %3   ·   "
                     "late %4 ms, worst %5 ms")
                     .arg(snapshot.frames_with_gap)
                     .arg(lost)
                     .arg(damaged)
                     .arg(snapshot.lateness_s * 1e3, 0, 'f', 1)
                     .arg(worst_lateness_s * 1e3, 0, 'f', 1);
  if (snapshot.recorder_dropped > 0)
    line += QObject::tr("   ·   not recorded %1").arg(snapshot.recorder_dropped);
  return line;
}

QString timing_details(const TimingSummary& timing, const std::string& realtime) {
  const auto line = [](const QString& what, const Quantiles& q) {
    const auto ms = [](double duration_s) { return QString::number(duration_s * 1e3, 'f', 2); };
    return QObject::tr("%1: half within %2 ms, 99 % within %3, 99.9 % within %4, longest %5\n")
        .arg(what, ms(q.median_s), ms(q.most_of_100_s), ms(q.most_of_1000_s), ms(q.largest_s));
  };
  return line(QObject::tr("From frame to frame"), timing.period) +
         line(QObject::tr("Late"), timing.lateness) +
         line(QObject::tr("Work on a frame"), timing.compute) +
         (realtime.empty()
              ? QObject::tr("Real time was not asked for")
              : QObject::tr("Acquisition with %1").arg(QString::fromStdString(realtime)));
}

QString push_words(const NetPush& push) {
  if (!push.share_of_grip_percent) return {};
  return QObject::tr("Push %1 %").arg(*push.share_of_grip_percent, 0, 'f', 0);
}

QString status_words(TrialStatus status) {
  switch (status) {
    case TrialStatus::running: return QObject::tr("running");
    case TrialStatus::completed: return QObject::tr("completed");
    case TrialStatus::aborted: return QObject::tr("stopped early, kept");
    case TrialStatus::interrupted: return QObject::tr("interrupted, kept");
  }
  return {};
}

}  // namespace isograsp
