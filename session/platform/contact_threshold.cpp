// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/platform/contact_threshold.hpp"

namespace isograsp::session {

std::array<std::optional<double>, kFingerCount> contact_thresholds(
    const tasks::ForceReferences& references) {
  std::array<std::optional<double>, kFingerCount> threshold_N{};
  const auto maximum_N = references.maximum({});
  if (!references.noise_sd_N || !maximum_N || !(*maximum_N > 0.0)) return threshold_N;
  for (std::size_t f = 0; f < kFingerCount; ++f)
    threshold_N[f] = contact_threshold_N((*references.noise_sd_N)[f].z(), *maximum_N);
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
