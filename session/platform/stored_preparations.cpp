// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/platform/stored_preparations.hpp"

namespace isograsp::session {

namespace {

/// What both have in common; the store gives the number.
template <class Taken>
storage::PreparationRecord stored_as(const char* kind, const Taken& taken) {
  storage::PreparationRecord record;
  record.kind = kind;
  record.session_time_s = taken.session_time_s;
  record.recorded_utc = taken.recorded_utc;
  record.operator_name = taken.operator_name;
  record.columns = platform::six_axes_columns();
  record.mean = platform::as_row(taken.mean);
  record.sd = platform::as_row(taken.sd);
  return record;
}

}  // namespace

storage::PreparationRecord as_stored(const ZeroRecord& zero) {
  storage::PreparationRecord record = stored_as(platform::kInstrumentZero, zero);
  storage::set_value(record.references, platform::kChange_N, zero.change_N);
  storage::set_value(record.references, platform::kDrift_N, zero.drift_N);
  record.change_confirmed = zero.change_confirmed;
  record.drifted = zero.drifted;
  return record;
}

storage::PreparationRecord as_stored(const RestRecord& rest) {
  storage::PreparationRecord record = stored_as(platform::kRestingForce, rest);
  record.trial_id = rest.trial_id;
  record.samples = rest.samples;
  storage::set_value(record.references, platform::kDuration_s, rest.duration_s);
  storage::set_value(record.references, platform::kSinceStrapping_s, rest.since_strapping_s);
  return record;
}

}  // namespace isograsp::session
