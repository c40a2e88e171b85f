// SPDX-License-Identifier: GPL-3.0-or-later
// A person in software who presses with both hands: two virtual patients that look at one screen,
// share what is asked of both together, and disturb each other. What the hands want, a hand alone
// would want, too (virtual_patient.hpp); here is only what two are more than one. Same seed, same
// forces, whichever hand is asked first.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/random.hpp"
#include "hand/hands.hpp"
#include "hand/stimulus.hpp"
#include "virtual_patient/pair/pair_traits.hpp"
#include "virtual_patient/virtual_patient.hpp"

namespace isograsp::virtual_patient {

class VirtualPair {
 public:
  VirtualPair(const PairTraits& traits, const OfHands<PatientTraits>& people, std::uint64_t seed);

  /// What one hand presses, for its simulated device; it lives as long as the pair. The hands are
  /// asked for the same times at 1 kHz, one of them at most kStored of them before the other.
  [[nodiscard]] FingerSource& source(Hand hand) noexcept { return sides_[hand]; }
  /// The object now on the screen as each hand meets it (VirtualPatient::meet_object()); none:
  /// there is none. Not real-time safe; between trials only.
  void meet_object(const OfHands<std::optional<Scene>>& halves);
  /// What each hand knows of points and bubbles by which it carries an object; none: it carries
  /// none. Real-time safe; between trials only.
  void meet_points(const OfHands<std::optional<CarryKnown>>& known) noexcept;
  /// The person's foot holds the clutch.
  [[nodiscard]] bool holds_clutch() const noexcept { return clutch_held_; }
  /// A new picture of the one screen, once per frame. Real-time safe.
  void see(const Stimulus& stimulus) noexcept;

  static constexpr std::size_t kStored = 2048;

 private:
  class Side final : public FingerSource {
   public:
    void belong_to(VirtualPair& pair, Hand hand) noexcept {
      pair_ = &pair;
      hand_ = hand;
    }
    void see(const Stimulus&) noexcept override {}  // the pair sees
    [[nodiscard]] FingerWrenches press(double t_s) noexcept override {
      return pair_->press(hand_, asked_++, t_s);
    }

   private:
    VirtualPair* pair_ = nullptr;
    Hand hand_ = Hand::left;
    std::size_t asked_ = 0;
  };

  /// What `hand` does at its n-th time.
  [[nodiscard]] FingerWrenches press(Hand hand, std::size_t n, double t_s) noexcept;
  /// Both hands at the next time.
  void advance(double t_s) noexcept;
  /// Pressed when neither point can do more without it, let go when both hands have relaxed.
  void use_clutch() noexcept;
  /// Each hand watches its own end of the object.
  static void look_at_end(Hand hand, const ShownTray& tray, Stimulus& picture) noexcept;
  /// The screen as one hand takes it.
  [[nodiscard]] Stimulus picture_for(Hand hand, const Stimulus& whole) const noexcept;

  PairTraits traits_;
  bool clutch_held_ = false;
  OfHands<double> force_cv_;  ///< of the noise in common
  OfHands<double> share_;     ///< of what is asked of both together
  OfHands<double> lag_s_;
  OfHands<VirtualPatient> patients_;
  OfHands<Side> sides_;
  Random random_;
  double wander_ = 0.0;    ///< noise in common, SD 1
  double wander_s_ = 0.0;  ///< its time constant
  double latest_s_ = 0.0;
  std::size_t crosstalk_steps_;
  std::size_t steps_ = 0;                         ///< times so far
  OfHands<std::vector<FingerWrenches>> own_;      ///< without the other hand; a ring
  OfHands<std::vector<FingerWrenches>> pressed_;  ///< with it; a ring
};

}  // namespace isograsp::virtual_patient
