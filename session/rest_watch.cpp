// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/rest_watch.hpp"

namespace isograsp::session {

namespace {
constexpr double kRest_s = 0.5;
/// What happened between two looks that lie further apart is not known. Some frames; snapshots come
/// with each of them, unless the thread that looks was held up.
constexpr double kLongestGap_s = 0.1;
}  // namespace

void RestWatch::begin(const std::optional<FingerWrenches>& resting_C) noexcept {
  rest_C_ = resting_C.value_or(FingerWrenches{});
  last_s_ = -1.0;
  since_s_.reset();
}

void RestWatch::add(const Snapshot& snapshot) noexcept {
  add(snapshot.session_time_s, snapshot.forces);
}

void RestWatch::add(double session_time_s, const FingerFrame& forces) noexcept {
  if (session_time_s <= last_s_) return;
  if (session_time_s - last_s_ > kLongestGap_s) since_s_.reset();
  last_s_ = session_time_s;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const Vec3 force_N = forces.wrench_C[f].force - rest_C_[f].force;
    if (forces.flags[f] == 0 && force_N.norm() <= kRestBand_N) continue;
    since_s_.reset();
    return;
  }
  if (!since_s_) since_s_ = last_s_;
}

bool RestWatch::at_rest() const noexcept {
  return since_s_ && last_s_ - *since_s_ >= kRest_s;
}

}  // namespace isograsp::session
