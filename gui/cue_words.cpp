// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/cue_words.hpp"

#include <QCoreApplication>
#include <QString>

namespace isograsp {

namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(PatientScreen)
};

bool is_whole_hand(Digits digits) {
  return digits == Digits::grip || digits == Digits::grip_mean || digits == Digits::sum;
}

QString digit_title(Digits digits) {
  switch (digits) {
    case Digits::pinch: return Words::tr("Thumb and index");
    case Digits::thumb: return Words::tr("Thumb");
    case Digits::index: return Words::tr("Index finger");
    case Digits::middle: return Words::tr("Middle finger");
    default: return Words::tr("All fingers");
  }
}

QString close(Digits digits) {
  switch (digits) {
    case Digits::pinch: return Words::tr("Pinch: thumb and index");
    case Digits::sum: return Words::tr("Press with all fingers");
    case Digits::thumb: return Words::tr("Press with the thumb only");
    case Digits::index: return Words::tr("Press with the index finger only");
    case Digits::middle: return Words::tr("Press with the middle finger only");
    default: return Words::tr("Squeeze");
  }
}

/// Against the straps.
QString open(Digits digits) {
  if (is_whole_hand(digits)) return Words::tr("Open your hand");
  if (digits == Digits::pinch) return Words::tr("Open thumb and index");
  return Words::tr("%1: pull back").arg(digit_title(digits));
}

/// Along the forearm. Thumb and fingers face each other: the same sign sends them opposite ways.
QString slide(Digits digits, bool plus_y, Hand hand) {
  const bool thumb_toward = plus_y == plus_y_is_toward(Finger::thumb, hand);
  switch (digits) {
    case Digits::thumb:
    case Digits::index:
    case Digits::middle:
      return ((digits == Digits::thumb) == thumb_toward ? Words::tr("%1: pull toward you")
                                                        : Words::tr("%1: push away"))
          .arg(digit_title(digits));
    case Digits::pinch:
      return thumb_toward ? Words::tr("Thumb toward you, index away")
                          : Words::tr("Thumb away, index toward you");
    default:
      return thumb_toward ? Words::tr("Thumb toward you, fingers away")
                          : Words::tr("Thumb away, fingers toward you");
  }
}

QString act_words(ForceChannel channel, Hand hand) {
  switch (channel.direction) {
    case Direction::plus_z: return close(channel.digits);
    case Direction::minus_z: return open(channel.digits);
    case Direction::plus_x: return Words::tr("%1: push up").arg(digit_title(channel.digits));
    case Direction::minus_x: return Words::tr("%1: push down").arg(digit_title(channel.digits));
    case Direction::plus_y: return slide(channel.digits, true, hand);
    case Direction::minus_y: return slide(channel.digits, false, hand);
  }
  return {};
}

CueWords plain(const QString& headline, const QString& detail) {
  return {headline.toStdString(), detail.toStdString()};
}

}  // namespace

std::string act_of(ForceChannel channel, Hand hand) {
  return act_words(channel, hand).toStdString();
}

CueWords words_for(Cue cue, ForceChannel channel, Hand hand) {
  const QString act = act_words(channel, hand);
  const QString sentence = Words::tr("%1.").arg(act);
  const bool grip =
      channel == ForceChannel{} || channel == ForceChannel{Digits::grip_mean, Direction::plus_z};
  switch (cue) {
    case Cue::hand_out:
      return plain(Words::tr("Take your hand out"), Words::tr("Please take it out of the device."));
    case Cue::relax:
      return plain(Words::tr("Let your hand rest"), Words::tr("Do nothing. Breathe calmly."));
    case Cue::squeeze:
      return plain(Words::tr("%1!").arg(act), Words::tr("As hard as you can. Breathe out."));
    case Cue::press:
      // How strongly is the large line: this hand may not be allowed more.
      if (grip)
        return plain(Words::tr("Squeeze comfortably"), Words::tr("Hold it. Breathe calmly."));
      return plain(channel.direction == Direction::plus_z    ? Words::tr("Press comfortably")
                   : channel.direction == Direction::minus_z ? Words::tr("Open comfortably")
                                                             : Words::tr("Push comfortably"),
                   sentence);
    case Cue::follow:
      if (grip)
        return plain(Words::tr("Follow the line"), Words::tr("Squeeze harder: the dot goes up"));
      return plain(act, Words::tr("Keep the dot on the line"));
    case Cue::reproduce:
      return plain(Words::tr("The same force again"),
                   grip ? Words::tr("Without looking, as before.") : sentence);
    case Cue::let_go: return plain(Words::tr("Let go!"), Words::tr("As fast as you can."));
    case Cue::move:
      return plain(Words::tr("Bring it to the outline"), Words::tr("Slowly and level"));
  }
  return {};
}

CueWords words_for_digits(const std::array<bool, kFingerCount>& asked) {
  QString who;
  int count = 0;
  for (const Finger finger : kFingers) {
    if (!asked[index_of(finger)]) continue;
    ++count;
    who = digit_title(channel_of(finger).digits);
  }
  const QString how = Words::tr("Disc into the ring, same size");
  if (count == 1) return plain(Words::tr("%1: fill the ring").arg(who), how);
  return plain(Words::tr("Fill every ring"), how);
}

}  // namespace isograsp
