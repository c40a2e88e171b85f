// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/platform/platform_trial.hpp"

#include "session/platform/health_json.hpp"

namespace isograsp::session {

std::vector<storage::SignalGroup> PlatformTrial::columns() const {
  const ObjectState still;
  return columns_of({{}, {}, {}, constants, plan ? &still : nullptr, {}});
}

std::string PlatformTrial::health_json() const {
  return as_json(health);
}

}  // namespace isograsp::session
