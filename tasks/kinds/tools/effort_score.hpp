// SPDX-License-Identifier: GPL-3.0-or-later
// Inside tasks/ only: how strong an effort was.
#pragma once

#include <string>
#include <vector>

#include "tasks/kinds/tools/score_tools.hpp"

namespace isograsp::tasks {

/// Best window of one effort, above rest and in total, and the highest sample.
struct EffortForces {
  statistics::Computed above_rest = "no samples"_text;
  statistics::Computed total = "no samples"_text;
  statistics::Computed peak = "no samples"_text;
};
EffortForces effort_of(const Record& record, const Part& part, double window_s,
                       const Column& force = columns::actual_force_N,
                       const Column& resting = columns::resting_force_N);

/// Press, above what the digits did in the lead-in, of those that were to open.
void add_coflexion(const Record& record, const Part& part, const std::string& channel,
                   double window_s, MeasureList& list);

/// Rows of an effort; of old records without segments, those that are active.
std::vector<Part> efforts_of(const Record& record);

}  // namespace isograsp::tasks
