// SPDX-License-Identifier: GPL-3.0-or-later
// Resting force: what each finger presses while the hand lies relaxed in the device. Kept as a
// result of its own; nothing is ever subtracted. Contact frames, SI units. Pure functions.
#pragma once

#include <array>
#include <optional>

#include "core/result.hpp"
#include "core/signals.hpp"
#include "hand/finger.hpp"

namespace isograsp::session {

/// A hand settles for at least this long after it was strapped [s].
inline constexpr double kSettleAfterStrapping_s = 60.0;

struct RestingForce {
  std::array<Vec6, kFingerCount> mean;  ///< [N, N m]
  std::array<Vec6, kFingerCount> sd;    ///< n - 1; of a hand that moves it is large
  std::int64_t samples = 0;
};

/// Mean and SD over the rows of a rest trial that count (active, nothing held, missing or
/// saturated). Nothing if there are fewer than two.
[[nodiscard]] std::optional<RestingForce> resting_force(const Signals& trial);

/// What the values suggest, in one or two plain sentences. Tone is data: nothing is refused.
[[nodiscard]] Text words_of(const RestingForce& rest);

}  // namespace isograsp::session
