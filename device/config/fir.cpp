// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/config/fir.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace isograsp {

namespace {

/// `ideal_Hz`: cut-off of the ideal low-pass before the window; the window shifts the -3 dB point.
std::vector<double> windowed_sinc(int taps, double rate_Hz, double ideal_Hz) {
  const double middle = (taps - 1) / 2.0;
  const double omega = 2.0 * std::numbers::pi * ideal_Hz / rate_Hz;
  std::vector<double> h(static_cast<std::size_t>(taps));
  double sum = 0.0;
  for (int n = 0; n < taps; ++n) {
    const double x = n - middle;
    const double sinc = x == 0.0 ? omega : std::sin(omega * x) / x;
    const double window = 0.54 - 0.46 * std::cos(2.0 * std::numbers::pi * n / (taps - 1));
    sum += h[static_cast<std::size_t>(n)] = sinc * window;
  }
  for (double& tap : h) tap /= sum;
  return h;
}

}  // namespace

double fir_gain(const std::vector<double>& taps, double rate_Hz, double frequency_Hz) noexcept {
  const double middle = static_cast<double>(taps.size() - 1) / 2.0;
  double sum = 0.0;
  for (std::size_t n = 0; n < taps.size(); ++n)
    sum += taps[n] * std::cos(2.0 * std::numbers::pi * frequency_Hz / rate_Hz *
                              (static_cast<double>(n) - middle));
  return std::abs(sum);
}

Result<std::vector<double>> design_fir(int taps, double rate_Hz, double cutoff_Hz) {
  if (taps < 3 || taps % 2 == 0 || taps > static_cast<int>(kMostFirTaps))
    return refused("%1 is no possible length of the filter"_text(taps),
                   "give an odd number from 3 to %1"_text(kMostFirTaps))
        .about("fir_taps");
  if (!(cutoff_Hz > 0.0 && cutoff_Hz < rate_Hz / 2.0))
    return refused("the cut-off is not below half the rate"_text, "give a lower fir_cutoff_Hz"_text)
        .about("fir_taps");
  const double half_power = std::sqrt(0.5);
  double low_Hz = 0.0;
  double high_Hz = rate_Hz / 2.0;
  const double least_Hz = rate_Hz * 1e-6;  // nearly the window alone: the lowest cut-off possible
  if (fir_gain(windowed_sinc(taps, rate_Hz, least_Hz), rate_Hz, cutoff_Hz) > half_power ||
      fir_gain(windowed_sinc(taps, rate_Hz, high_Hz), rate_Hz, cutoff_Hz) < half_power)
    return refused("%1 taps cannot make this cut-off at this rate"_text(taps),
                   "give more taps, a higher fir_cutoff_Hz or a lower rate_Hz"_text)
        .about("fir_taps");
  constexpr int kHalvings = 60;  // to the last bit
  for (int i = 0; i < kHalvings; ++i) {
    const double middle_Hz = (low_Hz + high_Hz) / 2.0;
    const bool too_low = middle_Hz <= least_Hz || fir_gain(windowed_sinc(taps, rate_Hz, middle_Hz),
                                                           rate_Hz, cutoff_Hz) < half_power;
    (too_low ? low_Hz : high_Hz) = middle_Hz;
  }
  return windowed_sinc(taps, rate_Hz, high_Hz);
}

FirFilter::FirFilter(const std::vector<double>& taps) : length_(taps.size()) {
  std::copy(taps.begin(), taps.end(), taps_.begin());
  line_.fill(Vec6::Zero());
}

bool FirFilter::push(Vec6& value) noexcept {
  if (length_ == 0) return true;
  line_[next_] = value;
  next_ = next_ + 1 == length_ ? 0 : next_ + 1;
  count_ = std::min(count_ + 1, length_);
  if (count_ < length_) return false;
  // The coefficients are symmetric, so the direction through the window does not matter.
  value.setZero();
  for (std::size_t n = 0; n < length_; ++n) {
    const std::size_t i = next_ + n < length_ ? next_ + n : next_ + n - length_;
    value += taps_[n] * line_[i];
  }
  return true;
}

}  // namespace isograsp
