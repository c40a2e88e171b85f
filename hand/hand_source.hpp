// SPDX-License-Identifier: GPL-3.0-or-later
// A person whose hand a tracker sees, and who reacts to what the screen shows. One thread uses it.
#pragma once

#include "hand/stimulus.hpp"
#include "hand/tracked_hand.hpp"

namespace isograsp {

class HandSource {
 public:
  virtual ~HandSource() = default;
  /// A new picture; called once per frame with increasing time. Real-time safe.
  virtual void see(const Stimulus& stimulus) noexcept = 0;
  /// The hand as the tracker gives it at time t_s, in the world of the tracker, which is that of
  /// the screen; `tracked` false: it is not seen, and no joint is given. Called with increasing
  /// time at the rate of the tracker. Real-time safe.
  [[nodiscard]] virtual HandFrame at(double t_s) noexcept = 0;
};

}  // namespace isograsp
