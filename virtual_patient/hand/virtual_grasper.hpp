// SPDX-License-Identifier: GPL-3.0-or-later
// A person in software whose hand a tracker sees: reaches for the object on the screen, closes the
// hand around it, brings it to the target, opens when it has turned purple; opens and closes where
// that is asked for. Sees object and target after a visual delay, and nothing else of the task;
// does not see the virtual hand. Same traits, seed and side: same hand, bit for bit.
//
// A left person is the reflection x -> -x of the right one with the same seed, who sees the
// reflected screen.
#pragma once

#include <cstdint>
#include <memory>

#include "hand/finger.hpp"
#include "hand/hand_source.hpp"
#include "virtual_hand/hand_model.hpp"
#include "virtual_patient/hand/grasp_traits.hpp"

namespace isograsp::virtual_patient {

class VirtualGrasper final : public HandSource {
 public:
  /// `hand`: what the hand measures.
  VirtualGrasper(const virtual_hand::HandModel& hand, const GraspTraits& traits, std::uint64_t seed,
                 Hand side = Hand::right);
  ~VirtualGrasper() override;

  /// Pictures are seen when they come, on the time axis of at(): their own t_s does not count.
  void see(const Stimulus& stimulus) noexcept override;
  [[nodiscard]] HandFrame at(double t_s) noexcept override;

  [[nodiscard]] const GraspTraits& person() const noexcept;
  /// How far thumb and index open [m].
  [[nodiscard]] double opening_m() const noexcept;
  /// What the tracker takes the hand for / what it is.
  [[nodiscard]] double seen_size() const noexcept;

 private:
  struct Mind;
  std::unique_ptr<Mind> mind_;
};

}  // namespace isograsp::virtual_patient
