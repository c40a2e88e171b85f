// SPDX-License-Identifier: GPL-3.0-or-later
// What the report says of a task of an arm beside its measures: how often each posture was reached
// and how soon, within which tolerance, and what the rest of the body did. Rules: docs/report.md.
#pragma once

#include <vector>

#include "reports/findings/measure_series.hpp"

namespace isograsp::reports {

/// For each posture how often it was reached in these trials and how soon:
/// targets that were not reached stand in the median as longer than the limit. Empty: of another
/// kind of task.
[[nodiscard]] std::vector<PostureResult> posture_results(
    const TaskSection& section, const std::vector<const StoredTrial*>& compared);
/// Reads a trial of the last session of a task with postures target by target into section.poses.
void add_poses(TaskSection& section, const Signals& signals);
/// Adds to each posture how far the object was off in section.poses, how far it turned and how long
/// it was not seen.
void finish_postures(TaskSection& section);

/// "Tolerance 15 mm and 10°, held for 0.3 s"; empty: of another kind of task.
[[nodiscard]] Text tolerance_words(const TaskSection& section);

/// Of the last of the trials that are compared: recognition and movement apart, which link turned
/// first, and the share of its turn that each had when the forearm had 63 % of its own. Describes:
/// no more and no less of it is better. Empty: of another kind of task, or nothing was reached.
[[nodiscard]] std::vector<Text> sharing_lines(const TaskSection& section,
                                              const std::vector<const StoredTrial*>& compared);

/// Of section.poses: in how many movements the upper arm moved, whether the device did, and that
/// the trunk was not measured. Empty: of another kind of task, or nothing to say.
[[nodiscard]] std::vector<Text> compensation_lines(const TaskSection& section);

}  // namespace isograsp::reports
