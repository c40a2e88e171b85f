// SPDX-License-Identifier: GPL-3.0-or-later
// The words of the flow before a tracker that sees a hand, where they differ from those of forces.
#include <QCoreApplication>
#include <QString>

#include "gui/rules/flow_parts.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

struct FlowHandTexts {
  Q_DECLARE_TR_FUNCTIONS(Flow)
};

/// What the running entry test asks for.
QString entry_words(const FlowFacts& facts) {
  using Stage = session::HandEntry::Stage;
  if (!facts.entry || facts.entry->stage == Stage::rest)
    return FlowHandTexts::tr("Entry test: the hand lies still for ten seconds.");
  return FlowHandTexts::tr("Entry test: the hand opens wide, then closes. %1 of %2.")
      .arg(facts.entry->openings)
      .arg(session::HandEntry::kOpenings);
}

}  // namespace

QString hand_device_words(const FlowFacts& facts, DeviceCondition condition) {
  using Condition = DeviceCondition;
  if (!facts.hand_entry) return {};
  switch (condition) {
    case Condition::gone: return FlowHandTexts::tr("The tracker sends no more pictures");
    case Condition::frozen:
      return FlowHandTexts::tr("Nothing arrives: check the tracker and its program");
    case Condition::waiting: return FlowHandTexts::tr("Waiting for the first picture …");
    case Condition::faulted:
    case Condition::degraded:
      if (facts.hand_fault == HandFault::none) return {};
      return translated(words_of(facts.hand_fault));
    case Condition::gap: return FlowHandTexts::tr("Connected, but pictures were missing");
    case Condition::zeroing: return FlowHandTexts::tr("Entry test …");
    case Condition::no_zero: return FlowHandTexts::tr("Connected, needs the entry test");
    default: return {};
  }
}

QString hand_words(Situation situation, const FlowFacts& facts) {
  if (!facts.hand_entry) return {};
  switch (situation) {
    case Situation::connecting: return FlowHandTexts::tr("Connecting to the tracker …");
    case Situation::choose_hand:
      return FlowHandTexts::tr("Which hand works today? Choose right or left.");
    case Situation::screen:
      return FlowHandTexts::tr("Ask the screening questions before any movement.");
    case Situation::connect: return FlowHandTexts::tr("Connect the tracker to begin the session.");
    case Situation::device_gone:
      return FlowHandTexts::tr(
          "The tracker sends no more pictures. Disconnect to end the session.");
    case Situation::wait_for_forces: return FlowHandTexts::tr("Waiting for the first picture …");
    case Situation::zeroing: return entry_words(facts);
    case Situation::paused_by_fault:
      return FlowHandTexts::tr("Paused: the tracker sent no hand. Resume when it works again.");
    case Situation::goes_on_by_itself:
      return FlowHandTexts::tr("The hand is not seen. The trial goes on by itself.");
    case Situation::zero_refused: return translated(facts.zero_refusal);
    case Situation::zero_missing:
    case Situation::protocol_zero:
      return FlowHandTexts::tr(
          "The hand lies on the table before the tracker: begin the entry test.");
    case Situation::check_picture:
      return facts.picture_watched
                 ? FlowHandTexts::tr("The hand is moved as Live hand says.")
                 : FlowHandTexts::tr(
                       "Before the first object: check that the picture moves as the hand does.");
    default: return {};
  }
}

QString hand_hint(const FlowFacts& facts, Obstacle obstacle) {
  if (!facts.hand_entry) return {};
  switch (obstacle) {
    case Obstacle::no_device: return FlowHandTexts::tr("Connect the tracker first.");
    case Obstacle::no_zero:
      return facts.zero_refusal.empty()
                 ? FlowHandTexts::tr("Do the entry test first.")
                 : FlowHandTexts::tr("No virtual objects for this hand: its entry test says so.");
    case Obstacle::zeroing: return FlowHandTexts::tr("Wait until the entry test is over.");
    case Obstacle::zero_again: return FlowHandTexts::tr("Do the entry test first.");
    case Obstacle::picture_unsure:
      return FlowHandTexts::tr("Check the picture first, in Live hand.");
    default: return {};
  }
}

}  // namespace isograsp::gui
