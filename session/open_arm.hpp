// SPDX-License-Identifier: GPL-3.0-or-later
// qtm://, natnet://, sim://arm, replay://FILE?rig=: an arm seen by markers.
#pragma once

#include "session/open_apparatus.hpp"

namespace isograsp::session {

/// The rig of the parameter `rig`, and of sim://arm the person: patient=healthy | paretic, seed,
/// recovery, day as for the simulated hand. Errors name the URI.
[[nodiscard]] Result<std::unique_ptr<Apparatus>> open_arm(const ApparatusRequest& request);

}  // namespace isograsp::session
