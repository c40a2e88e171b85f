// SPDX-License-Identifier: GPL-3.0-or-later
// What a session learns from its trials.
#include "session/session_parts.hpp"

#include <algorithm>

namespace isograsp {

namespace {

/// The noise of the empty device: SD of each force component.
std::array<Vec3, kFingerCount> noise_of(const InstrumentZeroRecord& zero) {
  std::array<Vec3, kFingerCount> sd_N;
  for (std::size_t f = 0; f < kFingerCount; ++f) sd_N[f] = zero.sd[f].head<3>();
  return sd_N;
}

FingerWrenches wrenches_of(const RestingForceRecord& rest) {
  FingerWrenches wrench_C;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    wrench_C[f].force = rest.mean[f].head<3>();
    wrench_C[f].torque = rest.mean[f].tail<3>();
  }
  return wrench_C;
}

/// Forces that this trial measured raise the references of their channels.
void learn_maxima(const TrialOutcome& outcome, ForceReferences& references) {
  for (const Measure& measure : outcome.measures) {
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

}  // namespace

void Session::Parts::learn(const std::vector<SessionNews>& news) {
  for (const auto& item : news) {
    if (item.zero || item.trial || item.failure) pending = false;
    if (item.zero && item.zero->accepted) {
      zero = item.zero->zero;
      references.noise_sd_N = noise_of(*zero);
    }
    if (!item.trial || item.trial->trial.status != TrialStatus::completed) continue;
    learn_maxima(*item.trial, references);
    training.learn(setups.back()->spec, item.trial->trial, item.trial->measures);
    if (item.trial->rest) references.resting_C = wrenches_of(item.trial->rest->rest);
  }
}

}  // namespace isograsp
