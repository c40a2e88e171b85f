// SPDX-License-Identifier: GPL-3.0-or-later
// Whether force goes where it should: direction of a digit's force, path of all digits, net push.
#pragma once

#include "core/spatial.hpp"
#include "statistics/samples.hpp"

namespace isograsp::tasks {

/// Angle between two vectors [rad, 0 … pi], of full precision also for tiny angles.
/// @pre neither is zero
[[nodiscard]] double angle_of(const Vec3& a, const Vec3& b);

/// Direction error, version 1 [rad]: weighted mean of the angle between force and the direction
/// asked for, over samples with |force| > least_N. Below the noise a force has no direction.
/// @pre direction is not zero, all in one frame
[[nodiscard]] statistics::Computed direction_error(std::span<const Vec3> force_N,
                                                   const Vec3& direction,
                                                   std::span<const double> weight,
                                                   double least_N = 0.0);
/// Projection ratio, version 1, dimensionless: sum(w force . direction) / sum(w |force|), direction
/// of length one; the share of effort that is useful, 1 at best, negative: the wrong way.
[[nodiscard]] statistics::Computed projection_ratio(std::span<const Vec3> force_N,
                                                    const Vec3& direction,
                                                    std::span<const double> weight);

/// Path deviation, version 1 [N]: weighted mean distance of the force path from the straight line
/// through its first and last point, in the space of all digits. Forces at the start need not be 0.
/// @param digits_N  one signal per digit, all of one length
[[nodiscard]] statistics::Computed path_deviation(std::span<const std::vector<double>> digits_N,
                                                  std::span<const double> weight);

/// Net push of arm or trunk on the platform, relative to the grip, version 1.
struct PushSummary {
  statistics::Computed median = "not computed"_text;    ///< [% of grip]
  statistics::Computed above_20 = "not computed"_text;  ///< share of time above 20 % of grip [%]
};
/// Over the samples with grip > least_grip_N. @param push_N  size of the net force [N]
[[nodiscard]] PushSummary summary_of_push(std::span<const double> push_N,
                                          std::span<const double> grip_N,
                                          std::span<const double> weight,
                                          double least_grip_N = 0.0);

}  // namespace isograsp::tasks
