// SPDX-License-Identifier: GPL-3.0-or-later
// Welch: windows w of 4 s that overlap by half, of the signal x about its line, step dt:
//   density = 2 dt / (number of windows * sum w^2) * sum over windows of |Fourier(w x)|^2
//   power in a band = sum of density * width of the line inside the band
#include "tasks/measures/spectrum.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/fourier.hpp"

namespace isograsp::tasks {

namespace {

/// What is left of x after its least-squares line over the sample number.
std::vector<double> detrended(const std::vector<double>& x) {
  const double n = static_cast<double>(x.size());
  const double middle = 0.5 * (n - 1.0);
  double mean = 0.0;
  double product = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    mean += x[k] / n;
    product += (static_cast<double>(k) - middle) * x[k];
  }
  const double slope = product / (n * (n * n - 1.0) / 12.0);
  std::vector<double> rest(x.size());
  for (std::size_t k = 0; k < x.size(); ++k)
    rest[k] = x[k] - mean - slope * (static_cast<double>(k) - middle);
  return rest;
}

/// Sum over the lines of density times the width that each has in the band.
double power_between(const PowerSpectrum& spectrum, Band band) {
  double power = 0.0;
  for (std::size_t k = 0; k < spectrum.density.size(); ++k) {
    const double centre = static_cast<double>(k) * spectrum.line_Hz;
    const double from = std::max(band.low_Hz, centre - 0.5 * spectrum.line_Hz);
    const double to = std::min(band.high_Hz, centre + 0.5 * spectrum.line_Hz);
    power += spectrum.density[k] * std::max(0.0, to - from);
  }
  return power;
}

Text unknown(const PowerSpectrum& spectrum, Band band) {
  if (spectrum.density.empty()) return spectrum.reason;
  const double top_Hz = static_cast<double>(spectrum.density.size() - 1) * spectrum.line_Hz;
  constexpr double kRoundingSlack = 1e-9;
  if (band.high_Hz > top_Hz * (1.0 + kRoundingSlack))
    return "the sampling rate is too low for the band"_text;
  return {};
}

}  // namespace

PowerSpectrum welch(const statistics::UniformSamples& samples) {
  constexpr double kWindow_s = 4.0;
  constexpr double kLeastWindow = 8.0;  ///< samples: a Hann window needs as many
  PowerSpectrum spectrum;
  const double in_window = std::round(kWindow_s / samples.step_s);
  if (in_window < kLeastWindow) {
    spectrum.reason = "the sampling rate is too low for a spectrum"_text;
    return spectrum;
  }
  const auto n = static_cast<std::size_t>(in_window);
  if (samples.values.size() < n) {
    spectrum.reason = "shorter than one window of 4 s"_text;
    return spectrum;
  }
  std::vector<double> window(n);
  double squares = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    const double turn = static_cast<double>(k) / static_cast<double>(n);
    window[k] = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * turn);
    squares += window[k] * window[k];
  }
  const std::size_t length = 2 * std::bit_ceil(n);
  const RealFourier fourier(length);
  spectrum.line_Hz = 1.0 / (samples.step_s * static_cast<double>(length));
  spectrum.density.assign(length / 2 + 1, 0.0);
  const std::vector<double> rest = detrended(samples.values);
  std::vector<double> part(n);
  std::size_t windows = 0;
  for (std::size_t first = 0; first + n <= rest.size(); first += n / 2) {
    for (std::size_t k = 0; k < n; ++k) part[k] = window[k] * rest[first + k];
    const auto lines = fourier(part);
    for (std::size_t k = 0; k < lines.size(); ++k) spectrum.density[k] += std::norm(lines[k]);
    ++windows;
  }
  const double scale = samples.step_s / (squares * static_cast<double>(windows));
  for (double& density : spectrum.density) density *= 2.0 * scale;
  // Line 0 and the highest stand for half the width of the others, both signs included.
  return spectrum;
}

statistics::Computed band_power(const PowerSpectrum& spectrum, Band band) {
  if (Text why = unknown(spectrum, band); !why.empty()) return why;
  return power_between(spectrum, band);
}

statistics::Computed band_share(const PowerSpectrum& spectrum, Band band) {
  if (Text why = unknown(spectrum, band); !why.empty()) return why;
  const double top_Hz = static_cast<double>(spectrum.density.size() - 1) * spectrum.line_Hz;
  const double whole = power_between(spectrum, {0.0, top_Hz});
  if (!(whole > 0.0)) return "the signal does not vary"_text;
  return 100.0 * power_between(spectrum, band) / whole;
}

statistics::Computed peak_frequency(const PowerSpectrum& spectrum, Band band) {
  if (Text why = unknown(spectrum, band); !why.empty()) return why;
  const auto& density = spectrum.density;
  constexpr double kRoundingSlack = 1e-9;  // a line on an edge: the lower belongs, the upper not
  std::optional<std::size_t> peak;
  for (std::size_t k = 1; k + 1 < density.size(); ++k) {
    const double f_Hz = static_cast<double>(k) * spectrum.line_Hz;
    if (f_Hz < band.low_Hz * (1.0 - kRoundingSlack) ||
        f_Hz >= band.high_Hz * (1.0 - kRoundingSlack))
      continue;
    if (!peak || density[k] > density[*peak]) peak = k;
  }
  if (!peak) return "the band has no line of the spectrum"_text;
  const double here = density[*peak];
  if (!(density[*peak - 1] > 0.0 && here > density[*peak - 1] && here >= density[*peak + 1] &&
        density[*peak + 1] > 0.0))
    return "the spectrum has no peak in the band"_text;
  const double before = std::log(density[*peak - 1] / here);
  const double after = std::log(density[*peak + 1] / here);
  const double part = 0.5 * (before - after) / (before + after);
  return (static_cast<double>(*peak) + part) * spectrum.line_Hz;
}

}  // namespace isograsp::tasks
