// SPDX-License-Identifier: GPL-3.0-or-later
// How fast, how far beyond and how soon settled the answer to a step is.
#pragma once

#include <optional>
#include <span>

#include "tasks/measures/samples.hpp"

namespace isograsp {

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

}  // namespace isograsp
