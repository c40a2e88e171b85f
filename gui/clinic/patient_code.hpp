// SPDX-License-Identifier: GPL-3.0-or-later
// New patients get a code that says nothing about them.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "storage/records/session_store.hpp"

namespace isograsp::gui {

/// A code such as "P-7K3M9" that none of `taken` has: digits and letters in turn, without those
/// that are mistaken for each other (0 O, 1 I). `entropy` must not be seeded with anything
/// personal.
[[nodiscard]] std::string generate_patient_code(const std::vector<storage::PatientRecord>& taken,
                                                std::mt19937_64& entropy);

}  // namespace isograsp::gui
