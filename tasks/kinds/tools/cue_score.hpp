// SPDX-License-Identifier: GPL-3.0-or-later
// Inside tasks/ only: how soon a force answers a cue.
#pragma once

#include <string>
#include <vector>

#include "tasks/kinds/tools/score_tools.hpp"
#include "tasks/measures/step.hpp"

namespace isograsp::tasks {

/// 0: not known.
double known_or_zero(const Record& record, const Part& part, std::string_view column);

/// Times of an event that may be censored, and the same without the known delay: their
/// median, as NAME_corrected.
void add_delayed_times(const std::string& name, const std::string& channel, const Record& record,
                       const Section& section, const std::vector<statistics::EventTime>& times,
                       double limit_s, MeasureList& list);

/// Reaction times of several cues: anticipations are excluded and counted, misses are censored.
void add_reactions(const std::string& name, const std::string& channel, const Record& record,
                   const Section& section, const std::vector<Reaction>& reactions, double limit_s,
                   MeasureList& list);

}  // namespace isograsp::tasks
