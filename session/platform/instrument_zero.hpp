// SPDX-License-Identifier: GPL-3.0-or-later
// The instrument zero as a preparation: the request, the measurement, the result.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "hand/finger.hpp"
#include "session/acquisition/apparatus.hpp"
#include "session/platform/zeroing.hpp"

namespace isograsp::session {

struct InstrumentZero final : public Preparation {
  [[nodiscard]] PreparationOutcome outcome() const override;

  // Asked for.
  double settle_s = 0.0;        ///< time before the second that is measured
  bool accept_changed = false;  ///< the device was serviced or remounted

  // While it is measured.
  Zeroing zeroing;
  double wait_s = 0.0;                                 ///< left before zeroing begins
  std::array<std::uint64_t, kFingerCount> restarts{};  ///< of each sensor, when it was asked for

  // The result.
  Zeroing::Statistics statistics;
  std::optional<ZeroRefusal> refusal;  ///< nothing: it is in force
  std::optional<double> change_N;      ///< from the last one of the same device
  std::optional<double> drift_N;       ///< from the last one of this session
  bool change_confirmed = false;       ///< beyond the band, as the operator confirmed
};

}  // namespace isograsp::session
