// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/rules/still_watch.hpp"

#include "kinematics/postures.hpp"
#include "session/arm/start_posture.hpp"

namespace isograsp::gui {

void StillWatch::add(const session::ArmSnapshot& now) {
  const double t_s = now.session_time_s;
  if (now.frames == 0 || t_s == last_s_) return;
  if (t_s < last_s_) rows_.clear();  // another session
  last_s_ = t_s;
  constexpr session::StartPostureLimits kLimits;
  Row row{t_s, {}};
  bool whole = true;
  for (std::size_t k = 0; k < session::kArmChain.size(); ++k) {
    const FramePose& segment = now.segment(session::kArmChain[k]);
    unseen_[k] = !has_pose(segment.state);
    whole = whole && !unseen_[k];
    row.X_W[k] = segment.X_W;
  }
  if (!whole) {
    rows_.clear();
    state_ = State::unseen;
    return;
  }
  rows_.push_back(row);
  while (rows_.size() > 2 && rows_[1].t_s <= t_s - kLimits.duration_s) rows_.pop_front();
  StartPostureMean mean(session::kArmChain.size());
  for (const Row& one : rows_) mean.add(one.X_W);
  const bool long_enough = t_s - rows_.front().t_s >= kLimits.duration_s;
  state_ =
      long_enough && mean.largest_sd_m() <= kLimits.largest_sd_m ? State::still : State::moving;
}

}  // namespace isograsp::gui
