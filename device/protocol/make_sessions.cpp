// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/protocol/make_sessions.hpp"

#include <utility>

#include "device/config/family_facts.hpp"

namespace isograsp {

SensorSessions make_sessions(const DeviceConfig& config) {
  SensorSessions sessions;
  for (std::size_t f = 0; f < kFingerCount; ++f)
    sessions[f] = config.family->make_session(config, f);
  return sessions;
}

Result<SensorSessions> ask_sessions(const DeviceConfig& config) {
  if (config.family->ask_session == nullptr) return make_sessions(config);
  SensorSessions sessions;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    auto session = config.family->ask_session(config, f);
    if (!session) return session.error();
    sessions[f] = *std::move(session);
  }
  return sessions;
}

}  // namespace isograsp
