// SPDX-License-Identifier: GPL-3.0-or-later
// What the patient is asked to do, as a task file says it (docs/file_formats.md). SI units,
// radians.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/result.hpp"
#include "core/spatial.hpp"
#include "tasks/kinds/object_kinds.hpp"
#include "tasks/kinds/recorded_kind.hpp"

namespace isograsp::tasks {

/// How long something takes as a rule and at most [s].
struct Duration {
  double nominal_s = 0.0;
  double worst_s = 0.0;
};

/// How a training task becomes easier or harder, and what counts as success.
struct Difficulty {
  enum class Factor : std::uint8_t { tolerance, distance, frequency, level };
  Factor factor = Factor::tolerance;  ///< what is multiplied
  double easiest = 1.0;               ///< by this at level 0 …
  double hardest = 1.0;               ///< … and by this at level 1
  double start = 0.3;                 ///< level of the first trial
  std::string measure;                ///< success: this measure …
  double at_least = 0.0;              ///< … is not below this
  std::optional<double> chosen;       ///< level of this trial; nothing: the file as it is
};

struct TaskSpec {
  std::string name;         ///< for people: "Grip force, sine"
  std::string instruction;  ///< plain words for the patient
  int version = 1;
  std::variant<RestSpec, MaximumSpec, ForceTrackingSpec, PoseTargetsSpec, ObserveSpec,
               DirectionalMaximaSpec, SteadinessSpec, StepResponseSpec, GripReleaseSpec,
               ForceSenseSpec, FatigueSpec, IndividuationSpec, ForceDirectionSpec, PoseTrackingSpec,
               PickPlaceSpec, RecordedSpec>
      kind;
  std::optional<Difficulty> difficulty;
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

/// The task at a level of its difficulty, 0 … 1; the level stands at the end of its text.
/// @pre spec.difficulty
[[nodiscard]] Result<TaskSpec> at_level(const TaskSpec& spec, double level);

[[nodiscard]] Result<TaskSpec> parse_task(std::string_view text, const std::string& file);

}  // namespace isograsp::tasks
