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
#include "tasks/kinds/object_kinds.hpp"

namespace isograsp {

/// How long something takes as a rule and at most [s].
struct Duration {
  double nominal_s = 0.0;
  double worst_s = 0.0;
};

struct TaskSpec {
  std::string name;         ///< for people: "Grip force, sine"
  std::string instruction;  ///< plain words for the patient
  int version = 1;
  std::variant<RestSpec, MaximumSpec, ForceTrackingSpec, PoseTargetsSpec, ObserveSpec,
               DirectionalMaximaSpec, SteadinessSpec, StepResponseSpec, GripReleaseSpec,
               ForceSenseSpec, FatigueSpec, IndividuationSpec, ForceDirectionSpec, PoseTrackingSpec,
               PickPlaceSpec>
      kind;
  std::string file;  ///< where it was read from, for errors
  std::string text;  ///< the file itself: stored with every trial

  /// The scene the task needs; empty: none (a force task has no object).
  [[nodiscard]] std::string scene() const;
  [[nodiscard]] Duration duration() const;
  /// How force and target are shown and scaled; null: the task has no force target.
  [[nodiscard]] const Aim* aim() const;
  /// Largest level of the task, in units of its scale.
  [[nodiscard]] double largest_level() const;
  /// The channels whose maximum, or comfortable force, must have been measured in the session.
  [[nodiscard]] std::vector<ForceChannel> channels_needed(Scale scale) const;
  [[nodiscard]] bool needs_maximum() const { return !channels_needed(Scale::of_maximum).empty(); }
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
