// SPDX-License-Identifier: GPL-3.0-or-later
// Completion times of which some are only known to be longer than the time tried (right-censored).
// The mean of the successes alone would improve by failing more often.
#pragma once

#include "statistics/samples.hpp"

namespace isograsp::statistics {

/// One target: reached after time_s, or tried for time_s without reaching it.
struct Completion {
  double time_s = 0.0;
  bool reached = false;
};

/// How many of how many were reached: to be read before any time.
struct Reached {
  int count = 0;
  int of = 0;
};
[[nodiscard]] Reached reached_of(std::span<const Completion> completions);

/// One step of the Kaplan-Meier estimate: from time_s on, `share` is not yet done.
struct SurvivalStep {
  double time_s = 0.0;
  double share = 1.0;
};
/// Kaplan & Meier (1958), version 2: S(t) = product over times t_i <= t of (1 - d_i / n_i), d_i
/// reached at t_i, n_i still trying just before; who stops at t_i, within kTimeSlack_s, still tried
/// then.
[[nodiscard]] std::vector<SurvivalStep> survival(std::span<const Completion> completions);

/// Median completion time [s], version 2: first time with S <= 1/2, or "longer than the limit".
[[nodiscard]] Computed median_completion(std::span<const Completion> completions);

/// Restricted mean time [s], version 2: integral of S from 0 to limit_s, the mean time spent when
/// nobody may try longer. No value if someone stopped before the limit and none tried longer: S is
/// not known up to the limit. @pre limit_s > 0
[[nodiscard]] Computed restricted_mean_time(std::span<const Completion> completions,
                                            double limit_s);

/// Rank of each, 1 is fastest, equal times (within kTimeSlack_s) share their mean rank; all that
/// were not reached are tied worst, however long they tried.
[[nodiscard]] std::vector<double> ranks(std::span<const Completion> completions);

}  // namespace isograsp::statistics
