// SPDX-License-Identifier: GPL-3.0-or-later
// What forces are measured against: rest, noise, maximum and comfortable force of each channel, and
// what the screening allows. SI units; contact frames.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>

#include "core/result.hpp"
#include "hand/force_channel.hpp"
#include "hand/hands.hpp"
#include "tasks/aim.hpp"

namespace isograsp::tasks {

/// Outcome of the screening for one hand.
enum class Effort : std::uint8_t { none, comfortable, maximum };
[[nodiscard]] std::string_view name_of(Effort effort) noexcept;
[[nodiscard]] std::optional<Effort> effort_from_name(std::string_view name) noexcept;

struct ForceReferences {
  std::optional<FingerWrenches> resting_C;  ///< mean at rest in this session; nothing: not measured
  /// SD of each force component, device empty; nothing: no instrument zero.
  std::optional<std::array<Vec3, kFingerCount>> noise_sd_N;
  std::optional<double> resolution_N;  ///< coarsest step of a force component; nothing: not known
  std::map<ForceChannel, double> maximum_N;      ///< above rest, of this session
  std::map<ForceChannel, double> comfortable_N;  ///< above rest, of this session
  std::map<ForceChannel, double> baseline_N;     ///< maximum of the first assessments
  Effort allowed = Effort::maximum;
  std::optional<double> ceiling_N;  ///< no target may exceed it

  // Of a channel; nothing: not measured.
  [[nodiscard]] std::optional<double> resting(ForceChannel channel) const noexcept;
  [[nodiscard]] std::optional<double> noise(
      ForceChannel channel) const noexcept;  ///< SD, device empty
  [[nodiscard]] std::optional<double> maximum(ForceChannel channel) const noexcept;

  /// What one unit of the scale is for this channel [N], or which measurement is missing. The
  /// error's field is `scale`; fixed loads above half of today's maximum are refused.
  [[nodiscard]] Result<double> unit_N(Scale scale, ForceChannel channel, double largest) const;
};

/// What is known of the grip force of one of two hands; nothing: not measured, or there is no
/// limit.
struct HandReferences {
  std::optional<double> resting_N;     ///< mean at rest in this session
  std::optional<double> maximum_N;     ///< of this hand alone, above rest, in this session
  std::optional<double> noise_sd_N;    ///< device empty
  std::optional<double> resolution_N;  ///< coarsest step of a force component
  std::optional<double> ceiling_N;     ///< no target may ask this hand for more
};
struct TwoHandsReferences {
  OfHands<HandReferences> of;
  std::optional<Hand> affected;  ///< nothing: not known, both or neither
  /// The smaller of both maxima [N]; nothing: one of them is not known.
  [[nodiscard]] std::optional<double> weaker_N() const noexcept {
    if (!of.left.maximum_N || !of.right.maximum_N) return std::nullopt;
    return *of.left.maximum_N < *of.right.maximum_N ? of.left.maximum_N : of.right.maximum_N;
  }
  /// Pressing one empty platform moves the other: there are no shares. Nothing: not checked.
  std::optional<bool> coupled;
};

/// Half the width of the band round a target [N]: max(fraction |T|, 3 noise SD) (docs/measures.md).
[[nodiscard]] constexpr double band_N(double target_N, double fraction, double noise_N) noexcept {
  constexpr double kNoiseFactor = 3.0;
  const double share = fraction * (target_N < 0.0 ? -target_N : target_N);
  const double noise = kNoiseFactor * noise_N;
  return share > noise ? share : noise;
}

}  // namespace isograsp::tasks
