// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers that are the same bits on every machine and in every build: integer arithmetic on
// std::mt19937_64, no standard distribution (their algorithms are not specified) and no libm.
#pragma once

#include <cstdint>
#include <random>

namespace isograsp {

class Random {
 public:
  /// Streams of one seed are independent of each other.
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0)
      : engine_(mixed(mixed(seed) + stream)) {}

  /// Uniform in [0, 1), 53 bits. Real-time safe.
  [[nodiscard]] double uniform() noexcept {
    return static_cast<double>(engine_() >> 11) * 0x1.0p-53;
  }

  /// Mean 0, standard deviation 1: the sum of twelve 16-bit uniforms (Irwin-Hall), within +-6.
  /// Real-time safe.
  [[nodiscard]] double gaussian() noexcept {
    constexpr int kMean = 12 * 65535 / 2;
    int sum = -kMean;
    for (int draw = 0; draw < 3; ++draw) {
      const std::uint64_t bits = engine_();
      for (unsigned shift = 0; shift < 64; shift += 16)
        sum += static_cast<int>((bits >> shift) & 0xFFFF);
    }
    return static_cast<double>(sum) * 0x1.0p-16;
  }

 private:
  /// SplitMix64: neighbouring seeds give unrelated states.
  [[nodiscard]] static std::uint64_t mixed(std::uint64_t value) noexcept {
    value += 0x9E3779B97F4A7C15U;
    value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9U;
    value = (value ^ (value >> 27)) * 0x94D049BB133111EBU;
    return value ^ (value >> 31);
  }

  std::mt19937_64 engine_;
};

}  // namespace isograsp
