// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/platform/snapshot.hpp"

namespace isograsp::session {

NetPush net_push(const Platform& platform, const FingerFrame& forces, double grip_N) noexcept {
  NetPush push;
  push.known = !forces.any(SampleFlag::missing);
  if (!push.known) return push;
  push.wrench_P = net_wrench(platform, forces.wrench_C);
  if (grip_N >= kLeastGripForPush_N)
    push.share_of_grip_percent = 100.0 * push.wrench_P.force.norm() / grip_N;
  return push;
}

}  // namespace isograsp::session
