// SPDX-License-Identifier: GPL-3.0-or-later
// How much later the answer to a target is.
#pragma once

#include <optional>
#include <span>

#include "statistics/samples.hpp"

namespace isograsp::tasks {

/// Lag by cross-correlation [s], version 1; positive when `actual` follows `target`. Pearson r over
/// the overlapping samples, re-centred at each whole shift within +-1.5 s; parabola through the
/// peak. No value if r < 0.35 everywhere, or if the peak lies at the limit.
/// @pre both on the same uniform grid
[[nodiscard]] statistics::Computed lag(const statistics::UniformSamples& target,
                                       const statistics::UniformSamples& actual);

/// The same with the r of the whole shift at which the peak stands; no value where lag has none.
struct LagPeak {
  statistics::Computed lag_s;
  statistics::Computed correlation;
};
[[nodiscard]] LagPeak lag_peak(const statistics::UniformSamples& target,
                               const statistics::UniformSamples& actual);

}  // namespace isograsp::tasks
