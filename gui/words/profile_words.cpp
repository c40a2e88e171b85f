// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/words/profile_words.hpp"

#include <QCoreApplication>
#include <QDate>
#include <QRegularExpression>
#include <cmath>

#include "core/csv.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

struct ProfileTexts {
  Q_DECLARE_TR_FUNCTIONS(Profile)
};

constexpr double kOnePlus = 1.5;  // MAS between 1 and 2

QString number_words(double value) {
  return translated_digits(format_number(value));
}

/// Year, month and day as ISO 8601 has them; empty: another form.
QString iso_of(const QString& text) {
  static const QRegularExpression kYearFirst("^(\\d{4})-(\\d{1,2})-(\\d{1,2})$");
  static const QRegularExpression kDayFirst("^(\\d{1,2})\\.\\s?(\\d{1,2})\\.\\s?(\\d{4})$");
  static const QRegularExpression kDaySlash("^(\\d{1,2})/(\\d{1,2})/(\\d{4})$");
  const auto joined = [](const QString& year, const QString& month, const QString& day) {
    return QStringLiteral("%1-%2-%3")
        .arg(year, month.rightJustified(2, '0'), day.rightJustified(2, '0'));
  };
  if (const auto found = kYearFirst.match(text); found.hasMatch())
    return joined(found.captured(1), found.captured(2), found.captured(3));
  if (const auto found = kDayFirst.match(text); found.hasMatch())
    return joined(found.captured(3), found.captured(2), found.captured(1));
  // Elsewhere a slash stands behind the month.
  if (const auto found = kDaySlash.match(text);
      found.hasMatch() && date_form() == QLatin1String("dd/MM/yyyy"))
    return joined(found.captured(3), found.captured(2), found.captured(1));
  return {};
}

}  // namespace

Date local_today() {
  const QDate today = QDate::currentDate();
  return {std::chrono::year{today.year()}, std::chrono::month(static_cast<unsigned>(today.month())),
          std::chrono::day(static_cast<unsigned>(today.day()))};
}

Typed<Date> typed_date(const QString& text, Date today, Ahead ahead) {
  const QString typed = text.simplified();
  const QString example = translated_date(iso_text(today));
  if (typed.isEmpty())
    return {{}, ProfileTexts::tr("Give year, month and day, such as %1.").arg(example)};
  const std::string iso = iso_of(typed).toStdString();
  const auto date = date_from_iso(iso);
  if (!date)
    return {
        {},
        ProfileTexts::tr("“%1” is no day of the calendar. Give year, month and day, such as %2.")
            .arg(typed, example)};
  if (!storage::check_date(iso, {}))
    return {{},
            ProfileTexts::tr("The year of “%1” cannot be right: it is not between %2 and %3.")
                .arg(typed)
                .arg(storage::kFirstYear)
                .arg(storage::kLastYear)};
  if (ahead == Ahead::refused && *date > today)
    return {{}, ProfileTexts::tr("%1 has not come yet.").arg(translated_date(iso))};
  return {date, {}};
}

Typed<double> typed_score(const QString& text, const storage::ClinicalScale& scale) {
  QString typed = text.simplified();
  if (typed.isEmpty()) return {{}, ProfileTexts::tr("Give the score.")};
  if (scale.name == "MAS" && typed == "1+") return {kOnePlus, {}};
  bool is_number = false;
  const double value = QString(typed).replace(',', '.').toDouble(&is_number);
  if (!is_number || !std::isfinite(value))
    return {{}, ProfileTexts::tr("“%1” is no number.").arg(typed)};
  const storage::ClinicalScore score{0, "2026-01-01", std::string(scale.name), value, ""};
  if (!storage::check_clinical_score(score))
    return {{}, ProfileTexts::tr("%1 is not possible. %2.").arg(typed, range_words(scale))};
  return {value, {}};
}

QString onset_words(Date onset, Date today) {
  const int days = days_between(onset, today);
  if (days == 0) return ProfileTexts::tr("The onset is today.");
  if (days == 1) return ProfileTexts::tr("1 day since the onset.");
  return ProfileTexts::tr("%1 days since the onset.").arg(days);
}

QString treatment_words(const std::string& kind) {
  if (kind == "botulinum_toxin") return ProfileTexts::tr("Botulinum toxin");
  if (kind == "drug") return ProfileTexts::tr("Drug");
  if (kind == "orthosis") return ProfileTexts::tr("Orthosis");
  if (kind == "therapy") return ProfileTexts::tr("Therapy");
  if (kind == "other") return ProfileTexts::tr("Other");
  return QString::fromStdString(kind);
}

QString scale_words(std::string_view scale) {
  if (scale == "ARAT") return ProfileTexts::tr("Action Research Arm Test");
  if (scale == "FMA-UE") return ProfileTexts::tr("Fugl-Meyer Assessment, arm and hand");
  if (scale == "BBT") return ProfileTexts::tr("Box and Block Test");
  if (scale == "NHPT") return ProfileTexts::tr("Nine-Hole Peg Test");
  if (scale == "MAL") return ProfileTexts::tr("Motor Activity Log");
  if (scale == "MAS") return ProfileTexts::tr("Modified Ashworth Scale");
  if (scale == "sensation") return ProfileTexts::tr("Sensation, as your clinic counts it");
  return QString::fromUtf8(scale.data(), static_cast<int>(scale.size()));
}

QString range_words(const storage::ClinicalScale& scale) {
  const QString name = scale_words(scale.name);
  const QString least = number_words(scale.least);
  if (std::isinf(scale.least)) return ProfileTexts::tr("%1: any number").arg(name);
  if (scale.unit == "s") return ProfileTexts::tr("%1: more than %2 seconds").arg(name, least);
  if (scale.unit == "blocks") return ProfileTexts::tr("%1: %2 blocks or more").arg(name, least);
  return ProfileTexts::tr("%1: %2 to %3").arg(name, least, number_words(scale.most));
}

QString score_words(const storage::ClinicalScore& score) {
  if (score.scale == "MAS" && score.value == kOnePlus) return QStringLiteral("1+");
  const storage::ClinicalScale* const scale = storage::clinical_scale(score.scale);
  const QString number = number_words(score.value);
  if (scale != nullptr && scale->unit == "s") return ProfileTexts::tr("%1 s").arg(number);
  if (scale != nullptr && scale->unit == "blocks") return ProfileTexts::tr("%1 blocks").arg(number);
  return number;
}

}  // namespace isograsp::gui
