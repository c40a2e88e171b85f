// SPDX-License-Identifier: GPL-3.0-or-later
// The columns of a session with a platform for three fingers, each once (core/column.hpp): what was
// asked and shown, the fingers' forces, what the device sent, the virtual object. A trial stores
// those that its task needs; in which order stands in session/acquisition/trial_row.cpp.
#pragma once

#include "core/column.hpp"
#include "hand/finger.hpp"

namespace isograsp::columns {

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
/// One for each axis: `name` x `ending`, "`what` along x" in `axes`.
[[nodiscard]] constexpr OfAxes along(std::string_view name, std::string_view ending,
                                     std::string_view what, std::string_view axes,
                                     std::string_view body) {
  OfAxes all;
  for (std::size_t a = 0; a < 3; ++a)
    all[a] = {FixedText<28>(name, kXyz[a], ending), FixedText<112>(what, " along ", kXyz[a]), axes,
              kXyz[a], body};
  return all;
}
/// Along each axis for each finger: `front` thumb `letter` x `ending`, "`what` thumb`whose` along
/// x".
[[nodiscard]] constexpr OfFingersAxes along_of_fingers(
    std::string_view front, std::string_view letter, std::string_view ending, std::string_view what,
    std::string_view whose, std::string_view axes) {
  OfFingersAxes all;
  for (std::size_t f = 0; f < kFingerCount; ++f)
    all[f] = along(FixedText<28>(front, kFingerNames[f], letter), ending,
                   FixedText<64>(what, kFingerNames[f], whose), axes, kFingerNames[f]);
  return all;
}
[[nodiscard]] constexpr OfComponents attitude(std::string_view name, std::string_view body) {
  OfComponents all;
  for (std::size_t i = 0; i < 4; ++i)
    all[i] = {FixedText<28>(name, "_q", kWxyz[i]),
              FixedText<112>("Attitude of the ", body, ", quaternion ", kWxyz[i]), "world",
              kQuaternion[i], body};
  return all;
}
[[nodiscard]] constexpr Column about_z(std::string_view name, std::string_view body) {
  return {FixedText<28>(name), FixedText<112>("Angle of the ", body, " about world z"), "world",
          "z", body};
}

// What was asked and shown. Numbers of enumerations: docs/file_formats.md.
inline constexpr Column sample_flags = plain(
    "sample_flags",
    "Over the fingers: 1 held, 2 missing, 4 saturated, 8 overload; anything but 0 is excluded "
    "from measures");
inline constexpr Column target_force_N = plain("target_force_N", "Force asked for; empty: none");
inline constexpr Column actual_force_N =
    plain("actual_force_N", "Force in the channel of this part of the task");
inline constexpr Column resting_force_N =
    plain("resting_force_N", "Resting force of this channel in this session");
inline constexpr Column maximum_force_N =
    plain("maximum_force_N", "Maximum force of this channel in this session");
inline constexpr Column noise_sd_N =
    plain("noise_sd_N", "Standard deviation of the empty device in this channel");
inline constexpr Column resolution_N = plain("resolution_N", "Coarsest step of a force component");
inline constexpr Column device_delay_s =
    plain("device_delay_s", "Delay of the sensors and their filters");
inline constexpr Column display_delay_s =
    plain("display_delay_s", "Delay of the patient's display; empty: not measured");
inline constexpr Column segment = plain("segment", "Part of the task's timeline, from 0");
inline constexpr Column cue = plain(
    "cue", "0 hand out, 1 relax, 2 squeeze, 3 press, 4 follow, 5 reproduce, 6 let go, 7 move");
inline constexpr Column channel_digits =
    plain("channel_digits", "0 grip, 1 grip_mean, 2 pinch, 3 sum, 4 thumb, 5 index, 6 middle");
inline constexpr Column channel_direction = plain(
    "channel_direction", "Contact axes: 0 +x, 1 -x, 2 +y, 3 -y, 4 +z (closing), 5 -z (opening)");
inline constexpr Column force_shown = plain("force_shown", "1: the patient saw the own force");
inline constexpr Column target_shown = plain("target_shown", "1: the patient saw the target");
inline constexpr Column target_index = plain("target_index", "Which target of the series, from 0");
inline constexpr Column targets_reached = plain("targets_reached", "Targets reached so far");
inline constexpr Column drops = plain("drops", "Drops so far");
/// Asked of single digits.
inline constexpr OfFingersAxes target_force =
    along_of_fingers("target_", "_f", "_N", "Force asked of the ", "", "contact");

// The fingers' forces.
inline constexpr OfFingersAxes finger_force =
    along_of_fingers("", "_f", "_N", "Force of the ", "", "contact");
/// Of each finger into the object: z of the contact.
inline constexpr OfFingers normal_force{finger_force[0][2], finger_force[1][2], finger_force[2][2]};
inline constexpr OfFingersAxes finger_torque =
    along_of_fingers("", "_t", "_Nm", "Torque of the ", "", "contact");
inline constexpr OfFingers finger_flags = each_finger([](std::string_view finger) {
  return Column{
      FixedText<28>(finger, "_flags"),
      FixedText<112>("Flags of the ", finger, ": 1 held, 2 missing, 4 saturated, 8 overload"),
      {},
      {},
      finger};
});
inline constexpr OfAxes net_force =
    along("net_f", "_N", "Net force of the hand on the platform", "platform", "platform");
inline constexpr OfAxes net_torque =
    along("net_t", "_Nm", "Net torque of the hand on the platform", "platform", "platform");
inline constexpr Column net_push_percent = plain(
    "net_push_percent", "Net force on the platform in percent of the grip; empty below 0.5 N");
/// In the axes of the hand: computed for exports, never stored. In the order of HandAxis.
inline constexpr OfFingersAxes hand_force = [] {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kAxes{
      {{"flexion", "flexion (closing; minus: opening)"},
       {"radial", "radial (minus: ulnar)"},
       {"distal", "distal (minus: proximal)"}}};
  OfFingersAxes all;
  for (std::size_t f = 0; f < kFingerCount; ++f)
    for (std::size_t a = 0; a < 3; ++a)
      all[f][a] = {FixedText<28>(kFingerNames[f], "_", kAxes[a].first, "_N"),
                   FixedText<112>("Force of the ", kFingerNames[f], ", ", kAxes[a].second),
                   "hand",
                   {},
                   kFingerNames[f]};
  return all;
}();

// What the device sent.
inline constexpr OfFingersAxes raw_force =
    along_of_fingers("", "_f", "_counts", "Raw force count of the ", "'s sensor", "sensor");
inline constexpr OfFingersAxes raw_torque =
    along_of_fingers("", "_t", "_counts", "Raw torque count of the ", "'s sensor", "sensor");

// The virtual object and its target.
inline constexpr OfAxes target_position =
    along("target_", "_m", "Position of the target", "world", "target");
inline constexpr OfAxes actual_position =
    along("actual_", "_m", "Position of the object", "world", "object");
inline constexpr OfComponents target_attitude = attitude("target", "target");
inline constexpr OfComponents actual_attitude = attitude("actual", "object");
inline constexpr Column target_angle_rad = about_z("target_angle_rad", "target");
inline constexpr Column actual_angle_rad = about_z("actual_angle_rad", "object");
inline constexpr OfAxes object_velocity =
    along("v", "_mps", "Velocity of the object's centre of mass", "world", "object");
inline constexpr OfAxes object_angular_velocity =
    along("w", "_radps", "Angular velocity of the object", "world", "object");
inline constexpr OfAxes object_force = along("f", "_N", "Force on the object", "world", "object");
inline constexpr OfAxes object_torque =
    along("t", "_Nm", "Torque on the object about its centre of mass", "world", "object");
inline constexpr OfFingers contact = each_finger([](std::string_view finger) {
  return Column{FixedText<28>("contact_", finger),
                FixedText<112>("1: touches the object: ", finger),
                {},
                {},
                finger};
});
inline constexpr OfFingers slip = each_finger([](std::string_view finger) {
  return Column{FixedText<28>("slip_", finger),
                FixedText<112>("1: at the limit of friction: ", finger),
                {},
                {},
                finger};
});
inline constexpr OfFingers utilisation = each_finger([](std::string_view finger) {
  return Column{FixedText<28>("utilisation_", finger),
                FixedText<112>("Tangential force over the limit of friction: ", finger),
                {},
                {},
                finger};
});
inline constexpr Column model_error_rad =
    plain("model_error_rad", "Estimated error of the attitude, made in the hold that ends here");
inline constexpr Column model_inexact =
    plain("model_inexact", "1: that error is above the scene's tolerance");

/// The column of this name; null: none of those above or of core/column.hpp.
[[nodiscard]] const Column* find(std::string_view name);

}  // namespace isograsp::columns
