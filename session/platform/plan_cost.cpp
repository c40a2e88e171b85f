// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/platform/plan_cost.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

namespace isograsp::session {

double cost_ns_per_frame(const Plan& plan) {
  constexpr int kBatches = 500;
  constexpr int kFrames = 20;
  FingerWrenches forces;
  for (auto& wrench : forces) wrench.force = Vec3(0.1, 0.3, 2.0);
  double least_ns = std::numeric_limits<double>::infinity();
  // Each batch starts anew: a body without damper would spin up under a constant force.
  for (int batch = 0; batch < kBatches; ++batch) {
    ObjectState state = plan.initial_state();
    const auto start = std::chrono::steady_clock::now();
    for (int frame = 0; frame < kFrames; ++frame) plan.step(forces, state);
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
    least_ns = std::min(least_ns, took.count() / kFrames);
  }
  return least_ns;
}

}  // namespace isograsp::session
