// SPDX-License-Identifier: GPL-3.0-or-later
// What a compiled scene costs on this machine, now: measured, not computed.
#pragma once

#include "grasp_model/plan.hpp"

namespace isograsp::session {

/// Least mean time of Plan::step() over batches of frames with all fingers pressing [ns]. Takes
/// some milliseconds; any thread.
[[nodiscard]] double cost_ns_per_frame(const Plan& plan);

}  // namespace isograsp::session
