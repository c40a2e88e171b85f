// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session_knowledge.hpp"

#include <algorithm>
#include <cmath>

#include "session/arm/passive_range.hpp"
#include "session/session.hpp"
#include "tasks/kinds/arm/active_range.hpp"

namespace isograsp::session {

namespace {

/// The seed of a trial, for its sequences and waits: from that of the session and the trial's
/// number.
std::uint64_t trial_seed(std::uint64_t session_seed, std::size_t trials_before) {
  constexpr std::uint64_t kTrialsPerSession = 1000;
  return session_seed * kTrialsPerSession + trials_before + 1;
}

FingerWrenches wrenches_of(const RestRecord& rest) {
  FingerWrenches wrench_C;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    wrench_C[f].force = rest.mean[f].head<3>();
    wrench_C[f].torque = rest.mean[f].tail<3>();
  }
  return wrench_C;
}

}  // namespace

void Lessons::learn(const tasks::TaskSpec& spec, const storage::TrialRecord& trial,
                    const std::vector<Measure>& measures, const RestOutcome* rest) {
  if (trial.status != storage::TrialStatus::completed || trial.helped) return;
  learn_maxima(measures);
  learn_hands(measures);
  learn_range(spec, measures);
  learn_way(spec);
  training.learn(spec, trial, measures);
  if (rest != nullptr) references.resting_C = wrenches_of(rest->rest);
}

void Lessons::learn_maxima(const std::vector<Measure>& measures) {
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

void Lessons::learn_hands(const std::vector<Measure>& measures) {
  for (const Measure& measure : measures) {
    const auto hand = hand_from_name(measure.channel);
    if (!hand || !measure.value) continue;
    tasks::HandReferences& of = two_hands.of[*hand];
    if (measure.name == "maximum_force")
      of.maximum_N = std::max(of.maximum_N.value_or(*measure.value), *measure.value);
    if (measure.name == "resting_force") of.resting_N = *measure.value;
  }
}

void Lessons::learn_range(const tasks::TaskSpec& spec, const std::vector<Measure>& measures) {
  const auto* const asked = spec.kind.get_if<tasks::ActiveRangeSpec>();
  if (asked == nullptr) return;
  const std::string_view link = kArmLinkNames[index_of(asked->link)];
  std::optional<double> least_rad, largest_rad;
  for (const Measure& measure : measures) {
    if (measure.name == "least_angle") least_rad = measure.value;
    if (measure.name == "largest_angle") largest_rad = measure.value;
  }
  if (!least_rad || !largest_rad) return;
  const int angle = asked->angle - 1;
  const auto known = std::find_if(ranges.begin(), ranges.end(), [&](const OwnRange& range) {
    return range.link == link && range.angle == angle;
  });
  if (known == ranges.end()) {
    ranges.push_back({std::string(link), angle, *least_rad, *largest_rad});
    return;
  }
  known->min_rad = std::min(known->min_rad, *least_rad);
  known->max_rad = std::max(known->max_rad, *largest_rad);
}

void Lessons::learn_way(const tasks::TaskSpec& spec) {
  const auto gone = way_of(spec);
  if (!gone || !arm_screening.way_done) return;
  double& way = (*arm_screening.way_done)[gone->postures];
  way = std::max(way, gone->way);
}

bool SessionKnowledge::asks_for(PreparationStep step) const noexcept {
  return std::find(steps.begin(), steps.end(), step) != steps.end();
}

std::uint64_t SessionKnowledge::order_seed() const noexcept {
  return session::order_seed(record, earlier);
}

tasks::TaskContext SessionKnowledge::next_context() const {
  tasks::TaskContext context;
  context.period_s = apparatus.period_s;
  context.references = references;
  context.two_hands = two_hands;
  context.ranges = ranges;
  context.screening = arm_screening;
  context.seed = trial_seed(order_seed(), earlier.trials_made + trials_begun);
  return context;
}

std::optional<double> SessionKnowledge::maximum_force_N() const noexcept {
  return references.maximum({});
}

}  // namespace isograsp::session
