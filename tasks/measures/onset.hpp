// SPDX-License-Identifier: GPL-3.0-or-later
// When a force begins to change.
#pragma once

#include <optional>
#include <span>

#include "statistics/samples.hpp"

namespace isograsp::tasks {

/// What a signal does while nothing is asked, unit of x.
struct RestingLevel {
  double mean = 0.0;
  double sd = 0.0;  ///< n - 1

  /// Change that is no longer rest: max(3 SD, 2 LSB), lsb = resolution of the sensor.
  [[nodiscard]] double margin(double lsb) const;
};
/// No level of fewer than two samples.
[[nodiscard]] std::optional<RestingLevel> resting_level(std::span<const double> x);
/// Level in the last second before `cue_s`.
[[nodiscard]] std::optional<RestingLevel> level_before(std::span<const double> t_s,
                                                       std::span<const double> x, double cue_s);

enum class Change { rise, fall };

/// First sample from which x stays above (below) `threshold` for at least 50 ms, version 1.
[[nodiscard]] std::optional<std::size_t> onset(std::span<const double> t_s,
                                               std::span<const double> x, double threshold,
                                               Change change);

/// Reaction time, version 1 [s]: from the cue to the onset of the change that lasts beyond it, past
/// mean +- margin(lsb). Less than 100 ms after the cue is anticipation: no reaction, counted apart.
struct Reaction {
  statistics::EventTime time;
  std::optional<double> anticipated_s;  ///< onset - cue, below 0.1 s, perhaps negative
};
/// `t_s` and `x` may begin before the cue. @pre t_s.size() == x.size()
[[nodiscard]] Reaction reaction(std::span<const double> t_s, std::span<const double> x,
                                double cue_s, const RestingLevel& before, double lsb,
                                Change change);

}  // namespace isograsp::tasks
