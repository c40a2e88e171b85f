// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/platform/instrument_zero.hpp"

#include "session/platform/stored_preparations.hpp"

namespace isograsp::session {

PreparationOutcome InstrumentZero::outcome() const {
  PreparationOutcome outcome;
  outcome.name = "zero";
  outcome.accepted = !refusal.has_value();
  ZeroRecord zero;
  zero.mean = statistics.mean;
  zero.sd = statistics.sd;
  zero.change_N = change_N;
  zero.drift_N = drift_N;
  zero.drifted = drift_N && *drift_N > ZeroLimits().force_drift_N;
  if (outcome.accepted) {
    zero.change_confirmed = change_confirmed;
    outcome.remark = remark_on(zero);
  } else {
    outcome.reason = words_of(*refusal);
    outcome.only_changed = refusal->why == ZeroRefusal::Why::changed;
  }
  outcome.record = as_stored(zero);
  return outcome;
}

}  // namespace isograsp::session
