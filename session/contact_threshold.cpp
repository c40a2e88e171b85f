// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/contact_threshold.hpp"

namespace isograsp::session {

std::array<std::optional<double>, kFingerCount> contact_thresholds(
    const std::optional<storage::InstrumentZeroRecord>& zero, double maximum_force_N) {
  std::array<std::optional<double>, kFingerCount> threshold_N{};
  if (!zero || !(maximum_force_N > 0.0)) return threshold_N;
  constexpr Eigen::Index kNormalForce = 2;
  for (std::size_t f = 0; f < kFingerCount; ++f)
    threshold_N[f] = contact_threshold_N(zero->sd[f][kNormalForce], maximum_force_N);
  return threshold_N;
}

Scene with_thresholds(Scene scene,
                      const std::array<std::optional<double>, kFingerCount>& threshold_N) {
  for (Contact& contact : scene.contacts)
    if (const auto& own = threshold_N[index_of(contact.finger)]) contact.threshold_N = *own;
  return scene;
}

std::array<std::optional<double>, kFingerCount> thresholds_of(const Scene& scene) {
  std::array<std::optional<double>, kFingerCount> threshold_N{};
  for (const Contact& contact : scene.contacts)
    threshold_N[index_of(contact.finger)] = contact.threshold_N;
  return threshold_N;
}

}  // namespace isograsp::session
