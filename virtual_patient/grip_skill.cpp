// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_patient/grip_skill.hpp"

#include <algorithm>

#include "virtual_patient/loop_delay.hpp"

namespace isograsp {

namespace {
constexpr double kCorrectionRate_per_s = 0.8;  ///< far below 1 / loop delay: a calm loop
constexpr double kSlopeTime_s = 0.1;
constexpr double kSuddenRate_per_s = 2.0;  ///< of the maximum: a jump cannot be foreseen
}  // namespace

void GripSkill::perceive(const Stimulus& picture) noexcept {
  if (!picture.force_target_shown) return;
  if (!seen_) {
    first_s_ = picture.t_s;
    target_N_ = picture.target_force_N;
    seen_ = true;
  }
  const double dt_s = picture.t_s - latest_s_;
  if (latest_s_ > 0.0 && dt_s > 0.0) {
    const double slope_N_s = (picture.target_force_N - target_N_) / dt_s;
    if (slope_N_s * slope_N_s >
        kSuddenRate_per_s * kSuddenRate_per_s * traits_.maximum_force_N * traits_.maximum_force_N) {
      slope_N_s_ = 0.0;
    } else {
      slope_N_s_ += std::min(1.0, dt_s / kSlopeTime_s) * (slope_N_s - slope_N_s_);
    }
    // The first pictures show a force that does not answer yet.
    const bool answers = picture.t_s - first_s_ > 2.0 * loop_delay_s(traits_);
    if (answers)
      correction_N_ +=
          kCorrectionRate_per_s * dt_s * (picture.target_force_N - picture.shown_force_N);
    const double most_N = 0.2 * traits_.maximum_force_N;
    correction_N_ = std::clamp(correction_N_, -most_N, most_N);
  }
  latest_s_ = picture.t_s;
  target_N_ = picture.target_force_N;
}

double GripSkill::wanted_N() const noexcept {
  const double foreseen_N = target_N_ + slope_N_s_ * traits_.prediction * loop_delay_s(traits_);
  return std::max(0.0, foreseen_N + correction_N_);
}

}  // namespace isograsp
