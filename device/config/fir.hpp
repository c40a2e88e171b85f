// SPDX-License-Identifier: GPL-3.0-or-later
// The low-pass for sensors that are read faster than the frame grid: linear phase, so that its
// delay is one number for every frequency. Pure.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/result.hpp"
#include "core/spatial.hpp"

namespace isograsp {

inline constexpr std::size_t kMostFirTaps = 129;

/// Windowed sinc (Hamming) with `taps` coefficients that sum to 1 and -3.01 dB at `cutoff_Hz`.
/// 33 taps at 500 Hz and 65 at 1 kHz make the 32 ms of the paper's sensor at 31.25 Hz
/// (docs/devices.md). Fails if `taps` is even, too many, or too few for so low a cut-off.
[[nodiscard]] Result<std::vector<double>> design_fir(int taps, double rate_Hz, double cutoff_Hz);

/// Magnitude of the filter at a frequency.
[[nodiscard]] double fir_gain(const std::vector<double>& taps, double rate_Hz,
                              double frequency_Hz) noexcept;

/// Delay of every frequency: half the length [s].
[[nodiscard]] inline double fir_delay_s(std::size_t taps, double rate_Hz) noexcept {
  return taps == 0 ? 0.0 : static_cast<double>(taps - 1) / 2.0 / rate_Hz;
}

/// Six axes of one sensor through the filter. Real-time safe after construction.
class FirFilter {
 public:
  FirFilter() = default;  ///< no taps: the input comes out
  explicit FirFilter(const std::vector<double>& taps);

  /// Takes the next sample; true: `value` is the filtered one. False until the whole window holds
  /// samples.
  [[nodiscard]] bool push(Vec6& value) noexcept;
  /// Forgets everything: there was a gap.
  void restart() noexcept { count_ = 0; }

 private:
  std::array<double, kMostFirTaps> taps_{};
  std::array<Vec6, kMostFirTaps> line_;  ///< ring
  std::size_t length_ = 0;
  std::size_t next_ = 0;
  std::size_t count_ = 0;
};

}  // namespace isograsp
