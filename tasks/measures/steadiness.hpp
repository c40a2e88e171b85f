// SPDX-License-Identifier: GPL-3.0-or-later
// How steadily a force is held.
#pragma once

#include <optional>
#include <span>

#include "statistics/samples.hpp"

namespace isograsp::tasks {

/// Steadiness of a plateau, version 1.
struct Steadiness {
  statistics::Computed sd;          ///< SD(n - 1) about the least-squares line, unit of x
  statistics::Computed cv_percent;  ///< cv() of error.hpp; no value while below resolution: the
                                    ///< floor exceeds a third of it
  statistics::Computed
      noise_floor_percent;  ///< 100 noise_sd / |mean|: the CV of a hand that is quite still
  statistics::Computed fall_percent;  ///< of that line from first to last sample, in % of the mean
};
/// `noise_sd`: of the empty device, unit of x; the CV is not judged while it is not known.
[[nodiscard]] Steadiness steadiness(std::span<const double> t_s, std::span<const double> x,
                                    std::optional<double> noise_sd);

}  // namespace isograsp::tasks
