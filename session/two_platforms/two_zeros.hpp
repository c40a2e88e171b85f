// SPDX-License-Identifier: GPL-3.0-or-later
// The instrument zeros of both platforms as one preparation: both are empty at the same time, and
// both are good or neither is in force.
#pragma once

#include <optional>

#include "hand/hands.hpp"
#include "hand/platform_records.hpp"
#include "session/platform/instrument_zero.hpp"
#include "storage/records/records.hpp"

namespace isograsp::session {

struct TwoZeros final : public Preparation {
  [[nodiscard]] PreparationOutcome outcome() const override;

  OfHands<InstrumentZero> of;
  OfHands<bool> ended;  ///< its second is over
};

}  // namespace isograsp::session
