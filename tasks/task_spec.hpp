// SPDX-License-Identifier: GPL-3.0-or-later
// What the patient is asked to do, as a task file says it (docs/file_formats.md). SI units,
// radians.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/result.hpp"
#include "core/spatial.hpp"

namespace isograsp {

/// Hand in, relaxed: the resting force of each finger is measured and stored, never subtracted.
struct RestSpec {
  double duration_s = 10.0;
};

/// Maximum grip force: build up, squeeze, stop. One attempt.
struct MaximumSpec {
  double lead_in_s = 1.0;
  double squeeze_s = 3.0;
  double window_s = 0.5;  ///< best moving mean over this window counts
};

/// Grip force follows a sine between two fractions of the maximum measured in the same session.
struct ForceTrackingSpec {
  double frequency_Hz = 0.2;
  double least_fraction = 0.1;  ///< of the maximum
  double most_fraction = 0.3;
  double lead_in_s = 2.0;    ///< constant at the sine's first value; not scored
  double duration_s = 30.0;  ///< of the sine
};

/// The object is brought to a series of poses, each held inside its tolerance.
struct PoseTarget {
  Vec3 p_WT = Vec3::Zero();  ///< [m]
  double angle_rad = 0.0;    ///< about world z
  double hold_s = 0.0;       ///< uninterrupted time inside the tolerance that counts as reached
  bool level = false;        ///< a transport: tilt on the way here is measured
};
struct PoseTargetsSpec {
  std::string scene;  ///< name of a scene file, beside the task file or in the library
  double position_tolerance_m = 0.02;
  double angle_tolerance_rad = 0.2617993877991494;  ///< 15 degrees
  double time_limit_s = 60.0;                       ///< per target
  std::vector<PoseTarget> targets;
};

/// Free handling of an object for a fixed time: recorded data, familiarisation.
struct ObserveSpec {
  std::string scene;
  double duration_s = 30.0;
};

struct TaskSpec {
  std::string name;         ///< for people: "Grip force, sine"
  std::string instruction;  ///< plain words for the patient
  int version = 1;
  std::variant<RestSpec, MaximumSpec, ForceTrackingSpec, PoseTargetsSpec, ObserveSpec> kind;
  std::string file;  ///< where it was read from, for errors
  std::string text;  ///< the file itself: stored with every trial

  /// The scene the task needs; empty: none (a force task has no object).
  [[nodiscard]] std::string scene() const;
  /// Longest time the task can take [s].
  [[nodiscard]] double worst_duration_s() const;
  /// True if targets are fractions of the maximum force of this session.
  [[nodiscard]] bool needs_maximum() const;
};

[[nodiscard]] Result<TaskSpec> parse_task(std::string_view text, const std::string& file);

/// One step of a protocol.
struct ProtocolStep {
  enum class Kind : std::uint8_t {
    instrument_zero,  ///< device empty
    task
  };
  Kind kind = Kind::task;
  std::string task;  ///< file name of the task, without folder
  int repetitions = 1;
  bool practice = false;  ///< recorded, but no assessment
  double rest_s = 0.0;    ///< pause after each repetition
};
struct ProtocolSpec {
  std::string name;
  std::vector<ProtocolStep> steps;
  std::string file;
  std::string text;
};
[[nodiscard]] Result<ProtocolSpec> parse_protocol(std::string_view text, const std::string& file);

}  // namespace isograsp
