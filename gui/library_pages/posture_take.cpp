// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/library_pages/posture_take.hpp"

#include <algorithm>
#include <array>

#include "session/arm/start_posture.hpp"

namespace isograsp::gui {

namespace {

constexpr session::StartPostureLimits kTakeLimits;

}  // namespace

void PostureTake::begin() {
  *this = {};
  state_ = State::running;
}

bool PostureTake::add(const session::ArmSnapshot& now) {
  const double t_s = now.session_time_s;
  if (!running() || now.frames == 0 || t_s == last_s_) return false;
  last_s_ = t_s;
  if (began_s_ < 0.0) began_s_ = t_s;
  std::array<Pose, session::kArmChain.size()> X_W;
  bool whole = true;
  for (std::size_t k = 0; k < session::kArmChain.size(); ++k) {
    const FramePose& segment = now.segment(session::kArmChain[k]);
    whole = whole && has_pose(segment.state);
    X_W[k] = segment.X_W;
  }
  if (whole) {
    if (first_s_ < 0.0) first_s_ = t_s;
    mean_.add(X_W);
  } else if (first_s_ >= 0.0) {  // a second without a gap
    mean_ = StartPostureMean(session::kArmChain.size());
    first_s_ = -1.0;
  }
  if (first_s_ >= 0.0 && t_s - first_s_ >= kTakeLimits.duration_s)
    state_ = sd_m() <= kTakeLimits.largest_sd_m ? State::taken : State::moved;
  else if (t_s - began_s_ >= kTakeLimits.longest_s)
    state_ = State::not_seen;
  return !running();
}

double PostureTake::progress() const noexcept {
  if (first_s_ < 0.0) return 0.0;
  return std::clamp((last_s_ - first_s_) / kTakeLimits.duration_s, 0.0, 1.0);
}

}  // namespace isograsp::gui
