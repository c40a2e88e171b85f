// SPDX-License-Identifier: GPL-3.0-or-later
// Lags, reaction and release times without the delay of sensor and display.
#pragma once

#include <optional>

#include "statistics/samples.hpp"

namespace isograsp::tasks {

/// A time as measured and as it would be without delay, version 1 [s].
struct DelayCorrected {
  statistics::Computed raw_s;
  statistics::Computed corrected_s;  ///< raw - delay; no value while the delay is not known
};
[[nodiscard]] DelayCorrected without_delay(statistics::Computed raw_s,
                                           std::optional<double> delay_s);

}  // namespace isograsp::tasks
