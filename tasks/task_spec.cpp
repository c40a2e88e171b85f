// SPDX-License-Identifier: GPL-3.0-or-later
// Task files: TOML in, TaskSpec out. Degrees in the file, radians inside.
#include "tasks/task_spec.hpp"

#include <numbers>

#include "core/csv.hpp"
#include "core/toml_reader.hpp"

namespace isograsp {

namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180.0;
constexpr double kLongest_s = 3600.0;  ///< nobody exercises for longer: a typing error

/// A number in [least, most]; the fallback makes the key optional.
double within(TomlReader& reader, std::string_view key, double least, double most,
              std::optional<double> fallback = {}) {
  const double value = reader.number(key, fallback);
  if (reader.has(key) && !(value >= least && value <= most))
    reader.fail(key, format_number(value) + " is out of range",
                "write a number from " + format_number(least) + " to " + format_number(most));
  return value;
}

/// A duration above zero.
double duration(TomlReader& reader, std::string_view key, double fallback) {
  const double value = within(reader, key, 0.0, kLongest_s, fallback);
  if (reader.has(key) && value == 0.0)
    reader.fail(key, "0 is out of range", "write a number above 0");
  return value;
}

std::string scene_name(TomlReader& reader) {
  std::string name = reader.text("scene");
  if (reader.has("scene") && (name.empty() || name.find('/') != std::string::npos))
    reader.fail("scene", "'" + name + "' is not the name of a scene",
                "write the name of its file without folder and ending, e.g. \"planar_block\"");
  return name;
}

RestSpec read_rest(TomlReader& reader) {
  RestSpec spec;
  spec.duration_s = duration(reader, "duration_s", spec.duration_s);
  return spec;
}

MaximumSpec read_maximum(TomlReader& reader) {
  MaximumSpec spec;
  spec.lead_in_s = within(reader, "lead_in_s", 0.0, kLongest_s, spec.lead_in_s);
  spec.squeeze_s = duration(reader, "squeeze_s", spec.squeeze_s);
  spec.window_s = duration(reader, "window_s", spec.window_s);
  if (spec.window_s > spec.squeeze_s)
    reader.fail("window_s", "is longer than squeeze_s", "make it shorter");
  return spec;
}

ForceTrackingSpec read_force_tracking(TomlReader& reader) {
  constexpr double kLeast_Hz = 0.001;
  constexpr double kMost_Hz = 5.0;  ///< beyond what a hand can follow
  ForceTrackingSpec spec;
  spec.frequency_Hz = within(reader, "frequency_Hz", kLeast_Hz, kMost_Hz, spec.frequency_Hz);
  spec.least_fraction = within(reader, "least_fraction", 0.0, 1.0, spec.least_fraction);
  spec.most_fraction = within(reader, "most_fraction", 0.0, 1.0, spec.most_fraction);
  if (spec.most_fraction <= spec.least_fraction)
    reader.fail("most_fraction", "is not above least_fraction", "write a larger fraction");
  spec.lead_in_s = within(reader, "lead_in_s", 0.0, kLongest_s, spec.lead_in_s);
  spec.duration_s = duration(reader, "duration_s", spec.duration_s);
  return spec;
}

PoseTargetsSpec read_pose_targets(TomlReader& reader) {
  PoseTargetsSpec spec;
  constexpr double kLeastTolerance_m = 1e-4;
  constexpr double kLeastTolerance_deg = 0.1;
  spec.scene = scene_name(reader);
  spec.position_tolerance_m =
      within(reader, "position_tolerance_m", kLeastTolerance_m, 1.0, spec.position_tolerance_m);
  spec.angle_tolerance_rad = kRadPerDeg * within(reader, "angle_tolerance_deg", kLeastTolerance_deg,
                                                 180.0, spec.angle_tolerance_rad / kRadPerDeg);
  spec.time_limit_s = duration(reader, "time_limit_s", spec.time_limit_s);
  for (TomlReader& table : reader.tables("target")) {
    PoseTarget target;
    target.p_WT = table.vec3("position_m");
    target.angle_rad = kRadPerDeg * within(table, "angle_deg", -360.0, 360.0, 0.0);
    target.hold_s = within(table, "hold_s", 0.0, kLongest_s, 0.0);
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
  spec.scene = scene_name(reader);
  spec.duration_s = duration(reader, "duration_s", spec.duration_s);
  return spec;
}

}  // namespace

std::string TaskSpec::scene() const {
  if (const auto* targets = std::get_if<PoseTargetsSpec>(&kind)) return targets->scene;
  if (const auto* observe = std::get_if<ObserveSpec>(&kind)) return observe->scene;
  return "";
}

double TaskSpec::worst_duration_s() const {
  if (const auto* rest = std::get_if<RestSpec>(&kind)) return rest->duration_s;
  if (const auto* maximum = std::get_if<MaximumSpec>(&kind))
    return maximum->lead_in_s + maximum->squeeze_s;
  if (const auto* tracking = std::get_if<ForceTrackingSpec>(&kind))
    return tracking->lead_in_s + tracking->duration_s;
  if (const auto* poses = std::get_if<PoseTargetsSpec>(&kind))
    return poses->time_limit_s * static_cast<double>(poses->targets.size());
  return std::get<ObserveSpec>(kind).duration_s;
}

bool TaskSpec::needs_maximum() const {
  return std::holds_alternative<ForceTrackingSpec>(kind);
}

Result<TaskSpec> parse_task(std::string_view text, const std::string& file) {
  auto reader = TomlReader::parse(text, file, "isograsp-task-1");
  if (!reader) return reader.error();
  TaskSpec spec;
  spec.file = file;
  spec.text = std::string(text);
  spec.name = reader->text("name");
  spec.instruction = reader->text("instruction");
  const auto version = reader->integer("version", 1);
  constexpr std::int64_t kMostVersion = 1'000'000;
  if (version < 1 || version > kMostVersion)
    reader->fail("version", std::to_string(version) + " is out of range", "count from 1");
  else
    spec.version = static_cast<int>(version);
  switch (
      reader->choice("kind", {"rest", "maximum", "force_tracking", "pose_targets", "observe"})) {
    case 0: spec.kind = read_rest(*reader); break;
    case 1: spec.kind = read_maximum(*reader); break;
    case 2: spec.kind = read_force_tracking(*reader); break;
    case 3: spec.kind = read_pose_targets(*reader); break;
    default: spec.kind = read_observe(*reader); break;
  }
  if (auto done = reader->finish(); !done) return done.error();
  return spec;
}

}  // namespace isograsp
