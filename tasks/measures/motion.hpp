// SPDX-License-Identifier: GPL-3.0-or-later
// Where the object is and how it lies: distance, attitude and path. Positions [m] and attitudes of
// the object in the world; all spans of one call have the same length.
#pragma once

#include "core/spatial.hpp"
#include "statistics/samples.hpp"

namespace isograsp::tasks {

/// Hold error, version 1 [m]: weighted mean distance of the object from its target.
[[nodiscard]] statistics::Computed mean_distance(std::span<const Vec3> actual_m,
                                                 std::span<const Vec3> target_m,
                                                 std::span<const double> weight);
/// Hold error of attitude, version 1 [rad, 0 … pi]: weighted mean geodesic angle.
[[nodiscard]] statistics::Computed mean_angle(std::span<const Quat> actual,
                                              std::span<const Quat> target,
                                              std::span<const double> weight);

/// Angle between the main axes [rad, 0 … pi]: rotation about the axis itself does not count.
/// @param axis_O  main axis in object coordinates, not zero
[[nodiscard]] double axis_angle(const Quat& a, const Quat& b, const Vec3& axis_O);
/// The same weighted over time, version 1. A symmetric object has no front: with `either_way` an
/// axis and its opposite are one, and the angle is at most pi / 2.
[[nodiscard]] statistics::Computed mean_axis_angle(std::span<const Quat> actual,
                                                   std::span<const Quat> target, const Vec3& axis_O,
                                                   std::span<const double> weight,
                                                   bool either_way = false);

/// Tilt, version 1 [rad, 0 … pi]: root of the weighted mean of the squared geodesic angle.
[[nodiscard]] statistics::Computed rms_angle(std::span<const Quat> actual,
                                             std::span<const Quat> target,
                                             std::span<const double> weight);

/// Path length, version 1 [m]: sum of the distances between successive positions; noise adds to it.
[[nodiscard]] double path_length(std::span<const Vec3> position_m);
/// Path efficiency, version 1, in %: 100 sum of straight distances from first to last / sum of path
/// lengths, over one way or several.
[[nodiscard]] statistics::Computed path_efficiency(std::span<const std::vector<Vec3>> paths_m);

}  // namespace isograsp::tasks
