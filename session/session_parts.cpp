// SPDX-License-Identifier: GPL-3.0-or-later
// What a session learns from its trials.
#include "session/session_parts.hpp"

#include <algorithm>

namespace isograsp::session {

namespace {

/// The noise of the empty device: SD of each force component.
std::array<Vec3, kFingerCount> noise_of(const storage::InstrumentZeroRecord& zero) {
  std::array<Vec3, kFingerCount> sd_N;
  for (std::size_t f = 0; f < kFingerCount; ++f) sd_N[f] = zero.sd[f].head<3>();
  return sd_N;
}

FingerWrenches wrenches_of(const storage::RestingForceRecord& rest) {
  FingerWrenches wrench_C;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    wrench_C[f].force = rest.mean[f].head<3>();
    wrench_C[f].torque = rest.mean[f].tail<3>();
  }
  return wrench_C;
}

}  // namespace

void learn_maxima(const std::vector<Measure>& measures, tasks::ForceReferences& references) {
  for (const Measure& measure : measures) {
    if (!measure.value) continue;
    auto* const known = measure.name == "maximum_force"       ? &references.maximum_N
                        : measure.name == "comfortable_force" ? &references.comfortable_N
                                                              : nullptr;
    const auto channel = force_channel_from_name(measure.channel);
    if (known == nullptr || !channel) continue;
    double& value_N = (*known)[*channel];
    value_N = std::max(value_N, *measure.value);
  }
}

void Session::Parts::learn(std::vector<SessionNews>& news) {
  for (auto& item : news) {
    if (item.zero || item.trial) pending = in_trial = false;
    if (item.zero && item.zero->accepted) {
      zero = item.zero->zero;
      lesson.references.noise_sd_N = before_last.references.noise_sd_N = noise_of(*zero);
    }
    if (!item.trial) continue;
    item.trial->trial.helped = helped;
    if (helped) recorder->mark_helped(item.trial->trial.id, true);
    last = *item.trial;
    before_last = lesson;
    learn(*last);
  }
}

void Session::Parts::learn(const TrialOutcome& outcome) {
  if (outcome.trial.status != storage::TrialStatus::completed || outcome.trial.helped) return;
  learn_maxima(outcome.measures, lesson.references);
  lesson.training.learn(setups.back()->spec, outcome.trial, outcome.measures);
  if (outcome.rest) lesson.references.resting_C = wrenches_of(outcome.rest->rest);
}

}  // namespace isograsp::session
