// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_hand/assistance.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp::virtual_hand {

TieGains tie_gains(const TieDesign& design) noexcept {
  constexpr double kReserve = 1.5;
  const double load_N = design.mass_kg * (design.gravity_m_s2 + design.acceleration_m_s2);
  const double n = design.digits;
  const double lever_m = PadFriction{0.0, design.patch_radius_m}.torsion_m();
  TieGains gains;
  gains.stiffness_N_m = load_N / (n * design.deflection_m);
  gains.damping_N_s_m =
      2.0 * design.damping_ratio * std::sqrt(gains.stiffness_N_m * design.mass_kg / n);
  gains.torsion_N_m_rad = gains.stiffness_N_m * lever_m * lever_m;
  gains.release_N = kReserve * load_N;
  return gains;
}

bool Assistance::lasts(const Since& since, double t_s, double span_s) noexcept {
  return since && t_s - *since >= span_s - kTimeSlack_s;
}

void Assistance::forget() noexcept {
  pulled_ = {};
  stands_.reset();
  standing_ = 0;
}

void Assistance::block(std::size_t digit, double t_s) noexcept {
  states_[digit] = DigitState::blocked;
  blocked_[digit] = t_s;
  pulled_[digit].reset();
}

void Assistance::let_go(double t_s) noexcept {
  for (std::size_t d = 0; d < kDigitCount; ++d)
    if (states_[d] == DigitState::attached) block(d, t_s);
}

void Assistance::step(const AssistanceRow& row) noexcept {
  if (!row.tracked) return forget();
  touch(row);
  release(row);
  tie(row);
}

void Assistance::touch(const AssistanceRow& row) noexcept {
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    const AssistanceRow::OfDigit& digit = row.digits[d];
    DigitState& state = states_[d];
    if (state == DigitState::blocked) {
      const bool away = !digit.contact && digit.gap_m >= kReleaseGap_m;
      if (!away && !lasts(blocked_[d], row.t_s, kBlocked_s)) continue;
      state = DigitState::free;
      blocked_[d].reset();
    }
    if (state != DigitState::attached)
      state = digit.contact ? DigitState::contact : DigitState::free;
  }
}

void Assistance::release(const AssistanceRow& row) noexcept {
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    const double pull_N = row.digits[d].pull_N;
    if (states_[d] != DigitState::attached || !(pull_N > release_N_)) {
      pulled_[d].reset();
      continue;
    }
    if (!pulled_[d]) pulled_[d] = row.t_s;
    if (pull_N > kPullAtOnce * release_N_ || lasts(pulled_[d], row.t_s, kPull_s)) block(d, row.t_s);
  }
  // One digit is no grasp.
  if (std::count(states_.begin(), states_.end(), DigitState::attached) != 1) return;
  const auto last = std::find(states_.begin(), states_.end(), DigitState::attached);
  block(static_cast<std::size_t>(last - states_.begin()), row.t_s);
}

void Assistance::tie(const AssistanceRow& row) noexcept {
  bool stands = row.feasible != 0;
  for (std::size_t d = 0; d < kDigitCount; ++d)
    if ((row.feasible >> d & 1U) != 0)
      stands &= states_[d] == DigitState::contact || states_[d] == DigitState::attached;
  if (!stands || row.feasible != standing_) stands_.reset();
  standing_ = stands ? row.feasible : 0;
  if (!stands) return;
  if (!stands_) stands_ = row.t_s;
  if (!lasts(stands_, row.t_s, kStanding_s)) return;
  for (std::size_t d = 0; d < kDigitCount; ++d)
    if ((row.feasible >> d & 1U) != 0) states_[d] = DigitState::attached;
}

}  // namespace isograsp::virtual_hand
