// SPDX-License-Identifier: GPL-3.0-or-later
// The rule for patient codes: they must not tell who the patient is.
#pragma once

#include <string>

#include "core/result.hpp"

namespace isograsp::storage {

/// Patients are codes: letters, digits and '-', 2 to 32 characters, with at least one digit (a code
/// is generated; names, initials and dates are refused).
[[nodiscard]] Result<void> check_patient_code(const std::string& code);

}  // namespace isograsp::storage
