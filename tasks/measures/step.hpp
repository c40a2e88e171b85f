// SPDX-License-Identifier: GPL-3.0-or-later
// How fast, how far beyond and how soon settled the answer to a step is.
#pragma once

#include <optional>
#include <span>

#include "statistics/samples.hpp"
#include "tasks/measures/onset.hpp"

namespace isograsp::tasks {

/// Answer to a step from 0 to a nominal final value, version 1. Levels are first upward crossings,
/// interpolated linearly.
struct StepResponse {
  std::optional<double> t10_s;  ///< 10 % of the final value
  std::optional<double> t63_s;  ///< 1 - 1/e
  std::optional<double> t90_s;
  std::optional<double> rise10_90_s;   ///< t90 - t10
  double overshoot = 0.0;              ///< (largest - final) / final, at least 0
  std::optional<double> settle2pct_s;  ///< first time after which |y - final| <= 2 % of it
};
/// @pre t_s.size() == y.size(), not empty, final_value != 0
[[nodiscard]] StepResponse step_response(std::span<const double> t_s, std::span<const double> y,
                                         double final_value);

/// A target that jumps at `cue_s`, up or down.
struct CuedStep {
  double cue_s = 0.0;
  double from = 0.0;
  double to = 0.0;
};
/// Answer to a cued step, version 1. All times count from the cue; z = (x - from) / (to - from).
struct CuedStepResponse {
  Reaction reaction;          ///< away from the level held in the second before the cue
  statistics::EventTime t10;  ///< z reaches 0.1, interpolated linearly
  statistics::EventTime t63;  ///< 1 - 1/e
  statistics::EventTime t90;
  statistics::Computed rise10_90_s;        ///< t90 - t10
  statistics::Computed overshoot_percent;  ///< 100 (largest z - 1), at least 0
  statistics::Computed peak_s;             ///< time of the largest z; only if that is an overshoot
  statistics::EventTime settling;          ///< start of the first 0.2 s with |z - 1| <= 0.05
};
/// `lsb`: resolution of x. @pre t_s.size() == x.size(), step.from != step.to
[[nodiscard]] CuedStepResponse cued_step_response(std::span<const double> t_s,
                                                  std::span<const double> x, const CuedStep& step,
                                                  double lsb);

}  // namespace isograsp::tasks
