// SPDX-License-Identifier: GPL-3.0-or-later
// One task with one hand over the sessions: what is compared, what is left out and why.
#pragma once

#include <vector>

#include "reports/findings/verdicts.hpp"

namespace isograsp::reports {

/// @param all  trials of one task and hand, oldest first, not empty; the last one decides with what
///             the others are compared
[[nodiscard]] Result<TaskSection> make_section(const VerdictContext& context,
                                               const std::vector<const StoredTrial*>& all,
                                               const std::vector<ReportSession>& sessions);

/// Of a force task: its best and worst trial among those that are compared, by its first key
/// measure; null where there are not two.
struct Extremes {
  const StoredTrial* best = nullptr;
  const StoredTrial* worst = nullptr;
};
[[nodiscard]] Extremes extremes_of(const TaskSection& section,
                                   const std::vector<const StoredTrial*>& all);

/// Tasks in the order of an assessment; the hand with more trials first.
void put_in_order(std::vector<TaskSection>& sections, const std::vector<ReportSession>& sessions);

}  // namespace isograsp::reports
