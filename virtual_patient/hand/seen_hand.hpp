// SPDX-License-Identifier: GPL-3.0-or-later
// What a tracker makes of a hand: noise, slow errors of its palm and of each digit, a size that is
// not quite its own, moments in which it is not seen.
#pragma once

#include <array>

#include "core/random.hpp"
#include "hand/tracked_hand.hpp"
#include "virtual_patient/hand/grasp_traits.hpp"

namespace isograsp::virtual_patient {

class SeenHand {
 public:
  SeenHand(const GraspTraits& traits, std::uint64_t seed) noexcept;

  /// The joints of a hand `dt_s` after the picture before; not seen: none is given and `tracked` is
  /// false. Side and time are the caller's. Real-time safe.
  [[nodiscard]] HandFrame look(const std::array<Vec3, kHandJointCount>& joints_W,
                               double dt_s) noexcept;
  /// What the tracker takes the hand for / what it is.
  [[nodiscard]] double size() const noexcept { return size_; }

 private:
  /// Noise through two equal low-passes: smooth, standard deviation 1.
  struct Slow {
    Vec3 first = Vec3::Zero();
    Vec3 second = Vec3::Zero();
    void begin(Random& random) noexcept;
    void pass(double keep, Random& random) noexcept;
    [[nodiscard]] Vec3 value() const noexcept;
  };

  GraspTraits traits_;
  Random wander_random_, noise_random_, loss_random_;
  double size_ = 1.0;
  Slow palm_;
  std::array<Slow, kDigitCount> tips_;
  double lost_s_ = 0.0;  ///< still lost for this long
};

}  // namespace isograsp::virtual_patient
