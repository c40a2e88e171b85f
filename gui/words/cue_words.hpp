// SPDX-License-Identifier: GPL-3.0-or-later
// The instruction on the patient's screen in plain words, by cue and channel. Pure: same cue, same
// words (in the language that is set).
#pragma once

#include <string>

#include "hand/stimulus.hpp"

namespace isograsp::gui {

struct CueWords {
  std::string headline;  ///< readable at 3 m: in English at most six words, kMostHeadline letters
  std::string detail;    ///< one more short sentence
};
inline constexpr std::size_t kMostHeadline = 34;
inline constexpr std::size_t kMostDetail = 42;

/// What the hand does, without how strongly: "Squeeze", "Press with the thumb only", "Thumb: push
/// up". Sideways directions are those of supports mounted as docs/conventions.md says: x of the
/// contact is up; y is along the forearm, toward the person for the thumb of the right hand and
/// for the fingers of the left one.
[[nodiscard]] std::string act_of(ForceChannel channel, Hand hand);

[[nodiscard]] CueWords words_of(Cue cue, ForceChannel channel, Hand hand);

/// Forces asked of these digits, each with its own picture.
[[nodiscard]] CueWords words_of_digits(const std::array<bool, kFingerCount>& asked);

/// +y of the finger's contact frame points toward the person.
[[nodiscard]] constexpr bool plus_y_is_toward(Finger finger, Hand hand) noexcept {
  return (finger == Finger::thumb) == (hand == Hand::right);
}

}  // namespace isograsp::gui
