// SPDX-License-Identifier: GPL-3.0-or-later
// How well the digits act apart: enslaving, individuation, unwanted co-flexion, sharing.
// Forces are signed normal forces fz [N], pressing positive.
#pragma once

#include <array>

#include "hand/finger.hpp"
#include "statistics/samples.hpp"

namespace isograsp::tasks {

/// One value per digit, in the order of kFingers.
using PerDigit = std::array<double, kFingerCount>;

/// Force of each digit over one stretch of time; all of one length.
struct DigitForces {
  std::array<std::span<const double>, kFingerCount> force_N;
  std::span<const double> weight;  ///< hold lengths [s]
};

/// One short hold in which one digit was asked to press and the others to stay still.
struct DigitHold {
  Finger instructed{};
  PerDigit start_N{};  ///< at the start of the trial: drift and tone are not enslaving
  PerDigit mean_N{};   ///< over the hold
};

/// Enslaving EN_ij, version 1, dimensionless, signed: mean over the holds in which j was instructed
/// of (F_i - F_i0) / (F_j - F_j0), F mean over the hold, F0 at the start of the trial. EN_jj = 1.
/// Holds in which j rose by less than `least_rise_N` do not count. (after Zatsiorsky et al. 1998)
[[nodiscard]] statistics::Computed enslaving(std::span<const DigitHold> holds, Finger i, Finger j,
                                             double least_rise_N = 0.0);
/// The same relative to the maximum of digit i, version 1: mean of (F_i - F_i0) / MVC_i.
[[nodiscard]] statistics::Computed enslaving_of_maximum(std::span<const DigitHold> holds, Finger i,
                                                        Finger j, double maximum_i_N);

/// Root mean square, over time and the digits that were not instructed, of F_i - F_i0 [N],
/// version 1.
[[nodiscard]] statistics::Computed uninstructed_deviation(const DigitForces& forces,
                                                          Finger instructed,
                                                          const PerDigit& start_N);

/// One hold: how much force was asked for and how far the other digits were off.
struct Individuation {
  double instructed_N = 0.0;  ///< mean rise of the instructed digit
  double deviation_N = 0.0;   ///< uninstructed_deviation()
};
/// Slope through 0 of deviation on instructed force by least absolute deviations, version 1,
/// dimensionless: the median of deviation / force, weighted with force. Half of the weight may be
/// outliers. Needs three holds with force.
[[nodiscard]] statistics::Computed individuation_slope(std::span<const Individuation> holds);
/// Three-digit individuation index, version 1, dimensionless: -ln of that slope; higher is better.
/// (Xu et al. 2017, with five digits and another robust line: not comparable in value)
[[nodiscard]] statistics::Computed individuation_index(std::span<const Individuation> holds);

/// Unwanted co-flexion, version 3, in %: largest press of any digit while opening, relative to the
/// largest opening force (sum of -fz of the digits that pull), each the best mean over any window
/// of `window_s` of uninterrupted samples. 0: no digit pressed.
/// @param forces above rest, while opening was asked for
/// @param valid  valid[k]: sample k may be used
[[nodiscard]] statistics::Computed coflexion(const DigitForces& forces,
                                             const std::vector<bool>& valid, double window_s);

/// Share of one digit in the sum of the three mean forces, version 1, in %.
[[nodiscard]] statistics::Computed sharing(const PerDigit& mean_N, Finger finger);
/// Thumb against fingers, version 1, dimensionless: F_thumb / (F_index + F_middle); 1 balances.
[[nodiscard]] statistics::Computed thumb_opposition(const PerDigit& mean_N);

}  // namespace isograsp::tasks
