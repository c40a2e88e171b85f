// SPDX-License-Identifier: GPL-3.0-or-later
// People as files, format "isograsp-patient-1" (library/patients, docs/virtual_patient.md). A file
// must give every trait, so that nobody is taken for healthy where a trait was left out.
#pragma once

#include <string>
#include <string_view>

#include "core/result.hpp"
#include "virtual_patient/traits.hpp"

namespace isograsp::virtual_patient {

struct VirtualPatientFile {
  std::string name;         ///< for people to read
  std::string description;  ///< what is wrong with this hand
  PatientTraits traits;
};

/// Unknown keys, missing traits and values out of range are errors with their line. `file` is used
/// in errors only.
[[nodiscard]] Result<VirtualPatientFile> parse_patient(std::string_view text,
                                                       const std::string& file);

}  // namespace isograsp::virtual_patient
