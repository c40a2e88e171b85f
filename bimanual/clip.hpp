// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a segment that lies in a solid: box, sphere or cylinder, in closed form.
#pragma once

#include <optional>

#include "core/spatial.hpp"
#include "grasp_model/scene.hpp"

namespace isograsp::bimanual {

/// From 0 (the begin of the segment) to 1.
struct ClippedPart {
  double from = 0.0;
  double to = 1.0;
};
/// Nothing: it passes by, or touches in one point. `size_m`: as in a scene; points in the axes of
/// the solid, from its middle. Real-time safe.
[[nodiscard]] std::optional<ClippedPart> clip(Shape shape, const Vec3& size_m, const Vec3& begin,
                                              const Vec3& end) noexcept;

}  // namespace isograsp::bimanual
