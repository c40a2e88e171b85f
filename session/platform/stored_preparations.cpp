// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/platform/stored_preparations.hpp"

#include "session/platform/zeroing.hpp"

namespace isograsp::session {

namespace {

/// What both have in common.
template <class Taken>
storage::PreparationRecord stored_as(const char* kind, const Taken& taken) {
  storage::PreparationRecord record;
  record.kind = kind;
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

Text remark_on(const ZeroRecord& zero) {
  std::vector<Text> remarks;
  if (zero.change_confirmed)
    remarks.push_back(
        "It differs from the last empty zero by %1 N; confirmed as serviced or remounted."_text(
            two_digits(*zero.change_N)));
  if (zero.drifted)
    remarks.push_back(
        "The zero has drifted by %1 N since the one before: the trials between are marked."_text(
            two_digits(*zero.drift_N)));
  return joined(remarks);
}

storage::PreparationRecord as_stored(const RestRecord& rest) {
  storage::PreparationRecord record = stored_as(platform::kRestingForce, rest);
  record.session_time_s = rest.session_time_s;
  record.recorded_utc = rest.recorded_utc;
  record.operator_name = rest.operator_name;
  record.trial_id = rest.trial_id;
  record.samples = rest.samples;
  storage::set_value(record.references, platform::kDuration_s, rest.duration_s);
  storage::set_value(record.references, platform::kSinceStrapping_s, rest.since_strapping_s);
  return record;
}

}  // namespace isograsp::session
