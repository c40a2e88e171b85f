// SPDX-License-Identifier: GPL-3.0-or-later
// Many objects that move at once: recordings simulated again, people in software, studies of
// parameters. Four of them go side by side, an object a lane, where Plan::step() takes one: the
// same bits, sooner.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "grasp_model/plan.hpp"
#include "hand/finger.hpp"

namespace isograsp {

struct BatchBlock;
struct BatchTerms;

/// One state for each of N plans. Side by side go four in a row whose plans are of one kind: three
/// fingers, every free axis moves independently, no travel ends, no torsion, none of three
/// rotations massless. All others move one by one. The plans must live as long as the batch.
class Batch {
 public:
  /// `count` states of one plan, all initial.
  Batch(const Plan& plan, std::size_t count);
  /// A state of each plan, initial; plans may repeat.
  explicit Batch(std::vector<const Plan*> plans);
  ~Batch();
  Batch(Batch&& other) noexcept;
  Batch& operator=(Batch&& other) noexcept;

  [[nodiscard]] std::size_t size() const noexcept { return plans_.size(); }
  [[nodiscard]] const Plan& plan(std::size_t i) const noexcept { return *plans_[i]; }
  [[nodiscard]] ObjectState state(std::size_t i) const noexcept;
  void set_state(std::size_t i, const ObjectState& state) noexcept;

  /// One hold of every state, as plan(i).step(wrench_C[i], state(i)) makes it, bit for bit.
  /// Real-time safe. @pre wrench_C.size() == size()
  void step(std::span<const FingerWrenches> wrench_C) noexcept { step(wrench_C, false); }
  /// The same as on a processor without AVX2: the same bits, which tests hold it to.
  void step_narrow(std::span<const FingerWrenches> wrench_C) noexcept { step(wrench_C, true); }

 private:
  void step(std::span<const FingerWrenches> wrench_C, bool narrow) noexcept;

  std::vector<const Plan*> plans_;
  std::vector<BatchTerms> terms_;
  std::vector<BatchBlock> blocks_;  ///< the last is filled up with copies of its last state
};

}  // namespace isograsp
