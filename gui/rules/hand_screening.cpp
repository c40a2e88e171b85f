// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/rules/hand_screening.hpp"

#include <QCoreApplication>
#include <QStringList>
#include <string>

#include "gui/rules/screening.hpp"

namespace isograsp::gui {

namespace {

struct HandScreeningTexts {
  Q_DECLARE_TR_FUNCTIONS(HandScreening)
};

}  // namespace

const char* name_of(HandQuestion question) noexcept {
  switch (question) {
    case HandQuestion::shoulder: return "shoulder";
    case HandQuestion::injury: return name_of(Caution::injury);
    case HandQuestion::treatment: return name_of(Caution::treatment);
    case HandQuestion::seizures: return name_of(Caution::seizures);
  }
  return "";
}

QString words_of(HandQuestion question) {
  switch (question) {
    case HandQuestion::shoulder: return HandScreeningTexts::tr("Shoulder pain or subluxation");
    case HandQuestion::injury: return words_of(Caution::injury);
    case HandQuestion::treatment: return words_of(Caution::treatment);
    case HandQuestion::seizures: return words_of(Caution::seizures);
  }
  return {};
}

QString details_of(HandQuestion question) {
  switch (question) {
    case HandQuestion::shoulder:
      return HandScreeningTexts::tr("The hand is carried to its targets: support the forearm");
    case HandQuestion::injury: return details_of(Caution::injury);
    case HandQuestion::treatment: return details_of(Caution::treatment);
    case HandQuestion::seizures: return details_of(Caution::seizures);
  }
  return {};
}

tasks::Effort allowed(const HandScreening& screening) noexcept {
  return *screening.may_move ? tasks::Effort::maximum : tasks::Effort::none;
}

std::vector<storage::SessionAnswer> stored(const HandScreening& screening) {
  constexpr const char* kTopic = "screening";
  std::vector<storage::SessionAnswer> answers;
  for (const HandQuestion question : kHandQuestions)
    answers.push_back({kTopic, name_of(question), screening.is(question) ? "yes" : "no"});
  answers.push_back({kTopic, "pain", std::to_string(*screening.pain)});
  answers.push_back({"posture", "forearm_supported", screening.forearm_supported ? "yes" : "no"});
  return answers;
}

std::optional<bool> suggested(const HandScreening& screening) {
  if (!screening.pain) return std::nullopt;
  return !screening.is(HandQuestion::injury) && *screening.pain < kTooMuchPain;
}

QString advice(const HandScreening& screening) {
  QStringList sentences;
  if (screening.is(HandQuestion::shoulder))
    sentences +=
        screening.forearm_supported
            ? HandScreeningTexts::tr("Stop where the shoulder hurts.")
            : HandScreeningTexts::tr("Support the forearm; stop where the shoulder hurts.");
  if (screening.is(HandQuestion::treatment))
    sentences += HandScreeningTexts::tr("Mark the treatment on the patient's page.");
  if (screening.is(HandQuestion::seizures))
    sentences += HandScreeningTexts::tr("Stay beside the patient.");
  return sentences.join(QLatin1Char(' '));
}

QString summary(const HandScreening& screening) {
  if (!screening.complete()) return {};
  const auto words = *screening.may_move ? HandScreeningTexts::tr("may move, pain %1")
                                         : HandScreeningTexts::tr("no movement, pain %1");
  return words.arg(*screening.pain);
}

}  // namespace isograsp::gui
