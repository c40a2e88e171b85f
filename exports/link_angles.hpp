// SPDX-License-Identifier: GPL-3.0-or-later
// How far the links of an arm have turned, for exports. Inside exports/ only.
#pragma once

#include "exports/export_trial.hpp"

namespace isograsp::exports {

/// Adds the group tasks::kLinkGroup to a trial whose signals have segments (tasks::kSegmentGroup):
/// of each link elbow_forearm, forearm_dorsum, dorsum_object of which both segments are there the
/// rotation vector log(R_0^T R) [rad], R the attitude of the further segment in the nearer one, 0
/// the first row that has both. Computed, never stored; missing where one of the two is.
void add_link_angles(ExportTrial& exported);

}  // namespace isograsp::exports
