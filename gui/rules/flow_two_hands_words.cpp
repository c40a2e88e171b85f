// SPDX-License-Identifier: GPL-3.0-or-later
// The words of the flow on two platforms, one for each hand, where they differ from those of one.
#include <QCoreApplication>
#include <QString>

#include "gui/rules/flow_parts.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

struct FlowBothTexts {
  Q_DECLARE_TR_FUNCTIONS(Flow)
};

/// Whose platform it is.
QString of_side(const std::optional<Hand>& side, const QString& words) {
  if (!side) return words;
  return (*side == Hand::left ? FlowBothTexts::tr("Left platform: %1")
                              : FlowBothTexts::tr("Right platform: %1"))
      .arg(words);
}

QString both_restart_words(const FlowFacts& facts) {
  return of_side(facts.restarted_side,
                 translated(words_of(DeviceFault::restarted, facts.restarted)));
}

QString before_both(Situation situation) {
  switch (situation) {
    case Situation::screen:
      return FlowBothTexts::tr("Ask the screening questions of each hand before any force.");
    case Situation::connecting: return FlowBothTexts::tr("Connecting to both platforms …");
    case Situation::choose_device: return FlowBothTexts::tr("Choose the platform of each hand.");
    case Situation::connect:
      return FlowBothTexts::tr("Connect both platforms to begin the session.");
    default: return {};
  }
}

/// What makes the hands free at any time comes before they are in.
QString before_hands_are_in(Situation situation, const FlowFacts& facts) {
  switch (situation) {
    case Situation::check_platforms:
      return facts.platforms_pressed
                 ? FlowBothTexts::tr("One platform is pressed, nobody touches the other.")
                 : FlowBothTexts::tr(
                       "Both zeros are set. Check whether the empty platforms move each other.");
    case Situation::test_stop:
      return FlowBothTexts::tr(
          "Before the hands go in: press the pedal (F9) or the stop key (F10) once, as a test.");
    case Situation::promise_reach:
      return FlowBothTexts::tr("The stop works. Confirm that you stay within reach.");
    case Situation::strap_in:
      return facts.protocol.active && facts.protocol.by_itself
                 ? FlowBothTexts::tr(
                       "Put both hands in and say so; after a minute the resting force begins.")
                 : FlowBothTexts::tr(
                       "Put both hands in and say so; after a minute start the resting force.");
    case Situation::strap_again:
      return FlowBothTexts::tr("Both zeros are set. Put both hands in again and say so.");
    case Situation::settle:
      return facts.protocol.active && facts.protocol.goes_on
                 ? FlowBothTexts::tr(
                       "Both hands are in. They settle: %1 s, then the resting force "
                       "begins.")
                       .arg(facts.settling_s)
                 : FlowBothTexts::tr(
                       "Both hands are in. They settle: %1 s until the resting force.")
                       .arg(facts.settling_s);
    case Situation::rest_ready:
      return FlowBothTexts::tr("The hands have settled. They relax: start the resting force.");
    case Situation::straps_due:
      return FlowBothTexts::tr(
          "The straps have been on for 20 minutes: look at the skin, then confirm that the hands "
          "are in.");
    default: return {};
  }
}

}  // namespace

QString both_device_words(const FlowFacts& facts, DeviceCondition condition) {
  using Condition = DeviceCondition;
  if (!facts.both_hands) return {};
  switch (condition) {
    case Condition::gone: return FlowBothTexts::tr("A platform sends no more forces");
    case Condition::frozen:
      return FlowBothTexts::tr("No forces arrive: check cable and power of both platforms");
    case Condition::outdated: return both_restart_words(facts);
    case Condition::faulted:
    case Condition::degraded:
      return of_side(facts.health_side,
                     translated(words_of(facts.health.fault, facts.health.finger)));
    case Condition::zeroing: return FlowBothTexts::tr("Measuring both empty platforms …");
    case Condition::no_zero: return FlowBothTexts::tr("Connected, both need their zero");
    default: return {};
  }
}

QString both_words(Situation situation, const FlowFacts& facts) {
  if (!facts.both_hands) return {};
  if (const auto words = before_both(situation); !words.isEmpty()) return words;
  if (const auto words = before_hands_are_in(situation, facts); !words.isEmpty()) return words;
  switch (situation) {
    case Situation::device_gone:
      return FlowBothTexts::tr("A platform sends no more forces. Disconnect to end the session.");
    case Situation::zeroing:
      return FlowBothTexts::tr("Setting both zeros. Nobody touches the platforms.");
    case Situation::zero_outdated: return both_restart_words(facts);
    case Situation::zero_missing:
      return FlowBothTexts::tr("Both platforms connected. Set their zeros with both empty.");
    case Situation::protocol_zero:
      return FlowBothTexts::tr(
          "Take both hands out, then set the zeros of the empty platforms once more.");
    case Situation::let_go:
      return FlowBothTexts::tr(
          "The device works again. Both hands let go; if Resume stays closed, stop, set the zeros "
          "and repeat the trial.");
    case Situation::first_maximum:
      return FlowBothTexts::tr("%1 Next: the maxima of both hands.")
          .arg(facts.rest_words.empty() ? FlowBothTexts::tr("Resting forces are known.")
                                        : translated(facts.rest_words));
    case Situation::choose_task:
      return FlowBothTexts::tr("The maxima are known. Choose a task and press Start.");
    default: return {};
  }
}

QString both_hint(const FlowFacts& facts, Obstacle obstacle) {
  if (!facts.both_hands) return {};
  switch (obstacle) {
    case Obstacle::no_device: return FlowBothTexts::tr("Connect both platforms first.");
    case Obstacle::no_zero: return FlowBothTexts::tr("Set both zeros first, with both empty.");
    case Obstacle::zeroing: return FlowBothTexts::tr("Wait until both zeros are set.");
    case Obstacle::zero_again:
      return FlowBothTexts::tr("Set the zeros of the empty platforms once more.");
    case Obstacle::platforms_unchecked:
      return FlowBothTexts::tr("Check the platforms first, or skip that check.");
    case Obstacle::stop_untested:
      return FlowBothTexts::tr("Press the pedal (F9) or F10 once, as a test.");
    case Obstacle::not_within_reach:
      return FlowBothTexts::tr("Confirm first that you stay within reach.");
    case Obstacle::not_strapped: return FlowBothTexts::tr("Say first that both hands are in.");
    case Obstacle::settles:
      return FlowBothTexts::tr("The hands settle: %1 s.").arg(facts.settling_s);
    default: return {};
  }
}

}  // namespace isograsp::gui
