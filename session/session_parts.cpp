// SPDX-License-Identifier: GPL-3.0-or-later
// What a session learns from its news.
#include "session/session_parts.hpp"

namespace isograsp::session {

namespace {

/// The noise of the empty device: SD of each force component.
std::array<Vec3, kFingerCount> noise_of(const ZeroRecord& zero) {
  std::array<Vec3, kFingerCount> sd_N;
  for (std::size_t f = 0; f < kFingerCount; ++f) sd_N[f] = zero.sd[f].head<3>();
  return sd_N;
}

}  // namespace

void Session::Parts::learn(std::vector<SessionNews>& news) {
  for (auto& item : news) {
    if (item.zero || item.trial) pending = in_trial = false;
    if (item.zero && item.zero->accepted) {
      known.references.noise_sd_N = before_last.references.noise_sd_N = noise_of(item.zero->zero);
    }
    if (!item.trial) continue;
    item.trial->trial.helped = helped;
    if (helped) recorder->mark_helped(item.trial->trial.id, true);
    last = *item.trial;
    before_last = static_cast<const Lessons&>(known);
    learn(*last);
  }
}

void Session::Parts::learn(const TrialOutcome& outcome) {
  known.learn(setups.back()->spec, outcome.trial, outcome.measures,
              outcome.rest ? &*outcome.rest : nullptr);
}

}  // namespace isograsp::session
