// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/facts/column_facts.hpp"

#include <algorithm>
#include <optional>

#include "hand/finger.hpp"

namespace isograsp::tasks {

namespace {

struct Named {
  std::string_view name;
  std::string_view description;
};

/// Columns without a direction in space. Numbers of enumerations: docs/file_formats.md.
constexpr Named kNamed[] = {
    {"t_s", "Time since the trial began"},
    {"task_time_s", "The task's own clock, which stands still while paused"},
    {"phase", "0 lead-in, 1 active, 2 transport, 3 hold, 4 paused, 5 done"},
    {"sample_flags",
     "Over the fingers: 1 held, 2 missing, 4 saturated, 8 overload; anything but 0 is excluded "
     "from measures"},
    {"target_force_N", "Force asked for; empty: none"},
    {"actual_force_N", "Force in the channel of this part of the task"},
    {"resting_force_N", "Resting force of this channel in this session"},
    {"maximum_force_N", "Maximum force of this channel in this session"},
    {"noise_sd_N", "Standard deviation of the empty device in this channel"},
    {"resolution_N", "Coarsest step of a force component"},
    {"device_delay_s", "Delay of the sensors and their filters"},
    {"display_delay_s", "Delay of the patient's display; empty: not measured"},
    {"segment", "Part of the task's timeline, from 0"},
    {"cue", "0 hand out, 1 relax, 2 squeeze, 3 press, 4 follow, 5 reproduce, 6 let go, 7 move"},
    {"channel_digits", "0 grip, 1 grip_mean, 2 pinch, 3 sum, 4 thumb, 5 index, 6 middle"},
    {"channel_direction", "Contact axes: 0 +x, 1 -x, 2 +y, 3 -y, 4 +z (closing), 5 -z (opening)"},
    {"force_shown", "1: the patient saw the own force"},
    {"target_shown", "1: the patient saw the target"},
    {"target_index", "Which target of the series, from 0"},
    {"targets_reached", "Targets reached so far"},
    {"drops", "Drops so far"},
    {"net_push_percent", "Net force on the platform in percent of the grip; empty below 0.5 N"},
    {"model_error_rad", "Estimated error of the attitude, made in the hold that ends here"},
    {"model_inexact", "1: that error is above the scene's tolerance"},
    {"lateness_s", "From the instant of the grid to its record"},
    {"compute_s", "Work on the frame before"},
};

std::string unit_of(std::string_view column) {
  constexpr std::pair<std::string_view, std::string_view> kUnits[] = {
      {"_Nm", "N m"},    {"_N", "N"},     {"_mps", "m/s"}, {"_radps", "rad/s"},
      {"_rad", "rad"},   {"_m", "m"},     {"_s", "s"},     {"_counts", "counts"},
      {"_percent", "%"}, {"_deg", "deg"}, {"_Hz", "Hz"}};
  for (const auto& [ending, unit] : kUnits)
    if (column.ends_with(ending)) return std::string(unit);
  return "";
}

/// Takes a word from the front; false: it does not stand there.
bool take(std::string_view& rest, std::string_view word) {
  if (!rest.starts_with(word)) return false;
  rest.remove_prefix(word.size());
  return true;
}

/// x, y or z behind a letter: "fx_N" with 'f' gives "x".
std::string axis_of(std::string_view rest, char letter, std::string_view ending) {
  if (rest.size() != 2 + ending.size() || rest[0] != letter || !rest.ends_with(ending)) return "";
  return std::string_view("xyz").find(rest[1]) == std::string_view::npos ? ""
                                                                         : std::string(1, rest[1]);
}

using Found = std::optional<ColumnFacts>;

Found along(const std::string& axis, const std::string& what, const char* axes,
            const std::string& body) {
  return ColumnFacts{"", what + " along " + axis, axes, axis, body};
}

Found of_finger(std::string_view rest, bool target) {
  std::string finger;
  for (const auto name : kFingerNames)
    if (take(rest, std::string(name) + "_")) finger = name;
  if (finger.empty()) return {};
  if (const auto axis = axis_of(rest, 'f', "_N"); !axis.empty())
    return along(axis, (target ? "Force asked of the " : "Force of the ") + finger, "contact",
                 finger);
  if (target) return {};
  if (const auto axis = axis_of(rest, 't', "_Nm"); !axis.empty())
    return along(axis, "Torque of the " + finger, "contact", finger);
  if (const auto axis = axis_of(rest, 'f', "_counts"); !axis.empty())
    return along(axis, "Raw force count of the " + finger + "'s sensor", "sensor", finger);
  if (const auto axis = axis_of(rest, 't', "_counts"); !axis.empty())
    return along(axis, "Raw torque count of the " + finger + "'s sensor", "sensor", finger);
  if (rest == "flags")
    return ColumnFacts{"",
                       "Flags of the " + finger + ": 1 held, 2 missing, 4 saturated, 8 overload",
                       "", "", finger};
  for (const auto& [name, words] :
       {std::pair<std::string_view, std::string>{"flexion_N", "flexion (closing; minus: opening)"},
        {"radial_N", "radial (minus: ulnar)"},
        {"distal_N", "distal (minus: proximal)"}})
    if (rest == name)
      return ColumnFacts{"", "Force of the " + finger + ", " + words, "hand", "", finger};
  return {};
}

Found of_pose(std::string_view rest, const std::string& body) {
  if (rest.size() == 3 && rest.ends_with("_m"))
    if (const std::string_view xyz = "xyz"; xyz.find(rest[0]) != std::string_view::npos)
      return along(std::string(1, rest[0]), "Position of the " + body, "world", body);
  if (rest == "angle_rad")
    return ColumnFacts{"", "Angle of the " + body + " about world z", "world", "z", body};
  if (rest.size() == 2 && rest[0] == 'q' &&
      std::string_view("wxyz").find(rest[1]) != std::string_view::npos)
    return ColumnFacts{"", "Attitude of the " + body + ", quaternion " + rest[1], "world",
                       std::string("quat_") + rest[1], body};
  return {};
}

Found of_object(std::string_view rest) {
  if (const auto axis = axis_of(rest, 'v', "_mps"); !axis.empty())
    return along(axis, "Velocity of the object's centre of mass", "world", "object");
  if (const auto axis = axis_of(rest, 'w', "_radps"); !axis.empty())
    return along(axis, "Angular velocity of the object", "world", "object");
  if (const auto axis = axis_of(rest, 'f', "_N"); !axis.empty())
    return along(axis, "Force on the object", "world", "object");
  if (const auto axis = axis_of(rest, 't', "_Nm"); !axis.empty())
    return along(axis, "Torque on the object about its centre of mass", "world", "object");
  for (const auto& [prefix, words] :
       {std::pair<std::string_view, std::string>{"contact_", "1: touches the object: "},
        {"slip_", "1: at the limit of friction: "},
        {"utilisation_", "Tangential force over the limit of friction: "}}) {
    std::string_view finger = rest;
    if (take(finger, prefix) && finger_from_name(finger))
      return ColumnFacts{"", words + std::string(finger), "", "", std::string(finger)};
  }
  return {};
}

Found of_net(std::string_view rest) {
  if (!take(rest, "net_")) return {};
  if (const auto axis = axis_of(rest, 'f', "_N"); !axis.empty())
    return along(axis, "Net force of the hand on the platform", "platform", "platform");
  if (const auto axis = axis_of(rest, 't', "_Nm"); !axis.empty())
    return along(axis, "Net torque of the hand on the platform", "platform", "platform");
  return {};
}

Found find(std::string_view name) {
  for (const auto& [known, description] : kNamed)
    if (name == known) return ColumnFacts{"", std::string(description), "", "", ""};
  std::string_view rest = name;
  if (take(rest, "target_")) {
    if (auto facts = of_finger(rest, true)) return facts;
    return of_pose(rest, "target");
  }
  if (take(rest, "actual_")) return of_pose(rest, "object");
  for (auto facts : {of_net(name), of_finger(name, false), of_object(name)})
    if (facts) return facts;
  return {};
}

}  // namespace

ColumnFacts describe_column(std::string_view name) {
  const std::string unit = unit_of(name);
  if (auto facts = find(name)) {
    facts->unit = unit;
    facts->known = true;
    return *facts;
  }
  std::string words(name);
  std::replace(words.begin(), words.end(), '_', ' ');
  return {unit, "Column of a recording: " + words, "", "", ""};
}

}  // namespace isograsp::tasks
