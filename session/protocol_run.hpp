// SPDX-License-Identifier: GPL-3.0-or-later
// A whole protocol without a window: every step in order, every outcome reported.
#pragma once

#include <functional>
#include <vector>

#include "session/session.hpp"

namespace isograsp {

struct ProtocolProgress {
  int step = 0;  ///< steps finished, repetitions counted singly
  int steps = 0;
  std::string doing;  ///< "Grip force, sine (2 of 3)"
};

struct ProtocolResult {
  std::vector<TrialOutcome> trials;
};

/// Runs `protocol` in `session`. A zero that is refused three times, or a trial that a device fault
/// interrupts twice, ends the protocol with an error; what was recorded stays.
[[nodiscard]] Result<ProtocolResult> run_protocol(
    Session& session, const ProtocolSpec& protocol, const std::string& library,
    const std::function<void(const ProtocolProgress&)>& progress);

}  // namespace isograsp
