// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/words/cue_words.hpp"

#include <QCoreApplication>
#include <QString>

namespace isograsp::gui {

namespace {

struct CueTexts {
  Q_DECLARE_TR_FUNCTIONS(PatientScreen)
};

bool is_whole_hand(Digits digits) {
  return digits == Digits::grip || digits == Digits::grip_mean || digits == Digits::sum;
}

QString digit_title(Digits digits) {
  switch (digits) {
    case Digits::pinch: return CueTexts::tr("Thumb and index");
    case Digits::thumb: return CueTexts::tr("Thumb");
    case Digits::index: return CueTexts::tr("Index finger");
    case Digits::middle: return CueTexts::tr("Middle finger");
    default: return CueTexts::tr("All fingers");
  }
}

QString close(Digits digits) {
  switch (digits) {
    case Digits::pinch: return CueTexts::tr("Pinch: thumb and index");
    case Digits::sum: return CueTexts::tr("Press with all fingers");
    case Digits::thumb: return CueTexts::tr("Press with the thumb only");
    case Digits::index: return CueTexts::tr("Press with the index finger only");
    case Digits::middle: return CueTexts::tr("Press with the middle finger only");
    default: return CueTexts::tr("Squeeze");
  }
}

/// Against the straps.
QString open(Digits digits) {
  if (is_whole_hand(digits)) return CueTexts::tr("Open your hand");
  if (digits == Digits::pinch) return CueTexts::tr("Open thumb and index");
  return CueTexts::tr("%1: pull back").arg(digit_title(digits));
}

/// Along the forearm. Thumb and fingers face each other: the same sign sends them opposite ways.
QString slide(Digits digits, bool plus_y, Hand hand) {
  const bool thumb_toward = plus_y == plus_y_is_toward(Finger::thumb, hand);
  switch (digits) {
    case Digits::thumb:
    case Digits::index:
    case Digits::middle:
      return ((digits == Digits::thumb) == thumb_toward ? CueTexts::tr("%1: pull toward you")
                                                        : CueTexts::tr("%1: push away"))
          .arg(digit_title(digits));
    case Digits::pinch:
      return thumb_toward ? CueTexts::tr("Thumb toward you, index away")
                          : CueTexts::tr("Thumb away, index toward you");
    default:
      return thumb_toward ? CueTexts::tr("Thumb toward you, fingers away")
                          : CueTexts::tr("Thumb away, fingers toward you");
  }
}

QString act_words(ForceChannel channel, Hand hand) {
  switch (channel.direction) {
    case Direction::plus_z: return close(channel.digits);
    case Direction::minus_z: return open(channel.digits);
    case Direction::plus_x: return CueTexts::tr("%1: push up").arg(digit_title(channel.digits));
    case Direction::minus_x: return CueTexts::tr("%1: push down").arg(digit_title(channel.digits));
    case Direction::plus_y: return slide(channel.digits, true, hand);
    case Direction::minus_y: return slide(channel.digits, false, hand);
  }
  return {};
}

CueWords plain_cue(const QString& headline, const QString& detail) {
  return {headline.toStdString(), detail.toStdString()};
}

}  // namespace

std::string act_of(ForceChannel channel, Hand hand) {
  return act_words(channel, hand).toStdString();
}

CueWords words_of(Cue cue, ForceChannel channel, Hand hand) {
  const QString act = act_words(channel, hand);
  const QString sentence = CueTexts::tr("%1.").arg(act);
  const bool grip =
      channel == ForceChannel{} || channel == ForceChannel{Digits::grip_mean, Direction::plus_z};
  switch (cue) {
    case Cue::hand_out:
      return plain_cue(CueTexts::tr("Take your hand out"),
                       CueTexts::tr("Please take it out of the device."));
    case Cue::relax:
      return plain_cue(CueTexts::tr("Let your hand rest"),
                       CueTexts::tr("Do nothing. Breathe calmly."));
    case Cue::squeeze:
      return plain_cue(CueTexts::tr("%1!").arg(act),
                       CueTexts::tr("As hard as you can. Breathe out."));
    case Cue::press:
      // How strongly is the large line: this hand may not be allowed more.
      if (grip)
        return plain_cue(CueTexts::tr("Squeeze comfortably"),
                         CueTexts::tr("Hold it. Breathe calmly."));
      return plain_cue(channel.direction == Direction::plus_z    ? CueTexts::tr("Press comfortably")
                       : channel.direction == Direction::minus_z ? CueTexts::tr("Open comfortably")
                                                                 : CueTexts::tr("Push comfortably"),
                       sentence);
    case Cue::follow:
      if (grip)
        return plain_cue(CueTexts::tr("Follow the line"),
                         CueTexts::tr("Squeeze harder: the dot goes up"));
      return plain_cue(act, CueTexts::tr("Keep the dot on the line"));
    case Cue::reproduce:
      return plain_cue(CueTexts::tr("The same force again"),
                       grip ? CueTexts::tr("Without looking, as before.") : sentence);
    case Cue::let_go:
      return plain_cue(CueTexts::tr("Let go!"), CueTexts::tr("As fast as you can."));
    case Cue::move:
      return plain_cue(CueTexts::tr("Bring it to the outline"), CueTexts::tr("Slowly and level"));
    case Cue::open:
      return plain_cue(CueTexts::tr("Open your hand"), CueTexts::tr("As far as it goes."));
    case Cue::close:
      return plain_cue(CueTexts::tr("Close your hand"), CueTexts::tr("As far as it goes."));
  }
  return {};
}

CueWords words_of_digits(const std::array<bool, kFingerCount>& asked) {
  QString who;
  int count = 0;
  for (const Finger finger : kFingers) {
    if (!asked[index_of(finger)]) continue;
    ++count;
    who = digit_title(channel_of(finger).digits);
  }
  const QString how = CueTexts::tr("Disc into the ring, same size");
  if (count == 1) return plain_cue(CueTexts::tr("%1: fill the ring").arg(who), how);
  return plain_cue(CueTexts::tr("Fill every ring"), how);
}

}  // namespace isograsp::gui
