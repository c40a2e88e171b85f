// SPDX-License-Identifier: GPL-3.0-or-later
// How long things take in whole frames, and how waits that cannot be foreseen are chosen.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/random.hpp"

namespace isograsp::tasks {

/// How long something takes as a rule and at most [s].
struct Duration {
  double nominal_s = 0.0;
  double worst_s = 0.0;
};

/// Whole frames that last `duration_s`; the epsilon keeps 0.3 s / 0.1 s at 3 frames, not 4.
[[nodiscard]] inline std::int64_t frames_in(double duration_s, double period_s) noexcept {
  constexpr double kRoundingSlack = 1e-9;
  return static_cast<std::int64_t>(std::ceil(duration_s / period_s - kRoundingSlack));
}

/// How waits that cannot be foreseen are chosen, and how long a frame is.
class Pace {
 public:
  enum class Waits : std::uint8_t { seeded, mean, longest };
  Pace(double period_s, std::uint64_t seed, Waits waits = Waits::seeded)
      : period_s_(period_s), seed_(seed), waits_(waits), random_(seed, kWaitStream) {}

  [[nodiscard]] double period_s() const noexcept { return period_s_; }
  [[nodiscard]] std::uint64_t seed() const noexcept { return seed_; }
  [[nodiscard]] std::int64_t frames(double duration_s) const noexcept {
    return frames_in(duration_s, period_s_);
  }
  /// The next wait [s].
  [[nodiscard]] double wait(double least_s, double most_s) noexcept;

 private:
  static constexpr std::uint64_t kWaitStream = 201;
  double period_s_;
  std::uint64_t seed_;
  Waits waits_;
  Random random_;
};

}  // namespace isograsp::tasks
