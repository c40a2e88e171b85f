// SPDX-License-Identifier: GPL-3.0-or-later
// The person in front of a simulated device, as its URI describes them.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "device/config/uri.hpp"
#include "virtual_patient/virtual_patient.hpp"

namespace isograsp::session {

/// sim://NAME: healthy, paretic or a file LIBRARY/patients/NAME.toml. Parameters:
///   seed      of the person; same seed, same forces
///   recovery  0: as named … 1: healthy
///   course    a file LIBRARY/patients/courses/NAME.toml
///   day       of the course and of the person's form; without it the person is as named
/// Nothing for a device that is not simulated. Without a library only the first two have a name.
[[nodiscard]] Result<std::unique_ptr<virtual_patient::VirtualPatient>> simulated_person(
    const Uri& uri, const std::string& library = "");

/// The traits that this person would have.
[[nodiscard]] Result<virtual_patient::PatientTraits> simulated_traits(const Uri& uri,
                                                                      const std::string& library);

/// Names of the TOML files in a folder of the library, without their ending, sorted.
[[nodiscard]] std::vector<std::string> names_in(const std::string& library,
                                                const std::filesystem::path& folder);
/// Names of the people of a library and of the program, and of its courses; sorted.
[[nodiscard]] std::vector<std::string> simulated_people(const std::string& library);
[[nodiscard]] std::vector<std::string> simulated_courses(const std::string& library);

}  // namespace isograsp::session
