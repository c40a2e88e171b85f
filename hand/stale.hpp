// SPDX-License-Identifier: GPL-3.0-or-later
// The rule for missing samples, the same live and offline: the last valid force stands in for at
// most 50 ms; after that the object and the task clock freeze until the next valid sample.
#pragma once

#include <array>

#include "hand/finger.hpp"

namespace isograsp {

inline constexpr double kLongestHold_s = 0.050;

class StaleRule {
 public:
  enum class Verdict { fresh, held, frozen };

  /// Replaces the wrench of each finger without a sample by the last valid one, if the bridged time
  /// including this slot stays within kLongestHold_s. Frozen: some finger cannot be bridged (also
  /// before its first valid sample). Real-time safe. `used[f]`: finger f matters here.
  [[nodiscard]] Verdict apply(FingerWrenches& wrench_C,
                              const std::array<bool, kFingerCount>& present,
                              const std::array<bool, kFingerCount>& used, double hold_s) noexcept {
    // Sums of equal holds (five of 10 ms) must not exceed the limit by rounding.
    constexpr double kRounding = 1e-9;
    Verdict verdict = Verdict::fresh;
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      if (present[f]) {
        last_[f] = wrench_C[f];
        bridged_s_[f] = 0.0;
        known_[f] = true;
        held_[f] = false;
        continue;
      }
      held_[f] = false;
      if (!used[f]) continue;
      bridged_s_[f] += hold_s;
      if (known_[f] && bridged_s_[f] <= kLongestHold_s * (1.0 + kRounding)) {
        wrench_C[f] = last_[f];
        held_[f] = true;
        if (verdict == Verdict::fresh) verdict = Verdict::held;
      } else {
        verdict = Verdict::frozen;
      }
    }
    return verdict;
  }

  /// Whether finger f's wrench of the last call was a held one.
  [[nodiscard]] bool held(std::size_t f) const noexcept { return held_[f]; }

 private:
  FingerWrenches last_{};
  std::array<double, kFingerCount> bridged_s_{};
  std::array<bool, kFingerCount> known_{};
  std::array<bool, kFingerCount> held_{};
};

}  // namespace isograsp
