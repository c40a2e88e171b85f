// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/emulator/finger_play.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp {

const FingerWrenches& FingerPlay::at(double play_time_s) const noexcept {
  constexpr double kSameInstant_s = 1e-9;
  if (repeat) play_time_s = std::fmod(play_time_s, duration_s);
  // n / rate and the row's own time may differ by a rounding: they mean the same instant.
  const auto after = std::upper_bound(t_s.begin(), t_s.end(), play_time_s + kSameInstant_s);
  const auto row = after == t_s.begin() ? 0 : after - t_s.begin() - 1;
  return wrench_C[static_cast<std::size_t>(row)];
}

}  // namespace isograsp
