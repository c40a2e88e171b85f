// SPDX-License-Identifier: GPL-3.0-or-later
// Second-order Butterworth low-pass, for simulated sensors and for measures.
#pragma once

#include <span>
#include <vector>

namespace isograsp {

/// y = b0 x + b1 x1 + b2 x2 - a1 y1 - a2 y2
struct LowPass2 {
  double b0 = 1.0, b1 = 0.0, b2 = 0.0, a1 = 0.0, a2 = 0.0;
};
/// Second-order Butterworth, bilinear transform with prewarping. @pre 0 < cutoff < rate / 2
[[nodiscard]] LowPass2 butterworth2(double rate_Hz, double cutoff_Hz) noexcept;

/// Filtered from the first sample on, as if that had been the value for ever before. Delayed.
[[nodiscard]] std::vector<double> filtered(const LowPass2& filter, std::span<const double> x);

/// Filtered forward, then backward: no delay, the gain squared (-6 dB at the cut-off, fourth
/// order). Both ends are continued by their point reflection, 2 x_0 - x_k, until the filter has
/// forgotten its start, so a straight line stays the same line.
[[nodiscard]] std::vector<double> filtered_zero_phase(const LowPass2& filter,
                                                      std::span<const double> x);

}  // namespace isograsp
