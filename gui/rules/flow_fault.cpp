// SPDX-License-Identifier: GPL-3.0-or-later
// A fault as it is told to the therapist: what happened, what is safe, what to do.
#include <QCoreApplication>
#include <QString>

#include "gui/rules/flow_parts.hpp"

namespace isograsp::gui {

namespace {

struct FlowFaultTexts {
  Q_DECLARE_TR_FUNCTIONS(FlowFault)
};

QString safe_words(const FlowFacts& facts) {
  const auto until = QString::fromStdString(facts.stored_until);
  if (facts.connection == Connection::open) {
    if (!in_trial(facts)) return FlowFaultTexts::tr("All that was measured is stored.");
    return until.isEmpty()
               ? FlowFaultTexts::tr("The trial stands still.")
               : FlowFaultTexts::tr("The trial stands still; all up to %1 is stored.").arg(until);
  }
  if (!facts.broken_off)
    return FlowFaultTexts::tr("No session has begun, and nothing was changed.");
  return until.isEmpty() ? FlowFaultTexts::tr("What is kept, and where, is said below.")
                         : FlowFaultTexts::tr("All up to %1 is stored.").arg(until);
}

QString remedy_words(const FlowFacts& facts, const FlowView& view) {
  switch (view.situation) {
    case Situation::session_failed: return QString::fromStdString(facts.connection_remedy);
    case Situation::device_gone:
      return facts.is_seen()
                 ? FlowFaultTexts::tr(
                       "Look at cables and power. Try again ends this session; the "
                       "next one begins with the questions before it.")
                 : FlowFaultTexts::tr(
                       "Look at cables and power of the device. Try again ends this session; the "
                       "next one begins with the questions before it.");
    case Situation::device_fault:
      return FlowFaultTexts::tr("Look at cables and power: it goes on when data arrive again.");
    case Situation::let_go:
    case Situation::paused_by_fault:
      return facts.is_seen() ? FlowFaultTexts::tr("Resume when the picture is back.")
                             : FlowFaultTexts::tr(
                                   "When it works again, the hand lets go; then resume. If "
                                   "Resume stays closed: stop, set the zero, repeat the trial.");
    default: return {};
  }
}

}  // namespace

std::optional<FaultStory> fault_of(const FlowFacts& facts, const FlowView& view) {
  switch (view.situation) {
    case Situation::session_failed:
    case Situation::device_gone:
    case Situation::device_fault:
    case Situation::paused_by_fault: break;
    default: return std::nullopt;
  }
  const bool told = view.device_mood == Mood::fault || view.device_mood == Mood::attention;
  FaultStory story;
  story.happened = told && !view.device_words.empty() ? view.device_words : view.sentence;
  story.safe = safe_words(facts).toStdString();
  story.remedy = remedy_words(facts, view).toStdString();
  return story;
}

}  // namespace isograsp::gui
