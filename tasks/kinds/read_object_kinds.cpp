// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>

#include "tasks/kinds/read_kinds.hpp"

namespace isograsp::tasks {

namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180.0;
constexpr double kMostAngle_deg = 360.0;

struct Tolerances {
  double position_m;
  double angle_rad;
};
Tolerances read_tolerances(TomlReader& reader, Tolerances fallback) {
  constexpr double kLeast_m = 1e-4;
  constexpr double kLeast_deg = 0.1;
  return {read_within(reader, "position_tolerance_m", kLeast_m, 1.0, fallback.position_m),
          kRadPerDeg * read_within(reader, "angle_tolerance_deg", kLeast_deg, 180.0,
                                   fallback.angle_rad / kRadPerDeg)};
}

}  // namespace

std::string read_scene(TomlReader& reader) {
  std::string name = reader.text("scene");
  if (reader.has("scene") && (name.empty() || name.find('/') != std::string::npos))
    reader.fail("scene", "'" + name + "' is not the name of a scene",
                "write the name of its file without folder and ending, e.g. \"planar_block\"");
  return name;
}

PoseTargetsSpec read_pose_targets(TomlReader& reader) {
  PoseTargetsSpec spec;
  spec.scene = read_scene(reader);
  const auto tolerances =
      read_tolerances(reader, {spec.position_tolerance_m, spec.angle_tolerance_rad});
  spec.position_tolerance_m = tolerances.position_m;
  spec.angle_tolerance_rad = tolerances.angle_rad;
  spec.time_limit_s = read_duration(reader, "time_limit_s", spec.time_limit_s);
  for (TomlReader& table : reader.tables("target")) {
    PoseTarget target;
    target.p_WT = table.vec3("position_m");
    target.angle_rad =
        kRadPerDeg * read_within(table, "angle_deg", -kMostAngle_deg, kMostAngle_deg, 0.0);
    target.hold_s = read_wait(table, "hold_s", 0.0);
    target.level = table.boolean("level", false);
    if (target.hold_s >= spec.time_limit_s)
      table.fail("hold_s", "leaves no time within time_limit_s", "make it shorter");
    spec.targets.push_back(target);
  }
  if (spec.targets.empty()) reader.fail("target", "is missing", "add at least one [[target]]");
  return spec;
}

ObserveSpec read_observe(TomlReader& reader) {
  ObserveSpec spec;
  spec.scene = read_scene(reader);
  spec.duration_s = read_duration(reader, "duration_s", spec.duration_s);
  return spec;
}

PoseTrackingSpec read_pose_tracking(TomlReader& reader) {
  PoseTrackingSpec spec;
  spec.scene = read_scene(reader);
  spec.lead_in_s = read_wait(reader, "lead_in_s", spec.lead_in_s);
  spec.duration_s = read_duration(reader, "duration_s", spec.duration_s);
  std::array<bool, 6> used{};
  for (TomlReader& table : reader.tables("axis")) {
    constexpr double kMost_m = 1.0;
    PoseTrackingSpec::Axis axis;
    axis.axis = static_cast<int>(table.choice("dof", {"x", "y", "z", "rx", "ry", "rz"}));
    const bool turns = axis.axis >= 3;
    const double most = turns ? kMostAngle_deg : kMost_m;
    const double unit = turns ? kRadPerDeg : 1.0;
    axis.least = unit * read_within(table, turns ? "least_deg" : "least_m", -most, most);
    axis.most = unit * read_within(table, turns ? "most_deg" : "most_m", -most, most);
    axis.waveform = read_waveform(table, spec.duration_s);
    if (axis.waveform.shape == Waveform::Shape::csv && axis.waveform.values.empty())
      table.fail("waveform", "cannot be a file here",
                 "write its points into [axis.csv_data], or choose another shape");
    if (std::exchange(used[static_cast<std::size_t>(axis.axis)], true))
      table.fail("dof", "is driven twice", "write one [[axis]] per degree of freedom");
    spec.axes.push_back(std::move(axis));
  }
  if (spec.axes.empty()) reader.fail("axis", "is missing", "add at least one [[axis]]");
  if (used[3] + used[4] + used[5] > 1)
    reader.fail("axis", "turns about more than one axis",
                "let the target turn about rx, ry or rz alone");
  return spec;
}

PickPlaceSpec read_pick_place(TomlReader& reader) {
  PickPlaceSpec spec;
  spec.scene = read_scene(reader);
  const auto tolerances =
      read_tolerances(reader, {spec.position_tolerance_m, spec.angle_tolerance_rad});
  spec.position_tolerance_m = tolerances.position_m;
  spec.angle_tolerance_rad = tolerances.angle_rad;
  spec.hold_s = read_wait(reader, "hold_s", spec.hold_s);
  spec.time_limit_s = read_duration(reader, "time_limit_s", spec.time_limit_s);
  spec.drop_distance_m = read_within(reader, "drop_distance_m", 1e-4, 1.0, spec.drop_distance_m);
  for (TomlReader& table : reader.tables("item")) {
    PickPlaceSpec::Item item;
    item.p_WO = table.vec3("from_m", Vec3::Zero());
    item.p_WT = table.vec3("to_m");
    item.angle_rad =
        kRadPerDeg * read_within(table, "angle_deg", -kMostAngle_deg, kMostAngle_deg, 0.0);
    spec.items.push_back(item);
  }
  if (spec.items.empty()) reader.fail("item", "is missing", "add at least one [[item]]");
  if (spec.hold_s >= spec.time_limit_s)
    reader.fail("hold_s", "leaves no time within time_limit_s", "make it shorter");
  return spec;
}

}  // namespace isograsp::tasks
