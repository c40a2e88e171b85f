// SPDX-License-Identifier: GPL-3.0-or-later
// The person in front of a simulated device, as its URI describes them.
#pragma once

#include <memory>

#include "core/result.hpp"
#include "device/uri.hpp"
#include "virtual_patient/virtual_patient.hpp"

namespace isograsp {

/// sim://healthy | sim://paretic, with `seed` and `recovery` (0: as named … 1: healthy). Nothing
/// for a device that is not simulated.
[[nodiscard]] Result<std::unique_ptr<VirtualPatient>> simulated_person(const Uri& uri);

}  // namespace isograsp
