// SPDX-License-Identifier: GPL-3.0-or-later
// The columns of a session with two platforms, one for each hand (hand/columns.hpp says how columns
// are made): what was asked of each hand and of both, their forces, what the devices sent. "Force
// of a hand" is its grip force: the weaker of the thumb and both fingers together, signed.
#pragma once

#include "hand/columns.hpp"
#include "hand/hands.hpp"

namespace isograsp::columns {

// Of each hand.
inline constexpr OfHands<Column> hand_grip{
    plain("left_force_N", "Grip force of the left hand"_text),
    plain("right_force_N", "Grip force of the right hand"_text)};
inline constexpr OfHands<Column> target_hand_grip{
    plain("target_left_force_N", "Force asked of the left hand; empty: none"_text),
    plain("target_right_force_N", "Force asked of the right hand; empty: none"_text)};
inline constexpr OfHands<Column> hand_cue{
    plain("left_cue", "What the left hand is asked to do, as in cue"_text),
    plain("right_cue", "What the right hand is asked to do, as in cue"_text)};
inline constexpr OfHands<Column> hand_force_shown{
    plain("left_force_shown", "1: the force of the left hand was on the screen"_text),
    plain("right_force_shown", "1: the force of the right hand was on the screen"_text)};
inline constexpr OfHands<Column> hand_resting_force_N{
    plain("left_resting_force_N", "Resting force of the left hand in this session"_text),
    plain("right_resting_force_N", "Resting force of the right hand in this session"_text)};
inline constexpr OfHands<Column> hand_maximum_force_N{
    plain("left_maximum_force_N", "Maximum force of the left hand alone in this session"_text),
    plain("right_maximum_force_N", "Maximum force of the right hand alone in this session"_text)};

// Of both.
inline constexpr Column sum_force_N =
    plain("sum_force_N", "Grip force of both hands together"_text);
inline constexpr Column target_sum_force_N =
    plain("target_sum_force_N", "Force asked of both hands together; empty: none"_text);
inline constexpr Column sum_force_shown =
    plain("sum_force_shown", "1: the force of both hands together was on the screen"_text);
inline constexpr Column affected_hand =
    plain("affected_hand", "Affected side: 0 left, 1 right; empty: not known, both or none"_text);
/// Of the empty platforms, before the work.
inline constexpr Column platforms_coupled = plain(
    "platforms_coupled",
    "1: pressing one empty platform moved the other by more than 1 %; 0: not; empty: not checked"_text);
/// Between the samples that completed the frames of both platforms.
inline constexpr Column skew_s = plain(
    "skew_s", "Newest sample of the right platform later than that of the left by so much"_text);

// Fingers of each hand.
inline constexpr OfHands<OfFingersAxes> hands_finger_force{
    along_of_fingers("left_", "_f", "_N", "Force of the left %1 along %2"_text, "contact"),
    along_of_fingers("right_", "_f", "_N", "Force of the right %1 along %2"_text, "contact")};
inline constexpr OfHands<OfFingersAxes> hands_finger_torque{
    along_of_fingers("left_", "_t", "_Nm", "Torque of the left %1 along %2"_text, "contact"),
    along_of_fingers("right_", "_t", "_Nm", "Torque of the right %1 along %2"_text, "contact")};
[[nodiscard]] constexpr OfFingers flags_of_fingers(std::string_view front, Phrase<1> what) {
  OfFingers all;
  for (std::size_t f = 0; f < kFingerCount; ++f)
    all[f] = {FixedText<28>(front, kFingerNames[f], "_flags"),
              ColumnWords(what, kFingerNames[f]),
              {},
              {},
              kFingerNames[f]};
  return all;
}
inline constexpr OfHands<OfFingers> hands_finger_flags{
    flags_of_fingers("left_",
                     "Flags of the left %1: 1 held, 2 missing, 4 saturated, 8 overload"_text),
    flags_of_fingers("right_",
                     "Flags of the right %1: 1 held, 2 missing, 4 saturated, 8 overload"_text)};
/// Sum of its fingers, signed, in the axes of the patient's view.
inline constexpr OfHands<OfAxes> hand_push{
    along("left_push_", "_N", "Net push of the left hand on its platform along %1"_text, "world",
          "platform"),
    along("right_push_", "_N", "Net push of the right hand on its platform along %1"_text, "world",
          "platform")};
// What they do to the object that both lift.
inline constexpr OfHands<Column> hand_squeeze_N{
    plain("left_squeeze_N", "Push of the left hand into the object"_text),
    plain("right_squeeze_N", "Push of the right hand into the object"_text)};
inline constexpr OfHands<Column> hand_contact{
    plain("left_contact", "1: the left hand touches the object"_text),
    plain("right_contact", "1: the right hand touches the object"_text)};
inline constexpr OfHands<Column> hand_slip{
    plain("left_slip", "1: the left hand is at the limit of friction"_text),
    plain("right_slip", "1: the right hand is at the limit of friction"_text)};
inline constexpr OfHands<Column> hand_utilisation{
    plain("left_utilisation", "Tangential force over the limit of friction: left hand"_text),
    plain("right_utilisation", "Tangential force over the limit of friction: right hand"_text)};
/// Of the object, where the hand holds it.
inline constexpr OfHands<OfAxes> hand_end{
    along("left_end_", "_m", "Position of the object's left end along %1"_text, "world", "object"),
    along("right_end_", "_m", "Position of the object's right end along %1"_text, "world",
          "object")};
// Hands that are points, and their bubbles.
inline constexpr OfHands<OfAxes> hand_point{
    along("left_", "_m", "Place of the left hand on the screen along %1"_text, "world", "hand"),
    along("right_", "_m", "Place of the right hand on the screen along %1"_text, "world", "hand")};
inline constexpr OfHands<OfAxes> hand_bubble{
    along("left_bubble_", "_m", "Middle of the left hand's bubble along %1"_text, "world", "hand"),
    along("right_bubble_", "_m", "Middle of the right hand's bubble along %1"_text, "world",
          "hand")};
inline constexpr OfHands<Column> hand_excess{
    plain("left_excess",
          "Left hand beyond the edge of its bubble, over the force at the edge"_text),
    plain("right_excess",
          "Right hand beyond the edge of its bubble, over the force at the edge"_text)};
inline constexpr OfHands<Column> hand_at_edge_N{
    plain("left_force_at_edge_N", "Push that brings the left hand to the edge of its bubble"_text),
    plain("right_force_at_edge_N",
          "Push that brings the right hand to the edge of its bubble"_text)};
inline constexpr OfHands<Column> hand_on_N{
    plain("left_force_on_N", "Squeeze of the left hand above which it holds"_text),
    plain("right_force_on_N", "Squeeze of the right hand above which it holds"_text)};
inline constexpr Column both_hold = plain("grasp", "1: both hands hold the object"_text);
inline constexpr Column joint_control = plain("joint", "1: the bubbles move as one"_text);
inline constexpr Column clutch_held =
    plain("clutch", "1: the clutch is held: hands stay and their bubbles come along"_text);
inline constexpr Column left_share =
    plain("left_share",
          "Weight of the left hand while the bubbles move as one; the right one: the rest"_text);
inline constexpr Column on_rest =
    plain("on_rest", "1: the hands do nothing to the object: it stands where it began"_text);
inline constexpr Column object_strength = plain(
    "object_strength", "Masses, springs and dampers of the scene are multiplied by this"_text);
inline constexpr OfHands<OfFingersAxes> hands_raw_force{
    along_of_fingers("left_", "_f", "_counts",
                     "Raw force count of the left %1's sensor along %2"_text, "sensor"),
    along_of_fingers("right_", "_f", "_counts",
                     "Raw force count of the right %1's sensor along %2"_text, "sensor")};
inline constexpr OfHands<OfFingersAxes> hands_raw_torque{
    along_of_fingers("left_", "_t", "_counts",
                     "Raw torque count of the left %1's sensor along %2"_text, "sensor"),
    along_of_fingers("right_", "_t", "_counts",
                     "Raw torque count of the right %1's sensor along %2"_text, "sensor")};

}  // namespace isograsp::columns
