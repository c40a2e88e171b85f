// SPDX-License-Identifier: GPL-3.0-or-later
// Patient files: who is accepted has traits within their ranges.
#include "tests/fuzz/support.hpp"
#include "virtual_patient/patient_file.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto text = fuzz::as_text(data, size);
  const auto patient = virtual_patient::parse_patient(text, "patient.toml");
  if (!patient) {
    fuzz::require_helpful(patient.error(), text);
    return 0;
  }
  fuzz::require(virtual_patient::clamped(patient->traits) == patient->traits,
                "every trait is within its range");
  return 0;
}
