// SPDX-License-Identifier: GPL-3.0-or-later
// Inside tasks/ only: the segments of each kind of force task. Levels times `unit` are newtons.
#pragma once

#include <functional>
#include <vector>

#include "core/random.hpp"
#include "tasks/timeline.hpp"

namespace isograsp::tasks {

/// How waits that cannot be foreseen are chosen, and how long a frame is.
class Pace {
 public:
  enum class Waits : std::uint8_t { seeded, mean, longest };
  Pace(double period_s, std::uint64_t seed, Waits waits = Waits::seeded)
      : period_s_(period_s), seed_(seed), waits_(waits), random_(seed, kWaitStream) {}

  [[nodiscard]] double period_s() const noexcept { return period_s_; }
  [[nodiscard]] std::uint64_t seed() const noexcept { return seed_; }
  [[nodiscard]] std::int64_t frames(double duration_s) const noexcept;
  /// The next wait [s].
  [[nodiscard]] double wait(double least_s, double most_s) noexcept;

 private:
  static constexpr std::uint64_t kWaitStream = 201;
  double period_s_;
  std::uint64_t seed_;
  Waits waits_;
  Random random_;
};

/// Newtons of one unit of the task's scale in a channel.
using Unit = std::function<double(ForceChannel)>;
using Segments = std::vector<Segment>;

[[nodiscard]] Segments segments_of(const RestSpec& spec, const Unit& unit, Pace& pace);
[[nodiscard]] Segments segments_of(const MaximumSpec& spec, const Unit& unit, Pace& pace);
[[nodiscard]] Segments segments_of(const DirectionalMaximaSpec& spec, const Unit& unit, Pace& pace);
[[nodiscard]] Segments segments_of(const ForceTrackingSpec& spec, const Unit& unit, Pace& pace);
[[nodiscard]] Segments segments_of(const SteadinessSpec& spec, const Unit& unit, Pace& pace);
[[nodiscard]] Segments segments_of(const StepResponseSpec& spec, const Unit& unit, Pace& pace);
[[nodiscard]] Segments segments_of(const GripReleaseSpec& spec, const Unit& unit, Pace& pace);
[[nodiscard]] Segments segments_of(const ForceSenseSpec& spec, const Unit& unit, Pace& pace);
[[nodiscard]] Segments segments_of(const FatigueSpec& spec, const Unit& unit, Pace& pace);
[[nodiscard]] Segments segments_of(const IndividuationSpec& spec, const Unit& unit, Pace& pace);
[[nodiscard]] Segments segments_of(const ForceDirectionSpec& spec, const Unit& unit, Pace& pace);

}  // namespace isograsp::tasks
