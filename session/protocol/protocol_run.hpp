// SPDX-License-Identifier: GPL-3.0-or-later
// A whole protocol without a window: every step in order, every outcome reported.
#pragma once

#include <functional>
#include <vector>

#include "session/session.hpp"

namespace isograsp::session {

struct ProtocolProgress {
  int step = 0;  ///< steps finished, repetitions counted singly
  int steps = 0;
  Text doing;  ///< "Grip force, sine (2 of 3)"
};

struct ProtocolResult {
  std::vector<TrialOutcome> trials;
  std::vector<Text> left_out;  ///< tasks that this hand cannot be asked, and why
};

/// Runs `protocol` in `session`, or what is left of it if the session resumes one; `serviced`: the
/// operator has confirmed that the device was serviced or remounted, so that its first zero may
/// differ from the last one. A zero that is refused three times, a trial that a device fault
/// interrupts twice, or one that would begin with a zero older than the restart of a sensor ends
/// the protocol with an error; what was recorded stays. A task that is refused for this hand (a
/// target that the sensors cannot resolve, effort that the screening does not allow) is left out,
/// noted and told.
[[nodiscard]] Result<ProtocolResult> run_protocol(
    Session& session, const ReadyProtocol& protocol,
    const std::function<void(const ProtocolProgress&)>& progress, bool serviced = false);

}  // namespace isograsp::session
