// SPDX-License-Identifier: GPL-3.0-or-later
// The columns of a session with a tracked hand, each once (core/column.hpp): how it was seen, its
// palm and angles, its joints where these may be kept, and what a virtual hand did with an object.
// World: that of the tracker, x right, y up, z to the viewer; a left hand is not mirrored, its
// angles are those of its digits.
#pragma once

#include "hand/columns.hpp"
#include "hand/tracked_hand.hpp"

namespace isograsp::columns {

/// One column for each digit: make(its name).
template <class Make>
[[nodiscard]] constexpr auto each_digit(Make make) {
  std::array<Column, kDigitCount> all;
  for (std::size_t d = 0; d < kDigitCount; ++d) all[d] = make(kDigitNames[d]);
  return all;
}
using OfDigits = std::array<Column, kDigitCount>;

// How it was seen.
inline constexpr Column pause_cause = plain(
    "pause_cause",
    "Why the task stands still: 0 it does not, 1 the therapist, 2 nothing is received, 3 a fault "
    "of the device, 4 out of sight, 5 the object has left the hand"_text);
inline constexpr Column confidence =
    plain("confidence", "How sure the tracker is, 0 to 1; 0 before the hand was seen"_text, "hand");
inline constexpr Column unseen_s =
    plain("unseen_s", "Time since the hand was seen last; 0: it is seen"_text, "hand");

// The hand: while it is not seen as it was seen last.
inline constexpr OfAxes palm_position = along(
    "hand_", "_m", "Position of the wrist along %1; empty: not seen yet"_text, "world", "hand");
inline constexpr OfComponents palm_attitude =
    attitude("hand", "Attitude of the palm, quaternion %1; empty: not seen yet"_text, "hand");
inline constexpr Column thumb_index_gap_m =
    plain("thumb_index_gap_m", "From the tip of the thumb to that of the index"_text, "hand");
inline constexpr OfDigits abduction = each_digit([](std::string_view digit) {
  return Column{FixedText<28>(digit, "_abduction_rad"),
                ColumnWords("Abduction of the %1, positive to the thumb's side"_text, digit),
                {},
                {},
                digit};
});
/// [digit][link], from its base on.
inline constexpr std::array<std::array<Column, 3>, kDigitCount> flexion = [] {
  constexpr std::array<std::string_view, 3> kNumbers{"1", "2", "3"};
  std::array<std::array<Column, 3>, kDigitCount> all;
  for (std::size_t d = 0; d < kDigitCount; ++d)
    for (std::size_t k = 0; k < 3; ++k)
      all[d][k] = {FixedText<28>(kDigitNames[d], "_flexion", kNumbers[k], "_rad"),
                   ColumnWords("Flexion of the %1 in its joint %2 from the palm on"_text,
                               kDigitNames[d], kNumbers[k]),
                   {},
                   {},
                   kDigitNames[d]};
  return all;
}();
inline constexpr Column fit_residual_m =
    plain("fit_residual_m", "Root mean square by which these angles miss the joints"_text, "hand");

/// Where the joints are: geometry of a body, kept and exported only with consent to research.
inline constexpr std::array<OfAxes, kHandJointCount> hand_joint = [] {
  std::array<OfAxes, kHandJointCount> all;
  for (std::size_t j = 0; j < kHandJointCount; ++j)
    for (std::size_t a = 0; a < 3; ++a)
      all[j][a] = {
          FixedText<28>(kHandJointNames[j], "_", kXyz[a], "_m"),
          ColumnWords("Position of the joint %1 along %2"_text, kHandJointNames[j], kXyz[a]),
          "world", kXyz[a], kHandJointNames[j]};
  return all;
}();

// A virtual object that the hand grasps: what is asked, and what became of it.
inline constexpr Column placement =
    plain("placement", "Which placement of the trial, from 0; -1: none"_text);
inline constexpr Column study_object =
    plain("study_object", "Which object, from 0 (small_cuboid); -1: none"_text);
inline constexpr Column assistance =
    plain("assistance", "Help with the grasp: 0 full, 1 softer, 2 off"_text);
inline constexpr Column eased =
    plain("eased", "1: the placement is easier than the task says, after fails"_text);
inline constexpr Column placement_fails =
    plain("placement_fails", "Drops in this placement so far"_text);
inline constexpr Column let_go_asked =
    plain("let_go_asked", "1: the object was placed, and the hand is to open"_text);
inline constexpr Column object_helped =
    plain("object_helped", "1: the object was let go for the person"_text, "object");
inline constexpr Column object_held =
    plain("object_held", "1: a digit is tied to the object, or two touch it"_text, "object");
inline constexpr Column object_touched =
    plain("object_touched", "1: a digit touches the object, or is tied to it"_text, "object");
inline constexpr Column object_supported =
    plain("object_supported", "1: the object rests on table or block"_text, "object");

// Why the assistance held and let go.
inline constexpr OfDigits grasp_state = each_digit([](std::string_view digit) {
  return Column{FixedText<28>(digit, "_grasp_state"),
                ColumnWords("State of the %1: 0 free, 1 in contact, 2 tied, 3 blocked"_text, digit),
                {},
                {},
                digit};
});
inline constexpr OfDigits pull_N = each_digit([](std::string_view digit) {
  return Column{
      FixedText<28>(digit, "_pull_N"),
      ColumnWords("Pull of the %1 on its tie, away from the object; in the row in which it lets "
                  "go that at which it did"_text,
                  digit),
      {},
      {},
      digit};
});
inline constexpr OfDigits touch_N = each_digit([](std::string_view digit) {
  return Column{FixedText<28>(digit, "_touch_N"),
                ColumnWords("Largest normal force of the %1 on the object"_text, digit),
                {},
                {},
                digit};
});
inline constexpr OfDigits gap_m = each_digit([](std::string_view digit) {
  return Column{FixedText<28>(digit, "_gap_m"),
                ColumnWords("Gap between the %1 and the object, up to 5 mm"_text, digit),
                {},
                {},
                digit};
});
inline constexpr Column release_pull_N =
    plain("release_pull_N", "Above this pull a tie lets go; empty: nothing is tied"_text);
inline constexpr Column grasp_digits = plain(
    "grasp_digits", "Best set of the digits that touch: 1 thumb + 2 index + 4 middle + …"_text);
inline constexpr Column grasp_feasible =
    plain("grasp_feasible", "1: that set is a feasible grasp, which may be tied"_text);
/// Criteria of that set, and what they must exceed.
inline constexpr Column grasp_G_min = plain("grasp_G_min", "Criterion G_min of that set"_text);
inline constexpr Column grasp_H_min = plain("grasp_H_min", "Criterion H_min of that set"_text);
inline constexpr Column grasp_H_det = plain("grasp_H_det", "Criterion H_det of that set"_text);
inline constexpr Column grasp_G_min_limit =
    plain("grasp_G_min_limit", "What G_min of such a set must exceed"_text);
inline constexpr Column grasp_H_min_limit =
    plain("grasp_H_min_limit", "What H_min of such a set must exceed"_text);
inline constexpr Column grasp_H_det_limit =
    plain("grasp_H_det_limit", "What H_det of such a set must exceed"_text);
inline constexpr Column tracked_gap_m =
    plain("tracked_gap_m", "Largest distance of the virtual hand from the tracked one"_text);
inline constexpr Column solver_sweeps =
    plain("solver_sweeps", "Sweeps of the contact solver, the most of the frame"_text);
inline constexpr Column solver_residual_mps =
    plain("solver_residual_mps", "What the last of them still changed"_text);

/// Where the virtual hand is.
inline constexpr OfAxes virtual_palm_position = along(
    "virtual_hand_", "_m", "Position of the virtual wrist along %1"_text, "world", "virtual_hand");
inline constexpr OfComponents virtual_palm_attitude =
    attitude("virtual_hand", "Attitude of the virtual palm, quaternion %1"_text, "virtual_hand");
/// [digit][abduction, three flexions].
inline constexpr std::array<std::array<Column, 4>, kDigitCount> virtual_angle = [] {
  constexpr std::array<std::string_view, 4> kAngles{"abduction", "flexion1", "flexion2",
                                                    "flexion3"};
  std::array<std::array<Column, 4>, kDigitCount> all;
  for (std::size_t d = 0; d < kDigitCount; ++d)
    for (std::size_t k = 0; k < 4; ++k)
      all[d][k] = {
          FixedText<28>("v_", kDigitNames[d], "_", kAngles[k], "_rad"),
          ColumnWords("Angle of the virtual hand: %1, %2"_text, kDigitNames[d], kAngles[k]),
          {},
          {},
          "virtual_hand"};
  return all;
}();

}  // namespace isograsp::columns
