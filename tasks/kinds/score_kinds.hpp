// SPDX-License-Identifier: GPL-3.0-or-later
// Inside tasks/ only: the measures of each kind of task.
#pragma once

#include <vector>

#include "tasks/record.hpp"

namespace isograsp::tasks {

[[nodiscard]] std::vector<Measure> measures_of(const RestSpec& spec, const Record& record);
[[nodiscard]] std::vector<Measure> measures_of(const MaximumSpec& spec, const Record& record);
[[nodiscard]] std::vector<Measure> measures_of(const DirectionalMaximaSpec& spec,
                                               const Record& record);
[[nodiscard]] std::vector<Measure> measures_of(const ForceTrackingSpec& spec, const Record& record);
[[nodiscard]] std::vector<Measure> measures_of(const SteadinessSpec& spec, const Record& record);
[[nodiscard]] std::vector<Measure> measures_of(const StepResponseSpec& spec, const Record& record);
[[nodiscard]] std::vector<Measure> measures_of(const GripReleaseSpec& spec, const Record& record);
[[nodiscard]] std::vector<Measure> measures_of(const ForceSenseSpec& spec, const Record& record);
[[nodiscard]] std::vector<Measure> measures_of(const FatigueSpec& spec, const Record& record);
[[nodiscard]] std::vector<Measure> measures_of(const IndividuationSpec& spec, const Record& record);
[[nodiscard]] std::vector<Measure> measures_of(const ForceDirectionSpec& spec,
                                               const Record& record);
[[nodiscard]] std::vector<Measure> measures_of(const PoseTargetsSpec& spec, const Record& record);
[[nodiscard]] std::vector<Measure> measures_of(const PoseTrackingSpec& spec, const Record& record);
[[nodiscard]] std::vector<Measure> measures_of(const PickPlaceSpec& spec, const Record& record);
[[nodiscard]] std::vector<Measure> measures_of(const ObserveSpec& spec, const Record& record);
[[nodiscard]] std::vector<Measure> measures_of(const RecordedSpec& spec, const Record& record);

}  // namespace isograsp::tasks
