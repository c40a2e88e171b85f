// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/rules/screening.hpp"

#include <QCoreApplication>
#include <QStringList>

namespace isograsp::gui {

namespace {

struct ScreeningTexts {
  Q_DECLARE_TR_FUNCTIONS(Screening)
};

bool applies(const Screening& screening, Caution caution) {
  return screening.applies[static_cast<std::size_t>(caution)];
}

}  // namespace

const char* name_of(Caution caution) noexcept {
  switch (caution) {
    case Caution::no_clearance: return "no_clearance";
    case Caution::injury: return "injury";
    case Caution::skin: return "skin_or_sensation";
    case Caution::treatment: return "treatment_changed";
    case Caution::seizures: return "seizures";
  }
  return "";
}

QString words_of(Caution caution) {
  switch (caution) {
    case Caution::no_clearance: return ScreeningTexts::tr("No clearance for maximal effort");
    case Caution::injury: return ScreeningTexts::tr("Injury or inflammation of the hand");
    case Caution::skin: return ScreeningTexts::tr("Broken or numb skin");
    case Caution::treatment: return ScreeningTexts::tr("Botulinum toxin or drug changed");
    case Caution::seizures: return ScreeningTexts::tr("Seizures");
  }
  return {};
}

QString details_of(Caution caution) {
  switch (caution) {
    case Caution::no_clearance:
      return ScreeningTexts::tr(
          "Recent haemorrhage or infarct, unstable heart disease, blood pressure at rest above "
          "180/110, aneurysm, recent eye surgery, or nobody has cleared it");
    case Caution::injury:
      return ScreeningTexts::tr("Fracture, tendon repair, wound, acute arthritis, CRPS");
    case Caution::skin:
      return ScreeningTexts::tr("Under the straps: wounds, pressure marks, no feeling");
    case Caution::treatment: return ScreeningTexts::tr("Since the last session");
    case Caution::seizures: return ScreeningTexts::tr("In the last year, or known epilepsy");
  }
  return {};
}

std::vector<storage::SessionAnswer> stored(const Screening& screening) {
  constexpr const char* kTopic = "screening";
  std::vector<storage::SessionAnswer> answers;
  for (const Caution caution : kCautions)
    answers.push_back({kTopic, name_of(caution), applies(screening, caution) ? "yes" : "no"});
  answers.push_back({kTopic, "pain", std::to_string(*screening.pain)});
  return answers;
}

std::optional<tasks::Effort> suggested(const Screening& screening) {
  if (!screening.pain) return std::nullopt;
  if (applies(screening, Caution::injury) || *screening.pain >= kTooMuchPain)
    return tasks::Effort::none;
  if (applies(screening, Caution::no_clearance)) return tasks::Effort::comfortable;
  return tasks::Effort::maximum;
}

QString advice(const Screening& screening) {
  QStringList sentences;
  if (applies(screening, Caution::skin))
    sentences += ScreeningTexts::tr("Look at the straps every 20 minutes.");
  if (applies(screening, Caution::treatment))
    sentences += ScreeningTexts::tr("Mark the treatment on the patient's page.");
  if (applies(screening, Caution::seizures))
    sentences += ScreeningTexts::tr("Stay beside the patient; the straps open with one hand.");
  return sentences.join(QLatin1Char(' '));
}

QString words_of(tasks::Effort effort) {
  switch (effort) {
    case tasks::Effort::maximum: return ScreeningTexts::tr("Maximum allowed");
    case tasks::Effort::comfortable: return ScreeningTexts::tr("Comfortable force only");
    case tasks::Effort::none: return ScreeningTexts::tr("No force");
  }
  return {};
}

QString summary(const Screening& screening) {
  if (!screening.complete()) return {};
  const auto effort = *screening.allowed == tasks::Effort::maximum ? ScreeningTexts::tr("maximum")
                      : *screening.allowed == tasks::Effort::comfortable
                          ? ScreeningTexts::tr("comfortable")
                          : ScreeningTexts::tr("no force");
  const auto words = ScreeningTexts::tr("%1, pain %2").arg(effort).arg(*screening.pain);
  if (!screening.ceiling_N) return words;
  return ScreeningTexts::tr("%1, ≤ %2 N").arg(words).arg(*screening.ceiling_N, 0, 'f', 0);
}

}  // namespace isograsp::gui
