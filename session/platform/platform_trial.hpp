// SPDX-License-Identifier: GPL-3.0-or-later
// One trial on the platform: a force task, or one with a virtual object.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "device/sensors/force_device.hpp"
#include "grasp_model/plan.hpp"
#include "session/acquisition/apparatus.hpp"
#include "session/platform/platform_row.hpp"

namespace isograsp::session {

class PlatformTrial final : public TrialSetup {
 public:
  [[nodiscard]] std::vector<storage::SignalGroup> columns() const override;
  [[nodiscard]] std::string health_json() const override;

  TrialConstants constants;
  std::optional<Plan> plan;  ///< none: a force task
  DeviceHealth health;       ///< at its end
};

}  // namespace isograsp::session
