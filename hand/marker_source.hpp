// SPDX-License-Identifier: GPL-3.0-or-later
// An arm that carries optical markers and reacts to what it sees. One thread uses it.
#pragma once

#include <span>
#include <string>

#include "core/spatial.hpp"
#include "hand/stimulus.hpp"

namespace isograsp {

class MarkerSource {
 public:
  virtual ~MarkerSource() = default;
  /// Names of the markers, in the order of their positions; fixed.
  [[nodiscard]] virtual std::span<const std::string> labels() const noexcept = 0;
  /// A new picture; called once per frame with increasing time. Real-time safe.
  virtual void see(const Stimulus& stimulus) noexcept = 0;
  /// Positions [m] in the frame W of the cameras at time t_s; not seen: NaN in all three places.
  /// Called with increasing time at the rate of the cameras. Real-time safe.
  /// @pre p_W.size() == labels().size()
  virtual void markers(double t_s, std::span<Vec3> p_W) noexcept = 0;
};

}  // namespace isograsp
