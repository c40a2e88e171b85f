// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/acquisition/snapshot.hpp"

namespace isograsp::session {

std::string_view name_of(Stage stage) noexcept {
  constexpr std::array<std::string_view, 5> kNames{"idle", "zeroing", "trial", "paused",
                                                   "finished"};
  return kNames[static_cast<std::size_t>(stage)];
}

NetPush net_push(const Platform& platform, const FingerFrame& forces, double grip_N) noexcept {
  NetPush push;
  push.known = !forces.any(SampleFlag::missing);
  if (!push.known) return push;
  push.wrench_P = net_wrench(platform, forces.wrench_C);
  if (grip_N >= kLeastGripForPush_N)
    push.share_of_grip_percent = 100.0 * push.wrench_P.force.norm() / grip_N;
  return push;
}

const char* describe(PauseCause cause) noexcept {
  switch (cause) {
    case PauseCause::none: return "";
    case PauseCause::therapist: return "Paused by the therapist.";
    case PauseCause::missing_samples:
      return "Paused: samples are missing. Check the cables, check the zero, then resume.";
    case PauseCause::device_fault:
      return "Paused: the device has a fault. Mend it, check the zero, then resume.";
  }
  return "";
}

}  // namespace isograsp::session
