// SPDX-License-Identifier: GPL-3.0-or-later
// One hold of four objects: side by side, or one by one where some object needs Plan's own way.
#include "grasp_model/batch/batch_block.hpp"

namespace isograsp {

namespace {

void step_each(const BatchTerms& terms, const BatchTerms::Rows& rows, BatchBlock& block,
               bool narrow) noexcept {
  for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
    ObjectState state = block.get(lane);
    if (narrow)
      terms.plans[lane]->step_narrow(*rows[lane], state);
    else
      terms.plans[lane]->step(*rows[lane], state);
    block.set(lane, state);
  }
}

}  // namespace

void step_block(const BatchTerms& terms, const BatchTerms::Rows& rows, BatchBlock& block,
                bool narrow) noexcept {
  narrow = narrow || terms.press == terms.narrow;  // this processor has no wide registers
  std::array<Four, 3> torque;
  if (!terms.side_by_side || !(narrow ? terms.narrow : terms.press)(terms, rows, block, torque))
    return step_each(terms, rows, block, narrow);
  if (terms.spins) spin_block(terms, torque, block, narrow);
}

}  // namespace isograsp
