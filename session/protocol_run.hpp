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

/// A protocol with all its tasks read: a bad file is found before a session begins.
struct ReadyProtocol {
  ProtocolSpec spec;
  std::vector<TaskSpec> tasks;  ///< of each step; unused for an instrument zero
};
/// Tasks are looked for beside the protocol, then in the library; their scenes must exist.
[[nodiscard]] Result<ReadyProtocol> read_protocol(const std::string& path,
                                                  const std::string& library);

/// Runs `protocol` in `session`; `serviced`: the operator has confirmed that the device was
/// serviced or remounted, so that its first zero may differ from the last one. A zero that is
/// refused three times, or a trial that a device fault interrupts twice, ends the protocol with an
/// error; what was recorded stays.
[[nodiscard]] Result<ProtocolResult> run_protocol(
    Session& session, const ReadyProtocol& protocol,
    const std::function<void(const ProtocolProgress&)>& progress, bool serviced = false);

}  // namespace isograsp
