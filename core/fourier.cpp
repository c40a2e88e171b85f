// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fourier.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <numbers>

namespace isograsp {

namespace {

using Complex = std::complex<double>;

/// The operators of std::complex look for infinities first, which costs most of the time.
Complex product(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// exp(-2 pi i k / n), k < n / 2, each to the last digit: repeated multiplication would lose some.
/// Only an eighth of the circle is computed, the rest mirrors it.
std::vector<Complex> roots_of_unity(std::size_t n) {
  std::vector<Complex> root(n / 2);
  const std::size_t quarter = n / 4;
  const auto set = [&](std::size_t k, double cosine, double sine) {
    if (k < root.size()) root[k] = {cosine, -sine};
  };
  for (std::size_t k = 0; 2 * k <= quarter; ++k) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    set(k, c, s);
    if (quarter == 0) break;
    set(quarter - k, s, c);
    set(quarter + k, -s, c);
    set(2 * quarter - k, -c, s);
  }
  return root;
}

/// Transform of input(0 … count - 1) and zeros into `x`, decimation in time. The roots are those of
/// a circle that x.size() divides.
template <class Input>
void transform(std::size_t count, Input&& input, std::span<const Complex> root,
               std::span<Complex> x) {
  const std::size_t n = x.size();
  const std::size_t filled = std::bit_ceil(std::max<std::size_t>(count, 1));
  // In bit-reversed order zeros surround each input: the first stages would only copy it.
  const std::size_t copies = n / filled;
  for (std::size_t i = 0, reversed = 0; i < filled; ++i) {
    const Complex value = i < count ? input(i) : Complex();
    std::fill_n(x.begin() + static_cast<std::ptrdiff_t>(reversed * copies), copies, value);
    std::size_t bit = filled >> 1;
    for (; (reversed & bit) != 0; bit >>= 1) reversed ^= bit;
    reversed |= bit;
  }
  const std::size_t circle = 2 * root.size();
  for (std::size_t length = 2 * copies; length <= n; length *= 2) {
    const std::size_t half = length / 2;
    const std::size_t stride = circle / length;
    for (std::size_t block = 0; block < n; block += length) {
      Complex* const low = x.data() + block;
      Complex* const high = low + half;
      for (std::size_t k = 0; k < half; ++k) {
        const Complex turned = product(root[k * stride], high[k]);
        high[k] = low[k] - turned;
        low[k] += turned;
      }
    }
  }
}

}  // namespace

void fourier_transform(std::span<Complex> x) {
  assert(std::has_single_bit(x.size()));
  const std::vector<Complex> input(x.begin(), x.end());
  transform(
      input.size(), [&](std::size_t i) { return input[i]; }, roots_of_unity(x.size()), x);
}

RealFourier::RealFourier(std::size_t length) : length_(length), root_(roots_of_unity(length)) {
  assert(std::has_single_bit(length) && length >= 2);
}

std::vector<Complex> RealFourier::operator()(std::span<const double> x) const {
  assert(x.size() <= length_);
  // Even samples as real, odd ones as imaginary parts: one transform of half the length.
  const std::size_t half = length_ / 2;
  std::vector<Complex> lines(half + 1);
  const auto pair = [&](std::size_t i) {
    return Complex(x[2 * i], 2 * i + 1 < x.size() ? x[2 * i + 1] : 0.0);
  };
  transform((x.size() + 1) / 2, pair, root_, std::span(lines).first(half));
  lines[half] = lines[0];
  for (std::size_t k = 0; 2 * k <= half; ++k) {
    const Complex here = lines[k];
    const Complex mirror = std::conj(lines[half - k]);
    const Complex even = 0.5 * (here + mirror);
    const Complex difference = 0.5 * (here - mirror);
    const Complex odd(difference.imag(), -difference.real());
    const Complex turned = product(root_[k == half ? 0 : k], odd);
    lines[half - k] = std::conj(even - turned);
    lines[k] = even + turned;
  }
  return lines;
}

namespace {

/// Modified Bessel function of order 0 by its series of positive terms: no digit is lost.
double bessel_i0(double x) {
  double sum = 1.0;
  double term = 1.0;
  for (int k = 1; term > 1e-17 * sum; ++k) {
    term *= 0.25 * x * x / (k * k);
    sum += term;
  }
  return sum;
}

/// Kaiser-Bessel low-pass w(t) = I0(b sqrt(1 - (t / h)^2)) e^-b, |t| <= h. Its spectrum is known,
/// h (e^s - e^-s) / s e^-b with s = sqrt(b^2 - (2 pi h f)^2), and below 1e-15 of its top where s is
/// no longer real. (Kaiser & Schafer 1980)
class LowPass {
 public:
  /// f in cycles per sample: nothing is left from `stop` on.
  explicit LowPass(double stop)
      : half_(kShape / (2.0 * std::numbers::pi * stop)),
        reach_(static_cast<std::ptrdiff_t>(half_)) {
    for (std::ptrdiff_t t = -reach_; t <= reach_; ++t) {
      const double part = static_cast<double>(t) / half_;
      tap_.push_back(bessel_i0(kShape * std::sqrt(1.0 - part * part)) * std::exp(-kShape));
    }
  }

