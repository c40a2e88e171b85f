// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/picture/two_hands_picture.hpp"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "gui/picture/patient_picture.hpp"

namespace isograsp::gui {

namespace {

using Sign = PatientPicture::Sign;
using Bar = TwoHandsPicture::Bar;

struct TwoHandsTexts {
  Q_DECLARE_TR_FUNCTIONS(PatientScreen)
};

/// Without a target in the trial: where a bar is about two thirds full, as the column of one hand.
constexpr double kFullHand_N = 30.0;

bool presses(Cue cue) noexcept {
  return cue != Cue::relax && cue != Cue::hand_out && cue != Cue::let_go;
}

/// Of the height above zero: the largest target of the trial stands well below the end, more force
/// still moves the mark, ever less.
double height(double force_N, double most_N) noexcept {
  if (force_N <= 0.0) return 0.0;
  if (!(most_N > 0.0)) return 1.0 - std::exp(-force_N / kFullHand_N);
  const ForceAxis axis{0.0, most_N};
  const double zero = axis.share(0.0);
  return (axis.share(force_N) - zero) / (1.0 - zero);
}

Bar bar_of(const ShownHand& shown, double most_N) {
  Bar bar;
  bar.force_shown = shown.force_shown;
  if (shown.force_shown) bar.force = height(shown.force_N, most_N);
  bar.target_shown = shown.target_shown;
  if (!shown.target_shown) return bar;
  bar.target = height(shown.target_force_N, most_N);
  bar.half_band = kHalfBandShare;
  bar.on_target = shown.force_shown && std::abs(bar.force - bar.target) <= bar.half_band;
  return bar;
}

QString act_of(const ShownHands& hands, Hand hand) {
  const Cue cue = hands.of[hand].cue;
  const bool other_works = presses(hands.of[other_than(hand)].cue);
  switch (cue) {
    case Cue::squeeze: return TwoHandsTexts::tr("squeezes");
    case Cue::follow:
    case Cue::press: return TwoHandsTexts::tr("presses");
    case Cue::move: return hands.carry ? TwoHandsTexts::tr("carries") : TwoHandsTexts::tr("lifts");
    case Cue::let_go: return TwoHandsTexts::tr("lets go");
    default: break;
  }
  return other_works ? TwoHandsTexts::tr("at rest", "the other hand works")
                     : TwoHandsTexts::tr("rests");
}

void say_of_hands(PatientPicture& picture, Sign sign, const QString& headline,
                  const QString& detail) {
  picture.sign = sign;
  picture.headline = headline.toStdString();
  picture.detail = detail.toStdString();
}

/// What comes after a rest, if it comes at once.
QString next_of_hands(const OfHands<Cue>& next) {
  const OfHands<bool> works{presses(next.left), presses(next.right)};
  if (works.left && works.right) return TwoHandsTexts::tr("Next: both hands");
  if (works.left) return TwoHandsTexts::tr("Next: left hand");
  return works.right ? TwoHandsTexts::tr("Next: right hand") : QString();
}

void say_rest(const PatientFacts& facts, PatientPicture& picture) {
  QString detail = TwoHandsTexts::tr("Do nothing. Breathe calmly.");
  const auto next = static_cast<std::size_t>(facts.stimulus.progress.segment) + 1;
  if (facts.preview != nullptr && next < facts.preview->hands.cues.size())
    if (const auto words = next_of_hands(facts.preview->hands.cues[next]); !words.isEmpty())
      detail = words;
  say_of_hands(picture, Sign::rest, TwoHandsTexts::tr("Let both hands rest"), detail);
}

void say_squeeze(const OfHands<bool>& works, PatientPicture& picture) {
  picture.urgent = true;
  const auto headline = works.left && works.right ? TwoHandsTexts::tr("Squeeze with both hands!")
                        : works.left              ? TwoHandsTexts::tr("Squeeze with the left hand!")
                                     : TwoHandsTexts::tr("Squeeze with the right hand!");
  say_of_hands(picture, Sign::act, headline, TwoHandsTexts::tr("As hard as you can. Breathe out."));
}

void say_follow(const ShownHands& hands, const OfHands<bool>& works, PatientPicture& picture) {
  if (hands.sum.target_shown)
    return say_of_hands(picture, Sign::act, TwoHandsTexts::tr("Press with both hands"),
                        TwoHandsTexts::tr("Together up to the line"));
  if (works.left && works.right)
    return say_of_hands(picture, Sign::act, TwoHandsTexts::tr("Press with both hands"),
                        TwoHandsTexts::tr("Each hand up to its line"));
  say_of_hands(picture, Sign::act,
               works.left ? TwoHandsTexts::tr("Press with the left hand")
                          : TwoHandsTexts::tr("Press with the right hand"),
               TwoHandsTexts::tr("Other hand at rest"));
}

/// The same in a pause: its notice stands over it.
void say_act(const PatientFacts& facts, PatientPicture& picture) {
  const ShownHands& hands = *facts.stimulus.hands;
  const OfHands<bool> works{presses(hands.of.left.cue), presses(hands.of.right.cue)};
  if (!works.left && !works.right) return say_rest(facts, picture);
  const Cue cue = works.left ? hands.of.left.cue : hands.of.right.cue;
  if (cue == Cue::squeeze) return say_squeeze(works, picture);
  say_follow(hands, works, picture);
}

}  // namespace

void add_two_hands(const PatientFacts& facts, PatientPicture& picture) {
  const ShownHands& hands = *facts.stimulus.hands;
  picture.page = PatientPicture::Page::two_hands;
  picture.force_shown = picture.line_shown = false;  // of one hand, which this is not about
  picture.force_N = picture.target_N = 0.0;
  TwoHandsPicture& both = picture.two_hands.emplace();
  const TargetPreview::Hands range =
      facts.preview == nullptr ? TargetPreview::Hands{} : facts.preview->hands;
  const double sum_most_N =
      hands.sum.target_shown ? std::max(range.most_sum_N, hands.sum.target_force_N) : 0.0;
  for (const Hand hand : kBothHands) {
    const ShownHand& shown = hands.of[hand];
    TwoHandsPicture::Side& side = both.of[hand];
    side.works = presses(shown.cue);
    side.name =
        (hand == Hand::left ? TwoHandsTexts::tr("Left hand") : TwoHandsTexts::tr("Right hand"))
            .toStdString();
    side.act = act_of(hands, hand).toStdString();
    // Beside a sum all stand on its scale: what the hands give adds up to what is asked.
    const double own_most_N =
        shown.target_shown ? std::max(range.most_N[hand], shown.target_force_N) : 0.0;
    side.bar = bar_of(shown, sum_most_N > 0.0 ? sum_most_N : own_most_N);
  }
  if (hands.sum.target_shown || hands.sum.force_shown) {
    both.sum = bar_of(hands.sum, sum_most_N);
    both.sum_name = TwoHandsTexts::tr("Together").toStdString();
    const double left_N = std::max(0.0, hands.of.left.force_N);
    const double all_N = left_N + std::max(0.0, hands.of.right.force_N);
    if (hands.of.left.force_shown && hands.of.right.force_shown && all_N > 0.0)
      both.left_of_sum = left_N / all_N;
  }
  say_act(facts, picture);
  if (hands.tray) add_tray(facts, picture);
  if (hands.carry) add_carry(facts, picture);
}

bool add_two_hands_between(const PatientFacts& facts, PatientPicture& picture) {
  if (facts.stage == session::Stage::zeroing) {
    say_of_hands(picture, Sign::hand_out, TwoHandsTexts::tr("Hands off, please"),
                 TwoHandsTexts::tr("The devices measure themselves."));
    return true;
  }
  if (facts.just_completed) return false;
  if (facts.stimulus.cue == Cue::hand_out)
    say_of_hands(picture, Sign::hand_out,
                 TwoHandsTexts::tr("Please take both hands out of the devices"), {});
  else
    say_of_hands(picture, Sign::wait, TwoHandsTexts::tr("Relax both hands"),
                 TwoHandsTexts::tr("The next task will begin in a moment."));
  return true;
}

}  // namespace isograsp::gui
