// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/cue_words.hpp"

namespace isograsp {

namespace {

bool is_whole_hand(Digits digits) {
  return digits == Digits::grip || digits == Digits::grip_mean || digits == Digits::sum;
}

std::string digit_title(Digits digits) {
  switch (digits) {
    case Digits::pinch: return "Thumb and index";
    case Digits::thumb: return "Thumb";
    case Digits::index: return "Index finger";
    case Digits::middle: return "Middle finger";
    default: return "All fingers";
  }
}

std::string close(Digits digits) {
  switch (digits) {
    case Digits::pinch: return "Pinch: thumb and index";
    case Digits::sum: return "Press with all fingers";
    case Digits::thumb: return "Press with the thumb only";
    case Digits::index: return "Press with the index finger only";
    case Digits::middle: return "Press with the middle finger only";
    default: return "Squeeze";
  }
}

/// Against the straps.
std::string open(Digits digits) {
  if (is_whole_hand(digits)) return "Open your hand";
  if (digits == Digits::pinch) return "Open thumb and index";
  return digit_title(digits) + ": pull back";
}

/// Along the forearm. Thumb and fingers face each other: the same sign sends them opposite ways.
std::string slide(Digits digits, bool plus_y, Hand hand) {
  const bool thumb_toward = plus_y == plus_y_is_toward(Finger::thumb, hand);
  switch (digits) {
    case Digits::thumb: return thumb_toward ? "Thumb: pull toward you" : "Thumb: push away";
    case Digits::index:
    case Digits::middle:
      return digit_title(digits) + (thumb_toward ? ": push away" : ": pull toward you");
    case Digits::pinch:
      return thumb_toward ? "Thumb toward you, index away" : "Thumb away, index toward you";
    default:
      return thumb_toward ? "Thumb toward you, fingers away" : "Thumb away, fingers toward you";
  }
}

}  // namespace

std::string act_of(ForceChannel channel, Hand hand) {
  switch (channel.direction) {
    case Direction::plus_z: return close(channel.digits);
    case Direction::minus_z: return open(channel.digits);
    case Direction::plus_x: return digit_title(channel.digits) + ": push up";
    case Direction::minus_x: return digit_title(channel.digits) + ": push down";
    case Direction::plus_y: return slide(channel.digits, true, hand);
    case Direction::minus_y: return slide(channel.digits, false, hand);
  }
  return "";
}

CueWords words_for(Cue cue, ForceChannel channel, Hand hand) {
  const std::string act = act_of(channel, hand);
  const bool grip =
      channel == ForceChannel{} || channel == ForceChannel{Digits::grip_mean, Direction::plus_z};
  switch (cue) {
    case Cue::hand_out: return {"Take your hand out", "Please take it out of the device."};
    case Cue::relax: return {"Let your hand rest", "Do nothing. Breathe calmly."};
    case Cue::squeeze: return {act + "!", "As hard as you can. Breathe out."};
    case Cue::press:
      // How strongly is the large line: this hand may not be allowed more.
      if (grip) return {"Squeeze comfortably", "Hold it. Breathe calmly."};
      return {(channel.direction == Direction::plus_z    ? "Press"
               : channel.direction == Direction::minus_z ? "Open"
                                                         : "Push") +
                  std::string(" comfortably"),
              act + "."};
    case Cue::follow:
      if (grip) return {"Follow the line", "Squeeze harder: the dot goes up"};
      return {act, "Keep the dot on the line"};
    case Cue::reproduce:
      return {"The same force again", grip ? "Without looking, as before." : act + "."};
    case Cue::let_go: return {"Let go!", "As fast as you can."};
    case Cue::move: return {"Bring it to the outline", "Slowly and level"};
  }
  return {};
}

CueWords words_for_digits(const std::array<bool, kFingerCount>& asked) {
  std::string who;
  int count = 0;
  for (const Finger finger : kFingers) {
    if (!asked[index_of(finger)]) continue;
    ++count;
    who = digit_title(channel_of(finger).digits);
  }
  const std::string how = "Disc into the ring, same size";
  if (count == 1) return {who + ": fill the ring", how};
  return {"Fill every ring", how};
}

}  // namespace isograsp
