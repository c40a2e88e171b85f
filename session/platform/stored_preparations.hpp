// SPDX-License-Identifier: GPL-3.0-or-later
// What a platform for three fingers measures before trials, and how it is stored.
#pragma once

#include <optional>
#include <string>

#include "hand/platform_records.hpp"
#include "storage/records/records.hpp"

namespace isograsp::session {

/// Device empty, one second quiet: mean and SD per finger and axis.
struct ZeroRecord {
  SixAxes mean;
  SixAxes sd;  ///< the empty noise
  /// Largest force component by which it differs from the last empty zero of the same device, in
  /// whichever session; nothing: there was none.
  std::optional<double> change_N = std::nullopt;
  bool change_confirmed = false;  ///< beyond the band: somebody said "serviced or remounted"
  /// The same from the zero before it in this session; nothing: it is the first.
  std::optional<double> drift_N = std::nullopt;
  bool drifted = false;  ///< beyond the limit: the forces of the trials between are in doubt
};

/// Hand in, relaxed: what each finger presses. Never subtracted from anything.
struct RestRecord {
  storage::RowId id = 0;
  storage::RowId trial_id = 0;  ///< its signals
  double session_time_s = 0.0;
  std::string recorded_utc;
  std::string operator_name;
  double duration_s = 0.0;
  std::optional<double> since_strapping_s = std::nullopt;  ///< nothing: not known
  std::int64_t samples = 0;
  SixAxes mean;
  SixAxes sd;
};

/// Without session, time and who.
[[nodiscard]] storage::PreparationRecord as_stored(const ZeroRecord& zero);
/// What is to be known about an accepted zero; may be empty.
[[nodiscard]] Text remark_on(const ZeroRecord& zero);
[[nodiscard]] storage::PreparationRecord as_stored(const RestRecord& rest);

}  // namespace isograsp::session
