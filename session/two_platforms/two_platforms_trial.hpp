// SPDX-License-Identifier: GPL-3.0-or-later
// One trial of both hands, each on its platform, and what is recorded of its frames; the columns
// are those of hand/two_hands_columns.hpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "session/acquisition/apparatus.hpp"
#include "session/two_platforms/carried_by_hands.hpp"
#include "session/two_platforms/lifted_object.hpp"
#include "session/two_platforms/two_platforms_snapshot.hpp"
#include "tasks/references.hpp"

namespace isograsp::session {

class TwoPlatformsTrial final : public TrialSetup {
 public:
  [[nodiscard]] std::vector<storage::SignalGroup> columns() const override;
  [[nodiscard]] std::string health_json() const override;
  /// One value per column of columns(), in that order. Real-time safe.
  void write(const RowFrame& frame, const TwoPlatformsSnapshot& seen, TrialRow& row) const noexcept;

  // What does not change within the trial; nothing: not known.
  tasks::TwoHandsReferences references;
  std::optional<double> device_delay_s;
  std::optional<double> display_delay_s;
  std::optional<LiftedObject> object;     ///< nothing: nothing is lifted
  std::optional<CarriedByHands> carried;  ///< nothing: nothing is carried
  OfHands<DeviceHealth> health;           ///< at its end
};

}  // namespace isograsp::session
