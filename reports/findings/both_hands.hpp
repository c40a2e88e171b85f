// SPDX-License-Identifier: GPL-3.0-or-later
// What both hands did together over the sessions, gathered from the tasks of both: how they share a
// force of which the sum alone is asked, and what they lifted and carried. SI units.
#pragma once

#include <vector>

#include "reports/findings/measure_series.hpp"
#include "reports/findings/report_content.hpp"

namespace isograsp::reports {

/// Adds what these trials tell of it: those that count and may be compared with the newest one.
/// Other kinds of task add nothing. @param all trials of one task and hand, oldest first, not empty
void add_both_hands(const TaskSection& section, const std::vector<const StoredTrial*>& all,
                    BothHands& both);

/// After the last task: sessions in their order; of several tasks that ask for a sum the one with
/// the newest trial stays, the others are named.
void finish_both_hands(BothHands& both);

}  // namespace isograsp::reports
