// SPDX-License-Identifier: GPL-3.0-or-later
// Discrete Fourier transforms, X_k = sum_n x_n exp(-2 pi i k n / N).
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace isograsp {

/// In place. @pre the size is a power of two
void fourier_transform(std::span<std::complex<double>> x);

/// Transforms of real signals of one length; keeps the roots of unity for the next signal.
class RealFourier {
 public:
  /// @pre length is a power of two, at least 2
  explicit RealFourier(std::size_t length);

  /// Lines 0 … length / 2 of x, padded with zeros to `length`; the others mirror them.
  /// @pre x.size() <= length
  [[nodiscard]] std::vector<std::complex<double>> operator()(std::span<const double> x) const;

 private:
  std::size_t length_;
  std::vector<std::complex<double>> root_;  ///< exp(-2 pi i k / length), k < length / 2
};

/// |X_k| for k = 0 … last_line of x padded with zeros to `length`, to within 1e-11 of the largest
/// line. Costs little if the lines are few: above them the signal is filtered away and thinned out.
/// @pre length is a power of two, x.size() <= length, last_line <= length / 2
[[nodiscard]] std::vector<double> low_magnitudes(std::span<const double> x, std::size_t length,
                                                 std::size_t last_line);

}  // namespace isograsp
