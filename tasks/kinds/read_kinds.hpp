// SPDX-License-Identifier: GPL-3.0-or-later
// Inside tasks/ only: the keys of each kind of task in a task file (docs/file_formats.md). Problems
// are reported to the reader; the caller asks it in the end.
#pragma once

#include "core/toml_reader.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::tasks {

inline constexpr double kLongestPart_s = 3600.0;  ///< nobody exercises for longer: a typing error

/// A number in [least, most]; the fallback makes the key optional.
double read_within(TomlReader& reader, std::string_view key, double least, double most,
                   std::optional<double> fallback = {});
/// A duration above zero [s].
double read_duration(TomlReader& reader, std::string_view key, double fallback);
/// A duration from zero on [s].
double read_wait(TomlReader& reader, std::string_view key, double fallback);
int read_count(TomlReader& reader, std::string_view key, int fallback, int most);
std::string read_scene(TomlReader& reader);
/// `of`: "_fraction" or "_N" is read for levels, as the scale demands.
Waveform read_waveform(TomlReader& reader, double duration_s);

RestSpec read_rest(TomlReader& reader);
MaximumSpec read_maximum(TomlReader& reader);
DirectionalMaximaSpec read_directional_maxima(TomlReader& reader);
ForceTrackingSpec read_force_tracking(TomlReader& reader);
SteadinessSpec read_steadiness(TomlReader& reader);
StepResponseSpec read_step_response(TomlReader& reader);
GripReleaseSpec read_grip_release(TomlReader& reader);
ForceSenseSpec read_force_sense(TomlReader& reader);
FatigueSpec read_fatigue(TomlReader& reader);
IndividuationSpec read_individuation(TomlReader& reader);
ForceDirectionSpec read_force_direction(TomlReader& reader);

PoseTargetsSpec read_pose_targets(TomlReader& reader);
ObserveSpec read_observe(TomlReader& reader);
PoseTrackingSpec read_pose_tracking(TomlReader& reader);
PickPlaceSpec read_pick_place(TomlReader& reader);

RecordedSpec read_recorded(TomlReader& reader);

}  // namespace isograsp::tasks
