// SPDX-License-Identifier: GPL-3.0-or-later
// Timing of the frames: histograms that are cheap to fill for every frame, and a summary of them.
#pragma once

#include <string>

#include "core/histogram.hpp"

namespace isograsp::session {

struct Timing {
  Histogram period;    ///< from one published frame to the next
  Histogram lateness;  ///< grid instant -> published
  Histogram compute;   ///< newest sample in hand -> published
  Histogram latency;   ///< arrival of the sample that completed the frame (its stamp) -> published
};

/// Each value is the upper edge of its bin, at most 12.5 % above the duration itself [s].
struct Quantiles {
  double median_s = 0.0;
  double most_of_100_s = 0.0;   ///< 99 %
  double most_of_1000_s = 0.0;  ///< 99.9 %
  double largest_s = 0.0;       ///< exact
};
/// Real-time safe.
[[nodiscard]] Quantiles quantiles_of(const Histogram& histogram) noexcept;

struct TimingSummary {
  Quantiles period;
  Quantiles lateness;
  Quantiles compute;
  Quantiles latency;
};
/// Real-time safe.
[[nodiscard]] TimingSummary summary_of(const Timing& timing) noexcept;

/// {"period": {"count", "median_s", "p99_s", "p999_s", "max_s", "bins": [[lower edge in ns, count],
/// …]}, "lateness": …, "compute": …, "latency": …}; bins without a count are left out.
[[nodiscard]] std::string as_json(const Timing& timing);

}  // namespace isograsp::session
