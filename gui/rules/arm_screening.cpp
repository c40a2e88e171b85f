// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/rules/arm_screening.hpp"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <numbers>

#include "gui/rules/screening.hpp"

namespace isograsp::gui {

namespace {

struct ArmScreeningTexts {
  Q_DECLARE_TR_FUNCTIONS(ArmScreening)
};

constexpr std::array<PassiveJoint, kPassiveJointCount> kPassiveJoints{
    {{{ArmLink::forearm, 3},
      "forearm",
      QT_TRANSLATE_NOOP("ArmScreening", "Supination / pronation"),
      QT_TRANSLATE_NOOP("ArmScreening", "Supination"),
      QT_TRANSLATE_NOOP("ArmScreening", "Pronation")},
     {{ArmLink::wrist, 1},
      "flexion",
      QT_TRANSLATE_NOOP("ArmScreening", "Extension / flexion"),
      QT_TRANSLATE_NOOP("ArmScreening", "Extension"),
      QT_TRANSLATE_NOOP("ArmScreening", "Flexion")},
     {{ArmLink::wrist, 2},
      "deviation",
      QT_TRANSLATE_NOOP("ArmScreening", "Radial / ulnar deviation"),
      QT_TRANSLATE_NOOP("ArmScreening", "Radial deviation"),
      QT_TRANSLATE_NOOP("ArmScreening", "Ulnar deviation")}}};

}  // namespace

const std::array<PassiveJoint, kPassiveJointCount>& passive_joints() noexcept {
  return kPassiveJoints;
}
QString words_of(const PassiveJoint& joint) {
  return ArmScreeningTexts::tr(joint.title);
}
QString negative_words(const PassiveJoint& joint) {
  return ArmScreeningTexts::tr(joint.negative);
}
QString positive_words(const PassiveJoint& joint) {
  return ArmScreeningTexts::tr(joint.positive);
}

const char* name_of(ArmQuestion question) noexcept {
  switch (question) {
    case ArmQuestion::shoulder: return "shoulder";
    case ArmQuestion::contracture: return "contracture";
    case ArmQuestion::tape: return "tape_allergy";
    case ArmQuestion::turns: return "turns_10_deg";
    case ArmQuestion::holds: return "holds_10_s";
  }
  return "";
}

QString words_of(ArmQuestion question) {
  switch (question) {
    case ArmQuestion::shoulder: return ArmScreeningTexts::tr("Shoulder pain or subluxation");
    case ArmQuestion::contracture: return ArmScreeningTexts::tr("Contracture");
    case ArmQuestion::tape: return ArmScreeningTexts::tr("Tape allergy or broken skin");
    case ArmQuestion::turns: return ArmScreeningTexts::tr("Turns the forearm by 10°, unaided");
    case ArmQuestion::holds: return ArmScreeningTexts::tr("Holds the object for 10 s");
  }
  return {};
}

QString details_of(ArmQuestion question) {
  switch (question) {
    case ArmQuestion::shoulder:
      return ArmScreeningTexts::tr("The arm is supported, and never pulled into its posture");
    case ArmQuestion::contracture:
      return ArmScreeningTexts::tr(
          "Of elbow, forearm, wrist or fingers: measure the passive range and enter it below");
    case ArmQuestion::tape:
      return ArmScreeningTexts::tr("Where markers are put on: bands instead of tape");
    case ArmQuestion::turns:
    case ArmQuestion::holds:
      return ArmScreeningTexts::tr("Without it tasks of the arm are not offered");
  }
  return {};
}

bool ArmScreening::ranges_hold() const noexcept {
  return std::all_of(passive.begin(), passive.end(), [](const auto& range) {
    return !range || -range->negative < range->positive;
  });
}

std::vector<storage::SessionAnswer> stored(const ArmScreening& screening) {
  constexpr const char* kTopic = "screening";
  std::vector<storage::SessionAnswer> answers;
  for (const ArmQuestion question : kArmQuestions)
    answers.push_back({kTopic, name_of(question), screening.is(question) ? "yes" : "no"});
  answers.push_back({kTopic, "pain", std::to_string(*screening.pain)});
  constexpr double kDegree_rad = std::numbers::pi / 180.0;
  std::vector<PassiveLimit> limits;
  for (std::size_t j = 0; j < kPassiveJointCount; ++j)
    if (const auto& range = screening.passive[j])
      limits.push_back(
          {kPassiveJoints[j].angle, -kDegree_rad * range->negative, kDegree_rad * range->positive});
  for (auto& answer : session::stored(limits)) answers.push_back(std::move(answer));
  return answers;
}

std::optional<tasks::Effort> suggested(const ArmScreening& screening) {
  if (!screening.pain) return std::nullopt;
  if (!screening.offered() || *screening.pain >= kTooMuchPain) return tasks::Effort::none;
  if (screening.is(ArmQuestion::shoulder) || screening.is(ArmQuestion::contracture))
    return tasks::Effort::comfortable;
  return tasks::Effort::maximum;
}

QString advice(const ArmScreening& screening) {
  QStringList sentences;
  if (screening.pain && !screening.offered())
    sentences += ArmScreeningTexts::tr(
        "Tasks of the arm need 10° of the forearm and 10 s of holding: take the isometric tasks of "
        "the hand instead.");
  if (screening.is(ArmQuestion::shoulder))
    sentences += ArmScreeningTexts::tr("Support the arm; stop where the shoulder hurts.");
  if (screening.is(ArmQuestion::contracture) &&
      std::none_of(screening.passive.begin(), screening.passive.end(),
                   [](const auto& range) { return range.has_value(); }))
    sentences += ArmScreeningTexts::tr("Enter the passive range: no target goes beyond it.");
  if (screening.is(ArmQuestion::tape))
    sentences += ArmScreeningTexts::tr("Markers on bands or clothes, no tape on the skin.");
  if (!screening.ranges_hold())
    sentences += ArmScreeningTexts::tr("A passive range has no angle in it: correct its numbers.");
  return sentences.join(QLatin1Char(' '));
}

QString range_words(tasks::Effort effort) {
  switch (effort) {
    case tasks::Effort::maximum: return ArmScreeningTexts::tr("Own range");
    case tasks::Effort::comfortable: return ArmScreeningTexts::tr("Small range: half of the way");
    case tasks::Effort::none: return ArmScreeningTexts::tr("No movement");
  }
  return {};
}

QString summary(const ArmScreening& screening) {
  if (!screening.complete()) return {};
  const auto range =
      *screening.allowed == tasks::Effort::maximum       ? ArmScreeningTexts::tr("own range")
      : *screening.allowed == tasks::Effort::comfortable ? ArmScreeningTexts::tr("small range")
                                                         : ArmScreeningTexts::tr("no movement");
  return ArmScreeningTexts::tr("%1, pain %2").arg(range).arg(*screening.pain);
}

}  // namespace isograsp::gui
