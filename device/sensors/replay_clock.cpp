// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/sensors/replay_clock.hpp"

#include <cmath>

namespace isograsp {

Result<double> replay_speed(const Uri& uri) {
  constexpr double kSlowest = 0.01;
  constexpr double kFastest = 1000.0;
  if (uri.target.empty())
    return refused("no file is named"_text, "write replay://FILE.csv"_text)
        .at(uri.text)
        .about("file");
  auto speed = uri.number_or("speed", 1.0, 0.0, kFastest);
  if (!speed) return speed;
  if (*speed > 0.0 && *speed < kSlowest)
    return refused("is too slow"_text, "give 0 (never wait) or 0.01 to 1000"_text)
        .at(uri.text)
        .about("speed");
  return speed;
}

Timestamp ReplayClock::scaled(Timestamp span, double factor) noexcept {
  if (factor == 1.0) return span;
  return Timestamp{std::llround(static_cast<double>(span.count()) * factor)};
}

}  // namespace isograsp
