// SPDX-License-Identifier: GPL-3.0-or-later
// The columns of a session with a platform for three fingers, each once (core/column.hpp): what was
// asked and shown, the fingers' forces, what the device sent, the virtual object. A trial stores
// those that its task needs; in which order stands in session/acquisition/trial_row.cpp.
#pragma once

#include "core/column.hpp"
#include "hand/finger.hpp"

namespace isograsp::columns {

/// Target and actual value have two columns: "target_force_N" and "actual_force_N".
inline constexpr std::string_view kTarget = "target_";
inline constexpr std::string_view kActual = "actual_";

inline constexpr std::array<std::string_view, 3> kXyz{"x", "y", "z"};
inline constexpr std::array<std::string_view, 4> kWxyz{"w", "x", "y", "z"};
inline constexpr std::array<std::string_view, 4> kQuaternion{"quat_w", "quat_x", "quat_y",
                                                             "quat_z"};

using OfFingers = std::array<Column, kFingerCount>;
using OfAxes = std::array<Column, 3>;                    ///< x y z
using OfFingersAxes = std::array<OfAxes, kFingerCount>;  ///< [finger][axis]
using OfComponents = std::array<Column, 4>;              ///< quaternion, w x y z

/// One column for each finger: make(name of the finger).
template <class Make>
[[nodiscard]] constexpr OfFingers each_finger(Make make) {
  return {make(kFingerNames[0]), make(kFingerNames[1]), make(kFingerNames[2])};
}
/// One for each axis: `name` x `ending`, `what` of x in `axes`.
[[nodiscard]] constexpr OfAxes along(std::string_view name, std::string_view ending, Phrase<1> what,
                                     std::string_view axes, std::string_view body) {
  OfAxes all;
  for (std::size_t a = 0; a < 3; ++a)
    all[a] = {FixedText<28>(name, kXyz[a], ending), ColumnWords(what, kXyz[a]), axes, kXyz[a],
              body};
  return all;
}
/// Along each axis for each finger: `front` thumb `letter` x `ending`, `what` of thumb and x.
[[nodiscard]] constexpr OfFingersAxes along_of_fingers(std::string_view front,
                                                       std::string_view letter,
                                                       std::string_view ending, Phrase<2> what,
                                                       std::string_view axes) {
  OfFingersAxes all;
  for (std::size_t f = 0; f < kFingerCount; ++f)
    for (std::size_t a = 0; a < 3; ++a)
      all[f][a] = {FixedText<28>(front, kFingerNames[f], letter, kXyz[a], ending),
                   ColumnWords(what, kFingerNames[f], kXyz[a]), axes, kXyz[a], kFingerNames[f]};
  return all;
}
[[nodiscard]] constexpr OfComponents attitude(std::string_view name, Phrase<1> what,
                                              std::string_view body,
                                              std::string_view axes = "world") {
  OfComponents all;
  for (std::size_t i = 0; i < 4; ++i)
    all[i] = {FixedText<28>(name, "_q", kWxyz[i]), ColumnWords(what, kWxyz[i]), axes,
              kQuaternion[i], body};
  return all;
}
[[nodiscard]] constexpr Column about_z(std::string_view name, Words what, std::string_view body) {
  return {FixedText<28>(name), ColumnWords(what), "world", "z", body};
}

// What was asked and shown. Numbers of enumerations: docs/file_formats.md.
inline constexpr Column sample_flags = plain(
    "sample_flags",
    "Over the fingers: 1 held, 2 missing, 4 saturated, 8 overload; anything but 0 is excluded "
    "from measures"_text);
inline constexpr Column target_force_N =
    plain("target_force_N", "Force asked for; empty: none"_text);
inline constexpr Column actual_force_N =
    plain("actual_force_N", "Force in the channel of this part of the task"_text);
inline constexpr Column resting_force_N =
    plain("resting_force_N", "Resting force of this channel in this session"_text);
inline constexpr Column maximum_force_N =
    plain("maximum_force_N", "Maximum force of this channel in this session"_text);
inline constexpr Column noise_sd_N =
    plain("noise_sd_N", "Standard deviation of the empty device in this channel"_text);
inline constexpr Column resolution_N =
    plain("resolution_N", "Coarsest step of a force component"_text);
inline constexpr Column device_delay_s =
    plain("device_delay_s", "Delay of the sensors and their filters"_text);
inline constexpr Column display_delay_s =
    plain("display_delay_s", "Delay of the patient's display; empty: not measured"_text);
inline constexpr Column segment = plain("segment", "Part of the task's timeline, from 0"_text);
inline constexpr Column cue = plain(
    "cue",
    "0 hand out, 1 relax, 2 squeeze, 3 press, 4 follow, 5 reproduce, 6 let go, 7 move, 8 open the "
    "hand, 9 close it"_text);
inline constexpr Column channel_digits =
    plain("channel_digits", "0 grip, 1 grip_mean, 2 pinch, 3 sum, 4 thumb, 5 index, 6 middle"_text);
inline constexpr Column channel_direction =
    plain("channel_direction",
          "Contact axes: 0 +x, 1 -x, 2 +y, 3 -y, 4 +z (closing), 5 -z (opening)"_text);
inline constexpr Column force_shown = plain("force_shown", "1: the patient saw the own force"_text);
inline constexpr Column target_shown = plain("target_shown", "1: the patient saw the target"_text);
inline constexpr Column target_index =
    plain("target_index", "Which target of the series, from 0"_text);
inline constexpr Column targets_reached = plain("targets_reached", "Targets reached so far"_text);
inline constexpr Column drops = plain("drops", "Drops so far"_text);
/// Asked of single digits.
inline constexpr OfFingersAxes target_force =
    along_of_fingers(kTarget, "_f", "_N", "Force asked of the %1 along %2"_text, "contact");

// The fingers' forces.
inline constexpr OfFingersAxes finger_force =
    along_of_fingers("", "_f", "_N", "Force of the %1 along %2"_text, "contact");
/// Of each finger into the object: z of the contact.
inline constexpr OfFingers normal_force{finger_force[0][2], finger_force[1][2], finger_force[2][2]};
inline constexpr OfFingersAxes finger_torque =
    along_of_fingers("", "_t", "_Nm", "Torque of the %1 along %2"_text, "contact");
inline constexpr OfFingers finger_flags = each_finger([](std::string_view finger) {
  return Column{
      FixedText<28>(finger, "_flags"),
      ColumnWords("Flags of the %1: 1 held, 2 missing, 4 saturated, 8 overload"_text, finger),
      {},
      {},
      finger};
});
inline constexpr OfAxes net_force = along(
    "net_f", "_N", "Net force of the hand on the platform along %1"_text, "platform", "platform");
inline constexpr OfAxes net_torque = along(
    "net_t", "_Nm", "Net torque of the hand on the platform along %1"_text, "platform", "platform");
inline constexpr Column net_push_percent = plain(
    "net_push_percent", "Net force on the platform in percent of the grip; empty below 0.5 N"_text);
/// In the axes of the hand: computed for exports, never stored. In the order of HandAxis.
inline constexpr OfFingersAxes hand_force = [] {
  constexpr std::array<std::pair<std::string_view, Phrase<1>>, 3> kAxes{
      {{"flexion", "Force of the %1, flexion (closing; minus: opening)"_text},
       {"radial", "Force of the %1, radial (minus: ulnar)"_text},
       {"distal", "Force of the %1, distal (minus: proximal)"_text}}};
  OfFingersAxes all;
  for (std::size_t f = 0; f < kFingerCount; ++f)
    for (std::size_t a = 0; a < 3; ++a)
      all[f][a] = {FixedText<28>(kFingerNames[f], "_", kAxes[a].first, "_N"),
                   ColumnWords(kAxes[a].second, kFingerNames[f]),
                   "hand",
                   {},
                   kFingerNames[f]};
  return all;
}();

// What the device sent.
inline constexpr OfFingersAxes raw_force = along_of_fingers(
    "", "_f", "_counts", "Raw force count of the %1's sensor along %2"_text, "sensor");
inline constexpr OfFingersAxes raw_torque = along_of_fingers(
    "", "_t", "_counts", "Raw torque count of the %1's sensor along %2"_text, "sensor");

// The virtual object and its target.
inline constexpr OfAxes target_position =
    along(kTarget, "_m", "Position of the target along %1"_text, "world", "target");
inline constexpr OfAxes actual_position =
    along(kActual, "_m", "Position of the object along %1"_text, "world", "object");
inline constexpr OfComponents target_attitude =
    attitude("target", "Attitude of the target, quaternion %1"_text, "target");
inline constexpr OfComponents actual_attitude =
    attitude("actual", "Attitude of the object, quaternion %1"_text, "object");
inline constexpr Column target_angle_rad =
    about_z("target_angle_rad", "Angle of the target about world z"_text, "target");
inline constexpr Column actual_angle_rad =
    about_z("actual_angle_rad", "Angle of the object about world z"_text, "object");
inline constexpr OfAxes object_velocity =
    along("v", "_mps", "Velocity of the object's centre of mass along %1"_text, "world", "object");
inline constexpr OfAxes object_angular_velocity =
    along("w", "_radps", "Angular velocity of the object along %1"_text, "world", "object");
inline constexpr OfAxes object_force =
    along("f", "_N", "Force on the object along %1"_text, "world", "object");
inline constexpr OfAxes object_torque = along(
    "t", "_Nm", "Torque on the object about its centre of mass along %1"_text, "world", "object");
inline constexpr OfFingers contact = each_finger([](std::string_view finger) {
  return Column{FixedText<28>("contact_", finger),
                ColumnWords("1: touches the object: %1"_text, finger),
                {},
                {},
                finger};
});
inline constexpr OfFingers slip = each_finger([](std::string_view finger) {
  return Column{FixedText<28>("slip_", finger),
                ColumnWords("1: at the limit of friction: %1"_text, finger),
                {},
                {},
                finger};
});
inline constexpr OfFingers utilisation = each_finger([](std::string_view finger) {
  return Column{FixedText<28>("utilisation_", finger),
                ColumnWords("Tangential force over the limit of friction: %1"_text, finger),
                {},
                {},
                finger};
});
inline constexpr Column model_error_rad = plain(
    "model_error_rad", "Estimated error of the attitude, made in the hold that ends here"_text);
inline constexpr Column model_inexact =
    plain("model_inexact", "1: that error is above the scene's tolerance"_text);

/// The column of this name; null: none of those above or of core/column.hpp.
[[nodiscard]] const Column* find(std::string_view name);

}  // namespace isograsp::columns
