// SPDX-License-Identifier: GPL-3.0-or-later
// What a session learns from its news.
#include "session/session_parts.hpp"

#include "session/two_platforms/two_zeros.hpp"

namespace isograsp::session {

namespace {

/// The noise of the empty device: SD of each force component; nothing: it is no platform's.
std::optional<std::array<Vec3, kFingerCount>> noise_of(const storage::PreparationRecord& zero) {
  if (zero.kind != platform::kInstrumentZero) return std::nullopt;
  const auto sd = platform::six_axes_of(zero.columns, zero.sd);
  if (!sd) return std::nullopt;
  std::array<Vec3, kFingerCount> sd_N;
  for (std::size_t f = 0; f < kFingerCount; ++f) sd_N[f] = (*sd)[f].head<3>();
  return sd_N;
}

/// The noise of the grip of each hand, both platforms empty.
void learn_noise(const storage::PreparationRecord& zeros, tasks::TwoHandsReferences& references) {
  if (zeros.kind != platform::kTwoInstrumentZeros) return;
  const auto sd = platform::two_six_axes_of(zeros.columns, zeros.sd);
  if (!sd) return;
  for (const Hand hand : kBothHands) {
    std::array<Vec3, kFingerCount> sd_N;
    for (std::size_t f = 0; f < kFingerCount; ++f) sd_N[f] = (*sd)[hand][f].head<3>();
    references.of[hand].noise_sd_N = isograsp::noise_of(sd_N, {});
  }
}

}  // namespace

void Session::Parts::learn(std::vector<SessionNews>& news) {
  for (auto& item : news) {
    if (item.prepared || item.trial) pending = in_trial = false;
    if (item.prepared && item.prepared->accepted) {
      learn_noise(item.prepared->record, known.two_hands);
      before_last.two_hands = known.two_hands;
      if (const auto noise_sd_N = noise_of(item.prepared->record))
        known.references.noise_sd_N = before_last.references.noise_sd_N = *noise_sd_N;
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
