// SPDX-License-Identifier: GPL-3.0-or-later
// Inside tasks/ only: how steady a force is held.
#pragma once

#include <string>

#include "tasks/kinds/tools/score_tools.hpp"

namespace isograsp::tasks {

inline constexpr Words kTrackingTooShort = "fewer than two samples"_text;

void add_steadiness(const Trace& hold, const std::string& channel, double noise_N,
                    MeasureList& list);

}  // namespace isograsp::tasks
