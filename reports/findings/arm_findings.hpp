// SPDX-License-Identifier: GPL-3.0-or-later
// What the report says of a task of an arm beside its measures: how often each posture was reached
// and how soon, within which tolerance, and what the rest of the body did. Rules: docs/report.md.
#pragma once

#include <vector>

#include "reports/findings/measure_series.hpp"

namespace isograsp::reports {

/// Tolerance, then a line for each posture over the trials that are compared. Targets that were not
/// reached are counted and stand in the median as longer than the limit: with as many or more of
/// them than of the others there is none. Empty: of another kind of task.
[[nodiscard]] std::vector<Text> posture_lines(const TaskSection& section,
                                              const std::vector<const StoredTrial*>& compared);

/// Of the last of the trials that are compared: recognition and movement apart, which link turned
/// first, and the share of its turn that each had when the forearm had 63 % of its own. Describes:
/// no more and no less of it is better. Empty: of another kind of task, or nothing was reached.
[[nodiscard]] std::vector<Text> sharing_lines(const TaskSection& section,
                                              const std::vector<const StoredTrial*>& compared);

/// Of the last trial as it is drawn: in how many movements the upper arm moved, whether the device
/// did, and that the trunk was not measured. Empty: of another kind of task, or nothing to say.
[[nodiscard]] std::vector<Text> compensation_lines(const TaskSection& section);

}  // namespace isograsp::reports
