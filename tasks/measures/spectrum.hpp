// SPDX-License-Identifier: GPL-3.0-or-later
// Which frequencies the unsteadiness of a held force has. Uniform grids only; see
// on_uniform_grid().
#pragma once

#include <string>
#include <vector>

#include "statistics/samples.hpp"

namespace isograsp::tasks {

/// One-sided power spectral density, or why there is none.
struct PowerSpectrum {
  double line_Hz = 0.0;         ///< distance of the lines, the first at 0 Hz
  std::vector<double> density;  ///< [unit^2 / Hz]; empty: none
  Text reason;
};

/// Welch's estimate, version 1 (Welch 1967): least-squares line of the whole signal removed, Hann
/// windows of 4 s that overlap by half, mean of |X|^2 dt / sum(w^2), the power of both signs at the
/// positive line. Padded to twice the window or more. The window, not the padding, sets what can be
/// told apart: 0.4 Hz. A rest at the end shorter than half a window is not used.
[[nodiscard]] PowerSpectrum welch(const statistics::UniformSamples& samples);

/// Frequencies low <= f < high.
struct Band {
  double low_Hz = 0.0;
  double high_Hz = 0.0;
};
inline constexpr Band kVerySlowBand{0.1, 0.3};  ///< wander of the force (Lodha et al. 2013)
inline constexpr Band kSlowBand{0.5, 0.8};      ///< visual correction (same)
inline constexpr Band kTremorBand{2.0, 8.0};
inline constexpr Band kFastTremorBand{8.0, 12.0};

/// Power in a band [unit^2], version 1: the density summed over it; a line stands for the
/// frequencies up to half way to its neighbours and counts with its share of the band.
[[nodiscard]] statistics::Computed band_power(const PowerSpectrum& spectrum, Band band);
/// The same in % of the power of all frequencies, version 1.
[[nodiscard]] statistics::Computed band_share(const PowerSpectrum& spectrum, Band band);
/// Frequency [Hz] of the highest density in a band, version 1, by a parabola through the logarithm
/// of three lines. No value if the density only falls or rises towards the edge of the band.
[[nodiscard]] statistics::Computed peak_frequency(const PowerSpectrum& spectrum, Band band);

}  // namespace isograsp::tasks