  /// Every `step`-th sample of the filtered signal, from before its start until after its end.
  [[nodiscard]] std::vector<double> thinned(std::span<const double> x, std::size_t step) const {
    const auto size = static_cast<std::ptrdiff_t>(x.size());
    std::vector<double> thin;
    thin.reserve((x.size() + tap_.size()) / step + 2);
    for (std::ptrdiff_t centre = -reach_; centre < size + reach_;
         centre += static_cast<std::ptrdiff_t>(step)) {
      const std::ptrdiff_t first = std::max<std::ptrdiff_t>(0, centre - reach_);
      const std::ptrdiff_t end = std::min(size, centre + reach_ + 1);
      const std::ptrdiff_t shift = reach_ - centre;
      const double* const tap = tap_.data();
      const double* const sample = x.data();
      std::array<double, 4> sum{};  // four sums run side by side: faster than one
      std::ptrdiff_t n = first;
      for (; n + 4 <= end; n += 4)
        for (std::ptrdiff_t i = 0; i < 4; ++i)
          sum[static_cast<std::size_t>(i)] += sample[n + i] * tap[n + i + shift];
      for (; n < end; ++n) sum[0] += sample[n] * tap[n + shift];
      thin.push_back((sum[0] + sum[1]) + (sum[2] + sum[3]));
    }
    return thin;
  }

  /// Spectrum of the filter at f < stop; there e^-s is below the rounding.
  [[nodiscard]] double gain(double f) const {
    const double angle = 2.0 * std::numbers::pi * half_ * f;
    const double s = std::sqrt(kShape * kShape - angle * angle);
    return half_ * std::exp(s - kShape) / s;
  }

 private:
  static constexpr double kShape = 36.0;  ///< e^-36 = 2e-16: the rest is below the rounding
  double half_;
  std::ptrdiff_t reach_;
  std::vector<double> tap_;
};

}  // namespace

std::vector<double> low_magnitudes(std::span<const double> x, std::size_t length,
                                   std::size_t last_line) {
  assert(x.size() <= length && last_line <= length / 2);
  // If only this share `rate` of the samples is kept, frequencies above rate - highest fold back
  // below highest.
  constexpr double kLeastRate = 2.4;  ///< of the highest line: the filter's slope costs no digits
  const double highest = static_cast<double>(last_line) / static_cast<double>(length);
  std::size_t step = 1;
  while (1.0 / static_cast<double>(2 * step) >= kLeastRate * highest && 4 * step < length)
    step *= 2;
  std::vector<double> magnitude(last_line + 1);
  if (step > 1) {
    const LowPass filter(1.0 / static_cast<double>(step) - highest);
    const std::vector<double> thin = filter.thinned(x, step);
    if (thin.size() <= length / step) {  // else there is no padding for the ends of the filter
      const auto lines = RealFourier(length / step)(thin);
      for (std::size_t k = 0; k <= last_line; ++k)
        magnitude[k] = static_cast<double>(step) * std::sqrt(std::norm(lines[k])) /
                       filter.gain(static_cast<double>(k) / static_cast<double>(length));
      return magnitude;
    }
  }
  const auto lines = RealFourier(length)(x);
  for (std::size_t k = 0; k <= last_line; ++k) magnitude[k] = std::sqrt(std::norm(lines[k]));
  return magnitude;
}

}  // namespace isograsp
