// SPDX-License-Identifier: GPL-3.0-or-later
// How durations are spread, from 1 ns to 68 s, in bins that grow with the duration: eight bins an
// octave, so that an edge is at most 12.5 % above the one below it. Add and read on one thread.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace isograsp {

class Histogram {
 public:
  static constexpr std::size_t kBins = 272;

  /// Wait-free: no allocation, no lock, no logarithm. What is negative or not a number counts as 0.
  void add(double duration_s) noexcept {
    const std::uint64_t duration_ns = nanoseconds(duration_s);
    ++counts_[bin_of(duration_ns)];
    ++count_;
    largest_ns_ = std::max(largest_ns_, duration_ns);
  }
  void clear() noexcept { *this = Histogram(); }

  [[nodiscard]] std::uint64_t count() const noexcept { return count_; }
  [[nodiscard]] std::uint64_t count(std::size_t bin) const noexcept { return counts_[bin]; }
  /// Exact to the nanosecond; 0: nothing was added.
  [[nodiscard]] double largest_s() const noexcept { return seconds(largest_ns_); }
  /// Upper edge of the bin that holds the ceil(share * count)-th smallest duration, or the largest
  /// duration if that is less. @pre 0 <= share <= 1
  [[nodiscard]] double quantile_s(double share) const noexcept {
    const double wanted = std::max(1.0, std::ceil(share * static_cast<double>(count_)));
    std::uint64_t seen = 0;
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      seen += counts_[bin];
      if (static_cast<double>(seen) >= wanted)
        return std::min(largest_s(), seconds(lower_edge_ns(bin + 1)));
    }
    return largest_s();
  }

  /// Bin k holds lower_edge(k) <= duration < lower_edge(k + 1).
  [[nodiscard]] static constexpr std::uint64_t lower_edge_ns(std::size_t bin) noexcept {
    if (bin < 2 * kPerOctave) return bin;
    return (kPerOctave + bin % kPerOctave) << (bin / kPerOctave - 1);
  }
  [[nodiscard]] static constexpr std::size_t bin_of(std::uint64_t duration_ns) noexcept {
    if (duration_ns < 2 * kPerOctave) return static_cast<std::size_t>(duration_ns);
    const auto shift = static_cast<std::size_t>(std::bit_width(duration_ns)) - kOctaveBits - 1;
    return std::min(kBins - 1, kPerOctave * (shift + 1) +
                                   static_cast<std::size_t>(duration_ns >> shift) - kPerOctave);
  }

 private:
  static constexpr std::size_t kOctaveBits = 3;
  static constexpr std::size_t kPerOctave = std::size_t{1} << kOctaveBits;

  [[nodiscard]] static std::uint64_t nanoseconds(double duration_s) noexcept {
    constexpr double kLongest_ns = 1e18;
    const double duration_ns = duration_s * 1e9;
    if (!(duration_ns > 0.0)) return 0;
    return static_cast<std::uint64_t>(std::llround(std::min(duration_ns, kLongest_ns)));
  }
  [[nodiscard]] static double seconds(std::uint64_t duration_ns) noexcept {
    return static_cast<double>(duration_ns) / 1e9;  // one rounding: 1920 ns is 1.92e-06 s
  }

  std::array<std::uint32_t, kBins> counts_{};
  std::uint64_t count_ = 0;
  std::uint64_t largest_ns_ = 0;
};

}  // namespace isograsp
