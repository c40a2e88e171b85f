// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/words/words.hpp"

#include <QDateTime>
#include <QLocale>
#include <QObject>
#include <algorithm>
#include <cctype>
#include <cmath>

#include "gui/words/texts.hpp"
#include "tasks/facts/measure_words.hpp"
#include "tasks/reasons/reasons.hpp"

namespace isograsp::gui {

QString short_number(double value) {
  const double size = std::abs(value);
  const int decimals = size >= 100.0 ? 0 : size >= 10.0 ? 1 : 2;
  constexpr double kRoundsToZero = 0.005;  // of two decimals: no minus before it
  QString text = translated_number(size < kRoundsToZero ? 0.0 : value, decimals);
  return text.replace(QLatin1Char('-'), QChar(0x2212));  // a real minus sign
}

QString measure_title(const Measure& measure) {
  auto title = translated(tasks::words_of(measure.name, measure.channel).title);
  if (!title.isEmpty()) title[0] = title[0].toUpper();  // of a measure that has no words here
  return title;
}

QString measure_value(const Measure& measure) {
  if (!measure.value) return QStringLiteral("–");
  const auto unit = translated(tasks::unit_words(tasks::printed_unit(measure.unit).text));
  const bool count = measure.name == "targets_reached";
  const auto number = count ? QString::number(std::lround(*measure.value))
                            : translated_digits(tasks::format_value(*measure.value, measure.unit));
  return unit.isEmpty() ? number : QStringLiteral("%1 %2").arg(number, unit);
}

QString measure_remark(const Measure& measure) {
  if (!measure.value) return translated(tasks::reason_words(measure.reason));
  if (measure.excluded > 0) return QObject::tr("%1 samples left out").arg(measure.excluded);
  return {};
}

namespace {
QString in_form(const std::string& utc, const QString& form) {
  auto time = QDateTime::fromString(QString::fromStdString(utc), Qt::ISODateWithMs);
  time.setTimeSpec(Qt::UTC);
  return time.isValid() ? QLocale().toString(time.toLocalTime(), form)
                        : QString::fromStdString(utc);
}
}  // namespace

QString local_time(const std::string& utc) {
  return in_form(utc, date_form() + QStringLiteral(" HH:mm"));
}

QString local_clock(const std::string& utc) {
  return in_form(utc, QStringLiteral("HH:mm:ss"));
}

QString local_date(const std::string& utc) {
  return in_form(utc, date_form());
}

QString health_line(const session::Snapshot& snapshot, double worst_lateness_s) {
  if (snapshot.frames == 0) return QObject::tr("No forces yet");
  std::uint64_t lost = snapshot.health.bus.kernel_drops;
  std::uint64_t damaged = 0;
  for (const auto& sensor : snapshot.health.sensors) {
    lost += sensor.lost;
    damaged += sensor.torn + sensor.invalid;
  }
  QString line = QObject::tr(
                     "Frames with gaps %1   ·   lost %2   ·   damaged %3   ·   "
                     "late %L4 ms, worst %L5 ms")
                     .arg(snapshot.frames_with_gap)
                     .arg(lost)
                     .arg(damaged)
                     .arg(snapshot.lateness_s * 1e3, 0, 'f', 1)
                     .arg(worst_lateness_s * 1e3, 0, 'f', 1);
  if (snapshot.recorder_dropped > 0)
    line += QObject::tr("   ·   not recorded %1").arg(snapshot.recorder_dropped);
  return line;
}

QString timing_details(const session::TimingSummary& timing, const Text& realtime) {
  const auto line = [](const QString& what, const session::Quantiles& q) {
    const auto ms = [](double duration_s) { return translated_number(duration_s * 1e3, 2); };
    return QObject::tr("%1: half within %2 ms, 99 % within %3, 99.9 % within %4, longest %5\n")
        .arg(what, ms(q.median_s), ms(q.most_of_100_s), ms(q.most_of_1000_s), ms(q.largest_s));
  };
  return line(QObject::tr("From frame to frame"), timing.period) +
         line(QObject::tr("Late"), timing.lateness) +
         line(QObject::tr("Work on a frame"), timing.compute) +
         (realtime.empty() ? QObject::tr("Real time was not asked for")
                           : QObject::tr("Acquisition with %1").arg(translated(realtime)));
}

QString push_words(const session::NetPush& push) {
  if (!push.share_of_grip_percent) return {};
  return QObject::tr("Push %1 %").arg(*push.share_of_grip_percent, 0, 'f', 0);
}

QString status_words(storage::TrialStatus status) {
  switch (status) {
    case storage::TrialStatus::running: return QObject::tr("running");
    case storage::TrialStatus::completed: return QObject::tr("completed");
    case storage::TrialStatus::aborted: return QObject::tr("stopped early, kept");
    case storage::TrialStatus::interrupted: return QObject::tr("interrupted, kept");
  }
  return {};
}

}  // namespace isograsp::gui
